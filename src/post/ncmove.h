/*
 * ncmove - one more block into the plan: its feed word and the time that it takes.
 */
#ifndef CLOUDMILL_NCMOVE_H
#define CLOUDMILL_NCMOVE_H

#include "post_feed.h"

/* Appends a move that ends at a stance, where the program then stands. */
struct nc_move *nc_move_to(struct nc_step *step, enum nc_kind kind,
                           const struct machine_pose *stance);

/*
 * A block from where the program is to a stance, along which the tracked point goes `length` mm;
 * index: of its arc or spline in the plan, which follows `along` (NULL: straight).  The program
 * then stands there; the pose is the caller's to set.
 */
void nc_add_move(struct nc_step *step, enum nc_kind kind, const struct machine_pose *stance,
                 double length, size_t index, const struct nc_along *along);

/* A straight block to a stance, which stands for the pose `goal`, unless it would say nothing. */
void nc_add_straight(struct nc_step *step, enum nc_kind kind, const struct machine_pose *to,
                     const struct pose *goal);

#endif
