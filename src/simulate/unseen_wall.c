/* unseen_wall - see unseen_wall.h. */
#include "simulate/unseen_wall.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/box.h"

static const double NEAR = 2.8;  /* spacings: so far the wall may be, seen from above */
static const double STEEP = 2.5; /* 68 degrees: by so much a slope rises over that way ... */
static const double ROUGH = 1;   /* ... and so many spacings more */
static const double ASIDE = 0.2; /* of that reach: the middle of the high points is farther off */
static const double AHEAD = 0.9; /* cosine: a low point is on the way to a high one */

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

/* The high points are on one side of p, and none of the low ones is before it there: on the way to
 * the wall, or beyond it, under a roof. */
static bool is_foot(struct vec3 p, const struct vec3s *near, size_t low, double reach)
{
    double x = 0, y = 0, n = (double)(near->n - low);

    for (size_t k = low; k < near->n; k++) {
        x += (near->item[k].x - p.x) / n;
        y += (near->item[k].y - p.y) / n;
    }
    double far = hypot(x, y);
    if (far < ASIDE * reach)
        return false;
    for (size_t k = 0; k < low; k++) {
        double u = near->item[k].x - p.x, v = near->item[k].y - p.y;
        if (x * u + y * v > AHEAD * far * hypot(u, v))
            return false;
    }
    return true;
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
                return is_foot(p, near, k, NEAR * spacing) ? high.z - p.z : 0;
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
        near.n = 0;
        kdtree_beside(s->tree, p, vec(p.x, p.y, s->top), NEAR * s->spacing[i], &near);
        qsort(near.item, near.n, sizeof *near.item, by_height);
        s->height[i] = wall_over(p, &near, s->spacing[i]);
    }
    array_free(&near);
}

void unseen_wall_find(const struct vec3 *point, const double *spacing, size_t n,
                      const struct kdtree *tree, int threads, double *height)
{
    struct search search = {point, spacing, box_around(point, n).high.z, tree, height};

    parallel_for(threads, n, find_walls, &search);
}
