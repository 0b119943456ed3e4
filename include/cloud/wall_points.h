/*
 * wall_points - which points of a cloud lie on walls: on what is too steep to be seen from above
 * (paper 1, 7 and fig. 44).
 */
#ifndef CLOUDMILL_WALL_POINTS_H
#define CLOUDMILL_WALL_POINTS_H

#include "base/array.h"
#include "math/vec.h"

/* Points that a plane goes through; the fewest of them that make one at the edge of a wall. */
enum { WALL_POINTS_NEAR = 16, WALL_POINTS_FEWEST = 5 };

#define WALL_POINTS_STEEP RADIANS(75) /* a plane from here on is a wall */

/*
 * Puts the points that lie on walls after the others, both in the order they had, and returns how
 * many the others are.  A point lies on a wall when the plane through the WALL_POINTS_NEAR points
 * nearest to it is steeper than WALL_POINTS_STEEP, or when it lies on such a plane of at least
 * WALL_POINTS_FEWEST points next to it.  Only points where the cloud rises by more than RISE widths
 * of a cell within it are tested, so that a cloud without walls is gone through once.
 */
size_t wall_points_part(struct vec3 *point, size_t n, double spacing, int threads);

#endif
