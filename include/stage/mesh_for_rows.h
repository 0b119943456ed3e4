/*
 * mesh_for_rows - the mesh that a path is made from, with the normals that were asked for.
 */
#ifndef CLOUDMILL_MESH_FOR_ROWS_H
#define CLOUDMILL_MESH_FOR_ROWS_H

#include "mesh/mesh.h"

enum mesh_for_rows_normals {
    ROW_NORMALS_MESH,    /* those of the mesh; of the facets when it has none */
    ROW_NORMALS_FACET,   /* the mean of the facets' (paper 1, eq 8) */
    ROW_NORMALS_GOURAUD, /* the mean of the neighbours' (eq 7) */
    ROW_NORMALS_CENTRAL  /* central differences on a mesh with rows */
};

/* Reads a mesh stream (NULL or "-": standard input).  -1 also when a vertex has no normal. */
int mesh_for_rows_read(const char *file, enum mesh_for_rows_normals normals, struct mesh *mesh,
                       struct error *error);

/* The highest z of a vertex, mm. */
double mesh_for_rows_top(const struct mesh *mesh);

/* A name for the part: its mesh's source without the folder, or PART. */
const char *mesh_for_rows_name(const struct mesh *mesh);

#endif
