/*
 * params - parameter values for data points along a curve (paper 2, 2.3; Piegl and Tiller, The
 * NURBS Book, eqs 9.3 to 9.6).
 */
#ifndef CLOUDMILL_PARAMS_H
#define CLOUDMILL_PARAMS_H

#include <stddef.h>

enum params_method {
    PARAMS_UNIFORM,     /* equally spaced */
    PARAMS_CENTRIPETAL, /* by the square roots of the chords */
    PARAMS_CHORD        /* by the chords */
};

/*
 * Fills u[0..n-1], rising from 0 to 1, for n >= 2 points; chord[k] >= 0 is the distance from point
 * k to point k + 1.  Points that all lie in one place get uniform parameters.
 */
void params_fill(enum params_method method, const double *chord, size_t n, double *u);

#endif
