/*
 * deviation - paper 2's C1 and C2.
 */
#include "splinefit/deviation.h"

struct deviation deviation_of(const struct bspline *curve, const struct vec3 *pole,
                              const struct vec3 *point, const double *u, size_t n)
{
    struct deviation d = {0};
    double sum = 0;

    for (size_t k = 0; k < n; k++) {
        double off = vec_distance(point[k], bspline_at(curve, pole, u[k]));
        d.c1 = fmax(d.c1, off);
        sum += off * off;
    }
    for (size_t k = 0; k + 1 < n; k++) {
        struct vec3 middle = vec_mix(point[k], point[k + 1], 0.5);
        struct vec3 there = bspline_at(curve, pole, (u[k] + u[k + 1]) / 2);
        d.middle = fmax(d.middle, vec_distance(middle, there));
    }
    d.c2 = sqrt(sum) / (double)n;
    d.rms = sqrt(sum / (double)n);
    return d;
}
