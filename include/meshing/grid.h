/*
 * grid - the oblique grid of equilateral triangles over a cloud (paper 1, 3.2.1).
 *
 * Chui, Chiu, Yu 2007, eqs 2 to 6: the pseudo minimum boundary parallelogram (PMBP) stands on the
 * lowest point of the cloud and leans at 60 degrees; node (column i, row j) is at
 * corner + i e1 + j e2 with e1 = t i, e2 = t/2 i + t sqrt(3)/2 j.  (The paper prints
 * e2 = i + sqrt(3) j, and a minus in eq 3 where the upper right corner needs a plus.)
 */
#ifndef CLOUDMILL_GRID_H
#define CLOUDMILL_GRID_H

#include <stddef.h>

#include "base/error.h"
#include "cloud/plan_extent.h"
#include "math/vec.h"

#define GRID_SLANT 0.86602540378443864676 /* sin 60: height of a row, times t */

struct grid {
    struct plan_extent plan_extent;
    double t;          /* side of the triangles, mm */
    double x, y;       /* lower left corner, node (0, 0), in the grid's axes (eq 2) */
    int columns, rows; /* of nodes: one more than of triangles */
};

/*
 * The grid with triangles of side t over a plan_extent.  -1 when it would have more than 50 nodes
 * for each of the n points (and 1,000), or 1e9: points far off, or t far too small.
 */
int grid_make(const struct plan_extent *plan_extent, size_t n, double t, struct grid *grid,
              struct error *error);

size_t grid_nodes(const struct grid *grid);

/* A node in the grid's axes, z = 0. */
struct vec3 grid_node(const struct grid *grid, int column, int row);

#endif
