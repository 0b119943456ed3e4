/*
 * ribway - which way a rib or a groove runs, and the surface along it.
 */
#ifndef CLOUDMILL_RIBWAY_H
#define CLOUDMILL_RIBWAY_H

#include <stdbool.h>

#include "math/quadric.h"

/* Neighbourhoods are so much longer along a rib, of no more points than that. */
enum { RIBWAY_LONGER = 4, RIBWAY_MOST = 64 };

struct ribway {
    struct quadric q; /* through the points of a neighbourhood that is longer that way */
    struct vec3 way;  /* unit */
    double rms;       /* of their distances from it, mm */
};

/*
 * Of the ways within 20 degrees of `way` (unit, across `up`), the one along which `some` of the n
 * points about a place fit a quadric best.  False: none carries one.
 */
bool ribway_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                 struct vec3 way, size_t some, struct ribway *rib);

#endif
