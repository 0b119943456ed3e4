/*
 * free_knots - the search for the B-spline with the fewest poles that keeps a tolerance, its knots
 * free to move.
 *
 * Counts of poles are tried one after the other.  Each starts from knots_init_*, is moved by
 * minimax.h on a few places of the reference, then on more, and is proven on its printed digits
 * (spline_bound.h).
 */
#ifndef CLOUDMILL_FREE_KNOTS_H
#define CLOUDMILL_FREE_KNOTS_H

#include "curve/bspline.h"
#include "curve/reference.h"

struct free_knots_options {
    int degree;
    double tolerance;            /* mm */
    double angle;                /* of the axis, radians */
    size_t known;                /* poles with which the tolerance is known to be kept; 0: none */
    double work;                 /* share of the work that uneven data may take; 0: all of it */
    double least;                /* mm: no knot span shorter; 0: any */
    const struct doubles *moved; /* as in splinefit_options; for grown_knots.h alone */
};

struct free_knots_result {
    struct bspline curve; /* no poles: none was found */
    struct deviation proof;
    bool cut; /* the bound on the work was reached: fewer poles might do */
};

/*
 * Counts of poles are tried upwards from the least there is, each from several starts: a knot more
 * where the last curve was worst, knots equally spaced, spread by the fourth root of the fourth
 * derivative, their mean; from ONE_BY_ONE poles on a quarter more each time, and then by bisection.
 * From the curve found, each knot in turn is tried to be left out.
 *
 * A curve serves when it keeps the tolerance on its printed digits.  None is found when none with
 * at most FEW poles, or a pole for every ROUGH_POINTS points, does.  Where a known count above FEW
 * has fewer than UNEVEN_KNOWN points for each pole, so that the curve follows the noise of the
 * data, the counts go down from there, to three fifths each time, and then by bisection, from knots
 * spread by the data alone.  The work is bounded by the number of points, and sooner in such a
 * case.
 */
struct free_knots_result free_knots_search(const struct reference *reference,
                                           const struct free_knots_options *options);

/*
 * From a curve of the same degree, with a head or without, that was found for nearly the same data:
 * it is moved to where the data is now, if need be with a few knots more where it is worst.  Finds
 * nothing when that does not serve; the search is what is left then.
 */
struct free_knots_result free_knots_again(const struct reference *reference,
                                          const struct free_knots_options *options,
                                          const struct bspline *before);

#endif
