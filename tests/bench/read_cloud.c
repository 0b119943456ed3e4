/*
 * read_cloud - the reader of clouds alone, to be compared with floor_read: reads a file and says how
 * many points there are and what they add up to.
 *
 *     read_cloud FILE
 */
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "io/cloud/cloud.h"

int main(int argc, char **argv)
{
    struct vec3s points = {0};
    struct cloud_count count;
    struct error error;
    struct vec3 sum = {0, 0, 0};

    if (cloud_read(argc > 1 ? argv[1] : "-", &points, &count, &error) < 0) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    for (size_t i = 0; i < points.n; i++)
        sum = vec_add(sum, points.item[i]);
    printf("%zu %.3f %.3f %.3f\n", points.n, sum.x, sum.y, sum.z);
    array_free(&points);
    return 0;
}
