/*
 * post_feed - how fast a block may be: the time that the machine's axes need for it.
 *
 * Under tool-centre-point control F is the tip's, while slides and rotary axes have to follow:
 * where the tool turns about a tip that hardly moves, or works far from a rotary centre, they are
 * the ones that say how fast it can be.
 */
#ifndef CLOUDMILL_POST_FEED_H
#define CLOUDMILL_POST_FEED_H

#include "post_planner.h"

/* What a block that is not straight follows: a motion from s0 to s1. */
struct nc_along {
    const struct motion *motion;
    double s0, s1;
    const struct nc_spline *spline; /* whose words say it, NULL: none */
    double length;                  /* of an arc as printed, 0: as the path has it */
};

/* The longest that an axis needs from one end of a straight block to the other, minutes: each axis
 * at an even speed; without tool-centre-point control the slides too. */
double post_feed_axes_minutes(const struct nc_planner *planner, const struct block_pose *a,
                              const struct block_pose *b);

/*
 * The time of the next block, minutes: the least at which no axis is faster than its rapid anywhere
 * on it, if the tip goes `length` mm at an even speed (where that is 0, the rotary axes do).
 * `along` NULL: the block is straight.  `least`: it takes no less than that.
 */
double post_feed_minutes(const struct nc_planner *planner, const struct machine_pose *to,
                         double length, const struct nc_along *along, double least);

/*
 * Where to divide a B-spline into two, each with its own F, so that a slow part does not slow the
 * rest: at s in (0, 1), with no part shorter than 0.02 mm; 1: nowhere, because it would save too
 * little time.
 */
double post_feed_divide(const struct nc_planner *planner, const struct motion *motion);

/* The same for a straight motion or an arc from s0, where the program is, to s1, with vectors, none
 * of whose blocks becomes shorter than 0.02 mm: s in (s0, s1); s1: nowhere. */
double post_feed_divide_even(const struct nc_planner *planner, const struct motion *motion,
                             double s0, double s1);

/*
 * F of the block of that length, *minutes what it takes: never 0, never beyond the control's, and
 * rounded down where an axis would be too fast else.  Where the tip stays, as printed, F counts
 * degrees.
 */
double post_feed_word(const struct nc_planner *planner, const struct machine_pose *to,
                      double length, const struct nc_along *along, double *minutes);

/* Decimals of F: three more below 1, where the tip hardly moves; not of inverse time. */
int post_feed_digits(const struct nc_ability *ability, double feed);

#endif
