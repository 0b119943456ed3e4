/*
 * rows - the rows of a mesh from a triangular grid, as strips of contact points (paper 1, 3.2.1
 * and 3.3: each row of tool centres belongs to a row of facets).
 */
#ifndef CLOUDMILL_ROWS_H
#define CLOUDMILL_ROWS_H

#include "base/array.h"
#include "base/error.h"
#include "mesh/mesh.h"

/* Neighbours in a row that facet edges join, by rising column. */
struct strip {
    int row;
    size_t from, to;   /* elements [from, to) of rows.node */
    struct vec3 along; /* unit vectors: the way the columns rise, ... */
    struct vec3 side;  /* ... perpendicular to it the way the rows rise ... */
    struct vec3 up;    /* ... and out of the plane that the grid of its part lies in */
};

struct rows {
    struct sizes node; /* vertices of the mesh, row by row and by rising column */
    struct {
        size_t n, cap;
        struct strip *item;
    } strip;           /* by row, then by column */
    struct vec3 along; /* horizontal unit vector, the way the columns rise */
    struct vec3 side;  /* horizontal unit vector perpendicular to it, the way the rows rise */
    double distance;   /* from row to row, mm */
    size_t loose;      /* vertices that belong to no facet: left out */
};

/*
 * Finds the rows of a mesh.  A strip ends where the next node of the row is not joined to it by a
 * facet edge and is not at the same place: there is a hole, or a step too high.  Vertices of one
 * row and column follow each other in the order of the mesh; those of a negative row are in no row.
 * The direction is the one that the mesh states (mesh.origin.direction) if the rows agree with it
 * within AGREE, else that of the rows; where the mesh has parts, what it states of these.  -1: the
 * mesh has no rows, or no facet.
 */
int rows_find(const struct mesh *mesh, struct rows *rows, struct error *error);

void rows_free(struct rows *rows);

#endif
