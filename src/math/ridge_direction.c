/* ridge_direction - see ridge_direction.h. */
#include "math/ridge_direction.h"

#include <stdlib.h>

#include "base/array.h"

enum { TRIES = 4 };

static const double STEP = PI / 36;

struct ranked {
    double distance2;
    size_t index;
};

static bool before(struct ranked p, struct ranked q)
{
    return p.distance2 < q.distance2 || (p.distance2 == q.distance2 && p.index < q.index);
}

/* Puts the k first ones of n in front, in no particular but repeatable order (Hoare's selection).
 */
static void select_first(struct ranked *r, size_t n, size_t k)
{
    for (size_t from = 0, to = n; to - from > 1 && k > from;) {
        struct ranked pivot = r[from + (to - from) / 2], swap;
        size_t i = from, j = to - 1;
        for (;; i++, j--) {
            while (before(r[i], pivot))
                i++;
            while (before(pivot, r[j]))
                j--;
            if (i >= j)
                break;
            swap = r[i];
            r[i] = r[j];
            r[j] = swap;
        }
        size_t cut = i > from ? i : from + 1;
        if (k < cut)
            to = cut;
        else
            from = cut;
    }
}

size_t neighbourhood_along(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
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
    if (k < n)
        select_first(ranked, n, k);
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

bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib)
{
    struct vec3 found[RIDGE_DIRECTION_MOST], side = vec_cross(up, way);

    rib->rms = INFINITY;
    for (int i = -TRIES; i <= TRIES; i++) {
        struct quadric q;
        struct vec3 turned = vec_along(vec_scale(cos(i * STEP), way), sin(i * STEP), side);
        size_t k = neighbourhood_along(point, n, at, turned, RIDGE_DIRECTION_LONGER, some, found);
        if (quadric_fit(found, k, at, up, &q) < 0)
            continue;
        double rms = quadric_rms(&q, found, k);
        if (rms < rib->rms)
            *rib = (struct ridge_direction){q, turned, rms};
    }
    return rib->rms < INFINITY;
}
