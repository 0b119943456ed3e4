/*
 * ncstraight - part of a motion as straight blocks, as many as it takes for the control's own way
 * between their ends to keep the tolerance.
 */
#ifndef CLOUDMILL_NCSTRAIGHT_H
#define CLOUDMILL_NCSTRAIGHT_H

#include "post/ncstep.h"

/*
 * From s0 of the motion (0 to 1), where the program is, to s1; each block is within `allowed`.
 * Where the rotary axes cannot go on as they stand, the tool retracts and turns, if it may.
 * -1: the error is filled with the pass, the axis and the point from which no way leads on.
 */
int nc_step_straight(struct nc_step *step, const struct motion *motion, double s0, double s1,
                     enum nc_kind kind, struct pose_deviation allowed);

#endif
