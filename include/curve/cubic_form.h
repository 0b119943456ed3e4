/*
 * cubic_form - a B-spline of any degree as a cubic one beside it, for controls that know no other.
 *
 * Each pole is the blossom of the curve's Taylor polynomial of the third degree at its Greville
 * parameter (de Boor and Fix, Spline approximation by quasiinterpolants, 1973): a curve that is a
 * cubic on these knots comes out as it is, any other within O(h^4) of its knot spans h.
 */
#ifndef CLOUDMILL_CUBIC_FORM_H
#define CLOUDMILL_CUBIC_FORM_H

#include "curve/bspline.h"

/*
 * On the same parameters, with the same ends; head as well where the curve has one.  It has the
 * knots of the curve, each as often as the curve is less smooth there than a cubic would be, and
 * the n knots of `more`, once each, in any order, inside and none of the curve's own.
 */
struct bspline cubic_form(const struct bspline *b, const double *more, size_t n);

#endif
