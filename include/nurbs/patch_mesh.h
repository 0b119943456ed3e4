/*
 * patch_mesh - the triangles of several patches, to be sewn, oriented and written as one mesh.
 */
#ifndef CLOUDMILL_PATCH_MESH_H
#define CLOUDMILL_PATCH_MESH_H

#include "nurbs/tessellate.h"

/* Degrees. */
#define PATCH_MESH_SMOOTH 1.0

/* Decimals of a mm that places have when they are written (cloudmill-mesh(5)). */
enum { PATCH_MESH_DIGITS = 6 };

struct patch_mesh_vertex {
    struct vec3 point, normal; /* the normal along dS/du x dS/dv */
    double k1, k2;             /* k1 >= k2, seen from that side */
    struct uv at;
    int sheet, piece;
    size_t place; /* sewn vertices have the same number, that of one of them ... */
    size_t next;  /* ... and form a ring */
};

struct patch_mesh_vertices {
    size_t n, cap;
    struct patch_mesh_vertex *item;
};

/* A border edge of a sheet (or of a piece of one), in the direction of its triangle. */
struct patch_mesh_edge {
    size_t from, to; /* vertices */
    size_t face;
};

struct patch_mesh_edges {
    size_t n, cap;
    struct patch_mesh_edge *item;
};

struct patch_mesh {
    struct patch_mesh_vertices vertex;
    struct faces face;
    struct ints sheet;            /* of each face */
    struct patch_mesh_edges edge; /* the boundary */
    size_t sheets;
    size_t narrow; /* sheets left out */
    bool *flipped; /* [sheet] its outside is the side away from dS/du x dS/dv */
};

/* All sheets, not yet joined.  Where there are several, one whose mean width is less than `least`
 * mm is left out: its neighbours on both sides then adjoin. */
void patch_mesh_make(const struct sheet *sheet, size_t n, double least,
                     struct patch_mesh *patch_mesh);

/* Do both belong to the same piece of the same sheet? */
bool patch_mesh_same_piece(const struct patch_mesh_vertex *a, const struct patch_mesh_vertex *b);

/* Gives two vertices, and all of their places, one place. */
void patch_mesh_unite(struct patch_mesh *patch_mesh, size_t a, size_t b);

/* Appends all triangles, each sheet turned to the side that `flipped` says.  Vertices of one place
 * whose normals are within PATCH_MESH_SMOOTH become one; the others of a place, along a sharp edge,
 * keep their normals and get the same coordinates.  Triangles without area are left out.
 * mesh->surface has the sheets. */
void patch_mesh_mesh(const struct patch_mesh *patch_mesh, struct mesh *mesh);

void patch_mesh_free(struct patch_mesh *patch_mesh);

#endif
