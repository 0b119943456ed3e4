/*
 * mesh_coverage - which points are above or below a mesh, seen along z.
 */
#ifndef CLOUDMILL_MESH_COVERAGE_H
#define CLOUDMILL_MESH_COVERAGE_H

#include "base/array.h"
#include "base/error.h"
#include "mesh/mesh.h"

/* Appends to `covered` those of n points that a facet is above or below, or has on its border; in
 * an order of their own, the same each time.  `spacing` is about what they are apart, mm.  -1: they
 * cannot be sorted (point_grid.h). */
int mesh_coverage(const struct mesh *mesh, const struct vec3 *point, size_t n, double spacing,
                  struct vec3s *covered, struct error *error);

#endif
