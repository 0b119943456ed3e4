/*
 * reposition - nodal point reposition: which point of the cloud each node of the grid takes
 * (paper 1, 3.2.2).
 *
 * The node takes the point nearest to it, seen from above.  Among points equally near (their
 * squared distances are the same within 1e-9 t^2) the paper's criteria decide, made a total order
 * so that the order of the points in the file does not matter:
 *   A  above the node, or level with it, before below
 *   B  in the middle one of the three triangles of that side before the outer two
 *   C  larger x,
 *
 * then larger z, larger y, and the smaller index.
 */
#ifndef CLOUDMILL_REPOSITION_H
#define CLOUDMILL_REPOSITION_H

#include "base/array.h"
#include "meshing/grid.h"

enum reach {
    REACH_NEAREST, /* a point competes for its nearest node only: no two nodes share a point; a node
                      inside the cloud (at least five full ones around it) that is left empty takes
                      the nearest point that no other node has and that is nearer than 0.7 t */
    REACH_CIRCLE   /* for every node that it is nearer to than t: the paper's circle */
};

#define NO_POINT ((size_t)-1)

/* The index of the point for each node, NO_POINT where there is none: chosen[row * columns +
 * column].  Free with free(). */
size_t *reposition(const struct grid *grid, const struct vec3 *point, size_t n, enum reach reach);

#endif
