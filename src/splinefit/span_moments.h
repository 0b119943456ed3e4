/*
 * span_moments - the pulls of many places on one span of a curve, taken together.
 *
 * In a span all that acts is a polynomial in s: the curve moves with an unknown by sum_k c_k s^k.
 * So the places of a span need not be taken one by one: with the moments  S_m = sum s^m W  and
 * G_m = sum s^m g  over them, the normal equations' element of the unknowns c and e is
 * sum_kl c_k' S_(k+l) e_l, and the right-hand side's of c  -sum_k c_k' G_k.
 */
#ifndef CLOUDMILL_SPAN_MOMENTS_H
#define CLOUDMILL_SPAN_MOMENTS_H

#include "residual.h"

/* How many numbers the moments of a span are, for a curve of this degree and width (3 or 6). */
size_t span_moments_size(int degree, int width);

/* Adds a pull at the place s of the span. */
void span_moments_add(double *moments, int degree, int width, double s,
                      const struct residual *pull);

/* The polynomial  y_k = sum_l S_(k+l) c_l;  c and y by [power][component]. */
void span_moments_times(const double *moments, int degree, int width, const double *c, double *y);

/* The same for a pole's basis function b_0 .. b_degree, in all components at once:
 * T_l = sum_k b_k S_(k+l), full matrices t[power][component][component]. */
void span_moments_of_basis(const double *moments, int degree, int width, const double *b,
                           double *t);

/* G, by [power][component]. */
const double *span_moments_right(const double *moments, int degree, int width);

#endif
