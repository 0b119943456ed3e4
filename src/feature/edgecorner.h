/*
 * edgecorner - where creases or walls meet within a facet.
 *
 * A facet that two walls cross, or creases between three sheets, holds the corner that they make:
 * the place where their planes meet.
 */
#ifndef CLOUDMILL_EDGECORNER_H
#define CLOUDMILL_EDGECORNER_H

#include <stdbool.h>

#include "math/vec.h"

struct edgecorner_plane {
    struct vec3 place, normal; /* unit */
};

/* Where three planes meet, reckoned from a place near to it.  False: two of them are turned by less
 * than about 8 degrees, or all are along one line. */
bool edgecorner_of(const struct edgecorner_plane plane[3], struct vec3 from, struct vec3 *corner);

/* The same; false too where that is not within the triangle, seen from above. */
bool edgecorner(const struct edgecorner_plane plane[3], const struct vec3 triangle[3],
                struct vec3 *corner);

/* The plane half way between two. */
struct edgecorner_plane edgecorner_mean(struct edgecorner_plane a, struct edgecorner_plane b);

#endif
