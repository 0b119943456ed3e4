/*
 * knots - knot vectors for the approximation of data points (paper 2, 2.3).
 */
#ifndef CLOUDMILL_KNOTS_H
#define CLOUDMILL_KNOTS_H

#include <stddef.h>

enum knots_method {
    KNOTS_UNIFORM, /* inner knots equally spaced */
    KNOTS_AVERAGE  /* inner knots follow the data: Piegl and Tiller eqs 9.68 and 9.69, so that each
                      span holds data; with as many poles as points their eq 9.8 */
};

/*
 * Fills knot[0 .. poles + degree], from 0 to 1, end knots repeated degree + 1 times.  u[n] are the
 * points' parameters from 0 to 1; degree + 1 <= poles <= n.
 */
void knots_fill(enum knots_method method, const double *u, size_t n, int degree, size_t poles,
                double *knot);

#endif
