/*
 * cellwalk - closed polygons followed over a grid from cell to cell.
 */
#ifndef CLOUDMILL_CELLWALK_H
#define CLOUDMILL_CELLWALK_H

#include "cellcut.h"
#include "lattice.h"
#include "nurbs/trimcut.h"

/* The grid, and what the polygons did to it. */
struct cellwalk {
    struct lattice u, v;
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
void cellwalk_loops(struct cellwalk *walk, const struct uvloops *loops);

#endif
