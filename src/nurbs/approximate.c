/* approximate - see approximate.h. */
#include "nurbs/approximate.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box.h"
#include "nurbs/construct.h"

enum { CUBIC = 3 };

/* Clamped cubic knots: `parts` equal spans between neighbours of at[0..n], which are kinks where
 * `kink` says so (NULL: all of them). */
static struct nurbs_axis cubic_axis(const double *at, size_t n, size_t parts, const bool *kink)
{
    struct doubles knot = {0};
    for (int k = 0; k < CUBIC; k++)
        *array_push(&knot) = at[0];
    for (size_t i = 0; i < n; i++) {
        int times = i == 0 ? 1 : !kink || kink[i] ? CUBIC : 1;
        for (int k = 0; k < times; k++)
            *array_push(&knot) = at[i];
        for (size_t p = 1; p < parts; p++)
            *array_push(&knot) = at[i] + (at[i + 1] - at[i]) * (double)p / (double)parts;
    }
    for (int k = 0; k <= CUBIC; k++)
        *array_push(&knot) = at[n];
    return (struct nurbs_axis){CUBIC, knot.n - CUBIC - 1, knot.item, at[0], at[n]};
}

struct nurbs_curve approximate_curve(approximate_curve_fn *f, const void *context, const double *at,
                                     size_t n, double tolerance, double *error)
{
    enum { FIRST = 4 };
    struct nurbs_curve c = {{0}, NULL};
    double worst = HUGE_VAL;
    for (size_t parts = FIRST;
         worst > tolerance && (parts == FIRST || n * parts <= APPROXIMATE_MOST); parts *= 2) {
        nurbs_curve_free(&c);
        c.t = cubic_axis(at, n, parts, NULL);
        struct vec3 *value = mem_alloc(c.t.poles, sizeof *value);
        for (size_t i = 0; i < c.t.poles; i++)
            value[i] = f(context, construct_greville(&c.t, i));
        c.pole = construct_interpolation(&c.t, value);
        free(value);
        worst = 0;
        for (size_t i = 0; i + 1 < c.t.poles; i++) {
            double t = (construct_greville(&c.t, i) + construct_greville(&c.t, i + 1)) / 2;
            worst = fmax(worst, vec_distance(f(context, t), nurbs_curve_point(&c, t)));
        }
    }
    if (error)
        *error = worst;
    return c;
}

/* The distinct knots in the range, and which of them are kinks. */
static void knots_of(const struct nurbs_axis *a, struct doubles *at, bool **kink)
{
    double *breaks;
    size_t n = nurbs_axis_breaks(a, NULL, 0);
    breaks = mem_alloc(n + 1, sizeof *breaks);
    nurbs_axis_breaks(a, breaks, n);
    *array_push(at) = a->from;
    for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++)
        if (a->knot[i] > at->item[at->n - 1] && a->knot[i] < a->to)
            *array_push(at) = a->knot[i];
    *array_push(at) = a->to;
    *kink = mem_alloc(at->n, sizeof **kink);
    for (size_t i = 0; i < at->n; i++)
        for (size_t k = 0; k < n; k++)
            (*kink)[i] = (*kink)[i] || !(at->item[i] < breaks[k] || at->item[i] > breaks[k]);
    free(breaks);
}

static struct vec3 offset_point(const struct nurbs *s, struct uv at, double distance)
{
    struct nurbs_place p = nurbs_place(s, at);
    return vec_along(p.point, distance, p.normal);
}

/* Interpolates at the Greville abscissae: rows along u first, then columns along v. */
static void interpolate_offset(const struct nurbs *s, double distance, struct nurbs *to)
{
    size_t nu = to->u.poles, nv = to->v.poles;
    struct vec3 *value = mem_alloc(nu > nv ? nu : nv, sizeof *value);
    to->pole = mem_alloc(nu * nv, sizeof *to->pole);
    for (size_t j = 0; j < nv; j++) {
        for (size_t i = 0; i < nu; i++) {
            struct uv at = {construct_greville(&to->u, i), construct_greville(&to->v, j)};
            value[i] = offset_point(s, at, distance);
        }
        struct nurbs_pole *row = construct_interpolation(&to->u, value);
        for (size_t i = 0; i < nu; i++)
            to->pole[j * nu + i] = row[i];
        free(row);
    }
    for (size_t i = 0; i < nu; i++) {
        for (size_t j = 0; j < nv; j++) {
            struct nurbs_pole p = to->pole[j * nu + i];
            value[j] = vec(p.wx, p.wy, p.wz);
        }
        struct nurbs_pole *column = construct_interpolation(&to->v, value);
        for (size_t j = 0; j < nv; j++)
            to->pole[j * nu + i] = column[j];
        free(column);
    }
    free(value);
}

/* The largest difference in the middles between the abscissae of u, of v, of both. */
static double offset_error(const struct nurbs *s, double distance, const struct nurbs *to)
{
    double worst = 0;
    for (size_t j = 0; j + 1 < to->v.poles; j++) {
        double v = construct_greville(&to->v, j), next_v = construct_greville(&to->v, j + 1);
        for (size_t i = 0; i + 1 < to->u.poles; i++) {
            double u = construct_greville(&to->u, i), next_u = construct_greville(&to->u, i + 1);
            struct uv at = {(u + next_u) / 2, (v + next_v) / 2};
            worst = fmax(worst, vec_distance(offset_point(s, at, distance), nurbs_point(to, at)));
        }
    }
    return worst;
}

static double size_of(const struct nurbs *s)
{
    struct box box = box_empty();
    for (size_t i = 0; i < s->u.poles * s->v.poles; i++)
        box_add(&box,
                vec_scale(1 / s->pole[i].w, vec(s->pole[i].wx, s->pole[i].wy, s->pole[i].wz)));
    return box_diagonal(&box);
}

struct nurbs approximate_offset(const struct nurbs *s, double distance, double *error)
{
    double tolerance = APPROXIMATE_OFFSET * size_of(s);
    struct nurbs to = {0};
    struct doubles u = {0}, v = {0};
    bool *kink_u, *kink_v;
    double worst = HUGE_VAL;
    bool last = false;
    knots_of(&s->u, &u, &kink_u);
    knots_of(&s->v, &v, &kink_v);
    for (size_t parts = 2; worst > tolerance && !last; parts *= 2) {
        last = 2 * parts * (u.n - 1) > APPROXIMATE_MOST_2 ||
               2 * parts * (v.n - 1) > APPROXIMATE_MOST_2;
        nurbs_free(&to);
        to.u = cubic_axis(u.item, u.n - 1, parts, kink_u);
        to.v = cubic_axis(v.item, v.n - 1, parts, kink_v);
        interpolate_offset(s, distance, &to);
        worst = offset_error(s, distance, &to);
    }
    if (error)
        *error = worst;
    array_free(&u);
    array_free(&v);
    free(kink_u);
    free(kink_v);
    return to;
}
