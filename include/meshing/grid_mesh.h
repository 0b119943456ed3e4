/*
 * grid_mesh - from the points chosen for the grid's nodes to the mesh in space (paper 1, 3.2.3).
 */
#ifndef CLOUDMILL_GRID_MESH_H
#define CLOUDMILL_GRID_MESH_H

#include "meshing/grid.h"
#include "cloud/holes.h"
#include "mesh/mesh.h"

/* What stayed out of the mesh. */
struct grid_mesh_count {
    size_t bridges; /* facets over a hole */
    size_t folded;  /* facets that would lie face down */
    size_t no_area; /* facets with the same point twice, or all corners on a line */
    size_t alone;   /* nodes that no facet reaches */
};

/* Are three points of neighbouring nodes the corners of a facet?  Counts why not.  `holes`: as
 * below. */
bool grid_mesh_facet(const struct vec3 p[3], const struct holes *holes,
                     struct grid_mesh_count *count);

/*
 * Vertices with their row and column, row by row; facets row by row of triangles, in each row
 * first those that point up, then those that point down, counter-clockwise in the grid.  A
 * triangle with a node that has no point is no facet.  With `holes` (else NULL) facets over a
 * hole are left out, those that lie face down seen from above (where the grid is too fine for the
 * points; the others around cover the place), and vertices without a facet.  `threads` as in
 * parallel.h.
 */
struct grid_mesh_count grid_mesh_make(const struct grid *grid, const size_t *chosen,
                                      const struct vec3 *point, const struct holes *holes,
                                      int threads, struct mesh *mesh);

#endif
