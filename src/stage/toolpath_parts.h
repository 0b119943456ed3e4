/*
 * toolpath_parts - what the files of toolpath.h share: strips lifted and their axes shaped
 * (toolpath_axes.c), centres smoothed (toolpath_smooth.c), their parts put in order
 * (toolpath_order.c), linked (toolpath.c), put into the path (toolpath_moves.c), and what is told
 * of it (toolpath_report.c).
 */
#ifndef CLOUDMILL_TOOLPATH_PARTS_H
#define CLOUDMILL_TOOLPATH_PARTS_H

#include "stage/toolpath.h"

/* Chooses lead and tilt anew, between what they are together and rule.turn, so that rotary axes
 * turn least over the contacts of all strips (rotary_cost.h), and says which. */
void toolpath_choose_lean(struct toolpath *t);

/* What plans the axes of all strips; NULL: they stay as their rule says. */
struct axis_planner *toolpath_new_planner(const struct toolpath *t);

/* How far axes may be off their rule to turn less, radians: on rest passes, whose ball touches now
 * one flank and now the other, so that the rule swings, further. */
double toolpath_play(const struct toolpath *t, bool rest);

/* How far rules may lean inward near the ends of a run, radians: none where a lead is asked for. */
double toolpath_inward(const struct toolpath *t);

/* Lifts a strip and cuts its loops off. */
void toolpath_lift_strip(const struct toolpath *t, struct toolpath_strip *strip);

/* Raises the centres of lifted rows, from this one on, to where they run smoothly (lift_smooth.h):
 * by rule.smooth, and by rule.raise where that leaves scallops no higher than they may be. */
void toolpath_smooth(struct toolpath *t, size_t first);

/* Plans the axes of a lifted strip (axis_plan.h).  Where the tool can't come to, points are left
 * out and the strip is in more parts. */
void toolpath_plan_strip(const struct toolpath *t, struct toolpath_strip *strip);

struct toolpath_parts {
    size_t n, cap;
    struct toolpath_part *item;
};

struct toolpath_parts toolpath_parts_of(const struct toolpath *t);

/* Its points; they stay the strip's. */
struct run toolpath_part_run(const struct toolpath *t, const struct toolpath_part *part);

/* Drops parts shorter than the ball's radius at all of whose contacts other parts leave no more
 * than the scallop between rows; returns how many. */
size_t toolpath_drop_slivers(const struct toolpath *t, struct toolpath_parts *parts);

/*
 * Puts the parts that are not dropped in the order in which they are cut: after each the one that
 * begins nearest, or turned round ends nearest, among those of neighbouring passes that are as near
 * as three rows, so that the rows on one side of a gap are cut before those on the other; where
 * there is none, the first that is left.  Rest passes are cut after all rows, each next one the
 * nearest of them all, where a turn of the axis counts as way.  Parts are turned round unless they
 * are to be cut one way or the axis leads.  With rows that have no gaps this is the order of the
 * strips.
 */
void toolpath_order(const struct toolpath *t, struct toolpath_parts *parts);

/* How far it is from one place to another, mm, where a turn of the axis counts as way. */
double toolpath_way(const struct toolpath *t, const struct run_point *a, const struct run_point *b);

/* Turns the points of a part round. */
void toolpath_part_turn(const struct toolpath *t, const struct toolpath_part *part);

/* Rest parts that follow each other in another order, some turned round, where the ways between
 * them are shorter then: parts of the order turned round as a whole, or a few put elsewhere, until
 * none helps. */
void toolpath_shorten(const struct toolpath *t, struct toolpath_parts *parts);

/* Finds how the tool goes with its tip down from each part to the next (`low`, `link`), where it
 * can. */
void toolpath_join(const struct toolpath *t, struct toolpath_parts *parts);

/* Leaves out of the parts, as they are in their order, and of the links between them what would be
 * blocks that are over before the next is read: one of two points whose tips are no further than
 * 0.021 mm apart, where the way past it is straight and clear (link_thin). */
void toolpath_thin(const struct toolpath *t, struct toolpath_parts *parts);

void toolpath_parts_free(struct toolpath_parts *parts);

/* Makes the axes of parts alike that are cut one after the other, and calm along them
 * (axis_calm.h), with the links between: parts in their order, and no further apart than `longest`,
 * mm. */
void toolpath_calm(const struct toolpath *t, const struct toolpath_parts *parts, double longest);

struct link_options toolpath_link_options(const struct toolpath *t);

/* No way leads to the part of so many points, or out of it. */
bool toolpath_is_blocked(const struct toolpath_part *part, size_t points);

/* Puts a part into the path, with what leads to it from the one before: a link, or up, over and
 * down. */
void toolpath_add_part(struct toolpath *t, const struct toolpath_part *part);

/* Up from the last of them. */
void toolpath_add_end(struct toolpath *t);

/* Of an axis off z, radians. */
double toolpath_axis_lean(struct vec3 axis);

/* Looks from the places where a lifted ball may leave something for the nearest that it comes on
 * the whole path, which may reach them from the side, and counts those where it does not. */
void toolpath_find_uncut(struct toolpath *t);

#endif
