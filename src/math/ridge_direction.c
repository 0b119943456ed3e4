/* ridge_direction - see ridge_direction.h. */
#include "math/ridge_direction.h"

#include <stdlib.h>

#include "base/array.h"

enum { TRIES = 4, SOME = 256 /* points ranked on the stack */ };

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

/* Ranks points, so far off and with these squares of their distance, by the distance along a way;
 * the first k in front.  The farthest in space of them goes to their end. */
static void rank_along(const struct vec3 *off, const double *all2, size_t n, struct vec3 way,
                       double aspect, size_t k, struct ranked *ranked)
{
    double most = -1, shorter = 1 - 1 / (aspect * aspect);
    size_t farthest = 0;

    for (size_t i = 0; i < n; i++) {
        double along = vec_dot(off[i], way);
        ranked[i] = (struct ranked){all2[i] - along * along * shorter, i};
    }
    if (k < n)
        select_first(ranked, n, k);
    for (size_t i = 0; i < k; i++) {
        if (all2[ranked[i].index] >= most) {
            most = all2[ranked[i].index];
            farthest = i;
        }
    }
    if (k > 0) {
        struct ranked last = ranked[k - 1];
        ranked[k - 1] = ranked[farthest];
        ranked[farthest] = last;
    }
}

/* Points as they lie about a place. */
struct about {
    size_t n;
    struct vec3 *off;
    double *all2; /* squares of their distance */
    struct ranked *ranked;
    struct vec3 *local; /* in the frame of a surface */
    struct vec3 few_off[SOME], few_local[SOME];
    double few_all2[SOME];
    struct ranked few_ranked[SOME];
};

static void about_begin(struct about *a, const struct vec3 *point, size_t n, struct vec3 at)
{
    bool few = n <= SOME;

    a->n = n;
    a->off = few ? a->few_off : mem_alloc(n, sizeof *a->off);
    a->local = few ? a->few_local : mem_alloc(n, sizeof *a->local);
    a->all2 = few ? a->few_all2 : mem_alloc(n, sizeof *a->all2);
    a->ranked = few ? a->few_ranked : mem_alloc(n, sizeof *a->ranked);
    for (size_t i = 0; i < n; i++) {
        a->off[i] = vec_sub(point[i], at);
        a->all2[i] = vec_dot(a->off[i], a->off[i]);
    }
}

static void about_end(struct about *a)
{
    if (a->off == a->few_off)
        return;
    free(a->off);
    free(a->local);
    free(a->all2);
    free(a->ranked);
}

size_t neighbourhood_along(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
                           double aspect, size_t k, struct vec3 *found)
{
    struct about a;

    k = k < n ? k : n;
    about_begin(&a, point, n, at);
    rank_along(a.off, a.all2, n, way, aspect, k, a.ranked);
    for (size_t i = 0; i < k; i++)
        found[i] = point[a.ranked[i].index]; /* NOLINT(clang-analyzer-core.*): all are ranked */
    about_end(&a);
    return k;
}

/* What is looked for, and where. */
struct finding {
    struct about about;
    size_t some;
    struct vec3 at, up, way, side;
};

/* Along direction i: how far the points are off; infinite where they carry no surface. */
static struct ridge_direction look_along(struct finding *f, int i)
{
    struct vec3 found[RIDGE_DIRECTION_MOST];
    struct ridge_direction rib = {.rms = INFINITY};
    struct about *a = &f->about;
    size_t k = f->some < a->n ? f->some : a->n;

    rib.way = vec_along(vec_scale(cos(i * STEP), f->way), sin(i * STEP), f->side);
    rank_along(a->off, a->all2, a->n, rib.way, RIDGE_DIRECTION_LONGER, k, a->ranked);
    for (size_t p = 0; p < k; p++)
        found[p] = a->local[a->ranked[p].index];
    if (quadric_fit_local(found, k, f->at, f->up, &rib.q) == 0)
        rib.rms = quadric_rms_local(&rib.q, found, k);
    return rib;
}

/* Every other direction, then those beside the best. */
bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib)
{
    struct finding f; /* large: only what is needed is set */
    struct quadric frame = quadric_frame(at, up);
    int best = 0;

    f.some = some;
    f.at = at;
    f.up = up;
    f.way = way;
    f.side = vec_cross(up, way);
    about_begin(&f.about, point, n, at);
    quadric_local_all(&frame, point, n, f.about.local);
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
    about_end(&f.about);
    return rib->rms < INFINITY;
}
