/*
 * weld - patches joined along their common edges.
 */
#ifndef CLOUDMILL_WELD_H
#define CLOUDMILL_WELD_H

#include "patch.h"
#include "quilt.h"

struct weld_count {
    size_t joined;   /* border vertices that lie on one of another sheet or piece */
    size_t inserted; /* vertices put into a border edge because a neighbour has one there */
};

/*
 * Gives border vertices that lie within `gap` mm of each other one place, never two of the same
 * piece that are apart; and where a vertex of one patch lies on the border of another, between two
 * vertices of that, gives it one there too, put on the surface with a normal of its own.  `slack`
 * mm is how far the border edges of trimmed patches may stray from the true border.
 */
struct weld_count weld(struct quilt *quilt, const struct patches *patches, double gap,
                       double slack);

#endif
