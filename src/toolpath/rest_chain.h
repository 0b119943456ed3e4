/*
 * rest_chain - strips through points that are few and far between, from each to the next.
 */
#ifndef CLOUDMILL_REST_CHAIN_H
#define CLOUDMILL_REST_CHAIN_H

#include "toolpath/rest_passes.h"

/*
 * Appends strips through the points: each goes on, to both sides, to the nearest point within `gap`
 * mm that faces the same way and lies ahead; points no further than `beside` mm off the straight
 * line between two of a strip are cut by it, and are left out.
 */
void rest_chain_points(const struct contacts *points, double gap, double beside,
                       struct rest_strips *strips);

#endif
