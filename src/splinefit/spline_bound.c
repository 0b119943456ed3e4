/*
 * spline_bound - printed digits, and distances both ways.
 */
#include "spline_bound.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "curve/flatten.h"
#include "curve/polyline.h"

/* Length of the curve by 8 chords in each span. */
static double length_of(const struct bspline *curve)
{
    enum { CHORDS = 8 };
    double length = 0;
    struct vec3 before = curve->pole[0];

    for (size_t span = (size_t)curve->degree; span < curve->poles; span++) {
        double from = curve->knot[span], width = curve->knot[span + 1] - from;
        for (int k = 1; width > 0 && k <= CHORDS; k++) {
            struct vec3 here = bspline_at(curve, curve->pole, from + width * k / CHORDS);
            length += vec_distance(before, here);
            before = here;
        }
    }
    return length;
}

static struct vec3 printed_point(struct vec3 p)
{
    return vec_round(p, SPLINE_BOUND_DIGITS);
}

/* A motion that only turns the axis has no length of its own: 1 mm then. */
static bool print_knots(struct bspline *curve)
{
    double length = length_of(curve), from = curve->knot[0];
    double scale = (length > 1e-3 ? length : 1) / (curve->knot[curve->poles] - from);

    if (!isfinite(scale))
        return false;
    double before = from;
    for (size_t i = 0; i < curve->poles + (size_t)curve->degree + 1; i++) {
        double knot = curve->knot[i];
        curve->knot[i] = num_round((knot - from) * scale, SPLINE_BOUND_DIGITS);
        if (i > 0 && curve->degree == 1 && knot > before) /* a pole at each: keep them apart */
            curve->knot[i] =
                fmax(curve->knot[i], num_round(curve->knot[i - 1] + 1e-6, SPLINE_BOUND_DIGITS));
        else if (i > 0 && curve->degree == 1)
            curve->knot[i] = curve->knot[i - 1];
        else if (knot > before && !(curve->knot[i] > curve->knot[i - 1]))
            return false;
        before = knot;
    }
    return true;
}

bool spline_bound_print(struct bspline *curve, const struct reference *reference)
{
    for (size_t i = 0; i < curve->poles; i++) {
        if (!isfinite(vec_dot(curve->pole[i], curve->pole[i])))
            return false;
        if (curve->head != NULL && !isfinite(vec_dot(curve->head[i], curve->head[i])))
            return false;
    }
    if (!print_knots(curve))
        return false;
    for (size_t i = 0; i < curve->poles; i++) {
        curve->pole[i] = printed_point(curve->pole[i]);
        if (curve->head != NULL)
            curve->head[i] =
                printed_point(reference_flat(reference, curve->head[i], curve->pole[i]));
    }
    return true;
}

/* The largest distance both ways, with what the flattening may hide; feet of the curve's vertices.
 */
static double both_ways(struct polyline curve, struct polyline data, double limit, double hidden,
                        struct foot *foot)
{
    double slack = hidden / 5;
    double there = polyline_distance(curve, data, limit - hidden, slack, foot);
    if (there + hidden > limit)
        return there + hidden;
    return fmax(there, polyline_distance(data, curve, limit - hidden, slack, NULL)) + hidden;
}

/* Largest angle between the curve's axis and the data's at the foot points. */
static double axis_angle(const struct flat *flat, const struct reference *reference,
                         const struct foot *foot)
{
    double worst = 0;

    for (size_t i = 0; i < flat->axis.n; i++) {
        size_t j = foot[i].segment, next = j + 1 < reference->n ? j + 1 : j;
        struct vec3 a = vec_mix(reference->axis[j], reference->axis[next], foot[i].t);
        worst = fmax(worst, vec_angle(flat->axis.item[i], a));
    }
    return worst;
}

static void measure_flat(const struct flat *flat, const struct reference *reference, double hidden,
                         double limit, struct deviation *proof)
{
    struct foot *foot = mem_alloc(2 * flat->u.n, sizeof *foot), *other_foot = foot + flat->u.n;
    struct polyline mine = {flat->point.n, flat->point.item},
                    data = {reference->n, reference->point};

    proof->point = both_ways(mine, data, limit, hidden, foot);
    if (!reference->turns) { /* the other point only runs beside */
        proof->other = proof->point;
        proof->axis = 0;
    } else if (proof->point <= limit) {
        struct polyline other = {flat->other.n, flat->other.item};
        struct polyline data_other = {reference->n, reference->other};
        proof->other = both_ways(other, data_other, limit, hidden, other_foot);
        if (proof->other <= limit)
            proof->axis = axis_angle(flat, reference, reference->other_leads ? other_foot : foot);
    }
    free(foot);
}

void spline_bound_measure(const struct bspline *curve, const struct reference *reference,
                          double resolution, double limit, struct deviation *proof)
{
    struct flat flat = {0};

    *proof = (struct deviation){INFINITY, INFINITY, INFINITY};
    if (flatten(curve, reference->offset, reference->axis[0], resolution, &flat))
        measure_flat(&flat, reference, resolution, limit, proof);
    flat_free(&flat);
}

bool spline_bound_feet(const struct bspline *curve, const struct reference *reference,
                       double resolution, double *u)
{
    struct flat flat = {0};
    bool done = flatten(curve, reference->offset, reference->axis[0], resolution, &flat);

    if (done) {
        struct foot *foot = mem_alloc(reference->n, sizeof *foot);
        struct polyline data = {reference->n, reference->point},
                        mine = {flat.point.n, flat.point.item};
        polyline_distance(data, mine, INFINITY, resolution, foot);
        for (size_t k = 0; k < reference->n; k++) {
            const double *at = &flat.u.item[foot[k].segment];
            u[k] = foot[k].segment + 1 < flat.u.n ? at[0] + foot[k].t * (at[1] - at[0]) : at[0];
        }
        free(foot);
    }
    flat_free(&flat);
    return done;
}

/* Point k + s of the way to the next one, of the curve against the reference. */
static void compare_at(const struct bspline *curve, const struct reference *reference, size_t k,
                       double s, struct deviation *proof)
{
    size_t next = k + 1 < reference->n ? k + 1 : k;
    struct vec3 p = vec_mix(curve->pole[k], curve->pole[next], s), a = reference->axis[0];

    if (curve->head != NULL)
        a = vec_unit(vec_sub(vec_mix(curve->head[k], curve->head[next], s), p));
    struct vec3 other = vec_along(p, reference->offset, a);
    struct vec3 there = vec_mix(reference->point[k], reference->point[next], s);
    struct vec3 other_there = vec_mix(reference->other[k], reference->other[next], s);
    struct vec3 axis_there = vec_mix(reference->axis[k], reference->axis[next], s);

    proof->point = fmax(proof->point, vec_distance(p, there));
    proof->other = fmax(proof->other, vec_distance(other, other_there));
    proof->axis = fmax(proof->axis, vec_angle(a, axis_there));
}

void spline_bound_polyline(const struct bspline *curve, const struct reference *reference,
                           struct deviation *proof)
{
    enum { PARTS = 4 };

    *proof = (struct deviation){0};
    for (size_t k = 0; k < reference->n; k++)
        for (int i = 0; i < PARTS; i++)
            compare_at(curve, reference, k, (double)i / PARTS, proof);
}

/* Point k is farther from the curve than the tolerance at its parameter, and the curve there from
 * all data beside it. */
static bool is_off_at(const struct bspline *curve, const struct reference *reference, size_t k,
                      double u, double tolerance, struct polyline_feet *data)
{
    struct vec3 p = bspline_at(curve, curve->pole, u);
    double step = vec_distance(p, reference->point[k]);

    if (step <= tolerance)
        return false;
    size_t segment = k + 1 < reference->n ? k : k - 1;
    struct foot at = {segment, k + 1 < reference->n ? 0 : 1, 0};
    return polyline_foot(data, at, step, p).distance > tolerance;
}

bool spline_bound_hopeless(const struct bspline *curve, const struct reference *reference,
                           const double *u, double tolerance)
{
    struct polyline_feet data = polyline_feet_on((struct polyline){reference->n, reference->point});
    bool off = false;

    for (size_t stride = 61; stride > 0 && !off; stride /= 61)
        for (size_t k = stride / 2; k < reference->n && !off; k += stride)
            off = is_off_at(curve, reference, k, u[k], tolerance, &data);
    polyline_feet_free(&data);
    return off;
}
