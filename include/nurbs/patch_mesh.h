/*
 * patch_mesh - the triangles of several patches, joined along common edges and turned to one side.
 */
#ifndef CLOUDMILL_PATCH_MESH_H
#define CLOUDMILL_PATCH_MESH_H

#include "nurbs/tessellate.h"

struct patch_mesh_vertex {
    struct vec3 point, normal; /* normal as the surface's own parameters give it */
    double k1, k2;             /* k1 >= k2, of that side */
    struct uv at;
    int sheet, piece;
    size_t place; /* vertices of the same place have the same number: that of one of them ... */
    size_t next;  /* ... and are a ring */
};

struct patch_mesh_vertices {
    size_t n, cap;
    struct patch_mesh_vertex *item;
};

/* A border edge of a sheet (or of a piece of one), as its triangle has it. */
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
    struct patch_mesh_edges edge; /* the borders */
    size_t sheets;
    size_t narrow; /* sheets left out */
    bool *flipped; /* [sheet] its normals were the wrong way round */
};

/* All sheets, each as it is.  Of several one that is, on the mean, less than `least` mm wide is
 * left out: its neighbours on both sides then adjoin. */
void patch_mesh_make(const struct sheet *sheet, size_t n, double least,
                     struct patch_mesh *patch_mesh);

bool patch_mesh_same_piece(const struct patch_mesh_vertex *a, const struct patch_mesh_vertex *b);

/* The places of two vertices made one. */
void patch_mesh_unite(struct patch_mesh *patch_mesh, size_t a, size_t b);

/* Every sheet to the side that `flipped` says, vertices of one place and (within one degree) one
 * normal made one; the others of a place, along a sharp edge, keep their normals and get the same
 * coordinates.  Triangles without area are left out. */
void patch_mesh_mesh(const struct patch_mesh *patch_mesh, struct mesh *mesh);

void patch_mesh_free(struct patch_mesh *patch_mesh);

#endif
