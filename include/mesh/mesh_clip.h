/*
 * mesh_clip - the part of a mesh on one side: of a plane, or of a value at its vertices.
 *
 * A facet that is partly there is cut (Sutherland and Hodgman 1974).  New vertices are on the
 * edges as the surface runs there (curve/edge_curve.h), neighbours share them, and their normals
 * and kmax are those of the edge's ends, mixed.  Vertices of which no facet is left stay till
 * mesh_clip_unused.
 */
#ifndef CLOUDMILL_MESH_CLIP_H
#define CLOUDMILL_MESH_CLIP_H

#include "math/region.h"
#include "mesh/mesh.h"

/* Keeps where x . direction >= at; a unit vector, mm. */
void mesh_clip_plane(struct mesh *mesh, struct vec3 direction, double at);

/* Keeps what lies inside an odd number of the polygons. */
void mesh_clip_polygons(struct mesh *mesh, const struct region_polygons *polygons);

/* Keeps where the normal's angle to `up` (unit) is from `least` to `most` radians; between
 * vertices the cosine runs evenly. */
void mesh_clip_steep(struct mesh *mesh, struct vec3 up, double least, double most);

/* Keeps the facets of the surfaces that are marked; the mesh knows of each facet its surface. */
void mesh_clip_surfaces(struct mesh *mesh, const bool *keep);

/* Leaves out the facets that are marked. */
void mesh_clip_marked(struct mesh *mesh, const bool *out);

/* Leaves out the vertices that no facet has. */
void mesh_clip_unused(struct mesh *mesh);

/* A copy of a mesh with normals, without rows and without what it says of its origin. */
struct mesh mesh_clip_copy(const struct mesh *mesh);

#endif
