/*
 * mesh_edges - the edges of a mesh and the facets beside them.
 */
#ifndef CLOUDMILL_MESH_EDGES_H
#define CLOUDMILL_MESH_EDGES_H

#include "curve/edge_curve.h"
#include "mesh/mesh.h"

enum { EDGE_BORDER = -1, EDGE_MANY = -2 };

struct mesh_edge {
    int v[2];     /* the smaller vertex first */
    int facet[2]; /* EDGE_BORDER where there is no second one; both EDGE_MANY: more than two */
};

struct mesh_edges {
    size_t n;
    struct mesh_edge *edge; /* by their vertices */
    int (*of)[3];           /* edges of each facet, [i] from its corner i to the next */
};

/* The facets must have three different vertices each. */
struct mesh_edges mesh_edges_find(const struct mesh *mesh);

void mesh_edges_free(struct mesh_edges *edges);

/* The facet on the other side of an edge; negative where there is none, or more than one. */
int mesh_edge_beyond(const struct mesh_edges *edges, int edge, int facet);

/* The way from one vertex to another as the surface runs there.  Straight where it would be off its
 * chord by more than half the spacing of the mesh's grid: such an edge spans what nobody has seen,
 * as a wall that scan lines pass by, and the normals of its ends say nothing of it. */
struct edge_curve mesh_edge_curve(const struct mesh *mesh, int from, int to);

#endif
