/*
 * cubic - a surface of the third degree through a neighbourhood of points: for where a quadric is
 * off because the points lie to one side, or because there are many of them to average out noise.
 */
#ifndef CLOUDMILL_CUBIC_H
#define CLOUDMILL_CUBIC_H

#include "math/quadric.h"

/*
 * As quadric_fit, with the terms u^3, u^2 v, u v^2, v^3 in cubic->c[6] to c[9].  Each point counts
 * with its weight; `weight` may be NULL: all 1.  The last point is the farthest from the origin.
 * -1 if the points do not determine one: fewer than 10 that count, so that a term is the sum of
 * the others up to INDEPENDENT, or so that the slope is UNCERTAIN, as on three lines.
 */
int cubic_fit(const struct vec3 *point, const double *weight, size_t n, struct vec3 origin,
              struct vec3 guess, struct quadric *cubic);

#endif
