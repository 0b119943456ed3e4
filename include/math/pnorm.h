/*
 * pnorm - the sum of a high power of many distances as a sum of squares.
 *
 * A distance is a pair (x, y) of numbers, d^2 = x^2 + y^2.  The sum of (d / scale)^(2 half), plus
 * the squares of three numbers `held`, is minimized as least squares of the vectors
 * (d / scale)^half in the direction of the pair (Gauss and Newton).
 */
#ifndef CLOUDMILL_PNORM_H
#define CLOUDMILL_PNORM_H

#include <stddef.h>

/* The sum for these pairs (x0, y0, x1, y1 ...) and held numbers. */
double pnorm_cost(const double *off, size_t pairs, const double held[3], int half, double scale);

/* The vector of a pair; it changes with the pair by (xx dx + xy dy, xy dx + yy dy). */
struct pnorm_vector {
    double x, y;
    double xx, xy, yy;
};

struct pnorm_vector pnorm_vector_of(double x, double y, int half, double scale);

#endif
