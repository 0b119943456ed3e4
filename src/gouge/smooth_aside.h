/*
 * smooth_aside - the smoothest curve near points that may be moved sideways: a row of balls on a
 * surface, each of which touches as well a little beside where it is.
 *
 * Minimized is the sum of the squared curvature along the points and of the squared moves, the
 * latter so weighed that waves longer than about 6 `length` stay and shorter ones go; a band of
 * equations.
 */
#ifndef CLOUDMILL_SMOOTH_ASIDE_H
#define CLOUDMILL_SMOOTH_ASIDE_H

#include <stddef.h>

#include "math/vec.h"

/* Points in order; side[i] unit vectors, or zero: that point stays.  move[i], from -most to most,
 * mm, is what was found.  The first and the last point stay where they are. */
void smooth_aside(const struct vec3 *point, const struct vec3 *side, double length, double most,
                  size_t n, double *move);

#endif
