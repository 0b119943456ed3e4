/* ridge_direction - see ridge_direction.h. */
#include "math/ridge_direction.h"

#include <stdlib.h>

#include "base/array.h"

enum { TRIES = 4, SOME = 512 /* points ranked on the stack */ };

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
    struct ranked few[SOME], *ranked = n > SOME ? mem_alloc(n, sizeof *ranked) : few;
    double most = -1, shorter = 1 - 1 / (aspect * aspect);
    size_t farthest = 0;

    k = k < n ? k : n;
    for (size_t i = 0; i < n; i++) {
        struct vec3 off = vec_sub(point[i], at);
        double along = vec_dot(off, way), all2 = vec_dot(off, off);
        ranked[i] = (struct ranked){all2 - along * along * shorter, i};
    }
    if (k < n)
        select_first(ranked, n, k);
    for (size_t i = 0; i < k; i++) {
        found[i] = point[ranked[i].index]; /* NOLINT(clang-analyzer-core.*): all are ranked */
        struct vec3 off = vec_sub(found[i], at);
        double distance2 = vec_dot(off, off);
        if (distance2 >= most) {
            most = distance2;
            farthest = i;
        }
    }
    if (k > 0) {
        struct vec3 last = found[k - 1];
        found[k - 1] = found[farthest];
        found[farthest] = last;
    }
    if (ranked != few)
        free(ranked);
    return k;
}

/* What is looked for, and where. */
struct finding {
    const struct vec3 *point;
    size_t n, some;
    struct vec3 at, up, way, side;
};

/* Along direction i: how far the points are off; infinite where they carry no surface. */
static struct ridge_direction look_along(const struct finding *f, int i)
{
    struct vec3 found[RIDGE_DIRECTION_MOST];
    struct ridge_direction rib = {.rms = INFINITY};

    rib.way = vec_along(vec_scale(cos(i * STEP), f->way), sin(i * STEP), f->side);
    size_t k =
        neighbourhood_along(f->point, f->n, f->at, rib.way, RIDGE_DIRECTION_LONGER, f->some, found);
    if (quadric_fit(found, k, f->at, f->up, &rib.q) == 0)
        rib.rms = quadric_rms(&rib.q, found, k);
    return rib;
}

/* Every other direction, then those beside the best. */
bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib)
{
    const struct finding f = {point, n, some, at, up, way, vec_cross(up, way)};
    int best = 0;

    rib->rms = INFINITY;
    for (int i = -TRIES; i <= TRIES; i += 2) {
        struct ridge_direction next = look_along(&f, i);
        if (next.rms < rib->rms) {
            *rib = next;
            best = i;
        }
    }
    for (int i = best - 1; i <= best + 1; i += 2) {
        if (i < -TRIES || i > TRIES)
            continue;
        struct ridge_direction next = look_along(&f, i);
        if (next.rms < rib->rms)
            *rib = next;
    }
    return rib->rms < INFINITY;
}
