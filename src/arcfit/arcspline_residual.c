/* arcspline_residual - see arcspline_residual.h. */
#include "arcspline_residual.h"

#include <stdlib.h>

static const double BLUNT = 0.05; /* cosine of half a turn: more of a turn is taken as its chord */

/* Two unit vectors across the way of a chain of points at point k. */
static void across(const struct vec3 *p, size_t n, size_t k, struct vec3 *u, struct vec3 *v)
{
    size_t before = k > 0 ? k - 1 : k, after = k + 1 < n ? k + 1 : k;
    struct vec3 t = vec_unit(vec_sub(p[after], p[before]));
    if (vec_dot(t, t) < 0.5)
        t = vec(1, 0, 0);
    *u = vec_perpendicular(t);
    *v = vec_cross(t, *u);
}

struct passing passing_of(const struct trace *trace, size_t from, size_t to, size_t most)
{
    size_t inner = to > from + 1 ? to - from - 1 : 0, n = inner < most ? inner : most;
    struct passing passing = {.n = n, .item = mem_alloc(n, sizeof *passing.item)};
    for (size_t i = 0; i < n; i++) {
        size_t k = from + 1 + (2 * i + 1) * inner / (2 * n);
        struct passed *at = &passing.item[i];
        at->p = trace->p[k];
        at->other = trace->other[k];
        across(trace->p, trace->n, k, &at->u, &at->v);
        across(trace->other, trace->n, k, &at->s, &at->w);
    }
    return passing;
}

void passing_free(struct passing *passing)
{
    free(passing->item);
    *passing = (struct passing){0};
}

/* A point of the arc between two joints; see arcspline_residual_slope. */
static struct vec3 conic(const struct joint *from, const struct joint *to, double b)
{
    struct vec3 e = vec_sub(to->p, from->p);
    double ahead = vec_dot(e, from->tangent), l = vec_length(e), c = l > 0 ? ahead / l : 0;
    if (c < BLUNT)
        return vec_along(from->p, b, e);
    double middle = 2 * b * (1 - b) * c, end = b * b, sum = (1 - b) * (1 - b) + middle + end;
    struct vec3 p = vec_along(from->p, middle * l / (2 * c * sum), from->tangent);
    return vec_along(p, end / sum, e);
}

/* The axis at a place between two joints: nearly on the great circle, and cheap. */
static struct vec3 axis_between(const struct joint *from, const struct joint *to, double part)
{
    return vec_unit(vec_mix(from->axis, to->axis, part));
}

static bool behind(const struct joint *joint, struct vec3 p)
{
    return vec_dot(vec_sub(p, joint->p), joint->tangent) > 0;
}

/* Where the arc passes the point. */
static void pass(const struct arcspline *chain, const struct arc *arc, double lever,
                 struct passed *q)
{
    const struct joint *from = &chain->joint[q->arc], *to = from + 1;
    q->part = arc_foot(arc, q->p);
    double a = sin(q->part * arc->angle / 2), b = sin((1 - q->part) * arc->angle / 2);
    q->bend = a + b > 0 ? a / (a + b) : q->part;
    q->at = conic(from, to, q->bend);
    if (lever != 0)
        q->axis = axis_between(from, to, q->part);
}

void arcspline_residual(const struct arcspline *chain, double lever, struct passing *passing,
                        double *off)
{
    size_t k = 0;
    struct arc arc = arcspline_arc(chain, k);
    double *other = off + 2 * passing->n;
    for (size_t i = 0; i < passing->n; i++) {
        struct passed *q = &passing->item[i];
        size_t before = k;
        while (k + 1 < chain->n && behind(&chain->joint[k + 1], q->p))
            k++;
        if (k > before)
            arc = arcspline_arc(chain, k);
        q->arc = k;
        pass(chain, &arc, lever, q);
        struct vec3 at = arc_at(&arc, q->part), d = vec_sub(q->p, at);
        off[2 * i] = vec_dot(d, q->u);
        off[2 * i + 1] = vec_dot(d, q->v);
        if (lever == 0)
            continue;
        struct vec3 axis = vec_slerp(chain->joint[k].axis, chain->joint[k + 1].axis, q->part);
        d = vec_sub(q->other, vec_along(at, lever, axis));
        other[2 * i] = vec_dot(d, q->s);
        other[2 * i + 1] = vec_dot(d, q->w);
    }
}

void arcspline_residual_slope(const struct arcspline *moved, double lever,
                              const struct passing *passing, size_t from, size_t to, double by,
                              double *slope)
{
    double *other = slope + 2 * passing->n, part = -1 / by;
    for (size_t i = from; i < to; i++) {
        const struct passed *q = &passing->item[i];
        const struct joint *a = &moved->joint[q->arc], *b = a + 1;
        struct vec3 d = vec_sub(conic(a, b, q->bend), q->at);
        slope[2 * i] = part * vec_dot(d, q->u);
        slope[2 * i + 1] = part * vec_dot(d, q->v);
        if (lever == 0)
            continue;
        d = vec_along(d, lever, vec_sub(axis_between(a, b, q->part), q->axis));
        other[2 * i] = part * vec_dot(d, q->s);
        other[2 * i + 1] = part * vec_dot(d, q->w);
    }
}

size_t passing_first(const struct passing *passing, size_t arc)
{
    size_t lo = 0, hi = passing->n;
    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (passing->item[middle].arc < arc)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}
