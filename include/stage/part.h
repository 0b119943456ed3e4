/*
 * part - the mesh that a path is made from, with the normals that were asked for.
 */
#ifndef CLOUDMILL_PART_H
#define CLOUDMILL_PART_H

#include "mesh/mesh.h"

enum part_normals {
    PART_MESH,    /* those of the mesh; of the facets when it has none */
    PART_FACET,   /* the mean of the facets' (paper 1, eq 8) */
    PART_GOURAUD, /* the mean of the neighbours' (eq 7) */
    PART_CENTRAL  /* central differences on a mesh with rows */
};

/* Reads a mesh stream (NULL or "-": standard input).  -1 also when a vertex has no normal. */
int part_read(const char *file, enum part_normals normals, struct mesh *mesh, struct error *error);

/* The highest z of a vertex, mm. */
double part_top(const struct mesh *mesh);

/* A name for the part: its mesh's source without the folder, or PART. */
const char *part_name(const struct mesh *mesh);

#endif
