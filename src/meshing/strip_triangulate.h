/*
 * strip_triangulate - the strip between two rows of a mesh as triangles.
 */
#ifndef CLOUDMILL_STRIP_TRIANGULATE_H
#define CLOUDMILL_STRIP_TRIANGULATE_H

#include "math/point_grid.h"
#include "cloud/plan_extent.h"
#include "mesh/mesh.h"
#include "row_simplify.h"

/*
 * Appends the triangles between a row and the one above it: their corners are the numbers of the
 * lower row's nodes, then, from lower->node.n on, of the upper row's; first those with two corners
 * below, then the others.  Of all ways to join the rows by edges that do not cross it takes the one
 * whose edges are least off the cloud at their middles (sum of squares, by dynamic programming), so
 * that an edge of the part that runs across the rows is followed.  Where they are off by much less
 * than `error` the short ones count.
 */
void strip_triangulate(const struct point_grid *point_grid, const struct plan_extent *plan_extent,
                       double error, const struct row_simplify *lower,
                       const struct row_simplify *upper, struct faces *faces);

#endif
