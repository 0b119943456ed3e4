/*
 * mesh_sums - figures of a mesh, read from its file by the tests' own reader.
 */
#ifndef READBACK_MESH_SUMS_H
#define READBACK_MESH_SUMS_H

#include <stddef.h>

#include "base/error.h"

struct mesh_sums {
    size_t vertices, facets;
    double area, volume; /* mm2; mm3 between the facets and the origin */
    size_t open;         /* edges, one way, that do not have one facet on each side ... */
    size_t uneven;       /* ... or not as many on either */
    double off;          /* most that the length of a normal is off one */
    double least;        /* cosine of a normal and a facet with some area at it */
};

/* Of a PLY as text with x y z nx ny nz first and triangles.  Vertices that are written alike are
 * one for its edges.  -1: no such file. */
int mesh_sums_read(const char *file, struct mesh_sums *sums, struct error *error);

#endif
