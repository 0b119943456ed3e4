/*
 * mesh_for_planes - a mesh of any origin made fit to be cut by planes, and how tight it is.
 */
#ifndef CLOUDMILL_MESH_FOR_PLANES_H
#define CLOUDMILL_MESH_FOR_PLANES_H

#include "base/error.h"
#include "mesh/mesh.h"

/* Reads a mesh (meshfile.h) and mends it (mesh_repair.h), with what was done told by note() and
 * say().  *closed: all its sheets are.  -1 also when no facet has an area, or a vertex of a facet
 * no normal. */
int mesh_for_planes_read(const char *file, struct vec3 up, struct mesh *mesh, bool *closed,
                         struct error *error);

/* The tightest hollow that a mesh knows of. */
struct mesh_for_planes_hollow {
    bool known;          /* the mesh says something of hollows at all */
    double radius;       /* mm; infinite: nothing is hollow */
    struct vec3 at;      /* where */
    const char *surface; /* in which one; NULL: the mesh does not name its surfaces */
    size_t tighter;      /* surfaces, or else vertices, that the ball does not fit */
};

/* By what the mesh says of its surfaces, which is exact, and where it says nothing by kmax of its
 * vertices.  A ball fits up to 1e-6 above the radius of the hollow.  The names are the mesh's. */
struct mesh_for_planes_hollow mesh_for_planes_hollow(const struct mesh *mesh, double ball);

#endif
