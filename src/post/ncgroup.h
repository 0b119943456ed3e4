/*
 * ncgroup - a group of motions: from a rapid, where the tool is off the part and the rotary axes
 * may go to either solution, up to the next rapid behind a cut.
 *
 * Its rotary axes take the way with the fewest turns back (retract - turn - return) inside their
 * travel, and of these the one on which they turn least.  Mostly that is the nearest way from place
 * to place, and can be seen to be: no single step of the other solution is as short, and both
 * solutions turn alike.  Else a look ahead over the whole group finds it (ncahead.h).
 */
#ifndef CLOUDMILL_NCGROUP_H
#define CLOUDMILL_NCGROUP_H

#include "post/ncstep.h"

/* Behind the group that starts at `from`. */
size_t nc_group_end(const struct path *path, size_t from);

/* Plans the items [from, to) of the path; -1: the error is filled. */
int nc_group_plan(struct nc_step *step, size_t from, size_t to);

#endif
