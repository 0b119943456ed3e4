/*
 * ppform - a B-spline as one polynomial for each span, and how it moves with its knots.
 *
 * The polynomials are in s, from -1 at the span's start to 1 at its end.  A value has 3 components,
 * those of the point, or 6 with the head's behind them.
 */
#ifndef CLOUDMILL_PPFORM_H
#define CLOUDMILL_PPFORM_H

#include "curve/bspline.h"

struct ppform {
    int degree, width; /* width: components, 3 or 6 */
    size_t spans;
    const double *knot; /* of the curve: span i is from knot[degree + i] to knot[degree + i + 1] */
    double *curve;      /* [span][power 0..degree][component] */
    double *basis;      /* [span][function 0..degree][power] */
    double *slope;      /* [span][knot 0..2 degree - 1][power][component] */
};

/* For a curve of so many poles, still without values. */
struct ppform ppform_new(const struct bspline *curve);
void ppform_free(struct ppform *form);

/* Fills `curve` alone from knots and poles; no span may be empty. */
void ppform_curve(struct ppform *form, const struct bspline *b);

/*
 * Fills `basis` and `slope`, the derivatives of the curve by the knots i + 1 .. i + 2 degree that
 * act in span i:  dC/dt_j = - sum N^_i (P_i - P_(i-1)) / (t_(i+p) - t_i),  i = j - p .. j, where
 * N^ are the basis functions of the knots with t_j doubled.  (The divided difference whose
 * derivative by a node is the one with that node doubled.)
 */
void ppform_slopes(struct ppform *form, const struct bspline *b);

/* The span of u, looked for from the span `near`. */
size_t ppform_span(const struct ppform *form, size_t near, double u);

/* Half of its length, and the s of u in it. */
double ppform_half(const struct ppform *form, size_t span);
double ppform_place(const struct ppform *form, size_t span, double u);

/* Value, first and second derivative at u in the span, each of `width` components. */
void ppform_at(const struct ppform *form, size_t span, double u, double *value, double *first,
               double *second);

#endif
