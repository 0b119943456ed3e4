/*
 * arc_carry - the pieces of a smooth part of a run, carried over to the same part of which some
 * points have moved.
 */
#ifndef CLOUDMILL_ARC_CARRY_H
#define CLOUDMILL_ARC_CARRY_H

#include "arcfit/arc_piece.h"
#include "curve/run.h"

/* Nothing of the two points differs. */
bool arc_carry_same(const struct run_point *a, const struct run_point *b);

/* From piece `from` to piece `to` - 1 all is to be fitted anew. */
struct arc_moved {
    size_t from, to;
};

struct arc_moves {
    size_t n, cap;
    struct arc_moved *item;
};

/* True if both are dense points of the same part: as many that were given, and neither end moved by
 * more than a tenth of a millimetre. */
bool arc_carry_alike(const struct run *old, const struct run *now);

/*
 * Appends the old pieces with their places among the new points, and the windows of those that
 * touch an interval between given points where any point is another; `beside` more on each side.
 * The parts are alike.
 */
void arc_carry(const struct run *old, const struct run *now, const struct pieces *pieces,
               size_t beside, struct pieces *carried, struct arc_moves *windows);

#endif
