/*
 * skin_loops - the open edges of a patch_mesh as loops, and how far apart the surfaces lie there.
 */
#ifndef CLOUDMILL_SKIN_LOOPS_H
#define CLOUDMILL_SKIN_LOOPS_H

#include "nurbs/skin.h"
#include "skin_sides.h"

/* The loops of the open edges, the longest first.  The caller frees the array. */
struct skin_loops skin_loops_find(const struct patch_mesh *mesh, const struct skin_sides *open);

#endif
