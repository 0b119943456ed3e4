/*
 * trim_traverse - closed polygons followed over a grid from cell to cell.
 */
#ifndef CLOUDMILL_TRIM_TRAVERSE_H
#define CLOUDMILL_TRIM_TRAVERSE_H

#include "trim_clip.h"
#include "trim_snap.h"
#include "nurbs/trim_grid.h"

/* The grid, and what the polygons did to it. */
struct trim_traverse {
    struct trim_lattice u, v;
    const double *u_line, *v_line;
    struct uvmesh *mesh;      /* its vertices: the nodes, row by row, then those of the polygons */
    struct ints id;           /* vertices of all chains */
    struct trim_chains chain; /* lines through cells, the inside on their left */
    int *turn;     /* [line of v][column + 1]: loops crossing it upwards less those downwards */
    bool *crossed; /* [cell] a chain runs through it */
    bool open;     /* the border of the grid bounds the inside too */
};

/*
 * Follows all loops: every corner, and every place where a side goes over a line of the grid, gets
 * a vertex, one that is shared by the cells on both sides of the line.  On the lattice lines are
 * even and corners odd, so that which line comes next is decided by whole numbers.
 */
void trim_traverse_loops(struct trim_traverse *walk, const struct uv_polygon *loops);

#endif
