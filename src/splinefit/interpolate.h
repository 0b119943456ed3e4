/*
 * interpolate - a pass as the cubic spline through all its points (Lai 1997; paper 1, fig 9).
 */
#ifndef CLOUDMILL_INTERPOLATE_H
#define CLOUDMILL_INTERPOLATE_H

#include "splinefit/splinefit.h"

/*
 * The curve of the third degree through the points of the reference, with a knot at each of them
 * (by its length) and continuous second derivatives everywhere: a pole for each point and two more.
 * Where the axis turns, the head's curve goes through the heads of all points, by the same rule.
 * The reference has at least 2 points, no two neighbours in one place.  Time O(n).
 */
struct bspline spline_through(const struct reference *reference, enum spline_ends ends);

#endif
