/*
 * post_group - a whole path into its plan, group by group, with a look ahead for the rotary axes.
 *
 * A group starts with a rapid, where the tool is off the part and the axes may go to either
 * solution, and ends before the next rapid after a cut.
 * The axes take the way with the fewest turns back (retract, turn, return) inside their travel, and
 * of these the one on which they turn least.  Mostly that is the nearest way from place to place,
 * and can be seen to be: no single step of the other solution is as short, and both solutions turn
 * alike.  Else a look ahead over the whole group finds it (post_lookahead.h).
 */
#ifndef CLOUDMILL_POST_GROUP_H
#define CLOUDMILL_POST_GROUP_H

#include "post_planner.h"

/* Fills the plan, which keeps nothing of the path; -1: the error says pass, line and axis. */
int nc_plan_make(struct nc_plan *plan, const struct path *path, const struct machine *machine,
                 struct nc_ability ability, struct nc_plan_options options, struct error *error);

#endif
