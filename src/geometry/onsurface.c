#include "onsurface.h"

#include <stdlib.h>

#include "array.h"
#include "kdtree.h"

enum { ACROSS = 64, NEAREST = 8, STEPS = 30 };

/* How far a point on a border may be beyond it, mm: a mesh stream has 6 decimals. */
static const double BEYOND = 1e-5;

/* A place of the grid from which a search begins. */
struct seed {
    int surface;
    struct uv at;
};

struct onsurface {
    const struct patches *patches;
    struct {
        size_t n, cap;
        struct seed *item;
    } seed;
    struct kdtree *tree;
};

struct onsurface *onsurface_new(const struct patches *patches)
{
    struct onsurface *on = mem_alloc(1, sizeof *on);
    struct vec3s points = {0};

    on->patches = patches;
    for (size_t k = 0; k < patches->n; k++) {
        const struct nurbs *s = &patches->item[k].surface;
        for (int i = 0; i <= ACROSS; i++) {
            for (int j = 0; j <= ACROSS; j++) {
                struct uv at = {s->u.from + (s->u.to - s->u.from) * i / ACROSS,
                                s->v.from + (s->v.to - s->v.from) * j / ACROSS};
                *array_push(&on->seed) = (struct seed){(int)k, at};
                *array_push(&points) = nurbs_point(s, at);
            }
        }
    }
    on->tree = kdtree_new(points.item, points.n);
    array_free(&points);
    return on;
}

void onsurface_free(struct onsurface *on)
{
    if (!on)
        return;
    kdtree_free(on->tree);
    array_free(&on->seed);
    free(on);
}

static double clamp(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

/* Newton's method for the place whose point lies level with p along both directions; what is left
 * of the two, mm. */
static double search(const struct nurbs *s, struct vec3 p, struct vec3 a, struct vec3 b,
                     struct uv *at)
{
    double left = HUGE_VAL;

    for (int i = 0; i < STEPS; i++) {
        struct vec3 d[3][3];
        nurbs_derivatives(s, *at, 1, d);
        struct vec3 off = vec_sub(p, d[0][0]);
        double fa = vec_dot(off, a), fb = vec_dot(off, b);
        double ua = vec_dot(d[1][0], a), va = vec_dot(d[0][1], a);
        double ub = vec_dot(d[1][0], b), vb = vec_dot(d[0][1], b);
        double det = ua * vb - va * ub;
        left = hypot(fa, fb);
        if (left < 1e-11 || det == 0)
            break;
        at->u = clamp(at->u + (fa * vb - va * fb) / det, s->u.from, s->u.to);
        at->v = clamp(at->v + (ua * fb - ub * fa) / det, s->v.from, s->v.to);
    }
    return left;
}

int onsurface_put(const struct onsurface *on, struct vec3 plane, double reach,
                  struct contact *contact)
{
    struct vec3 course = vec_unit(vec_cross(plane, contact->n)), p = contact->p, n = contact->n;
    size_t nearest[NEAREST];
    size_t found = kdtree_nearest(on->tree, p, NEAREST, nearest, NULL);
    int best = -1;

    for (size_t i = 0; i < found && vec_length(course) > 0; i++) {
        const struct seed *seed = &on->seed.item[nearest[i]];
        const struct nurbs *s = &on->patches->item[seed->surface].surface;
        struct uv at = seed->at;
        if (best == seed->surface || search(s, p, plane, course, &at) > BEYOND)
            continue;
        struct nurbs_place place = nurbs_place(s, at);
        double away = vec_distance(place.point, p), agree = vec_dot(place.normal, n);
        if (away > reach || fabs(agree) < 0.7)
            continue;
        reach = away;
        best = seed->surface;
        /* On the plane to the last bit, whatever is left of the search. */
        contact->p = vec_along(place.point, vec_dot(vec_sub(p, place.point), plane), plane);
        contact->n = vec_scale(agree < 0 ? -1 : 1, place.normal);
    }
    return best;
}
