/*
 * wall_points - which points of a cloud lie on walls: on what is too steep to be seen from above
 * (paper 1, 7 and fig. 44).
 */
#ifndef CLOUDMILL_WALL_POINTS_H
#define CLOUDMILL_WALL_POINTS_H

#include "base/array.h"
#include "math/vec.h"

/*
 * Puts the points that lie on walls after the others, both in the order they had, and returns how
 * many the others are.  A point lies on a wall when the plane through the sixteen points nearest to
 * it is steeper than 75 degrees, or on five such planes of points next to it; only points where the
 * cloud rises by more than twice the width of a cell (two mean spacings wide) are looked at so
 * closely, so that a cloud without walls costs one look at each point.
 */
size_t wall_points_part(struct vec3 *point, size_t n, double spacing, int threads);

#endif
