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

static void push_neighbours(const struct estimation *e, size_t i, const bool *done,
                            struct steps *heap)
{
    for (size_t k = 0; k < CLOUD_NEAR; k++) {
        size_t j = e->neighbour[i * CLOUD_NEAR + k];
        if (!done[j])
            heap_push(heap, (struct step){1 - fabs(vec_dot(e->normal[i], e->normal[j])), i, j});
    }
}

/* Signs for all that can be reached from a point that has its own. */
static void orient_from(const struct estimation *e, size_t start, bool *done, struct steps *heap)
{
    done[start] = true;
    push_neighbours(e, start, done, heap);
    while (heap->n > 0) {
        struct step s = heap_pop(heap);
        struct vec3 *n = &e->normal[s.to];
        if (done[s.to])
            continue;
        if (vec_dot(*n, e->normal[s.from]) < 0)
            *n = vec_scale(-1, *n);
        done[s.to] = true;
        push_neighbours(e, s.to, done, heap);
    }
}

struct height {
    double z;
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
static bool is_ambiguous(const struct plane_fit *plane)
{
    return fabs(plane->normal.z) < 0.5 || plane->rms > BENT * plane->length;
}

void cloud_normals(const struct vec3 *point, size_t n, const size_t *neighbour, int threads,
                   struct vec3 *normal)
{
    struct estimation e = {.point = point, .neighbour = (size_t *)neighbour};
    struct height *height = mem_alloc(n, sizeof *height);
    bool *done = mem_alloc(n, sizeof *done);
    struct steps heap = {0};

    e.normal = mem_alloc(n, sizeof *e.normal);
    e.plane = mem_alloc(n, sizeof *e.plane);
    parallel_for(threads, n, fit_planes, &e);
    choose_sharp_planes(&e, n, threads);
    for (size_t i = 0; i < n; i++)
        height[i] = (struct height){point[i].z, i, is_ambiguous(&e.plane[i])};
    qsort(height, n, sizeof *height, by_height);
    for (size_t i = 0; i < n; i++) {
        size_t top = height[i].point;
        if (done[top])
            continue;
        if (e.normal[top].z < 0)
            e.normal[top] = vec_scale(-1, e.normal[top]);
        orient_from(&e, top, done, &heap);
    }
    for (size_t i = 0; i < n; i++)
        normal[i] = e.normal[e.best[i]];
    free(e.best);
    free(e.plane);
    free(e.normal);
    array_free(&heap);
    free(height);
    free(done);
}
