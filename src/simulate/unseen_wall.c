/* unseen_wall - see unseen_wall.h. */
#include "simulate/unseen_wall.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/box.h"
#include "unseen_step.h"

static const double NEAR = 2.8;  /* spacings: so far the wall may be, seen from above */
static const double STEEP = 2.5; /* 68 degrees: by so much a slope rises over that way ... */
static const double ROUGH = 1;   /* ... and so many spacings more */
static const double WIDER = 1.4; /* the spacing about one point is known so far */

struct search {
    const struct vec3 *point;
    const double *spacing;
    double top; /* of all points */
    const struct kdtree *tree;
    double *height;
};

static int by_height(const void *pa, const void *pb)
{
    const struct vec3 *a = pa, *b = pb;

    return (a->z > b->z) - (a->z < b->z);
}

static double plan_distance(struct vec3 a, struct vec3 b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* The point of near[from] on that is nearest to p, seen from above. */
static struct vec3 nearest_above(struct vec3 p, const struct vec3s *near, size_t from)
{
    struct vec3 nearest = near->item[from];

    for (size_t k = from + 1; k < near->n; k++)
        if (plan_distance(p, near->item[k]) < plan_distance(p, nearest))
            nearest = near->item[k];
    return nearest;
}

/* How high a wall may stand over a point, by those near it, lowest first. */
static double wall_over(struct vec3 p, const struct vec3s *near, double spacing)
{
    double below = p.z;

    for (size_t k = 0; k < near->n; k++) {
        if (near->item[k].z - below > ROUGH * spacing) {
            struct vec3 high = nearest_above(p, near, k);
            double step = near->item[k].z - below;
            if (step > STEEP * plan_distance(p, high) + ROUGH * spacing)
                return unseen_step_is_foot(p, near->item, k, near->item + k, near->n - k,
                                           NEAR * spacing)
                           ? high.z - p.z
                           : 0;
        }
        below = fmax(below, near->item[k].z);
    }
    return 0;
}

static void find_walls(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    struct vec3s near = {0};

    for (size_t i = from; i < to; i++) {
        struct vec3 p = s->point[i];
        if (s->height[i] < 0)
            continue;
        near.n = 0;
        kdtree_beside(s->tree, p, vec(p.x, p.y, s->top), NEAR * s->spacing[i], &near);
        qsort(near.item, near.n, sizeof *near.item, by_height);
        s->height[i] = wall_over(p, &near, s->spacing[i]);
        if (s->height[i] > 0)
            continue;
        near.n = 0;
        kdtree_beside(s->tree, p, vec(p.x, p.y, s->top), WIDER * UNSEEN_STEP_REACH * s->spacing[i],
                      &near);
        s->height[i] = unseen_step_over(p, &near);
    }
    array_free(&near);
}

void unseen_wall_find(const struct vec3 *point, const double *spacing, size_t n,
                      const struct kdtree *tree, int threads, double *height)
{
    struct search search = {point, spacing, box_around(point, n).high.z, tree, height};

    parallel_for(threads, n, find_walls, &search);
}
