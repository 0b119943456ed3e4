/*
 * skin_close - what sewing leaves: facets folded onto each other taken out, narrow slits filled.
 */
#ifndef CLOUDMILL_SKIN_CLOSE_H
#define CLOUDMILL_SKIN_CLOSE_H

#include "nurbs/patch_mesh.h"

struct skin_close_count {
    size_t folded; /* pairs of facets with the same three places, turned against each other: taken
                      out, for nothing is between them */
    size_t filled; /* open loops of which no place is farther than the gap from another side */
    size_t facets; /* put into these */
};

/* On patches that are joined and turned (orient.h). */
struct skin_close_count skin_close(struct patch_mesh *mesh, double gap);

#endif
