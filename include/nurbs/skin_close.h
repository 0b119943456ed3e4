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
    double width;  /* of the widest of them, mm */
};

/*
 * On patches that are joined and turned (orient.h).  Slivers no wider than the gap that lie over
 * each other, so that more than two facets share an edge or two are turned differently, are taken
 * out, and what is open then is filled, up to four gaps wide where less does not help; and what is
 * open between several surfaces in any case up to `most` mm (of eight gaps).
 */
struct skin_close_count skin_close(struct patch_mesh *mesh, double gap, double most);

#endif
