/*
 * mesh_distance - how far points are from the facets of a mesh, and which are above or below it.
 */
#ifndef CLOUDMILL_MESH_DISTANCE_H
#define CLOUDMILL_MESH_DISTANCE_H

#include "base/array.h"
#include "base/error.h"
#include "mesh/mesh.h"

/* Fills distance[n], mm: of each point from the facet nearest to it.  The mesh must have facets. */
void mesh_distance(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
                   double *distance);

/* Appends to `covered` those of n points that a facet is above or below, or has on its border; in
 * an order of their own, the same each time.  `spacing` is about what they are apart, mm.  -1: they
 * cannot be sorted (point_grid.h). */
int mesh_coverage(const struct mesh *mesh, const struct vec3 *point, size_t n, double spacing,
                  struct vec3s *covered, struct error *error);

#endif
