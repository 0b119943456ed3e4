/*
 * toolpath_parts - what the files of toolpath.h share: strips lifted and their axes shaped
 * (toolpath_axes.c) before they are linked and put into the path (toolpath.c).
 */
#ifndef CLOUDMILL_TOOLPATH_PARTS_H
#define CLOUDMILL_TOOLPATH_PARTS_H

#include "stage/toolpath.h"

/* Chooses lead and tilt anew, between what they are together and rule.turn, so that rotary axes
 * turn least over the contacts of all strips (rotary_cost.h), and says which. */
void toolpath_choose_lean(struct toolpath *t);

/* Lifts a strip and does with its axes what the rule says: play, lean and rate.  Where the holder
 * still touches, points are left out and the strip is in more parts. */
void toolpath_lift_strip(const struct toolpath *t, struct toolpath_strip *strip);

#endif
