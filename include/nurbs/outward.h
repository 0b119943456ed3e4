/*
 * outward - which side of the patches is outside.
 */
#ifndef CLOUDMILL_OUTWARD_H
#define CLOUDMILL_OUTWARD_H

#include "nurbs/quilt.h"

struct outward_count {
    size_t bodies;    /* groups of sheets that hang together by their edges */
    size_t conflicts; /* pairs of neighbours that cannot both be right */
    size_t unclear;   /* groups of which up does not say which side is outside */
    size_t open;      /* border edges that no other sheet shares */
};

/*
 * Sets quilt->flipped.  Neighbours along an edge are turned to the same side; then each group as a
 * whole so that its outside looks, on the whole, along `up`.  Where it looks to all sides alike (a
 * closed body, within 2 percent of the area) outside is where its volume is not.
 */
struct outward_count outward(struct quilt *quilt, struct vec3 up);

#endif
