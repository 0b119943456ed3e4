/*
 * sew - patches joined along their common edges.
 */
#ifndef CLOUDMILL_SEW_H
#define CLOUDMILL_SEW_H

#include "nurbs/patch.h"
#include "nurbs/patch_mesh.h"

struct sew_count {
    size_t joined;   /* border vertices that lie on one of another sheet or piece */
    size_t inserted; /* vertices put into a border edge because a neighbour has one there */
    double moved;    /* how far the farthest went, mm */
};

/*
 * Gives border vertices that lie within `gap` mm of each other one place, never two of the same
 * piece that are apart, and puts vertices into the edges between (sew_insert.h): the nearest edges
 * first, then step by step farther ones among those that are still without a neighbour, so that the
 * two sides of a narrow surface each get their own.  Vertices of one place are moved to the middle
 * of them.  `slack` mm is how far the border edges of trimmed patches may stray from the true
 * border.
 */
struct sew_count sew(struct patch_mesh *patch_mesh, const struct patches *patches, double gap,
                     double slack);

#endif
