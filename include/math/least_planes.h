/*
 * least_planes - a surface of few facets that no hollow parts, through a neighbourhood of points:
 * over each place the lowest of up to LEAST_PLANES planes, as heights over a plane u, v.
 *
 * By least squares, each point counted to the plane that is lowest over it, planes and counts found
 * in turn (Magnani and Boyd, "Convex piecewise-linear fitting", 2009), one plane more at a time,
 * from all ways to divide the points of one of those before by a line.  Lengths in mm.
 */
#ifndef CLOUDMILL_LEAST_PLANES_H
#define CLOUDMILL_LEAST_PLANES_H

#include <stddef.h>

#include "math/vec.h"

enum { LEAST_PLANES = 5, LEAST_PLANES_POINTS = 64 };

struct least_planes {
    int n;
    double plane[LEAST_PLANES][3]; /* height: [0] + [1] u + [2] v */
    double rms;                    /* of the heights, for those that the fit leaves free */
};

/* Through n points, LEAST_PLANES_POINTS at most, u, v and height each: the fewest planes, two or
 * more, that leave no more than `even`, or those that leave the least.  -1: there are none, for
 * each has points enough to be known. */
int least_planes_fit(const struct vec3 *local, size_t n, double even, struct least_planes *fit);

double least_planes_at(const struct least_planes *fit, double u, double v);

#endif
