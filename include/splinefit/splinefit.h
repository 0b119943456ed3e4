/*
 * splinefit - a pass as the B-spline with the fewest poles (control points) that keeps a tolerance.
 *
 * In: a reference (curve/reference.h; reference_distinct), the points of a cutting run between two
 * corners, and what the curve may be off it.  Out: a curve as it will be printed, and its distance
 * from the reference both ways.  Where the tool axis turns, a second curve, the head's, carries it.
 *
 * The stages (splinefit_search):
 *
 *   1. a straight line, where that serves
 *   2. spline_lsq.h    least squares with given parameters and knots, counts of poles upwards and
 *                      then by bisection (paper 2, 2.3 and 3; The NURBS Book, 9.4)
 *   3. free_knots.h    fewer poles: knots that move
 *        minimax.h       Gauss-Newton steps of poles and knots for p-norms rising towards the
 *                        largest distance
 *        footpoints.h    distances at the foot points and the normal equations' parts
 *      grown_knots.h  uneven data, or little time for each point: knots put in and taken out
 *   4. spline_bound.h  each candidate rounded to its printed digits and proven on them, as an upper
 *                      bound of the distance both ways
 *   5. a polyline with a pole at each point, where nothing else serves
 *
 * Beside it, as Lai (1997) has it, the curve through all points (splinefit_through; interpolate.h).
 *
 * spline_run.h drives this for a whole run: corners, dense data, the part kept clear of.
 *
 * Who spends what of the tolerance (bsplfit -e; E below):
 *
 *   constant           of   what for
 *   SPLINE_SPARSE      E    points whose straight lines are further than this off the smooth path
 *                           are made dense
 *   SPLINE_DENSE       E    dense points off the smooth path; taken from E before the fit
 *   SPLINE_RESOLUTION  what is left   of a proof by least squares: what its bound may hide
 *   SPLINE_RESOLUTION_FREE   what is left   the same with free knots
 *   SPLINE_RESOLUTION_GROWN  what is left   the same with knots that have grown
 *   SPLINE_MARGIN      what is left   kept by free knots for what the proof may find above it
 *   SPLINE_FALLBACK    E    straight pieces off the curve, for controls without splines; they do
 *                           not add to the curve's own distance in the ledger
 *   SPLINE_CORNER      E    a turn is a corner if it is one over so many tolerances, too
 */
#ifndef CLOUDMILL_SPLINEFIT_H
#define CLOUDMILL_SPLINEFIT_H

#include "curve/bspline.h"
#include "curve/reference.h"

#define SPLINE_SPARSE 1.0
#define SPLINE_DENSE 0.1
#define SPLINE_RESOLUTION 0.005
#define SPLINE_RESOLUTION_FREE 0.002
#define SPLINE_RESOLUTION_GROWN 0.01
#define SPLINE_MARGIN 0.001
#define SPLINE_FALLBACK 0.99
#define SPLINE_CORNER 10.0

enum params_method {
    PARAMS_UNIFORM,     /* equally spaced */
    PARAMS_CENTRIPETAL, /* by the square roots of the chords */
    PARAMS_CHORD        /* by the chords */
};

enum knots_method {
    KNOTS_UNIFORM, /* inner knots equally spaced */
    KNOTS_AVERAGE  /* inner knots follow the data: Piegl and Tiller eqs 9.68 and 9.69, so that each
                      span holds data; with as many poles as points their eq 9.8 */
};

/* What holds at both ends of a curve through all points. */
enum spline_ends {
    ENDS_NATURAL, /* no curvature: the second derivative is zero */
    ENDS_CLAMPED, /* the tangent of paper 1 for ends (run_tangents), as fast as the first chord */
    ENDS_BESSEL   /* the derivative of the parabola through the three points next to it */
};

/* How far a curve is from its data, by the measures of paper 2, at the data's own parameters. */
struct fit_error {
    double c1;     /* eq 7: largest |Q_k - C(u_k)|, mm */
    double c2;     /* eq 8 as it is printed: sqrt(sum |Q_k - C(u_k)|^2) / (m + 1), mm */
    double rms;    /* the root of the mean square, sqrt(sum / (m + 1)) = c2 sqrt(m + 1), mm */
    double middle; /* largest distance from the middle of two neighbouring points to the curve at
                      the middle of their parameters, mm */
};

struct splinefit_options {
    int degree;       /* 1 to BSPLINE_DEGREE_MAX, as a rule 3 */
    int params;       /* one enum params_method, or -1: all */
    int knots;        /* one enum knots_method, or -1: all */
    double tolerance; /* of the tracked point and the other one, mm */
    double angle;     /* of the axis, radians */
    double least;     /* mm: no knot span shorter, as long as the tolerance allows it; 0: any */
    double work;      /* share of the work that free knots may take on uneven data; 0: all of it */
    const struct doubles *moved; /* for splinefit_again: where the data is other than that of
                                    `before`, as pairs of places, parts of its length; NULL:
                                    anywhere */
};

enum splinefit_kind {
    SPLINEFIT_FITTED,   /* by least squares, with `params` and `knots` */
    SPLINEFIT_STRAIGHT, /* degree 1 with two poles */
    SPLINEFIT_POLYLINE, /* degree 1 with a pole at each point: nothing else served */
    SPLINEFIT_FREE,     /* with free knots (free_knots_search) */
    SPLINEFIT_GROWN,    /* with knots where the data asks for them (grown_knots_fit) */
    SPLINEFIT_THROUGH   /* through all points (splinefit_through) */
};

struct splinefit {
    struct bspline curve; /* as printed; its head NULL when the axis is fixed */
    enum splinefit_kind kind;
    enum params_method params;
    enum knots_method knots;
    struct fit_error deviation; /* of the tracked point, by the paper's measures */
    struct deviation proof;     /* distance both ways */
    bool within;                /* what the search promises holds */
    bool cut;                   /* it took too long: fewer poles might do */
};

/*
 * The six combinations of parameters (uniform, centripetal, by chord length) and knots (uniform,
 * average) are tried in the paper's order.
 *
 * As published: 5 poles, then 5 more each time, until a combination has C1 (eq 7) <= tolerance at
 * the tracked point - and, what a paper on 3 axes leaves open, at the other point; with
 * more poles than points, degree 1 with a pole at each.  `proof` tells what the distance both ways
 * is then; it may be more than the tolerance.  The reference has at least 2 points.
 */
void splinefit_paper(const struct reference *reference, const struct splinefit_options *options,
                     struct splinefit *fit);

/*
 * The default: a straight line; else what grown_knots_fit finds where that has many poles with few
 * points for each, for the data are uneven then and a search would end by its bound with more; and
 * with less than half of the usual `work` in any case, or the polyline; else what free_knots_search
 * finds, if it has fewer poles.  Where that finds nothing, where it was cut short and this is
 * better, and when `params` or `knots` are given: 5, 10, 15 ... poles
 * (from 40 on a quarter more each time) until a combination keeps the tolerance, then the
 * least count above the last that failed, by bisection.  Degree 1 with a pole at each point when
 * nothing else serves.
 */
void splinefit_search(const struct reference *reference, const struct splinefit_options *options,
                      struct splinefit *fit);

/*
 * The default for data that lies only a little beside that of `before`: the same curve, moved
 * (free_knots_again); where that does not serve, as splinefit_search.
 */
void splinefit_again(const struct reference *reference, const struct splinefit_options *options,
                     const struct splinefit *before, struct splinefit *fit);

/*
 * The cubic spline through all points, with continuous second derivatives.  `proof` and `within`
 * are its distance from `whole`: the same reference or the denser one that its points are part of.
 */
void splinefit_through(const struct reference *reference, const struct reference *whole,
                       const struct splinefit_options *options, enum spline_ends ends,
                       struct splinefit *fit);

void splinefit_free(struct splinefit *fit);

#endif
