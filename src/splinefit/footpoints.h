/*
 * footpoints - how far the places of a reference are off a B-spline, and what each of them asks of
 * its poles and knots.
 *
 *   struct ppform      the curve as one polynomial for each span, and how it moves with its knots
 *   struct footpoints  the feet of the places on the curve, followed while the curve moves
 *   struct residual    the quadratic form of one place at its foot
 *   span_moments_*     the residuals of all places on one span, taken together
 *
 * minimax.h sets up the normal equations with them.
 */
#ifndef CLOUDMILL_FOOTPOINTS_H
#define CLOUDMILL_FOOTPOINTS_H

#include "curve/bspline.h"
#include "curve/reference.h"

/*
 * The polynomials are in s, from -1 at the span's start to 1 at its end.  A value has 3 components,
 * those of the point, or 6 with the head's after them.
 */
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

/* The span of u, searched from the span `near`. */
size_t ppform_span(const struct ppform *form, size_t near, double u);

/* Half of its length, and the s of u in it. */
double ppform_half(const struct ppform *form, size_t span);
double ppform_place(const struct ppform *form, size_t span, double u);

/* Value, first and second derivative at u in the span, each of `width` components. */
void ppform_at(const struct ppform *form, size_t span, double u, double *value, double *first,
               double *second);

enum { FOOTPOINT_KINDS = 3 };

/* The curve at a foot. */
struct footpoint {
    size_t span;
    double u;
    struct vec3 off;   /* from the place to the curve, mm */
    struct vec3 along; /* unit: its direction */
    struct vec3 axis;  /* unit, with a turning axis only */
    double reach;      /* and from the point to the head, mm */
};

struct footpoints {
    struct deviation within; /* what may be off: with a turning axis its angle counts as its
                                distance */
    double *u;               /* of the tracked point */
    double *v;               /* of the other point; NULL with a fixed axis */
    double *off; /* for each place, FOOTPOINT_KINDS (with a fixed axis 1) in turn: distance of the
                    point, distance of the other one, angle of the axis in the measure of `within`,
                    mm */
    struct footpoint *point, *other; /* at u and v, as they were last followed to */
    double worst;                    /* the largest of `off`, mm */
    size_t where;                    /* and its place */
};

/* How many distances each place has. */
size_t footpoints_kinds(const struct reference *places);

struct footpoints footpoints_new(const struct reference *places, const struct deviation *within);
void footpoints_free(struct footpoints *feet);

/* Copies where the feet stand, u and v, and the largest distance; not what is to be found there. */
void footpoints_copy(struct footpoints *to, const struct footpoints *from,
                     const struct reference *places);

/*
 * Newton's steps from the feet as they are (at most half a span each, so that no foot jumps to
 * another branch; until they are small against the distance), then the distances.
 */
void footpoints_follow(const struct ppform *form, const struct reference *places,
                       struct footpoints *feet);

/*
 * What one place asks of the curve at its foot is the quadratic form  x' W x / 2 + g' x,  where x
 * says how the curve moves there: its point, and with a turning axis its head after it.  off is the
 * distance, and what shall become small is the sum of off^power.  Moving a foot along the curve
 * changes nothing of the first order, so that only what is perpendicular to the curve counts; with
 * d the direction of the distance  W = off^(power - 2) (I + (power - 2) dd'),  perpendicular to the
 * curve.
 */
enum { RESIDUAL_WIDTH = 6, RESIDUAL_SIZE = RESIDUAL_WIDTH * (RESIDUAL_WIDTH + 1) / 2 };

/* W's element (i, j), j <= i, stands at i (i + 1) / 2 + j: the point's own are the first six. */
struct residual {
    double w[RESIDUAL_SIZE], g[RESIDUAL_WIDTH];
};

/* Where element (i, j) stands, whichever of the two is larger. */
static inline int residual_at(int i, int j)
{
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
}

/*
 * Of place k at the foot of the tracked point, or with `other` at that of the other point; the axis
 * counts at the one that leads (reference.h).  Distances count in parts of the worst one.
 */
void residual_of(const struct reference *places, const struct footpoints *feet, size_t k,
                 bool other, int power, struct residual *residual);

/*
 * In a span all that acts is a polynomial in s: the curve moves with an unknown by sum_k c_k s^k.
 * So the places of a span need not be taken one by one: with the moments  S_m = sum s^m W  and
 * G_m = sum s^m g  over them, the normal equations' element of the unknowns c and e is
 * sum_kl c_k' S_(k+l) e_l, and the right-hand side's of c  -sum_k c_k' G_k.
 */

/* How many numbers the moments of a span are, for a curve of this degree and width (3 or 6). */
size_t span_moments_size(int degree, int width);

/* Adds a residual at the place s of the span. */
void span_moments_add(double *moments, int degree, int width, double s,
                      const struct residual *residual);

/* The polynomial  y_k = sum_l S_(k+l) c_l;  c and y by [power][component]. */
void span_moments_times(const double *moments, int degree, int width, const double *c, double *y);

/* The same for a pole's basis function b_0 .. b_degree, in all components at once:
 * T_l = sum_k b_k S_(k+l), full matrices t[power][component][component]. */
void span_moments_of_basis(const double *moments, int degree, int width, const double *b,
                           double *t);

/* G, by [power][component]. */
const double *span_moments_right(const double *moments, int degree, int width);

#endif
