/*
 * lsq - B-spline curves by least squares with both ends fixed (paper 2, eqs 5 and 6; Piegl and
 * Tiller, The NURBS Book, eqs 9.63 to 9.67).
 */
#ifndef CLOUDMILL_LSQ_H
#define CLOUDMILL_LSQ_H

#include "curve/bspline.h"

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

#endif
