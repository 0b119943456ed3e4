/*
 * mesh_join - the meshes of the parts of a cloud as one mesh.
 */
#ifndef CLOUDMILL_MESH_JOIN_H
#define CLOUDMILL_MESH_JOIN_H

#include "mesh/mesh.h"
#include "cloud/segment.h"

/* Appends the mesh of a part, which is in the part's own axes: turned back, its rows after those
 * that are there, and its frame to to->origin.part. */
void mesh_join_add(struct mesh *to, const struct mesh *mesh, const struct segment *part);

/* Part k of a mesh that such parts were put together to: its vertices and facets, without rows. */
struct mesh mesh_join_of(const struct mesh *mesh, size_t k);

#endif
