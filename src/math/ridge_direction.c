/* ridge_direction - see ridge_direction.h. */
#include "math/ridge_direction.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/pair.h"

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

/* So many parts of the range that the first k are in; counts of those that are beyond it. */
enum { PARTS = 64, SPREAD = 8 };

/* Points as they lie about a place. */
struct about {
    size_t n;
    double *x, *y, *z;   /* from it, each by itself: two numbers fit a register */
    double *all2;        /* squares of their distance */
    double *value;       /* the same, along a way */
    unsigned char *part; /* of the range, in which that is */
    size_t *first;       /* the first ones of them, and room for one more */
    struct ranked *ranked;
    struct vec3 *local; /* in the frame of a surface */
    double few_x[SOME], few_y[SOME], few_z[SOME];
    struct vec3 few_local[SOME];
    double few_all2[SOME], few_value[SOME];
    unsigned char few_part[SOME];
    size_t few_first[SOME + 1];
    struct ranked few_ranked[SOME + 1];
};

/* The largest of the first k values (not NaN): four at a time, for one would wait for another. */
static double largest(const double *value, size_t k)
{
    pair low = {0, 0}, high = {0, 0};
    size_t i = 0;

    for (; i + 3 < k; i += 4) {
        low = pair_greater(pair_at(value + i), low);
        high = pair_greater(pair_at(value + i + 2), high);
    }
    low = pair_greater(high, low);
    double most = low[0] > low[1] ? low[0] : low[1];
    for (; i < k; i++)
        most = value[i] > most ? value[i] : most;
    return most;
}

/* The part of the range that the k-th of the values is in; *below: how many are in parts before. */
static unsigned find_part(const struct about *a, size_t k, size_t *below)
{
    unsigned count[PARTS + SPREAD] = {0}, last = 0;
    const double *value = a->value;
    unsigned char *restrict to = a->part;
    size_t n = a->n;
    double limit = largest(value, k); /* k of the values are no larger */

    double scale = limit > 0 ? PARTS / limit : 0;
    for (size_t i = 0; i < n; i++) {
        double part = value[i] * scale;
        to[i] = (unsigned char)(int)(part < PARTS ? part : PARTS);
    }
    for (size_t i = 0; i < n; i++) /* of those beyond not all in one count, to wait for it */
        count[to[i] + to[i] / PARTS * (i % SPREAD)]++;
    for (*below = 0; last < PARTS && *below + count[last] < k; last++)
        *below += count[last];
    return last;
}

/* The k smallest of the values to first[]: those of the parts of the range before the k-th one's in
 * the order of the points, then those of that part: a histogram, for to select from all (Hoare)
 * means to go through most of them some three times. */
static void rank_values(const struct about *a, size_t k)
{
    size_t below, sure = 0, at_last = 0, n = a->n;
    unsigned last = find_part(a, k, &below);
    size_t *restrict first = a->first;
    struct ranked *restrict ranked = a->ranked;

    for (size_t i = 0; i < n; i++) {
        unsigned part = a->part[i]; /* NOLINT(clang-analyzer-core.*): all are set */
        first[sure] = i;
        sure += part < last;
        ranked[at_last].index = i;
        at_last += part == last;
    }
    for (size_t i = 0; i < at_last; i++)
        ranked[i].distance2 = a->value[ranked[i].index];
    if (below + at_last > k)
        select_first(ranked, at_last, k - below);
    for (size_t i = below; i < k; i++)
        first[i] = ranked[i - below].index;
}

/* Ranks points by the distance along a way; the k (not 0) first.  The farthest in space of them
 * goes to their end. */
static void rank_along(const struct about *a, struct vec3 way, double aspect, size_t k)
{
    double most = -1, shorter = 1 - 1 / (aspect * aspect);
    size_t farthest = 0;

    const double *x = a->x, *y = a->y, *z = a->z, *all2 = a->all2;
    double *restrict to = a->value;
    for (size_t i = 0, n = a->n; i < n; i++) {
        double along = x[i] * way.x + y[i] * way.y + z[i] * way.z;
        double value = all2[i] - along * along * shorter;
        to[i] = value > 0 ? value : 0;
    }
    rank_values(a, k);
    for (size_t i = 0; i < k; i++) {
        double far2 = all2[a->first[i]];
        farthest = far2 >= most ? i : farthest;
        most = far2 >= most ? far2 : most;
    }
    size_t swap = a->first[k - 1];
    a->first[k - 1] = a->first[farthest];
    a->first[farthest] = swap;
}

static void about_begin(struct about *a, const struct vec3 *point, size_t n, struct vec3 at)
{
    bool few = n <= SOME;

    a->n = n;
    a->x = few ? a->few_x : mem_alloc(n, sizeof *a->x);
    a->y = few ? a->few_y : mem_alloc(n, sizeof *a->y);
    a->z = few ? a->few_z : mem_alloc(n, sizeof *a->z);
    a->local = few ? a->few_local : mem_alloc(n, sizeof *a->local);
    a->all2 = few ? a->few_all2 : mem_alloc(n, sizeof *a->all2);
    a->value = few ? a->few_value : mem_alloc(n, sizeof *a->value);
    a->part = few ? a->few_part : mem_alloc(n, 1);
    a->first = few ? a->few_first : mem_alloc(n + 1, sizeof *a->first);
    a->ranked = few ? a->few_ranked : mem_alloc(n + 1, sizeof *a->ranked);
    for (size_t i = 0; i < n; i++) {
        struct vec3 off = vec_sub(point[i], at);
        a->x[i] = off.x, a->y[i] = off.y, a->z[i] = off.z;
        a->all2[i] = vec_dot(off, off);
    }
}

static void about_end(struct about *a)
{
    if (a->x == a->few_x)
        return;
    free(a->x);
    free(a->y);
    free(a->z);
    free(a->local);
    free(a->all2);
    free(a->value);
    free(a->part);
    free(a->first);
    free(a->ranked);
}

size_t neighbourhood_along(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
                           double aspect, size_t k, struct vec3 *found)
{
    struct about a;

    k = k < n ? k : n;
    about_begin(&a, point, n, at);
    if (k > 0)
        rank_along(&a, way, aspect, k);
    for (size_t i = 0; i < k; i++)
        found[i] = point[a.first[i]]; /* NOLINT(clang-analyzer-core.*): all are ranked */
    about_end(&a);
    return k;
}

/* What is looked for, and where. */
struct finding {
    struct about about;
    size_t some;
    struct vec3 way, side;
    struct quadric frame;
};

/* Along direction i: how far the points are off; infinite where they carry no surface. */
static struct ridge_direction look_along(struct finding *f, int i)
{
    struct vec3 found[RIDGE_DIRECTION_MOST];
    struct ridge_direction rib = {.rms = INFINITY};
    struct about *a = &f->about;
    size_t k = f->some < a->n ? f->some : a->n;

    rib.way = vec_along(vec_scale(cos(i * STEP), f->way), sin(i * STEP), f->side);
    if (k > 0)
        rank_along(a, rib.way, RIDGE_DIRECTION_LONGER, k);
    for (size_t p = 0; p < k; p++)
        found[p] = a->local[a->first[p]]; /* NOLINT(clang-analyzer-core.*): all are ranked */
    if (quadric_fit_local(found, k, &f->frame, &rib.q) == 0)
        rib.rms = quadric_rms_local(&rib.q, found, k);
    return rib;
}

/* Every other direction up to so many to either side, then those beside the best. */
static bool find_among(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                       struct vec3 way, size_t some, int tries, struct ridge_direction *rib)
{
    struct finding f;              /* large: only what is needed is set */
    int best = tries % 2 ? -1 : 0; /* so that where none is found the middle has been tried */

    f.some = some;
    f.frame = quadric_frame(at, up);
    f.way = way;
    f.side = vec_cross(up, way);
    about_begin(&f.about, point, n, at);
    quadric_local_all(&f.frame, point, n, f.about.local);
    rib->rms = INFINITY;
    for (int i = -tries; i <= tries; i += 2) {
        struct ridge_direction next = look_along(&f, i);
        if (next.rms < rib->rms) {
            *rib = next;
            best = i;
        }
    }
    for (int i = best - 1; i <= best + 1; i += 2) {
        if (i < -tries || i > tries)
            continue;
        struct ridge_direction next = look_along(&f, i);
        if (next.rms < rib->rms)
            *rib = next;
    }
    about_end(&f.about);
    return rib->rms < INFINITY;
}

bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib)
{
    return find_among(point, n, at, up, way, some, TRIES, rib);
}

bool ridge_direction_follow(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                            struct vec3 way, size_t some, struct ridge_direction *rib)
{
    return find_among(point, n, at, up, way, some, 1, rib);
}
