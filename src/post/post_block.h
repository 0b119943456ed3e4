/*
 * post_block - one more block of the program, from where the last one ended.
 */
#ifndef CLOUDMILL_POST_BLOCK_H
#define CLOUDMILL_POST_BLOCK_H

#include "post_feed.h"
#include "post_planner.h"

/* Appends a move that ends at this pose, where the program then stands. */
struct nc_move *post_block_append(struct nc_planner *planner, enum nc_kind kind,
                                  const struct machine_pose *to);

/* The same with its feed, counted in the plan's total: of this length, in the program's unit; for
 * an arc or B-spline with its index in the plan and what it follows (else 0 and NULL). */
void post_block_add(struct nc_planner *planner, enum nc_kind kind, const struct machine_pose *to,
                    double length, size_t index, const struct nc_along *along);

/* A straight one to a pose of the path, unless the program says that already. */
void post_block_straight(struct nc_planner *planner, enum nc_kind kind,
                         const struct machine_pose *to, const struct pose *goal);

/* The tip stays at rest where the rotary axes turn by no more, degrees, in one block of a control
 * without tool-centre-point control. */
enum { POST_BLOCK_TURN = 2 };

/* Radians: rotary axes that turn by more off the part go to another solution, or whole turns. */
#define POST_FAR_TURN (PI / 6)

/* The rotary axes turn to q in n blocks alike, the tip at rest. */
void post_block_stand(struct nc_planner *planner, enum nc_kind kind, const double q[], int n);

/* The same at the rapid, in as many blocks as keep the tip at rest. */
void post_block_turn(struct nc_planner *planner, const double q[]);

#endif
