/*
 * feature_link - gaps in the lines that creases and walls make over a mesh.
 */
#ifndef CLOUDMILL_FEATURE_LINK_H
#define CLOUDMILL_FEATURE_LINK_H

#include "feature.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

/*
 * A crease or wall ends where it comes into a facet over one of its edges and crosses none of the
 * other two.  From there it is followed, straight on over the sheets that it has, from facet to
 * facet; where that leads within six of them to another crease or wall, or to the border of the
 * mesh (or through a corner beside that), the edges on the way get its continuation, in place of
 * FEATURE_NONE.  A crease goes on only over edges whose ends are on its sheets.  Nothing else
 * changes.
 */
void feature_link_close(const struct mesh *mesh, const struct mesh_edges *edges,
                        struct feature *feature);

/* The most edges in one chain: from facet to facet, over edges that something crosses. */
size_t feature_link_longest(const struct mesh_edges *edges, const struct feature *feature);

#endif
