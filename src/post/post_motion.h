/*
 * post_motion - a motion as blocks, from where the last one ended.
 *
 * A straight motion is one block where a bound shows that it may be; else it is divided until what
 * the control makes of each block keeps the tolerance (interpolation.h).  An arc or B-spline stays
 * one where the control can be given it within the tolerance; else it becomes straight blocks.
 */
#ifndef CLOUDMILL_POST_MOTION_H
#define CLOUDMILL_POST_MOTION_H

#include "post_feed.h"
#include "post_planner.h"

/* Appends a move that ends at this pose, where the program then stands. */
struct nc_move *post_motion_append(struct nc_planner *planner, enum nc_kind kind,
                                   const struct machine_pose *to);

/* At the machine's rapid, straight to a pose. */
int post_motion_rapid(struct nc_planner *planner, struct pose to);

/* The rotary axes to q at the rapid, while the tip stays where it is. */
void post_motion_turn(struct nc_planner *planner, const double q[]);

/* At feed, straight to a pose in one block.  1, and nothing is done: the pose is out of reach, or
 * one block may be too far off the motion. */
int post_motion_one_block(struct nc_planner *planner, const struct pose *to);

/*
 * At feed, along a motion from s0, where the program stands, to s1 (0 to 1); each block is within
 * the planner's `allowed`.  Where the rotary axes cannot go on as they stand, the tool retracts and
 * turns, if the planner may.  -1: the error says the pass, the axis and the point from which no way
 * leads on.
 */
int post_motion_along(struct nc_planner *planner, const struct motion *motion, double s0,
                      double s1);

#endif
