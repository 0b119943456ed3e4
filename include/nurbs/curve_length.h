/*
 * curve_length - how long a NURBS curve is up to a place, and the place at a length.
 *
 * Three points of Gauss in each of some parts of every span; the way back by Newton's method within
 * a part, which the speed does not let go astray.  Lengths as the poles come.
 */
#ifndef CLOUDMILL_CURVE_LENGTH_H
#define CLOUDMILL_CURVE_LENGTH_H

#include "nurbs/nurbs.h"

/* The lengths at n + 1 places at[0..n], rising, of a curve that must stay. */
struct curve_length {
    const struct nurbs_curve *curve;
    size_t n;
    double *at, *length;
};

/* The caller frees it (curve_length_free). */
struct curve_length curve_length(const struct nurbs_curve *c);

/* The length from the beginning of the range to parameter t. */
double curve_length_to(const struct curve_length *l, double t);

/* The parameter where the curve is that long; the ends of the range for lengths beyond it. */
double curve_length_at(const struct curve_length *l, double length);

void curve_length_free(struct curve_length *l);

#endif
