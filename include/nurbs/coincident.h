/*
 * coincident - surfaces that a model has twice: two of them in one place, over the same area, of
 * which one is enough.
 */
#ifndef CLOUDMILL_COINCIDENT_H
#define CLOUDMILL_COINCIDENT_H

#include "nurbs/patch.h"
#include "nurbs/tessellate.h"

/*
 * For each patch the number of one before it that it coincides with, or -1; the caller frees the
 * array.  Both may be of other parameters and poles.  They are as large, and places all over each
 * lie on the other, inside its trimming, within `same` mm.  Surfaces of bodies that stay apart
 * (patch_may_join) are none; nor are two with neighbours of their own around them, within `gap` mm:
 * they are walls between two bodies that touch.
 */
int *coincident_find(const struct patches *patches, const struct sheet *sheet, double same,
                     double gap);

#endif
