/*
 * surfaces_told - what is wrong with the trimming of surfaces, as their triangles show it, in
 * messages: of whoever makes a mesh of them, and of whoever judges by them.
 */
#ifndef CLOUDMILL_SURFACES_TOLD_H
#define CLOUDMILL_SURFACES_TOLD_H

#include "nurbs/patch.h"
#include "nurbs/tessellate.h"

/* By the size of the part: edges of neighbours, and curves of a loop, so near are one. */
#define SURFACES_GAP 2.5e-4

/*
 * Surfaces are refused whose curves in space lie further than `limit` mm off them, or whose
 * trimming crosses itself: with `error` the first of them goes there; with NULL each is said,
 * emptied and marked.  Returns how many.
 */
size_t surfaces_tell_refused(const struct patches *patches, struct sheet *sheet, double limit,
                            struct error *error);

/* Says what the trimming of each surface left unclear, and which curves in space lie further than
 * `fine` mm off their surface. */
void surfaces_tell_trimming(const struct patches *patches, const struct sheet *sheet, double fine);

/* Trimming loops with a gap of more than `limit` mm, which a straight line closes; returns of how
 * many surfaces. */
size_t surfaces_tell_gaps(const struct patches *patches, const struct sheet *sheet, double limit);

#endif
