/*
 * step_repeats - faces of a STEP file that its representations show more often than they are there:
 * what is dropped of the patches from number `from` on.
 */
#ifndef CLOUDMILL_STEP_REPEATS_H
#define CLOUDMILL_STEP_REPEATS_H

#include "base/array.h"
#include "nurbs/patch.h"

/* What a representation that is part of no assembly shows of a component, as some systems write for
 * the solid that a volume or an area is told of: it is where the assembly has it.  `unplaced` has
 * ranges of such patches, the first and the one after the last. */
void step_drop_unplaced(struct patches *patches, const struct sizes *unplaced, size_t from);

/* Faces that a representation names by themselves, as the place of a tolerance or a colour, when
 * they are faces of a closed shell too. */
void step_drop_named(struct patches *patches, size_t from);

/* What several representations show in the same place: it is there once. */
void step_drop_repeated(struct patches *patches, size_t from);

#endif
