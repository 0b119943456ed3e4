/*
 * rowzip - the strip between two rows of a mesh as triangles.
 */
#ifndef CLOUDMILL_ROWZIP_H
#define CLOUDMILL_ROWZIP_H

#include "math/point_grid.h"
#include "cloud/plan_extent.h"
#include "mesh/mesh.h"
#include "rowcurve.h"

/*
 * Appends the triangles between a row and the one above it: their corners are the numbers of the
 * lower row's nodes, then, from lower->node.n on, of the upper row's; first those with two corners
 * below, then the others.  Of all ways to join the rows by edges that do not cross it takes the one
 * whose edges are least off the cloud at their middles (sum of squares, by dynamic programming), so
 * that an edge of the part that runs across the rows is followed.  Where they are off by much less
 * than `error` the short ones count.
 */
void rowzip(const struct point_grid *point_grid, const struct plan_extent *plan_extent,
            double error, const struct rowcurve *lower, const struct rowcurve *upper,
            struct faces *faces);

#endif
