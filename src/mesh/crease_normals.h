/*
 * crease_normals - normals for a mesh that has none, and sharp edges kept sharp.
 */
#ifndef CLOUDMILL_CREASE_NORMALS_H
#define CLOUDMILL_CREASE_NORMALS_H

#include "mesh/mesh.h"

/*
 * Where two facets meet at more than 30 degrees, or at a border or an edge of many facets, each
 * side gets vertices of its own.  Fills mesh->normal with the mean of the facets' normals at each
 * vertex, weighted by their angle there.  Vertices without a facet go, and so do kmax, rows and
 * columns. Facets must have area and be turned alike.
 */
void crease_normals(struct mesh *mesh);

#endif
