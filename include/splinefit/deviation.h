/*
 * deviation - how far a curve is from its data, by the measures of paper 2, at the data's own
 * parameters.  (The true distance both ways is spline_bound.h's.)
 */
#ifndef CLOUDMILL_DEVIATION_H
#define CLOUDMILL_DEVIATION_H

#include "curve/bspline.h"

struct deviation {
    double c1;     /* eq 7: largest |Q_k - C(u_k)|, mm */
    double c2;     /* eq 8 as it is printed: sqrt(sum |Q_k - C(u_k)|^2) / (m + 1), mm */
    double rms;    /* the root of the mean square, sqrt(sum / (m + 1)) = c2 sqrt(m + 1), mm */
    double middle; /* largest distance from the middle of two neighbouring points to the curve at
                      the middle of their parameters, mm */
};

/* Of the curve with these poles from the n = m + 1 points with the parameters u, in the range of
 * the curve's knots. */
struct deviation deviation_of(const struct bspline *curve, const struct vec3 *pole,
                              const struct vec3 *point, const double *u, size_t n);

#endif
