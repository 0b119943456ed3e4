/*
 * splinefit - the search for the B-spline with the fewest poles that keeps a tolerance, by least
 * squares over parametrisations and knot vectors (paper 2, 2.3 and 3).
 *
 * The six combinations are tried in the paper's order: parameters uniform, centripetal, by chord
 * length, each with knots uniform, then average.  Everything is judged on the printed digits.
 */
#ifndef CLOUDMILL_SPLINEFIT_H
#define CLOUDMILL_SPLINEFIT_H

#include "splinefit/deviation.h"
#include "splinefit/knots.h"
#include "splinefit/params.h"
#include "splinefit/spline_bound.h"
#include "splinefit/track.h"

struct splinefit_options {
    int degree;       /* 1 to BSPLINE_DEGREE_MAX, as a rule 3 */
    int params;       /* one enum params_method, or -1: all */
    int knots;        /* one enum knots_method, or -1: all */
    double tolerance; /* mm */
    double angle;     /* of the axis, radians */
};

enum splinefit_kind {
    SPLINEFIT_FITTED,   /* by least squares, with `params` and `knots` */
    SPLINEFIT_STRAIGHT, /* degree 1 with two poles */
    SPLINEFIT_POLYLINE, /* degree 1 with a pole at each point: nothing else served */
    SPLINEFIT_FREE      /* with free knots (free_knots_search) */
};

struct splinefit {
    struct bspline curve; /* as printed; its head NULL when the axis is fixed */
    enum splinefit_kind kind;
    enum params_method params;
    enum knots_method knots;
    struct deviation deviation; /* of the tracked point, by the paper's measures */
    struct spline_bound proof;  /* distance both ways */
    bool within;                /* what the search promises holds */
    bool cut;                   /* it took too long: fewer poles might do */
};

/*
 * As published: 5 poles, then 5 more each time, until a combination has C1 (eq 7) <= tolerance at
 * the tracked point - and, what a paper on 3 axes leaves open, at the other end of the radius; with
 * more poles than points, degree 1 with a pole at each.  `proof` tells what the distance both ways
 * is then; it may be more than the tolerance.  The track has at least 2 points.
 */
void splinefit_paper(const struct track *track, const struct splinefit_options *options,
                     struct splinefit *fit);

/*
 * The default: a straight line; else what free_knots_search finds.  Where that finds nothing, where
 * it was cut short and this is better, and when `params` or `knots` are given: 5, 10, 15 ... poles
 * (from 40 on a quarter more each time) until spline_bound_keeps holds for a combination, then the
 * least count above the last that failed, by bisection.  Degree 1 with a pole at each point when
 * nothing else serves.
 */
void splinefit_search(const struct track *track, const struct splinefit_options *options,
                      struct splinefit *fit);

/*
 * The default for data that lies only a little beside that of `before`: the same curve, moved
 * (free_knots_again); where that does not serve, as splinefit_search.
 */
void splinefit_again(const struct track *track, const struct splinefit_options *options,
                     const struct splinefit *before, struct splinefit *fit);

void splinefit_free(struct splinefit *fit);

#endif
