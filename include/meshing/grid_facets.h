/*
 * grid_facets - the mesh of grid_mesh.h without a copy of it: which facets there are between the
 * nodes of a reposition, and a vertex or a facet at a time as it is wanted, in the order of a mesh
 * stream.  A byte a node.
 */
#ifndef CLOUDMILL_GRID_FACETS_H
#define CLOUDMILL_GRID_FACETS_H

#include "meshing/grid_mesh.h"
#include "meshing/reposition.h"

struct grid_facets {
    const struct reposition *nodes;
    struct grid_mesh_count count;
    size_t vertices, facets;
    double steep;        /* mesh_steep_part */
    unsigned char *mark; /* of each node that is kept: its facets, and whether it is a vertex */
};

/* Facets as grid_mesh_make has them with these holes. */
struct grid_facets grid_facets_find(const struct reposition *nodes, const struct holes *holes);
void grid_facets_free(struct grid_facets *facets);

/* Shows the vertices, with normals as mesh_normals_facet and mesh_normals_seen have them. */
void grid_facets_vertices(const struct grid_facets *facets,
                          void (*take)(void *context, struct vec3 at, struct vec3 normal, int row,
                                       int column),
                          void *context);

/* Shows the facets, their corners as numbers of vertices. */
void grid_facets_faces(const struct grid_facets *facets,
                       void (*take)(void *context, const int corner[3]), void *context);

/* Appends to the mesh the part of it between two rows and two columns (these included): vertices
 * with row and column, and the facets with all corners there, in the order of the whole. */
void grid_facets_part(const struct grid_facets *facets, int row0, int row1, int column0,
                      int column1, struct mesh *mesh);

/* The row and the column of n vertices of these numbers, which rise; and where one of them is. */
void grid_facets_numbered(const struct grid_facets *facets, const size_t *number, size_t n,
                          int *row, int *column);
struct vec3 grid_facets_vertex(const struct grid_facets *facets, size_t number);

#endif
