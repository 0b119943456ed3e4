/*
 * skin_sides - the sides of all facets of a patch_mesh by their places.
 */
#ifndef CLOUDMILL_SKIN_SIDES_H
#define CLOUDMILL_SKIN_SIDES_H

#include "nurbs/patch_mesh.h"

/* The side of a facet, by its places, the lower first. */
struct skin_side {
    size_t low, high;
    size_t facet;
    bool forward; /* from low to high, as the facet is turned */
    int corner;   /* of the facet, that it begins at as the facet stands */
};

struct skin_sides {
    size_t n, cap;
    struct skin_side *item;
};

/* Three places that differ; one with less is no facet. */
bool skin_facet_counts(const struct patch_mesh *mesh, size_t facet);

/* All sides, those between the same two places one after the other.  The caller frees them. */
struct skin_side *skin_sides_find(const struct patch_mesh *mesh, size_t *n);

/* How many sides from side i on are between the same two places. */
size_t skin_sides_same(const struct skin_side *side, size_t n, size_t i);

/* True if the k sides of one edge are two, of facets turned alike. */
bool skin_edge_sound(const struct skin_side *side, size_t k);

/* How many edges are not. */
size_t skin_count_unsound(const struct patch_mesh *mesh);

#endif
