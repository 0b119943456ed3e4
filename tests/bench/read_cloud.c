/*
 * read_cloud - the reader of clouds alone, to be compared with floor_read: reads a file and says
 * how many points there are and what they add up to.
 *
 *     read_cloud FILE
 */
#include <stdio.h>

#include "io/cloud/cloud.h"

static void add_up(void *context, const struct vec3 *point, size_t n)
{
    struct vec3 *sum = context, s = *sum;

    for (size_t i = 0; i < n; i++)
        s = vec_add(s, point[i]);
    *sum = s;
}

int main(int argc, char **argv)
{
    struct cloud_count count;
    struct error error;
    struct vec3 sum = {0, 0, 0};

    if (cloud_read_blocks(argc > 1 ? argv[1] : "-", add_up, &sum, 1, &count, &error) < 0) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    printf("%zu %.3f %.3f %.3f\n", count.points, sum.x, sum.y, sum.z);
    return 0;
}
