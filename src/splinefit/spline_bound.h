/*
 * spline_bound - a spline as it will be printed, and how far it is from the data it stands for.
 */
#ifndef CLOUDMILL_SPLINE_BOUND_H
#define CLOUDMILL_SPLINE_BOUND_H

#include "curve/bspline.h"
#include "curve/reference.h"

enum { SPLINE_BOUND_DIGITS = 6 }; /* decimals of poles and knots in the path stream */

/*
 * Scales the knots so that they run from 0 to the curve's length in mm, and rounds knots and poles
 * to the printed digits; the head's poles stand over the curve's along what is 0 in all axes of
 * the reference, so that the curve's axes have no other.  False when a pole is not finite or inner
 * knots that were apart fall into one (the curve is too short for its poles).
 */
bool spline_bound_print(struct bspline *curve, const struct reference *reference);

/*
 * Fills *proof with upper bounds of the distances both ways between the curve and the reference.
 * They exceed the truth by at most 2.2 times `resolution` mm; when the distance of a point is found
 * to be above `limit` (INFINITY: never), the search stops there: that
 * distance is then only known to be above the limit, and what comes later is INFINITY.
 */
void spline_bound_measure(const struct bspline *curve, const struct reference *reference,
                          double resolution, double limit, struct deviation *proof);

/* The same when the curve is the data's polyline itself, with a pole and a knot at each point. */
void spline_bound_polyline(const struct bspline *curve, const struct reference *reference,
                           struct deviation *proof);

/*
 * Fills u[reference->n], rising, with the parameters of the places of the curve that are nearest to
 * the reference's points.  False when the curve cannot be flattened (flatten.h).
 */
bool spline_bound_feet(const struct bspline *curve, const struct reference *reference,
                       double resolution, double *u);

/*
 * A quick look first: true when the curve at the parameters u of some of the data is further than
 * `tolerance` from the data's polyline, so that it cannot keep it.
 */
bool spline_bound_hopeless(const struct bspline *curve, const struct reference *reference,
                           const double *u, double tolerance);

#endif
