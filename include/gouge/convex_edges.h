/*
 * convex_edges - where a mesh has a sharp edge that stands out, as points: a scan seldom has points
 * on its edges, and a ball that rolls over them would sink in between those beside.
 */
#ifndef CLOUDMILL_CONVEX_EDGES_H
#define CLOUDMILL_CONVEX_EDGES_H

#include "mesh/mesh.h"

/*
 * Appends points no further than `spacing` mm apart on the edges between two facets that have
 * vertices of their own there, at the same places, and fall off from each other to both sides.
 */
void convex_edges_sample(const struct mesh *mesh, double spacing, struct vec3s *to);

#endif
