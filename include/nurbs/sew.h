/*
 * sew - patches joined along their common boundaries.
 */
#ifndef CLOUDMILL_SEW_H
#define CLOUDMILL_SEW_H

#include "nurbs/patch.h"
#include "nurbs/patch_mesh.h"

struct sew_count {
    size_t joined;   /* border vertices made one with a vertex of another sheet or piece */
    size_t inserted; /* vertices put into a border edge because a neighbour has one there */
    double moved;    /* how far the farthest vertex was moved, mm */
};

/*
 * Gives border vertices that lie within `gap` mm of each other one place, but never two of the same
 * piece that are apart.  A border vertex that lies between the ends of a neighbour's border edge is
 * put into that edge too, on the neighbour's surface and with its normal.  The nearest edges are
 * joined first, then step by step farther ones among those that are still open, so that each side
 * of a narrow surface finds its own neighbour.  Vertices of one place are moved to their middle.
 * `slack` mm is how far the border edges of trimmed patches may be off the true border.
 */
struct sew_count sew(struct patch_mesh *patch_mesh, const struct patches *patches, double gap,
                     double slack);

#endif
