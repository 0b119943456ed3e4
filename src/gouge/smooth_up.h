/*
 * smooth_up - the smoothest curve through points that may each be moved a little along a direction
 * of their own, and never back: a ball that may rise, and not sink.
 *
 * The sum of the squared curvature along the points is minimized, one point after another
 * (Gauss-Seidel, over-relaxed), each within its bounds.
 */
#ifndef CLOUDMILL_SMOOTH_UP_H
#define CLOUDMILL_SMOOTH_UP_H

#include <stddef.h>

#include "math/vec.h"

/* Points in order; up[i] unit vectors.  rise[i], from 0 to most[i], mm, is what was found.  The
 * first and the last point stay where they are. */
void smooth_up(const struct vec3 *point, const struct vec3 *up, const double *most, size_t n,
               double *rise);

#endif
