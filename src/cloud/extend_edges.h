/*
 * extend_edges - the surface of a part of a cloud continued beyond its sharp edges, for rows to run
 * out over them.
 */
#ifndef CLOUDMILL_EXTEND_EDGES_H
#define CLOUDMILL_EXTEND_EDGES_H

#include <stdbool.h>

#include "base/array.h"
#include "math/vec.h"

struct extend_edges {
    const struct vec3 *point, *normal;
    const size_t *neighbour; /* as of cloud_neighbours */
    size_t n;
    const bool *in; /* which points are of the part */
};

/*
 * Appends points, about `spacing` mm apart and no further than `length` mm off the part, beside its
 * points at convex edges: where neighbours outside of it stand off by more than 40 degrees.  They
 * lie square to the edge on a quadric, or plane (side_fit.h), through points nearby with like
 * normals. There is none where other points keep a ball of radius `length` from touching there.
 */
void extend_edges_find(const struct extend_edges *cloud, double spacing, double length,
                       struct vec3s *beyond);

#endif
