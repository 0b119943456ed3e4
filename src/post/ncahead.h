/*
 * ncahead - the look ahead over a group of motions for its rotary axes (ik_plan.h).
 */
#ifndef CLOUDMILL_NCAHEAD_H
#define CLOUDMILL_NCAHEAD_H

#include "post/ncstep.h"
#include "machine/ik_plan.h"

/* A straight motion that may be one block past the singular direction: it ends at that place. */
struct nc_leap {
    size_t end;
    struct pose from, to;
};

struct nc_ahead {
    size_t n, cap;
    struct ik_plan_place *item; /* along the group, from where its rapids have led to */
    struct doubles s;           /* of each place: how far along its motion, 0 to 1 */
    struct sizes start;         /* of each item of the group: the place where it starts; then that
                                   where the last one ends */
    struct {
        size_t n, cap;
        struct nc_leap *item;
    } leap;
    struct chain_solutions found; /* at the last place */
    const struct nc_step *step;
    struct ik_plan_cost cost; /* of the way that was found */
};

/*
 * Looks ahead over the items [from, to) of the path, which start with rapids or where the program
 * is.  False: no way, or too many places to look at.
 */
bool nc_ahead_make(struct nc_ahead *ahead, const struct nc_step *step, size_t from, size_t to);

void nc_ahead_free(struct nc_ahead *ahead);

#endif
