/*
 * triangle_points - points on triangles in space, for who looks at points alone.
 */
#ifndef CLOUDMILL_TRIANGLE_POINTS_H
#define CLOUDMILL_TRIANGLE_POINTS_H

#include "base/array.h"
#include "math/vec.h"

/*
 * Appends points on the triangle with these corners, which are there already, to `points`: in rows
 * along its longest side, so that no place of it is farther than 0.65 times the spacing (mm) from a
 * point or a corner, and a needle gets no more than its length asks for.
 */
void triangle_points(const struct vec3 corner[3], double spacing, struct vec3s *points);

/* Its longest side, from corner k to the next: k, and the length, mm. */
int triangle_longest_side(const struct vec3 corner[3]);
double triangle_longest(const struct vec3 corner[3]);

#endif
