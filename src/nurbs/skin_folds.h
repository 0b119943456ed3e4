/*
 * skin_folds - facets of a skin that lie on each other: folds, slivers, crumbs.
 */
#ifndef CLOUDMILL_SKIN_FOLDS_H
#define CLOUDMILL_SKIN_FOLDS_H

#include "nurbs/patch_mesh.h"

/* Width of a facet, mm: its height over its longest side; HUGE_VAL for one that stands for what
 * lies beyond a region (skin_region.h). */
double skin_facet_width(const struct patch_mesh *mesh, size_t facet);

/* Takes out the facets with out[] true; the others close up. */
void skin_drop_facets(struct patch_mesh *mesh, const bool *out);

/*
 * Takes out pairs of facets with the same three places, and slivers no wider than the gap (mm)
 * along an edge of three facets without which more edges have two.  Returns how many of both.
 */
size_t skin_drop_folds(struct patch_mesh *mesh, double gap);

/* Takes out what hangs together by its sides and is no wider, on the whole, than the gap: left over
 * between borders that were joined.  Where all is so small nothing is taken out. */
void skin_drop_crumbs(struct patch_mesh *mesh, double gap);

/* Where vertices became one place, a sliver between them may have been left upside down: it is
 * turned as most of its neighbours are. */
void skin_turn_slivers(struct patch_mesh *mesh, double gap);

#endif
