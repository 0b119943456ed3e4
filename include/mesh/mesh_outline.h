/*
 * mesh_outline - the border of a mesh seen along z, as polygons.
 */
#ifndef CLOUDMILL_MESH_OUTLINE_H
#define CLOUDMILL_MESH_OUTLINE_H

#include "math/region.h"
#include "mesh/mesh.h"

/*
 * Polygons of which an odd number hold what the mesh has, where none of it is over another part of
 * it.  Corners of its border are left out as far as none is farther than `within` mm from the
 * straight line that goes past it, and so are holes that are no wider, and islands no wider than
 * `narrow`.  False, and nothing is found: more than two facets meet in an edge, or neighbours face
 * different sides.
 */
bool mesh_outline_find(const struct mesh *mesh, double within, double narrow,
                       struct region_polygons *outline);

#endif
