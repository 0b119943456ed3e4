/*
 * minimax - a B-spline's poles and inner knots moved until its largest distance from a target is
 * small enough, or as small as it gets.
 */
#ifndef CLOUDMILL_MINIMAX_H
#define CLOUDMILL_MINIMAX_H

#include "footpoints.h"

/* A curve and the feet of a target on it. */
struct attempt {
    struct bspline curve;
    struct footpoints feet;
};

/* Least squares on these knots (0 to the target's length, of which the attempt gets a copy), with
 * the places at the parameters u.  False when the places do not determine the poles. */
bool attempt_start(const struct target *target, const struct bspline *form, const double *knot,
                   const double *u, struct attempt *attempt);

struct attempt attempt_copy(const struct attempt *attempt, const struct target *target);
void attempt_free(struct attempt *attempt);

/* The same curve with the feet of another target of the same track, still to be followed; the
 * worst place stays.*/
struct attempt attempt_onto(const struct attempt *attempt, const struct target *from,
                            const struct target *to);

/*
 * Levenberg's and Marquardt's steps for the sum of the distances to the power 2, 4, 8 ... 64, until
 * no place asks for more than `goal` mm (true).  False as soon as that is out of reach: the
 * distances' mean by the norm is never above the largest one, so that a minimum of it above `goal`
 * is the end of it.  Each step takes its number of distances from *effort; false when that is used
 * up. More patience than 1 takes that many times the steps.
 */
bool minimax_fit(const struct target *target, double goal, int patience, struct attempt *attempt,
                 double *effort);

#endif
