/*
 * post_travel - how far the rotary axes turn over a group of items as it is planned, and at least
 * have to: whether another way may be worth to be looked for.
 */
#ifndef CLOUDMILL_POST_TRAVEL_H
#define CLOUDMILL_POST_TRAVEL_H

#include "post_planner.h"

/* Where a group starts: after so many moves of the plan, the rotary axes at q. */
struct nc_group_start {
    size_t moves;
    double q[ROTARY_MAX];
};

/* A way of that travel is shorter than another by what a second plan is worth. */
bool post_travel_saves(double travel, double than);

/* How far the axes turn from there on, as ik_travel says it. */
double post_travel_since(const struct nc_planner *planner, const struct nc_group_start *since);

/* The items from..to are planned, each block the nearest way: no other way would save enough. */
bool post_travel_is_least(const struct nc_planner *planner, const struct nc_group_start *since,
                          size_t from, size_t to);

#endif
