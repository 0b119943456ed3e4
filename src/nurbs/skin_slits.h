/*
 * skin_slits - open edges of a skin followed round, and narrow loops of them filled.
 */
#ifndef CLOUDMILL_SKIN_SLITS_H
#define CLOUDMILL_SKIN_SLITS_H

#include "nurbs/skin_close.h"

/* How slits are filled. */
struct skin_slits_options {
    double gap;   /* mm: wider ones stay */
    bool between; /* only those between several surfaces: one in a single surface is a slot that its
                     trimming says */
    bool avoid;   /* no second edge between two places: where every diagonal would be one, a vertex
                     is put into the middle; else the shortest are taken */
};

/* Fills the slits there are; adds to the counts of filled loops and facets, and what widens the
 * width.  Folds and slivers that are the wrong way round are mended (skin_folds.h). */
void skin_fill_slits(struct patch_mesh *mesh, const struct skin_slits_options *options,
                     struct skin_close_count *count);

#endif
