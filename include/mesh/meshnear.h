/*
 * meshnear - how far points are from the facets of a mesh.
 */
#ifndef CLOUDMILL_MESHNEAR_H
#define CLOUDMILL_MESHNEAR_H

#include "mesh/mesh.h"

/* Fills distance[n], mm: of each point from the facet nearest to it.  The mesh must have facets. */
void meshnear(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
              double *distance);

#endif
