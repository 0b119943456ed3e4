/*
 * ridge_direction - along a rib or a groove, where a surface bends across and not along:
 * neighbourhoods that are longer that way, and which way it runs.
 */
#ifndef CLOUDMILL_RIDGE_DIRECTION_H
#define CLOUDMILL_RIDGE_DIRECTION_H

#include <stdbool.h>
#include <stddef.h>

#include "math/quadric.h"

/*
 * Of n points the k (at most; k > 0) that are nearest to `at` if lengths along `way` (unit) count
 * only 1 / `aspect`: found[], the farthest in space of them last.  Equal ones by their order in
 * point[].  Returns how many.
 */
size_t neighbourhood_along(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
                           double aspect, size_t k, struct vec3 *found);

/* Neighbourhoods are so much longer along a rib, of no more points than that. */
enum { RIDGE_DIRECTION_LONGER = 4, RIDGE_DIRECTION_MOST = 64 };

struct ridge_direction {
    struct quadric q; /* through the points of a neighbourhood that is longer that way, without
                         variances */
    struct vec3 way;  /* unit */
    double rms;       /* of their distances from it, mm */
};

/*
 * Of the directions near `way` (unit, across `up`; TRIES times STEP to either side), the one along
 * which `some` of the n points about a place fit a quadric best, as found among every other one and
 * beside it.  False: none carries one.
 */
bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib);

/* The same of three directions only, that which a place near by has and one to either side. */
bool ridge_direction_follow(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                            struct vec3 way, size_t some, struct ridge_direction *rib);

#endif
