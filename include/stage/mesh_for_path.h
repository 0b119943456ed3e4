/*
 * mesh_for_path - the mesh that a path is made from: one with rows, or one of any origin made fit
 * to be cut by planes; and how tight its hollows are.  Its origin names the file and its vertices
 * as they were read (`itself`), for the path to name.
 */
#ifndef CLOUDMILL_MESH_FOR_PATH_H
#define CLOUDMILL_MESH_FOR_PATH_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "stage/normals.h"

/* Reads a mesh stream (NULL or "-": standard input), and gives it the normals that were asked for.
 * -1 also when a vertex has none. */
int mesh_for_rows_read(const char *file, const struct normal_estimator *normals, struct mesh *mesh,
                       struct error *error);

/* Reads a mesh (meshfile.h) and repairs it (mesh_repair.h), and reports it by note() and
 * say().  *closed: all its components are.  -1 also when no facet has an area, or a vertex of a
 * facet no normal. */
int mesh_for_planes_read(const char *file, struct vec3 up, int threads, struct mesh *mesh,
                         bool *closed, struct error *error);

/* The tightest hollow that a mesh knows of. */
struct tightest_hollow {
    bool known;          /* the mesh says something of hollows at all */
    double radius;       /* mm; infinite: nothing is hollow */
    struct vec3 at;      /* where */
    const char *surface; /* in which one; NULL: the mesh does not name its surfaces */
    size_t tighter;      /* surfaces, or else vertices, that the ball does not fit */
};

/* By what the mesh says of its surfaces, which is exact, and where it says nothing by kmax of its
 * vertices.  A ball fits up to 1e-6 above the radius of the hollow.  The names are the mesh's. */
struct tightest_hollow mesh_tightest_hollow(const struct mesh *mesh, double ball);

#endif
