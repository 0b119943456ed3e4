/*
 * mesh_repair_steps - the steps of mesh_repair.h that are of use alone.
 */
#ifndef CLOUDMILL_MESH_REPAIR_STEPS_H
#define CLOUDMILL_MESH_REPAIR_STEPS_H

#include "mesh/mesh.h"

/* ---- mesh_clean: facets that a foreign mesh is better without.  Vertices stay; the facets that
 * stay keep their order. */

/* Leaves out facets whose corners are in a line, as far as numbers can say; returns how many. */
size_t mesh_clean_no_area(struct mesh *mesh);

/* Of facets with the same three vertices the first one stays; returns how many went. */
size_t mesh_clean_doubled(struct mesh *mesh);

/* ---- crease_normals: normals for a mesh that has none, and sharp edges kept sharp. */

/*
 * Where two facets meet at more than 30 degrees, or at a border or an edge of many facets, each
 * side gets vertices of its own.  Fills mesh->normal with the mean of the facets' normals at each
 * vertex, weighted by their angle there.  Vertices without a facet go, and so do kmax, rows and
 * columns. Facets must have area and be turned alike.
 */
void crease_normals(struct mesh *mesh);

#endif
