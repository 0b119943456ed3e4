/*
 * post_item - one item of a path as blocks: a motion with the way down before it, a hole of a
 * drilling cycle, another tool or plane, a note.
 */
#ifndef CLOUDMILL_POST_ITEM_H
#define CLOUDMILL_POST_ITEM_H

#include "post_planner.h"

/* The next item; -1: the error says pass, line and axis. */
int post_item(struct nc_planner *planner, const struct path_item *item);

/* Where the path, or a tool's part of it, ends in the cut: retracts along the tool axis. */
int post_item_retract(struct nc_planner *planner);

/* The radius of the ball in the spindle, and what rounding leaves of the tolerance with it. */
void post_item_tool(struct nc_planner *planner, double ball);

/* The machine's chain for the tool in the spindle (post_ik_chain).  -1: without tool-centre-point
 * control, and its length is not known. */
int post_item_length(struct nc_planner *planner);

#endif
