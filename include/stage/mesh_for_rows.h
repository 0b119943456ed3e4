/*
 * mesh_for_rows - the mesh that a path is made from, with the normals that were asked for.
 */
#ifndef CLOUDMILL_MESH_FOR_ROWS_H
#define CLOUDMILL_MESH_FOR_ROWS_H

#include "mesh/mesh.h"
#include "stage/normals.h"

/* Reads a mesh stream (NULL or "-": standard input).  -1 also when a vertex has no normal. */
int mesh_for_rows_read(const char *file, const struct normal_estimator *normals, struct mesh *mesh,
                       struct error *error);

/* The highest z of a vertex, mm. */
double mesh_for_rows_top(const struct mesh *mesh);

/* A name for the part: its mesh's source without the folder, or PART. */
const char *mesh_for_rows_name(const struct mesh *mesh);

#endif
