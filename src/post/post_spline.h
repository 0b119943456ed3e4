/*
 * post_spline - a B-spline as the words of its blocks, checked as they will be read back.
 *
 * As a polynomial for each knot span: a span is its Taylor polynomial at its start, so any curve
 * whose degree the control knows goes over exactly, whatever its knots.  Or as knots and poles.
 */
#ifndef CLOUDMILL_POST_SPLINE_H
#define CLOUDMILL_POST_SPLINE_H

#include "base/array.h"
#include "machine/interpolation.h"

enum {
    NC_POLY_DEGREE = 5, /* the highest that POLY knows */
    NC_POLY_WIDTH = 460 /* a block has 512 characters, with its number, PL and F */
};

/* One knot span as a polynomial in p, 0 to h: its end, and the factors of p^2, p^3 and so on (that
 * of p follows from both ends). */
struct nc_span {
    double h;
    int digits; /* of the factors */
    struct vec3 end, factor[NC_POLY_DEGREE - 1];
    struct vec3 head_end, head_factor[NC_POLY_DEGREE - 1];
};

struct nc_spans {
    size_t n, cap;
    struct nc_span *item;
};

/* Factors that are printed for a curve of a degree: PO[X]=(end,a2,a3) at least. */
static inline int nc_poly_factors(int degree)
{
    return degree > 3 ? degree - 1 : 2;
}

/* The spans of a curve, in the digits that will be printed; false: one of them is shorter than the
 * digits can say, or so short that its factors have more than nine before the point. */
bool nc_poly_words(struct nc_spans *spans, const struct bspline *b, int digits);

/* Characters of the words of the widest span, with those of the head when it `turns`. */
size_t nc_poly_width(const struct nc_spans *spans, int degree, bool turns, int digits);

/*
 * The printed polynomials, those of the head from `head` on, against a motion on the curve's
 * parameters, which need not be the curve.  Each span that is beyond `allowed` adds its middle to
 * `more`.
 */
struct pose_deviation nc_poly_deviation(const struct nc_spans *spans, const struct bspline *b,
                                        const struct interpolation *f, struct vec3 start,
                                        struct vec3 head, const struct motion *motion,
                                        struct pose_deviation allowed, struct doubles *more);

/* What splines a control can be given. */
enum nc_splines {
    NC_SPLINES_NONE,
    NC_SPLINES_ROTARY, /* NURBS by knots and poles, rotary words as poles too: G06.2 */
    NC_SPLINES_HEAD    /* polynomials, or uniform B-splines; a second curve for the head: POLY */
};

struct nc_spline {
    enum { NC_NURBS, NC_POLY, NC_BSPLINE } form;
    bool turns;                /* rotary words (NURBS), a head curve (POLY, BSPLINE) */
    struct vec3 head_start;    /* POLY, BSPLINE: where the head curve begins */
    struct bspline curve;      /* NURBS, BSPLINE: knots and poles as printed, head likewise */
    double *angle[ROTARY_MAX]; /* NURBS: poles of the rotary words, degrees, as printed */
    struct nc_spans span;      /* POLY */
    int degree;                /* POLY: of its polynomials */
};

struct nc_spline_digits {
    int linear, angle, knot;
};

/*
 * Words for the whole spline motion from a block's end as printed; *to is where it ends, as
 * printed.  A curve of a higher degree than the control knows becomes a cubic beside it
 * (cubic_form.h). False where the control cannot be given it within `allowed` (its degree, its
 * axis, its digits); nothing then needs freeing.  *d: the deviation of what is printed from the
 * motion.
 */
bool nc_spline_words(struct nc_spline *spline, enum nc_splines kind, struct nc_spline_digits digits,
                     const struct interpolation *f, const struct block_pose *from,
                     const struct motion *motion, struct pose_deviation allowed,
                     struct block_pose *to, struct pose_deviation *d);

void nc_spline_free(struct nc_spline *spline);

/* The tool at s in [0, 1] of a curve as printed that begins at the tip `start`, where its tool axis
 * turns with a head. */
struct pose nc_spline_at(const struct nc_spline *spline, struct vec3 start, double s);

/* Where the span that begins at s ends; those of polynomials count the same. */
double nc_spline_next(const struct nc_spline *spline, double s);

#endif
