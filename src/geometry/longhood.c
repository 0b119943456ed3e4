/* longhood - see longhood.h. */
#include "longhood.h"

#include <stdlib.h>

#include "array.h"

struct ranked {
    double distance2;
    size_t index;
};

static int by_distance(const void *a, const void *b)
{
    const struct ranked *p = a, *q = b;

    if (p->distance2 != q->distance2)
        return p->distance2 < q->distance2 ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

size_t longhood_take(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
                     double aspect, size_t k, struct vec3 *found)
{
    struct ranked *ranked = mem_alloc(n, sizeof *ranked);
    size_t farthest = 0;

    k = k < n ? k : n;
    for (size_t i = 0; i < n; i++) {
        struct vec3 off = vec_sub(point[i], at);
        double along = vec_dot(off, way), all2 = vec_dot(off, off);
        ranked[i] = (struct ranked){all2 - along * along * (1 - 1 / (aspect * aspect)), i};
    }
    qsort(ranked, n, sizeof *ranked, by_distance);
    for (size_t i = 0; i < k; i++) {
        found[i] = point[ranked[i].index];
        if (vec_distance(found[i], at) >= vec_distance(found[farthest], at))
            farthest = i;
    }
    if (k > 0) {
        struct vec3 last = found[k - 1];
        found[k - 1] = found[farthest];
        found[farthest] = last;
    }
    free(ranked);
    return k;
}
