/*
 * pnorm - the sum of a high power of many distances, and the step of the unknowns that makes it
 * less.
 *
 * A distance is a pair (x, y) of numbers, d^2 = x^2 + y^2; a point has one pair or two.  The sum of
 * (d / scale)^(2 half), plus the squares of three numbers `held`, is minimized as least squares of
 * the vectors (d / scale)^half in the direction of the pair (Gauss and Newton).
 */
#ifndef CLOUDMILL_PNORM_H
#define CLOUDMILL_PNORM_H

#include <stdbool.h>
#include <stddef.h>

#include "math/band.h"

struct pnorm {
    size_t points, pairs, unknowns;
    double *off; /* the pairs: those of all points, then the second ones; 2 * pairs */
    double held[3];
    double *weighed; /* 2 * pairs, of pnorm_equations */
    struct pnorm_column {
        size_t from, to; /* points that change with this unknown */
        double held[3];  /* how `held` does */
        double *slope;   /* how off does: 2 * pairs, looked at for those points alone */
    } * column;          /* one for each unknown */
    double *slopes;      /* where they lie */
    struct band normal;
    double *right;
};

/* `twice`: two pairs a point.  The caller sets off, held and the columns. */
struct pnorm pnorm_new(size_t points, bool twice, size_t unknowns);
void pnorm_free(struct pnorm *sum);

/* The sum for these pairs and held numbers. */
double pnorm_cost(const struct pnorm *sum, const double *off, const double held[3], int half,
                  double scale);

/* Sets the normal equations for a step from `off` and `held`: normal * step = right.  The slopes
 * become those of the powers. */
void pnorm_equations(struct pnorm *sum, int half, double scale);

#endif
