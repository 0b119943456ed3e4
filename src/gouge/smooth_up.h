/*
 * smooth_up - the smoothest curve through points that may each be moved along a direction of their
 * own, and never back: a ball that may rise a little, and not sink.
 *
 * Minimized is the sum of the squared curvature along the points and of the squared moves, the
 * latter so weighed that waves longer than about 6 `length` stay; within the bounds by alternating
 * directions: Boyd, Parikh, Chu, Peleato, Eckstein, Distributed optimization and statistical
 * learning via the alternating direction method of multipliers, 2011, 5.2, with an over-relaxation
 * of 1.6 and a penalty that falls.
 */
#ifndef CLOUDMILL_SMOOTH_UP_H
#define CLOUDMILL_SMOOTH_UP_H

#include <stddef.h>

#include "math/vec.h"

/* Points in order, evenly spaced or nearly; up[i] unit vectors.  rise[i], from 0 to most[i], mm,
 * is what was found; the first and the last point stay where they are. */
void smooth_up(const struct vec3 *point, const struct vec3 *up, const double *most, double length,
               size_t n, double *rise);

#endif
