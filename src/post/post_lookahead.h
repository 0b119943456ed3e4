/*
 * post_lookahead - the way of the rotary axes through a group, found by looking ahead over all of
 * it: its places and both solutions at each, and the shortest way through this graph (ik_plan.h).
 */
#ifndef CLOUDMILL_POST_LOOKAHEAD_H
#define CLOUDMILL_POST_LOOKAHEAD_H

#include "machine/ik_plan.h"
#include "post_planner.h"

/* A part of a motion, from s0 to s1, that may be one block past the singular direction: it ends at
 * that place. */
struct crossing {
    size_t end;
    struct motion motion;
    double s0, s1;
};

struct lookahead {
    size_t n, cap;
    struct ik_plan_place *item; /* along the group, from where its rapids have led to */
    struct doubles s;           /* of each place: how far along its motion, 0 to 1 */
    struct sizes start;         /* of each item of the group: the place where it starts; then that
                                   where the last one ends */
    struct {
        size_t n, cap;
        struct crossing *item;
    } crossing;
    struct chain_solutions found; /* at the last place */
    const struct nc_planner *planner;
    struct ik_plan_cost cost; /* of the way that was found */
};

/* Finds it over the items [from, to) of the planner's path, from where its state is; the result is
 * to be freed.  False: there is nothing to be found, as where the control turns vectors, or too
 * much to look through, or no way. */
bool post_lookahead_over(struct lookahead *ahead, const struct nc_planner *planner, size_t from,
                         size_t to);

void post_lookahead_free(struct lookahead *ahead);

#endif
