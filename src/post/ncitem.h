/*
 * ncitem - one item of a path into blocks: a motion with its way down before it, another tool, a
 * note.
 */
#ifndef CLOUDMILL_NCITEM_H
#define CLOUDMILL_NCITEM_H

#include "post/ncstep.h"

/* The next item; -1: the error says pass, line and axis. */
int nc_item(struct nc_step *step, const struct path_item *item);

/* Where the path, or a tool's part of it, ends in the cut: off the part along the tool axis. */
int nc_item_depart(struct nc_step *step);

/* The ball of the tool in the spindle, and what rounding leaves of the tolerance with it. */
void nc_item_tool(struct nc_step *step, double ball);

#endif
