/*
 * meshnear - how far points are from the facets of a mesh.
 */
#ifndef CLOUDMILL_MESHNEAR_H
#define CLOUDMILL_MESHNEAR_H

#include "mesh.h"

/* Distance of p from the triangle a b c, mm. */
double meshnear_triangle(struct vec3 p, struct vec3 a, struct vec3 b, struct vec3 c);

/*
 * Fills distance[n], mm: of each point from the nearest of the facets with the twenty-four middles
 * that are nearest to it; slender facets have several.  The mesh must have facets.
 */
void meshnear(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
              double *distance);

#endif
