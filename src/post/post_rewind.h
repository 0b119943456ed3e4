/*
 * post_rewind - the tool off the part so that the rotary axes can turn: retract, turn, return.
 */
#ifndef CLOUDMILL_POST_REWIND_H
#define CLOUDMILL_POST_REWIND_H

#include "post_planner.h"

/* What a planner asks of a whole path, found in one walk. */
struct nc_extent {
    struct box cut; /* around the ends of all cuts */
    double rapid;   /* z of the highest rapid, NAN: there is none */
    bool planes;    /* it has tilted planes */
};

struct nc_extent post_rewind_extent(const struct path *path);

/* The pose to retract to: along the tool axis by the machine's `retract`, and where it leads up
 * above all rapids of the path; where it leads down with a head, beside all cuts, infinitely far
 * where it never is. */
struct pose post_rewind_retracted(const struct nc_planner *planner);

/* The pose above this one at the plan's top: along the tool axis where that leads up, else along z.
 * The pose itself where it is as high. */
struct pose post_rewind_above(const struct nc_planner *planner, struct pose pose);

/* Retracts, turns to the angles nearest to q that have the pose where the program stands, and
 * returns. */
int post_rewind_to(struct nc_planner *planner, const double q[]);

/* The same, to angles in the middle of the travel from which the goal is in reach; -1: none. */
int post_rewind_for(struct nc_planner *planner, struct pose goal);

/* At feed, straight to a pose, or along a motion that starts where the program stands: with the
 * planner's rewinds inside of it. */
int post_rewind_line(struct nc_planner *planner, struct pose to);
int post_rewind_motion(struct nc_planner *planner, const struct motion *motion);

#endif
