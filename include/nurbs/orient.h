/*
 * orient - which side of the patches is outside.
 */
#ifndef CLOUDMILL_ORIENT_H
#define CLOUDMILL_ORIENT_H

#include "nurbs/patch_mesh.h"

struct orient_count {
    size_t bodies;    /* groups of sheets that hang together by their edges */
    size_t conflicts; /* pairs of neighbours that cannot both be right */
    size_t unclear;   /* groups of which up does not say which side is outside */
    size_t open;      /* border edges that no other sheet shares */
};

/*
 * Sets patch_mesh->flipped.  Neighbours along an edge are turned to the same side; then each group
 * as a whole so that its outside looks, on the whole, along `up`.  Where it looks to all sides
 * alike (a closed body, within 2 percent of the area) outside is where its volume is not.
 */
struct orient_count orient_outward(struct patch_mesh *patch_mesh, struct vec3 up);

#endif
