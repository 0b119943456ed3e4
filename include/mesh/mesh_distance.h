/*
 * mesh_distance - how far points are from the facets of a mesh.
 */
#ifndef CLOUDMILL_MESH_DISTANCE_H
#define CLOUDMILL_MESH_DISTANCE_H

#include "mesh/mesh.h"

/* Fills distance[n], mm: of each point from the facet nearest to it.  The mesh must have facets. */
void mesh_distance(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
                   double *distance);

#endif
