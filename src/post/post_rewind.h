/*
 * post_rewind - the rotary axes turned with the tool off the part.
 */
#ifndef CLOUDMILL_POST_REWIND_H
#define CLOUDMILL_POST_REWIND_H

#include "post/ncstep.h"

/* Off the part along the tool axis, above all rapids of the path where it leads up. */
struct pose nc_pose_off(const struct nc_step *step);

/* The rotary axes to q while the tip stays where it is. */
void nc_turn_to(struct nc_step *step, const double q[]);

/* Retracts along the tool axis, turns to the angles nearest to q that have the pose where the
 * program is, and returns. */
int nc_step_turn(struct nc_step *step, const double q[]);

/* The same, to angles in the middle of the travel from which the goal is in reach; -1: none. */
int nc_turn_for(struct nc_step *step, struct pose goal);

#endif
