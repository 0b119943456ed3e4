/* project - see project.h. */
#include "nurbs/project.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/kdtree.h"
#include "trim_loops.h"

/* Starts of searches: samples of each surface in each direction, and of these the nearest ones. */
enum { ACROSS = 64, NEAREST = 8, STEPS = 30 };

/* How far a point on a border may be beyond it, mm: a mesh stream has 6 decimals. */
static const double BEYOND = 1e-5;

/* A place of the grid from which a search begins. */
struct seed {
    int surface;
    struct uv at;
};

struct projection {
    const struct patches *patches;
    struct uv_polygon *loops; /* [patch] what trims it */
    double slack;
    struct {
        size_t n, cap;
        struct seed *item;
    } seed;
    struct kdtree *tree;
};

/* Loops are followed to a fifth of the slack. */
static struct uv_polygon *loops_of(const struct patches *patches, double slack)
{
    struct uv_polygon *loops = mem_alloc(patches->n + 1, sizeof *loops);

    for (size_t k = 0; k < patches->n; k++)
        trim_loops(&patches->item[k], slack / 5, &loops[k]);
    return loops;
}

struct projection *project_new(const struct patches *patches, double slack)
{
    struct projection *on = mem_alloc(1, sizeof *on);
    struct vec3s points = {0};

    on->patches = patches;
    on->slack = slack;
    on->loops = loops_of(patches, slack);
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

void project_free(struct projection *on)
{
    if (!on)
        return;
    for (size_t k = 0; k < on->patches->n; k++)
        uv_polygon_free(&on->loops[k]);
    free(on->loops);
    kdtree_free(on->tree);
    array_free(&on->seed);
    free(on);
}

static double clamp(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

/* Newton's method for the place whose point differs from p along neither of two directions; returns
 * what is left of the difference, mm. */
static double search_along(const struct nurbs *s, struct vec3 p, struct vec3 a, struct vec3 b,
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

/* How far a place is outside the trimming of its surface, mm: 0 inside. */
static double distance_outside(const struct projection *on, int k, struct uv at)
{
    const struct uv_polygon *loops = &on->loops[k];
    struct vec3 d[3][3];
    double least = HUGE_VAL;

    if (loops->n == 0 || uv_polygon_inside(loops, on->patches->item[k].open || loops->open, at))
        return 0;
    nurbs_derivatives(&on->patches->item[k].surface, at, 1, d);
    for (size_t i = 0; i < loops->n; i++) {
        const struct uvs *loop = &loops->item[i];
        for (size_t m = 0; m < loop->n; m++) {
            struct uv a = loop->item[m], b = loop->item[(m + 1) % loop->n];
            struct vec3 p = vec_along(vec_scale(a.u - at.u, d[1][0]), a.v - at.v, d[0][1]);
            struct vec3 side = vec_along(vec_scale(b.u - a.u, d[1][0]), b.v - a.v, d[0][1]);
            double l = vec_dot(side, side), t = l > 0 ? -vec_dot(p, side) / l : 0;
            least = fmin(least, vec_length(vec_along(p, clamp(t, 0, 1), side)));
        }
    }
    return least;
}

int project_contact(const struct projection *on, struct vec3 plane, double reach,
                    struct contact *contact)
{
    struct vec3 along = vec_unit(vec_cross(plane, contact->n)), p = contact->p, n = contact->n;
    size_t nearest[NEAREST];
    size_t found = kdtree_nearest(on->tree, p, NEAREST, nearest, NULL);
    int best = -1;

    for (size_t i = 0; i < found && vec_length(along) > 0; i++) {
        const struct seed *seed = &on->seed.item[nearest[i]];
        const struct nurbs *s = &on->patches->item[seed->surface].surface;
        struct uv at = seed->at;
        if (best == seed->surface || search_along(s, p, plane, along, &at) > BEYOND)
            continue;
        struct nurbs_place place = nurbs_place(s, at);
        double away = vec_distance(place.point, p), agree = vec_dot(place.normal, n);
        if (away > reach || fabs(agree) < 0.7)
            continue;
        double beyond = distance_outside(on, seed->surface, at);
        if (beyond > on->slack || away + beyond > reach)
            continue;
        away += beyond; /* points inside the trimming come first */
        reach = away;
        best = seed->surface;
        /* On the plane to the last bit, whatever is left of the search. */
        contact->p = vec_along(place.point, vec_dot(vec_sub(p, place.point), plane), plane);
        contact->n = vec_scale(agree < 0 ? -1 : 1, place.normal);
    }
    return best;
}
