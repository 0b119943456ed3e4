/*
 * greedy_insert - points put into a mesh as vertices between its rows where it is off them.
 */
#ifndef CLOUDMILL_GREEDY_INSERT_H
#define CLOUDMILL_GREEDY_INSERT_H

#include "mesh/mesh.h"

/*
 * Splits facets until each of n points that one is above or below, seen along z, is within
 * within[i] mm of it or of a facet beside it: the farthest point of a facet becomes a vertex in no
 * row (row and column -1), and edges about it are turned (facet_split.h; Garland, Heckbert 1995).
 * Points that an upright facet is near enough to are left alone, and so are those steeper than 85
 * degrees to a corner of their facet.  New normals are the means of the facets'; a new vertex has
 * the largest hollow curvature of the corners about it.  Returns how many vertices there are more.
 * The mesh must have rows and normals.
 */
size_t greedy_insert(struct mesh *mesh, const struct vec3 *point, const double *within, size_t n,
                     int threads);

#endif
