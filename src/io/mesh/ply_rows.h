/*
 * ply_rows - the rows of a PLY element into a mesh.
 *
 * Each reads all rows of the source's element, 0 or -1; the arrays grow as the rows come in.
 */
#ifndef CLOUDMILL_PLY_ROWS_H
#define CLOUDMILL_PLY_ROWS_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "ply_source.h"

/* What is wanted of a file: the mesh, checked, or its points as they are. */
enum ply_purpose { PLY_MESH, PLY_POINTS };

/* Vertices, with normals, rows and columns, and kmax where the element has them. */
int ply_vertices(struct ply_source *s, enum ply_purpose purpose, struct mesh *mesh,
                 struct error *error);

/* Faces, behind the vertices; a polygon becomes a fan of triangles about its first corner. */
int ply_faces(struct ply_source *s, struct mesh *mesh, struct error *error);

/* Any other element. */
int ply_passed_over(struct ply_source *s, struct error *error);

#endif
