/*
 * unseen_wall - walls of a part that a scan from above has no points on.
 *
 * Between the last points of a roof and the first ones below it a wall may stand anywhere, as far
 * as the scan tells: a tool that keeps clear of all of that leaves material beside the wall, and
 * who judges it does not know better.  A point is at the foot of such a wall where, seen from
 * above, other points near it are higher by more than a steep slope explains, with none of a height
 * between, and no other low point is nearer to these.  On a flank that was scanned, however steep,
 * there are points of all heights.  A lower step counts where both its sides are plane and alike,
 * as of a terrace.  Lengths in mm.
 */
#ifndef CLOUDMILL_UNSEEN_WALL_H
#define CLOUDMILL_UNSEEN_WALL_H

#include "math/kdtree.h"

/*
 * The height above each of n points, which are those of the tree, up to which an unseen wall may
 * stand over it; 0: none.  `spacing`: distances of the points about each; height[n], of which those
 * are looked for that are not below zero.
 */
void unseen_wall_find(const struct vec3 *point, const double *spacing, size_t n,
                      const struct kdtree *tree, int threads, double *height);

#endif
