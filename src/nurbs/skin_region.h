/*
 * skin_region - the part of a skin about its edges that are not sound, as a patch_mesh of its own:
 * what is mended there takes time by the region, not by the skin.
 */
#ifndef CLOUDMILL_SKIN_REGION_H
#define CLOUDMILL_SKIN_REGION_H

#include "nurbs/patch_mesh.h"

/*
 * The facets within a few rings of an edge that has not two facets turned alike, or two that are
 * each other's back.  In place of the skin beyond it there is one vertex of sheet -1, the apex: a
 * facet from it to each edge of the region's border keeps that edge from being open.
 */
struct skin_region {
    struct patch_mesh mesh; /* vertices [0, n) are copies; `flipped` is the skin's */
    size_t *vertex;         /* of the skin, of the first `vertices` of the mesh */
    size_t vertices;
    bool *inside; /* [facet of the skin] it is in the region */
};

/* False: all edges are sound, and there is nothing to free. */
bool skin_region_find(const struct patch_mesh *skin, struct skin_region *region);

/* Puts the region's facets, and vertices that were added to it, in place of those that it was made
 * of. */
void skin_region_put(struct patch_mesh *skin, const struct skin_region *region);

void skin_region_free(struct skin_region *region);

#endif
