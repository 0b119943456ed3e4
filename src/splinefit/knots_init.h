/*
 * knots_init - where the knots of a B-spline may stand before any of them moves, and which of them
 * it would miss least.
 */
#ifndef CLOUDMILL_KNOTS_INIT_H
#define CLOUDMILL_KNOTS_INIT_H

#include "curve/bspline.h"
#include "curve/reference.h"

/*
 * Where the knots of a curve may stand to begin with: from 0 to the length of the places, end knots
 * repeated degree + 1 times; knot[] has room for poles + degree + 1.
 *
 * _uniform: equally spaced.  _spread: by the fourth root of the fourth derivative (of the
 * derivative above `degree`), which is where a spline of least error has them; it is taken from a
 * least squares curve with twice as many knots; false when there are too few places for that.
 * _mean: moves knots half-way to the equally spaced ones.
 */
void knots_init_uniform(const struct reference *places, int degree, size_t poles, double *knot);
bool knots_init_spread(const struct reference *places, int degree, size_t poles, double *knot);
void knots_init_mean(const struct reference *places, int degree, size_t poles, double *knot);

/* About how far the curve would move without each of its inner knots, in their order, in no unit:
 * by the jump of the highest derivative there and the lengths of the spans at it. */
void knots_init_missed(const struct bspline *curve, double *missed);

#endif
