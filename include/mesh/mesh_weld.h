/*
 * mesh_weld - vertices at one place made one vertex.
 */
#ifndef CLOUDMILL_MESH_WELD_H
#define CLOUDMILL_MESH_WELD_H

#include "mesh/mesh.h"

/* Of each vertex the first one at the same place, to the last bit; the caller frees them. */
size_t *mesh_first_at_place(const struct mesh *mesh);

/*
 * Vertices with the same coordinates, to the last bit, become one, in the order in which facets
 * name them first; those that no facet names go.  Returns how many were made one with another.
 * Normals, rows, columns and kmax, which may differ between such vertices, are dropped.
 */
size_t mesh_weld(struct mesh *mesh);

#endif
