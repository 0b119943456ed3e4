/*
 * ncspline - a B-spline as the words of its blocks, checked as they will be read back.
 */
#ifndef CLOUDMILL_NCSPLINE_H
#define CLOUDMILL_NCSPLINE_H

#include "post/ncpoly.h"

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
 * Words for the whole spline motion from a station as printed; *to is where it ends, as printed.  A
 * curve of a higher degree than the control knows becomes a cubic beside it (cubic_form.h).
 * False where the control cannot be given it within `allowed` (its degree, its axis, its digits);
 * nothing then needs freeing.  *d: the deviation of what is printed from the motion.
 */
bool nc_spline_words(struct nc_spline *spline, enum nc_splines kind, struct nc_spline_digits digits,
                     const struct interpolation *f, const struct block_pose *from,
                     const struct motion *motion, struct pose_deviation allowed,
                     struct block_pose *to, struct pose_deviation *d);

void nc_spline_free(struct nc_spline *spline);

#endif
