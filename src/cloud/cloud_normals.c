/* cloud_normals - see segment_steps.h. */
#include "segment_steps.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/kdtree.h"
#include "base/parallel.h"
#include "math/plane_fit.h"

/* Off a plane, by its length, at a sharp edge. */
static const double BENT = 0.07;

struct estimation {
    const struct vec3 *point;
    const struct kdtree *tree;
    size_t *neighbour;
    struct vec3 *normal;     /* of the planes below */
    struct plane_fit *plane; /* through each point and its neighbours */
    size_t *best, *better;   /* whose plane each point takes, and takes next */
    struct vec3 up;          /* unit: what is seen from there is the outside */
};

/* A way to a point that has no sign yet, from one that has. */
struct step {
    double turn; /* 1 - |cosine| */
    size_t from, to;
};

struct steps {
    size_t n, cap;
    struct step *item;
};

static void find_neighbours(void *context, size_t from, size_t to)
{
    const struct estimation *e = context;

    for (size_t i = from; i < to; i++) {
        size_t near[CLOUD_NEAR + 1], *out = e->neighbour + i * CLOUD_NEAR, found = 0;
        kdtree_nearest(e->tree, e->point[i], CLOUD_NEAR + 1, near, NULL);
        for (size_t k = 0; k <= CLOUD_NEAR && found < CLOUD_NEAR; k++)
            if (near[k] != i)
                out[found++] = near[k];
    }
}

size_t *cloud_neighbours(const struct vec3 *point, size_t n, int threads)
{
    struct kdtree *tree = kdtree_new(point, n);
    struct estimation e = {.point = point, .tree = tree};

    e.neighbour = mem_alloc(n * CLOUD_NEAR, sizeof *e.neighbour);
    parallel_for(threads, n, find_neighbours, &e);
    kdtree_free(tree);
    return e.neighbour;
}

double cloud_spacing(const struct vec3 *point, size_t n, const size_t *neighbour)
{
    double *reach = mem_alloc(n, sizeof *reach);

    for (size_t i = 0; i < n; i++)
        reach[i] = vec_distance(point[i], point[neighbour[i * CLOUD_NEAR + CLOUD_NEAR - 1]]);
    doubles_sort(reach, n);
    double spacing = reach[n / 2] * sqrt(PI / CLOUD_NEAR);
    free(reach);
    return spacing;
}

static void fit_planes(void *context, size_t from, size_t to)
{
    const struct estimation *e = context;

    for (size_t i = from; i < to; i++) {
        struct vec3 near[CLOUD_NEAR + 1] = {e->point[i]};
        struct plane_fit *plane = &e->plane[i];
        for (size_t k = 0; k < CLOUD_NEAR; k++)
            near[k + 1] = e->point[e->neighbour[i * CLOUD_NEAR + k]];
        if (plane_fit(near, CLOUD_NEAR + 1, plane) != 0)
            *plane = (struct plane_fit){near[0], vec(0, 0, 1), HUGE_VAL, 0, 0};
        e->normal[i] = plane->normal;
    }
}

/* How badly the plane of point j serves point i. */
static double misfit_of(const struct estimation *e, size_t i, size_t j)
{
    const struct plane_fit *plane = &e->plane[j];

    return hypot(plane->rms, vec_dot(plane->normal, vec_sub(e->point[i], plane->centre)));
}

/* Of the plane that a point has and those that its neighbours have the one that serves it best:
 * beside a sharp edge one whose points are all on its side. */
static void choose_planes(void *context, size_t from, size_t to)
{
    const double clearly = 0.5;
    const struct estimation *e = context;

    for (size_t i = from; i < to; i++) {
        size_t best = e->best[i];
        double least = clearly * misfit_of(e, i, best);
        bool sharp = least > clearly * BENT * e->plane[i].length;
        for (size_t k = 0; sharp && k < CLOUD_NEAR; k++) {
            size_t j = e->best[e->neighbour[i * CLOUD_NEAR + k]];
            double now = misfit_of(e, i, j);
            if (now < least) {
                least = now;
                best = j;
            }
        }
        e->better[i] = best;
    }
}

/* Three times, so that it comes from three times as far. */
static void choose_sharp_planes(struct estimation *e, size_t n, int threads)
{
    e->best = mem_alloc(n, sizeof *e->best);
    e->better = mem_alloc(n, sizeof *e->better);
    for (size_t i = 0; i < n; i++)
        e->best[i] = i;
    for (int turn = 0; turn < 3; turn++) {
        parallel_for(threads, n, choose_planes, e);
        size_t *swap = e->best;
        e->best = e->better;
        e->better = swap;
    }
    free(e->better);
}

/* A total order, so that the tree does not depend on how the heap came about. */
static bool comes_before(const struct step *a, const struct step *b)
{
    if (a->turn < b->turn || a->turn > b->turn)
        return a->turn < b->turn;
    return a->to != b->to ? a->to < b->to : a->from < b->from;
}

static void swap_steps(struct step *a, struct step *b)
{
    struct step c = *a;
    *a = *b;
    *b = c;
}

static void heap_push(struct steps *heap, struct step step)
{
    *array_push(heap) = step;
    for (size_t i = heap->n - 1; i > 0; i = (i - 1) / 2) {
        if (!comes_before(&heap->item[i], &heap->item[(i - 1) / 2]))
            break;
        swap_steps(&heap->item[i], &heap->item[(i - 1) / 2]);
    }
}

static struct step heap_pop(struct steps *heap)
{
    struct step first = heap->item[0];
    size_t i = 0, n = --heap->n;

    heap->item[0] = heap->item[n];
    for (size_t child; (child = 2 * i + 1) < n; i = child) {
        if (child + 1 < n && comes_before(&heap->item[child + 1], &heap->item[child]))
            child++;
        if (!comes_before(&heap->item[child], &heap->item[i]))
            break;
        swap_steps(&heap->item[child], &heap->item[i]);
    }
    return first;
}

/* How well two normals go together, from -1 to 1: the cosine between the one and what a circle
 * through both points would make of the other.  At a right angle their own says nothing. */
static double agreement(const struct estimation *e, size_t i, size_t j)
{
    struct vec3 d = vec_unit(vec_sub(e->point[j], e->point[i])), n = e->normal[j];

    return vec_dot(e->normal[i], vec_along(n, -2 * vec_dot(n, d), d));
}

/* The points that have a sign, in the order in which they got it, and steps from them to others. */
struct front {
    bool *done;
    struct sizes reached;
    struct steps heap;
};

static void reach(const struct estimation *e, size_t i, struct front *front)
{
    front->done[i] = true;
    *array_push(&front->reached) = i;
    for (size_t k = 0; k < CLOUD_NEAR; k++) {
        size_t j = e->neighbour[i * CLOUD_NEAR + k];
        if (!front->done[j])
            heap_push(&front->heap, (struct step){1 - fabs(agreement(e, i, j)), i, j});
    }
}

static void turn_over(struct vec3 *normal)
{
    *normal = vec_scale(-1, *normal);
}

/* Signs for all that can be reached from those that have theirs. */
static void orient_reached(const struct estimation *e, struct front *front)
{
    while (front->heap.n > 0) {
        struct step s = heap_pop(&front->heap);
        struct vec3 *n = &e->normal[s.to];
        if (front->done[s.to])
            continue;
        if (agreement(e, s.from, s.to) < 0)
            turn_over(n);
        reach(e, s.to, front);
    }
}

struct height {
    double z; /* along `up` */
    size_t point;
    bool vague; /* its normal does not tell which side is up */
};

/* Those that are not vague, and of these the highest first. */
static int by_height(const void *a, const void *b)
{
    const struct height *h = a, *k = b;

    if (h->vague != k->vague)
        return h->vague ? 1 : -1;
    if (h->z < k->z || h->z > k->z)
        return h->z > k->z ? -1 : 1;
    return (h->point > k->point) - (h->point < k->point);
}

/* Steep, or no plane. */
static bool is_ambiguous(const struct plane_fit *plane, struct vec3 up)
{
    return fabs(vec_dot(plane->normal, up)) < 0.5 || plane->rms > BENT * plane->length;
}

struct sight {
    const struct estimation *e;
    const struct kdtree *tree;
    double spacing, top;
    bool *seen;
};

/* What is neither steep nor under other points. */
static void look_from_above(void *context, size_t from, size_t to)
{
    const double beside = 2.25, over = 4; /* spacings: as lines are apart, and more than a surface
                                             so flat rises in that */
    const struct sight *s = context;
    double within = beside * s->spacing, least = over * s->spacing;

    for (size_t i = from; i < to; i++) {
        struct vec3 p = s->e->point[i], up = s->e->up;
        s->seen[i] =
            !is_ambiguous(&s->e->plane[i], up) &&
            !kdtree_any_beside(s->tree, vec_along(p, least, up),
                               vec_along(p, fmax(least, s->top - vec_dot(p, up)), up), within);
    }
}

/* Which points are in sight from above, and not steep there. */
static void find_seen(const struct estimation *e, size_t n, int threads, bool *seen)
{
    struct kdtree *tree = kdtree_new_by(e->point, n, threads);
    struct sight s = {e, tree, cloud_spacing(e->point, n, e->neighbour), -HUGE_VAL, seen};

    for (size_t i = 0; i < n; i++)
        s.top = fmax(s.top, vec_dot(e->point[i], e->up));
    parallel_for(threads, n, look_from_above, &s);
    kdtree_free(tree);
}

/* The points that hang together with this one and have no sign. */
static void find_piece(const struct estimation *e, size_t start, bool *found, struct sizes *piece)
{
    piece->n = 0;
    *array_push(piece) = start;
    found[start] = true;
    for (size_t k = 0; k < piece->n; k++)
        for (size_t m = 0; m < CLOUD_NEAR; m++) {
            size_t j = e->neighbour[piece->item[k] * CLOUD_NEAR + m];
            if (found[j])
                continue;
            found[j] = true;
            *array_push(piece) = j;
        }
}

/* Begins with all points of the piece that are in sight from above: these face up.  How many. */
static size_t begin_seen(const struct estimation *e, const struct sizes *piece, const bool *seen,
                         struct front *front)
{
    size_t some = 0;

    for (size_t k = 0; k < piece->n; k++) {
        size_t i = piece->item[k];
        if (seen[i] && vec_dot(e->normal[i], e->up) < 0)
            turn_over(&e->normal[i]);
        front->done[i] = seen[i];
        some += seen[i];
    }
    for (size_t k = 0; k < piece->n; k++)
        if (seen[piece->item[k]])
            reach(e, piece->item[k], front);
    return some;
}

/* Turns over those reached from number `from` on whose normals' mean points down by more than
 * `least`. */
static void turn_up(const struct estimation *e, const struct front *front, size_t from,
                    double least)
{
    double up = 0;

    for (size_t k = from; k < front->reached.n; k++)
        up += vec_dot(e->normal[front->reached.item[k]], e->up);
    if (up >= -least * (double)(front->reached.n - from))
        return;
    for (size_t k = from; k < front->reached.n; k++)
        turn_over(&e->normal[front->reached.item[k]]);
}

/* Most of a piece faces up, or nearly so where some of it is in sight from above. */
static void orient_piece(const struct estimation *e, const struct sizes *piece, const bool *seen,
                         struct front *front)
{
    const double nearly = 0.1;
    size_t from = front->reached.n, some = begin_seen(e, piece, seen, front);

    if (some == 0)
        reach(e, piece->item[0], front);
    orient_reached(e, front);
    turn_up(e, front, from, some > 0 ? nearly : 0);
}

/* Signs for all, piece by piece from the top. */
static void orient(const struct estimation *e, size_t n, int threads)
{
    struct height *height = mem_alloc(n, sizeof *height);
    struct front front = {.done = mem_alloc(n, sizeof *front.done)};
    bool *seen = mem_alloc(n, sizeof *seen), *found = mem_alloc(n, sizeof *found);
    struct sizes piece = {0};

    for (size_t i = 0; i < n; i++)
        height[i] =
            (struct height){vec_dot(e->point[i], e->up), i, is_ambiguous(&e->plane[i], e->up)};
    qsort(height, n, sizeof *height, by_height);
    find_seen(e, n, threads, seen);
    for (size_t i = 0; i < n; i++) {
        if (front.done[height[i].point])
            continue;
        find_piece(e, height[i].point, found, &piece);
        orient_piece(e, &piece, seen, &front);
    }
    free(seen);
    free(found);
    array_free(&piece);
    free(front.done);
    array_free(&front.reached);
    array_free(&front.heap);
    free(height);
}

void cloud_normals(const struct vec3 *point, size_t n, const size_t *neighbour, struct vec3 up,
                   int threads, struct vec3 *normal)
{
    struct estimation e = {.point = point, .neighbour = (size_t *)neighbour, .up = up};

    e.normal = mem_alloc(n, sizeof *e.normal);
    e.plane = mem_alloc(n, sizeof *e.plane);
    parallel_for(threads, n, fit_planes, &e);
    choose_sharp_planes(&e, n, threads);
    orient(&e, n, threads);
    for (size_t i = 0; i < n; i++)
        normal[i] = e.normal[e.best[i]];
    free(e.best);
    free(e.plane);
    free(e.normal);
}
