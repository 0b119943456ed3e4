/*
 * t_vertices - vertices of a border that lie on the border edges of other patches.
 */
#ifndef CLOUDMILL_T_VERTICES_H
#define CLOUDMILL_T_VERTICES_H

#include "boundary.h"
#include "nurbs/patch.h"

/* A vertex that is to be put into a border edge. */
struct t_vertex {
    double t;      /* how far along the edge, 0 to 1 */
    size_t vertex; /* whose place it takes */
    struct uv at;  /* on the surface that the edge is of */
};

struct t_vertices {
    size_t n, cap;
    struct t_vertex *item;
};

/* Borders that are to meet. */
struct meeting {
    const struct patch_mesh *patch_mesh;
    const struct patches *patches;
    const struct boundary *border;
    double gap; /* mm: what is nearer meets */
    double
        slack; /* mm: how far the border edges of trimmed patches may stray from the true border */
};

/* True of two vertices of one piece that its border does not bring together again: those less than
 * half the range apart.  A surface that closes on itself has others at one place. */
bool t_vertices_beside(const struct patches *patches, const struct patch_mesh_vertex *a,
                       const struct patch_mesh_vertex *b);

/* The vertices, in the order of the edge, that lie between its ends, near its chord as far as the
 * surface and the slack let them, and within the gap of the surface `part`, which is the edge's. */
void t_vertices_find(const struct meeting *m, const struct nurbs *part,
                     const struct patch_mesh_edge *edge, struct t_vertices *guests);

#endif
