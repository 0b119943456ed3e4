/*
 * knots_try - curves with knots that move, tried one after the other: fitted, printed, proven.
 */
#ifndef CLOUDMILL_KNOTS_TRY_H
#define CLOUDMILL_KNOTS_TRY_H

#include "free_knots.h"
#include "minimax.h"

/* What the trials on one track share, and the best of what they came to. */
struct knots_trials {
    const struct track *track;
    const struct free_knots_options *options;
    struct target rough;   /* few places: most trials fail on them already */
    struct target fine;    /* and more, to be nearly sure before a proof */
    struct attempt failed; /* of the last count that did not serve the nearest to it, on `rough` */
    struct attempt served; /* the least count that did, as it was before printing, on `rough` */
    struct bspline curve;  /* and as printed; no poles as long as none did */
    struct spline_bound proof;
    double *knot;  /* room for those of a start */
    size_t parts;  /* places of `rough`, about */
    bool coarse;   /* a curve that kept the tolerance at the places did not keep it between */
    int patience;  /* of minimax_fit */
    double effort; /* distances times steps that may still be spent */
};

/* With at least `parts` places and enough of them for so many poles; all found so far is kept, but
 * `failed`. */
void knots_trials_aim(struct knots_trials *t, size_t parts, size_t poles);

/* Before any trial: as few places as tell for curves of at most so many poles. */
void knots_trials_aim_few(struct knots_trials *t, size_t poles);

/* Frees all but the curve. */
void knots_trials_free(struct knots_trials *t);

/*
 * Fits the attempt, on `rough` and then on `fine`, and proves it on the printed digits; if need be
 * it is moved on, to a smaller distance.  True when it serves; `served`, `curve` and `proof` are
 * its then.  Takes the attempt, whatever comes of it.
 */
bool knots_try_serves(struct knots_trials *t, struct attempt *attempt);

/* The same from the knots t->knot, by least squares with the places of `rough` at u. */
bool knots_try_from_knots(struct knots_trials *t, size_t poles, const double *u);

/* The same from a curve that was fitted to nearly the same data. */
bool knots_try_from_curve(struct knots_trials *t, const struct bspline *before);

/* The same for the curve of `from` without its knot j. */
bool knots_try_without(struct knots_trials *t, const struct attempt *from, size_t j);

/* A copy with a knot more where it is worst; the curve is the same. */
struct attempt knots_try_one_more(const struct knots_trials *t, const struct attempt *from);

#endif
