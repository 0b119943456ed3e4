/*
 * knots_init - where the knots of a curve may stand to begin with.
 *
 * Knots run from 0 to the length of the target, end knots repeated degree + 1 times; knot[] has
 * room for poles + degree + 1.
 */
#ifndef CLOUDMILL_KNOTS_INIT_H
#define CLOUDMILL_KNOTS_INIT_H

#include "curve/bspline.h"
#include "target.h"

/* Equally spaced. */
void knots_init_uniform(const struct target *target, int degree, size_t poles, double *knot);

/*
 * Spread by the fourth root of the fourth derivative (of the derivative above `degree`), which is
 * where a spline of least error has them.  It is taken from a least squares curve with twice as
 * many knots; false when the target has too few places for that.
 */
bool knots_init_spread(const struct target *target, int degree, size_t poles, double *knot);

/* Moves knots half-way to the equally spaced ones. */
void knots_init_mean(const struct target *target, int degree, size_t poles, double *knot);

/* About how far the curve would move without its inner knot j, in no unit: by the jump of the
 * highest derivative there and the lengths of the spans at it. */
double knots_init_missed(const struct bspline *curve, size_t j);

#endif
