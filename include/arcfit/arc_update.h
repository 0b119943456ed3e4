/*
 * arc_update - a chain of arcs for a trace that has changed in places: the arcs beside them stay.
 */
#ifndef CLOUDMILL_ARC_UPDATE_H
#define CLOUDMILL_ARC_UPDATE_H

#include "arcfit/arcfit.h"

/*
 * `before` are the pieces of the trace `old`, `now` the trace that it has become: points in its
 * middle are moved, and there may be more or fewer of them.  Into `pieces` go those of `before`
 * that follow what is as it was, and between them as many arcs as there were, or up to three more,
 * proven by arc_piece_deviation.  False, and nothing of use in `pieces`, where that does not hold,
 * where too many pieces would be put anew, or the ends of the trace moved.
 */
bool arc_update(const struct trace *old, const struct trace *now,
                const struct arc_deviation *within, int digits, const struct pieces *before,
                struct pieces *pieces);

#endif
