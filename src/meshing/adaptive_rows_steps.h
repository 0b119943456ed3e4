/*
 * adaptive_rows_steps - how rows get as far apart as an error allows: the fewest points along one
 * row, and the triangles between two.
 */
#ifndef CLOUDMILL_ADAPTIVE_ROWS_STEPS_H
#define CLOUDMILL_ADAPTIVE_ROWS_STEPS_H

#include <stdbool.h>

#include "base/array.h"
#include "cloud/plan_extent.h"
#include "math/point_grid.h"
#include "mesh/mesh.h"
#include "cell_surface.h"
#include "meshing/feature_zone.h"

/* ---- row_simplify: a row of a mesh: points of the cloud along a straight line seen from above,
 * and those of them that it takes to follow the rest within a tolerance. */

struct row_simplify {
    double v;          /* the line's place across the rows, in the grid's axes, mm */
    double longest;    /* as it was made */
    struct vec3s node; /* those taken, in the grid's axes, by rising x ... */
    struct ints col;   /* ... and the cells of the line that they stand for */
};

struct row_simplify_options {
    double width, reach, gap, tolerance; /* mm, see below */
    const struct feature_zone *zone;     /* NULL: no creases and walls are known */
};

/*
 * Goes along the line y = v of the grid's axes in steps of `width`; at each is the surface over it,
 * by a quadric through the nearest points or, where that is off them, as at an edge, the nearest
 * point itself; nothing where no point is within `reach`.  Of these places the ends of each stretch
 * without a gap wider than `gap` are taken, and by Douglas and Peucker's rule (1973) the fewest
 * others, so that none is farther than `tolerance` from the straight lines between those taken, in
 * space, and these are about as long as `longest` at most.  None is taken on a crease or wall, but
 * where one runs along the row; near them the lines are no longer than the zone says.
 */
struct row_simplify row_simplify_make(const struct point_grid *point_grid,
                                      const struct plan_extent *plan_extent, double v,
                                      const struct row_simplify_options *options, double longest);
void row_simplify_free(struct row_simplify *row);

/* ---- strip_triangulate: the strip between two rows of a mesh as triangles. */

/*
 * Appends the triangles between a row and the one above it: their corners are the numbers of the
 * lower row's nodes, then, from lower->node.n on, of the upper row's; first those with two corners
 * below, then the others.  Of all ways to join the rows by edges that do not cross it takes the one
 * whose edges are least off the cloud at their middles (sum of squares, by dynamic programming), so
 * that an edge of the part that runs across the rows is followed.  Where they are off by much less
 * than `error` the short ones count.
 */
void strip_triangulate(const struct cell_surfaces *cells, const struct plan_extent *plan_extent,
                       double error, const struct row_simplify *lower,
                       const struct row_simplify *upper, struct faces *faces);

#endif
