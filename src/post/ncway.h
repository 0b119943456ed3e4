/*
 * ncway - how far the rotary axes turn in a group of motions, and whether no other way through it
 * can be shorter: then nobody has to look ahead.
 */
#ifndef CLOUDMILL_NCWAY_H
#define CLOUDMILL_NCWAY_H

#include "post/ncstep.h"

/* Where a group starts: behind so many moves of the plan, the rotary axes at q. */
struct nc_since {
    size_t moves;
    double q[ROTARY_MAX];
};

/* How far the rotary axes turn in all that was planned since, as ik_travel says it. */
double nc_way_since(const struct nc_step *step, const struct nc_since *since);

/* One way is so much shorter than another that planning again is worth it. */
bool nc_way_saves(double way, double than);

/*
 * The items [from, to) of the path, planned since with each block the nearest way, have no other
 * way that saves as much.  False: look closer.
 */
bool nc_way_surely_shortest(const struct nc_step *step, const struct nc_since *since, size_t from,
                            size_t to);

#endif
