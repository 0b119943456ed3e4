/*
 * post_time - how long a plan takes on its machine (machine/axis_time.h): what its moves take at
 * their feeds and the rapid speeds, and what speeding up and slowing down add.
 */
#ifndef CLOUDMILL_POST_TIME_H
#define CLOUDMILL_POST_TIME_H

#include "post_plan.h"

/* Adds to the plan's minutes what acceleration and jerk cost, and, where F is inverse time, gives
 * each block the time that it takes. */
void post_time(struct nc_plan *plan, const struct machine *machine);

#endif
