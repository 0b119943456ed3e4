/*
 * bspline - B-spline curves: evaluation, knots, exact conversions.
 *
 * A curve of degree p with n poles has n + p + 1 knots in rising order; here the end knots are
 * always repeated p + 1 times (clamped), so that the curve starts and ends on its end poles.
 * de Boor's algorithm and the basis functions are those of Piegl and Tiller, The NURBS Book,
 * A2.1 to A2.3; knot insertion is Boehm's (A5.1).
 */
#ifndef CLOUDMILL_BSPLINE_H
#define CLOUDMILL_BSPLINE_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

enum { BSPLINE_DEGREE_MAX = 9 };

struct bspline {
    int degree;
    size_t poles;
    double *knot;      /* poles + degree + 1 */
    struct vec3 *pole; /* of the tracked point, mm */
    struct vec3
        *head;     /* of head = tip + length * axis on the same knots; NULL: the axis is fixed */
    double length; /* distance from the tip to the head, mm */
};

struct bspline bspline_new(int degree, size_t poles, bool with_head);
struct bspline bspline_copy(const struct bspline *b);
void bspline_free(struct bspline *b);

/* The span i with knot[i] <= u < knot[i+1] (the last one that is not empty at the end). */
size_t bspline_span(int degree, size_t poles, const double *knot, double u);

/* The same, for parameters one after the other: quick where it is span `from` or soon after it. */
size_t bspline_span_from(int degree, size_t poles, const double *knot, double u, size_t from);

/* The degree + 1 basis functions that are not zero in the span, at u. */
void bspline_basis(int degree, const double *knot, size_t span, double u, double *value);

/* The same with derivatives up to `order`: value[d * (degree + 1) + i]. */
void bspline_basis_derivatives(int degree, const double *knot, size_t span, double u, int order,
                               double *value);

/* Point at u, of the poles or of any other set of poles on the curve's knots. */
struct vec3 bspline_at(const struct bspline *b, const struct vec3 *pole, double u);

/* The point and the head at u, of a curve that has one. */
void bspline_both_at(const struct bspline *b, double u, struct vec3 *point, struct vec3 *head);

/* Point and its first `order` derivatives: result[0..order]. */
void bspline_derivatives(const struct bspline *b, const struct vec3 *pole, double u, int order,
                         struct vec3 *result);

/* How far the curve's places at knot i and at the next one are apart, mm. */
double bspline_span_length(const struct bspline *b, size_t i);

/* Some of its spans are shorter than `least` mm. */
bool bspline_has_short_span(const struct bspline *b, double least);

/* A knot more at u, strictly inside; the curve stays as it is. */
void bspline_insert(struct bspline *b, double u);

/* The part of the curve from u0 to u1 as a curve of its own, on the same parameters.  Within 1e-12
 * of the range a knot is meant. */
struct bspline bspline_part(const struct bspline *b, double u0, double u1);

/* True when the inner knots are simple and equally spaced, within 1e-9 of the whole range or 1e-6,
 * the last digit of a printed knot. */
bool bspline_uniform(const struct bspline *b);

#endif
