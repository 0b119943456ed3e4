/*
 * mesh_clean - facets that a foreign mesh is better without.  Vertices stay; the facets that stay
 * keep their order.
 */
#ifndef CLOUDMILL_MESH_CLEAN_H
#define CLOUDMILL_MESH_CLEAN_H

#include "mesh/mesh.h"

/* Leaves out facets whose corners are in a line, as far as numbers can say; returns how many. */
size_t mesh_clean_no_area(struct mesh *mesh);

/* Of facets with the same three vertices the first one stays; returns how many went. */
size_t mesh_clean_doubled(struct mesh *mesh);

#endif
