/*
 * free_knots - the search for the B-spline with the fewest poles that keeps a tolerance, its knots
 * free to move.
 */
#ifndef CLOUDMILL_FREE_KNOTS_H
#define CLOUDMILL_FREE_KNOTS_H

#include "splinefit/spline_bound.h"
#include "splinefit/track.h"

struct free_knots_options {
    int degree;
    double tolerance; /* mm */
    double angle;     /* of the axis, radians */
    size_t known;     /* poles with which the tolerance is known to be kept; 0: none */
};

/*
 * Counts of poles are tried upwards from the least there is, each from several starts: a knot more
 * where the last curve was worst, knots equally spaced, spread by the fourth root of the fourth
 * derivative, their mean; from 12 poles on a quarter more each time, and then by bisection.  From
 * the curve found, each knot in turn is tried to be left out.
 * A curve serves when spline_bound_keeps holds on its printed digits; true then, with *curve and
 * its *proof.  False when none with at most 16 poles, or a pole for every fourth point, does. Where
 * a known count above 16 has fewer than twelve points for each pole, so that the curve follows the
 * noise of the data, the counts go down from there, to three fifths each time, and then by
 * bisection, from knots spread by the data alone. The work is bounded by the number of points, and
 * sooner in such a case; *cut tells that the bound was reached, so that fewer poles might do.
 */
bool free_knots_search(const struct track *track, const struct free_knots_options *options,
                       struct bspline *curve, struct spline_bound *proof, bool *cut);

/*
 * From a curve of the same degree, with a head or without, that was found for nearly the same data:
 * it is moved to where the data is now, if need be with a few knots more where it is worst.  False
 * when that does not serve; the search is what is left then.
 */
bool free_knots_again(const struct track *track, const struct free_knots_options *options,
                      const struct bspline *before, struct bspline *curve,
                      struct spline_bound *proof);

#endif
