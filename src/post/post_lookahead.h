/*
 * post_lookahead - the rotary axes over a group of motions: from a rapid, where the tool is off the
 * part and the axes may go to either solution, to before the next rapid after a cut.
 *
 * The axes take the way with the fewest turns back (retract, turn, return) inside their travel, and
 * of these the one on which they turn least.  Mostly that is the nearest way from place to place,
 * and can be seen to be: no single step of the other solution is as short, and both solutions turn
 * alike.  Else a look ahead over the whole group finds it, as the shortest way through a graph
 * (ik_plan.h).
 */
#ifndef CLOUDMILL_POST_LOOKAHEAD_H
#define CLOUDMILL_POST_LOOKAHEAD_H

#include "post_planner.h"

/* The end of the group that starts at the item `from`. */
size_t post_lookahead_end(const struct path *path, size_t from);

/* Plans the items [from, to) of the path; -1: the error is filled. */
int post_lookahead_plan(struct nc_planner *planner, size_t from, size_t to);

#endif
