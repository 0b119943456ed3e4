/*
 * ik_bound - how far the rotary axes turn at least along a pass, whatever the way that ik_plan
 * finds without turns back: a bound by the two solutions alone, without ends of travel, in one
 * walk.
 *
 * For chains whose solutions are each other's mirror image, half a turn of the first axis apart:
 * both axes at right angles, and the tool across the second.  From one place to the next either
 * the solution stays or it changes; angles go the shortest way round.  A way of ik_plan does one
 * of both between any two places, by whatever places lie between, and a way round is no shorter.
 */
#ifndef CLOUDMILL_IK_BOUND_H
#define CLOUDMILL_IK_BOUND_H

#include "machine/ik_near.h"

struct ik_bound {
    const struct ik_near_table *near;
    double weight[ROTARY_MAX],
        mirror;           /* of the second axis: the angle about which it is mirrored */
    double q[ROTARY_MAX]; /* where the walk is, by one solution */
    struct turned turned;
    bool free, unknown;   /* the first axis is free there; somewhere nothing was found */
    double same, changed; /* the least travel up to here, by that solution and by the other */
};

/* From the angles q; `near` stays with the caller. */
struct ik_bound ik_bound_from(const struct ik_near_table *near, const double q[]);

/* On to a tool axis. */
void ik_bound_to(struct ik_bound *bound, struct vec3 axis);

/* Of the whole walk, as ik_travel says it; 0: not known. */
double ik_bound_least(const struct ik_bound *bound);

#endif
