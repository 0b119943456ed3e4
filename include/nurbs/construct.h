/*
 * construct - curves and surfaces of other kinds as NURBS, exactly.
 *
 * Lines, conics, polynomial splines; surfaces of extrusion, of revolution, ruled ones, planes
 * (Piegl and Tiller, The NURBS Book, chapters 7 and 8).  Lengths as they come, angles in radians.
 * The caller frees what is returned (nurbs_free, nurbs_curve_free).
 */
#ifndef CLOUDMILL_CONSTRUCT_H
#define CLOUDMILL_CONSTRUCT_H

#include "math/transform.h"
#include "nurbs/nurbs.h"

/* The straight line from a to b, over 0 to 1. */
struct nurbs_curve construct_line(struct vec3 a, struct vec3 b);

/* n >= 2 points joined by straight lines, over 0 to 1. */
struct nurbs_curve construct_polyline(const struct vec3 *point, size_t n);

/* Part of the ellipse (a cos t, b sin t) in the plane of x and y of the place, from < to, at most
 * one turn, counter-clockwise.  Its knots are angles, so that its parameter is t at every knot. */
struct nurbs_curve construct_ellipse(const struct transform *place, double a, double b, double from,
                                     double to);

/* Part of the hyperbola (a cosh t, b sinh t), of the parabola (a t^2, 2 a t). */
struct nurbs_curve construct_hyperbola(const struct transform *place, double a, double b,
                                       double from, double to);
struct nurbs_curve construct_parabola(const struct transform *place, double a, double from,
                                      double to);

/*
 * A piecewise polynomial surface of degree 3 over m x n patches, breakpoints u[0..m] and v[0..n]:
 * coordinate k of patch (i, j) is the sum of c[48 * (i * n + j) + 16 * k + 4 * q + p] s^p t^q, with
 * s = u - u[i] and t = v - v[j].
 */
struct nurbs construct_spline_surface(const double *u, size_t m, const double *v, size_t n,
                                      const double *c);

/* The same of a curve over n pieces, breakpoints t[0..n]: coordinate k of piece i is the sum of
 * c[12 * i + 4 * k + p] s^p with s = t - t[i]. */
struct nurbs_curve construct_spline_curve(const double *t, size_t n, const double *c);

/* Greville abscissa i of an axis: the mean of the inner knots of its basis function. */
double construct_greville(const struct nurbs_axis *axis, size_t i);

/* The poles of the spline with these values at the Greville abscissae.  The caller frees them. */
struct nurbs_pole *construct_interpolation(const struct nurbs_axis *axis, const struct vec3 *value);

/* The curve over its range alone, with clamped knots, of a degree not below its own; `inner`,
 * rising, are further knots that it gets at least (or NULL). */
struct nurbs_curve construct_refined(const struct nurbs_curve *c, int degree, const double *inner,
                                     size_t n);

/* n curves, each beginning where the one before it ends, as one over 0 to n, with a kink, or what
 * may be one, at every joint. */
struct nurbs_curve construct_joined(const struct nurbs_curve *c, size_t n);

/* The curve over the range 0 to 1, with clamped knots. */
struct nurbs_curve construct_unit_range(const struct nurbs_curve *c);

/* The curve moved along `by`: u along the curve, v over 0 to 1. */
struct nurbs construct_extrusion(const struct nurbs_curve *c, struct vec3 by);

/* The curve turned about the axis (unit) through `at`, counter-clockwise from angle `from` to `to`,
 * at most one turn: u is the angle (at every knot), v runs along the curve.  An end of the curve
 * within 1e-7 of its width of the axis is put onto it: a pole, not a hole. */
struct nurbs construct_revolution(const struct nurbs_curve *c, struct vec3 at, struct vec3 axis,
                                  double from, double to);

/* Straight lines between places of two curves at the same part of their ranges: u along the curves,
 * v from the first (0) to the second (1). */
struct nurbs construct_ruled(const struct nurbs_curve *a, const struct nurbs_curve *b);

/* The rectangle x0..x1, y0..y1 in the plane of x and y of the place: u is x, v is y. */
struct nurbs construct_plane(const struct transform *place, double x0, double x1, double y0,
                             double y1);

/* The place with these axes: x is made perpendicular to z; where it is parallel to it, or zero, a
 * perpendicular direction is taken. */
struct transform construct_place(struct vec3 at, struct vec3 z, struct vec3 x);

/* Poles moved by an affine map. */
void construct_move(const struct transform *t, struct nurbs_pole *pole, size_t n);

#endif
