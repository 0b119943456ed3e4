/* near_lists - see near_lists.h. */
#include "math/near_lists.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"

struct making {
    const struct point_grid *grid;
    uint32_t *index;
};

static void make_some(void *context, size_t from, size_t to)
{
    const struct making *m = context;
    double distance2[NEAR_LIST];

    for (size_t i = from; i < to; i++)
        point_grid_nearest(m->grid, m->grid->point[i], NEAR_LIST, m->index + NEAR_LIST * i,
                           distance2);
}

struct near_lists near_lists_of(const struct point_grid *b, int threads)
{
    struct near_lists lists = {NULL};

    if (b->n < NEAR_LIST || b->n > NEAR_LISTS_MOST)
        return lists;
    lists.index = mem_alloc(b->n, NEAR_LIST * sizeof *lists.index);
    parallel_for(threads, b->n, make_some, &(struct making){b, lists.index});
    return lists;
}

void near_lists_free(struct near_lists *lists)
{
    free(lists->index);
    lists->index = NULL;
}

size_t near_lists_nearest(const struct near_lists *lists, const struct point_grid *b, size_t i,
                          size_t k, uint32_t *index, double *distance2)
{
    struct vec3 at = b->point[i];

    if (!lists || !lists->index || k > NEAR_LIST)
        return point_grid_nearest(b, at, k, index, distance2);
    memcpy(index, lists->index + NEAR_LIST * i, k * sizeof *index);
    for (size_t n = 0; n < k; n++) {
        struct vec3 d = vec_sub(b->point[index[n]], at);
        distance2[n] = vec_dot(d, d);
    }
    return k;
}
