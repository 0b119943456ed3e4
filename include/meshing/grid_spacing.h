/*
 * grid_spacing - how far apart the nodes of a grid may be for its facets to follow a scan: by what
 * the surface needs, not by how dense its points are.
 */
#ifndef CLOUDMILL_GRID_SPACING_H
#define CLOUDMILL_GRID_SPACING_H

#include "math/vec.h"

struct grid_spacing_options {
    double mean;  /* spacing of the points, mm */
    double width; /* of what they cover, mm */
    double noise; /* their standard deviation, mm */
    int threads;  /* as of parallel_for */
};

/*
 * The widest of LEAST mean spacings, and of that times powers of the root of two up to 1 / ROWS of
 * the width, at which the facets are off the surface by no more than OFF or 1.5 sigma at USUAL of
 * the places; to two digits.  Facets of side t over a curvature k are off by k t^2 / 8, and points
 * within t / sqrt(3) of a place by k t^2 / 20.8 (root mean square) from the plane through them: this
 * is measured at PLACES places, less the noise.  Where no spacing serves, it is the least.
 */
double grid_spacing_needed(const struct vec3 *point, size_t n,
                           const struct grid_spacing_options *options);

#endif
