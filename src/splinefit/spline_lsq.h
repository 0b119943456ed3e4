/*
 * spline_lsq - B-splines of a reference by least squares (paper 2, 2.3; Piegl and Tiller, The NURBS
 * Book, 9.2 and 9.4): parameters of the points, knots, poles, and the paper's measures of the
 * error.
 */
#ifndef CLOUDMILL_SPLINE_LSQ_H
#define CLOUDMILL_SPLINE_LSQ_H

#include "splinefit/splinefit.h"

/* A curve carries the tool axis by a second one, the head's, at this distance along the axis, mm.
 */
enum { HEAD_LENGTH = 100 };

/* The head at point k of the reference; at all points, for the caller to free. */
static inline struct vec3 spline_head(const struct reference *reference, size_t k)
{
    return vec_along(reference->point[k], HEAD_LENGTH, reference->axis[k]);
}

struct vec3 *spline_heads(const struct reference *reference);

/* A new curve, with a head when the axis turns, its knots and poles still zero. */
struct bspline spline_new(const struct reference *reference, int degree, size_t poles);

/* Degree 1 from the first point to the last, with knots 0 and 1. */
struct bspline spline_straight(const struct reference *reference);

/* Degree 1 through all points, with knots at the lengths of the reference. */
struct bspline spline_polyline(const struct reference *reference);

/*
 * Fills u[0..n-1], rising from 0 to 1, for n >= 2 points (The NURBS Book, eqs 9.3 to 9.6);
 * chord[k] >= 0 is the distance from point k to point k + 1.  Points that all lie in one place get
 * uniform parameters.
 */
void params_fill(enum params_method method, const double *chord, size_t n, double *u);

/*
 * Fills knot[0 .. poles + degree], from 0 to 1, end knots repeated degree + 1 times.  u[n] are the
 * points' parameters from 0 to 1; degree + 1 <= poles <= n.
 */
void knots_fill(enum knots_method method, const double *u, size_t n, int degree, size_t poles,
                double *knot);

/*
 * Finds the poles of `curve` (its degree, number of poles and knots are given) so that the sum of
 * squares |C(u[k]) - point[k]|^2 over the n points is the least, with the first and the last pole
 * on the first and the last point.  Where the curve has a head, its poles are found the same way
 * from head[k]; else `head` may be NULL.  Time O(n degree^2).
 * False when the points do not determine the poles (spans without data: the condition of Schoenberg
 * and Whitney), or when there are more poles than points.
 */
bool lsq_fit(struct bspline *curve, const double *u, const struct vec3 *point,
             const struct vec3 *head, size_t n);

/* Of the curve with these poles from the n = m + 1 points with the parameters u, in the range of
 * the curve's knots. */
struct fit_error fit_error_of(const struct bspline *curve, const struct vec3 *pole,
                              const struct vec3 *point, const double *u, size_t n);

#endif
