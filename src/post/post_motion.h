/*
 * post_motion - a motion as blocks, from where the last one ended.
 *
 * An arc or B-spline stays one where the control can be given it within the tolerance; else it
 * becomes straight blocks, as a straight motion does (post_straight.h).
 */
#ifndef CLOUDMILL_POST_MOTION_H
#define CLOUDMILL_POST_MOTION_H

#include "post_feed.h"
#include "post_planner.h"

/* At the machine's rapid, straight to a pose. */
int post_motion_rapid(struct nc_planner *planner, struct pose to);

/* The same out of the part: in the singular direction no axis turns on it. */
int post_motion_leave(struct nc_planner *planner, struct pose to);

/*
 * At feed, along a motion from s0, where the program stands, to s1 (0 to 1); each block is within
 * the planner's `allowed`.  Where the rotary axes cannot go on as they stand, the tool retracts and
 * turns, if the planner may.  -1: the error says the pass, the axis and the point from which no way
 * leads on.
 */
int post_motion_along(struct nc_planner *planner, const struct motion *motion, double s0,
                      double s1);

#endif
