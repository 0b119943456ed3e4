/*
 * feature_corner - where creases or walls meet within a facet.
 *
 * A facet that two walls cross, or creases between three sheets, holds the corner that they make:
 * the place where their planes meet.
 */
#ifndef CLOUDMILL_FEATURE_CORNER_H
#define CLOUDMILL_FEATURE_CORNER_H

#include <stdbool.h>

#include "math/vec.h"

struct feature_corner_plane {
    struct vec3 place, normal; /* unit */
};

/* Where three planes meet, reckoned from a place near to it.  False: two of them are turned by less
 * than about 8 degrees, or all are along one line. */
bool feature_corner_of(const struct feature_corner_plane plane[3], struct vec3 from,
                       struct vec3 *corner);

/* The same; false too where that is not within the triangle, seen from above. */
bool feature_corner(const struct feature_corner_plane plane[3], const struct vec3 triangle[3],
                    struct vec3 *corner);

/* The plane half way between two. */
struct feature_corner_plane feature_corner_mean(struct feature_corner_plane a,
                                                struct feature_corner_plane b);

#endif
