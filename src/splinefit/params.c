/*
 * params - the three parametrisations of paper 2.
 */
#include "splinefit/params.h"

#include <math.h>

static double step(enum params_method method, double chord)
{
    switch (method) {
    case PARAMS_CENTRIPETAL:
        return sqrt(chord);
    case PARAMS_CHORD:
        return chord;
    default:
        return 1;
    }
}

void params_fill(enum params_method method, const double *chord, size_t n, double *u)
{
    double sum = 0;

    u[0] = 0;
    for (size_t k = 1; k < n; k++) {
        sum += step(method, chord[k - 1]);
        u[k] = sum;
    }
    if (!(sum > 0)) {
        params_fill(PARAMS_UNIFORM, chord, n, u);
        return;
    }
    for (size_t k = 1; k < n; k++)
        u[k] /= sum;
    u[n - 1] = 1;
}
