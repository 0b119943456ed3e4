/*
 * cloud_normals - normals of a cloud in space that is no height field, all on one side of it.
 */
#ifndef CLOUDMILL_CLOUD_NORMALS_H
#define CLOUDMILL_CLOUD_NORMALS_H

#include "math/vec.h"

/* Neighbours of each point, its own index left out: [i * CLOUD_NEAR + k], nearest first. */
enum { CLOUD_NEAR = 16 };

/*
 * The n indices of the CLOUD_NEAR points nearest to each point.  n must be above CLOUD_NEAR.  Free
 * with free().
 */
size_t *cloud_neighbours(const struct vec3 *point, size_t n, int threads);

/* Mean spacing of the points on the surface that they are of, mm: by the median of the circles that
 * the neighbours take. */
double cloud_spacing(const struct vec3 *point, size_t n, const size_t *neighbour);

/*
 * Fills normal[n]: unit, of the plane through each point and its neighbours.  Their signs follow
 * from neighbour to neighbour over the least change of direction (minimum spanning tree: Hoppe et
 * al. 1992), from the highest point of each connected piece that is flat and no steeper than 60
 * degrees, where the normal points up.  Where the plane of a neighbour, or of one up to three steps
 * away, serves a point at least twice as well as its own it takes that normal, so that beside a
 * sharp edge normals are those of their side.
 */
void cloud_normals(const struct vec3 *point, size_t n, const size_t *neighbour, int threads,
                   struct vec3 *normal);

#endif
