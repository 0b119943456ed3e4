/*
 * post_straight - a motion as straight blocks.
 *
 * A straight motion is one block where a bound shows that it may be; else it is divided until what
 * the control makes of each block keeps the tolerance (interpolation.h).
 */
#ifndef CLOUDMILL_POST_STRAIGHT_H
#define CLOUDMILL_POST_STRAIGHT_H

#include "post_planner.h"

/* At feed, straight to a pose in one block.  1, and nothing is done: the pose is out of reach, or
 * one block may be too far off the motion. */
int post_straight_one(struct nc_planner *planner, const struct pose *to);

/* Along a motion from s0, where the program stands, to s1, each block no further off it than
 * `allowed`.  Where the rotary axes cannot go on as they stand, the tool retracts and turns, if the
 * planner may.  -1: the error says from where no way leads on. */
int post_straight_blocks(struct nc_planner *planner, const struct motion *motion, double s0,
                         double s1, enum nc_kind kind, struct pose_deviation allowed);

/* -1: the error says the pass, the axis and the point from which no way leads on to the goal. */
int post_straight_no_way(struct nc_planner *planner, struct pose goal,
                         const struct machine_pose *to);

#endif
