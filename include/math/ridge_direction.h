/*
 * ridge_direction - which way a rib or a groove runs, and the surface along it.
 */
#ifndef CLOUDMILL_RIDGE_DIRECTION_H
#define CLOUDMILL_RIDGE_DIRECTION_H

#include <stdbool.h>

#include "math/quadric.h"

/* Neighbourhoods are so much longer along a rib, of no more points than that. */
enum { RIDGE_DIRECTION_LONGER = 4, RIDGE_DIRECTION_MOST = 64 };

struct ridge_direction {
    struct quadric q; /* through the points of a neighbourhood that is longer that way */
    struct vec3 way;  /* unit */
    double rms;       /* of their distances from it, mm */
};

/*
 * Of the ways within 20 degrees of `way` (unit, across `up`), the one along which `some` of the n
 * points about a place fit a quadric best.  False: none carries one.
 */
bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib);

#endif
