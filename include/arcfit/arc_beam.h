/*
 * arc_beam - the fewest single arcs that follow a trace: the tangent-relaxed search.
 *
 * Each arc starts at the point and in the direction where the last one ended, and ends beside a
 * point of the trace, up to 0.85 of the tolerance across: freeing the tangents saves a third of the
 * arcs of any biarc fit (design/3-geometry.md, "tangent-relaxed search").  Of the chains with
 * equally many arcs a beam is kept: those from which the next arc can reach furthest
 * (arc_window.h).
 */
#ifndef CLOUDMILL_ARC_BEAM_H
#define CLOUDMILL_ARC_BEAM_H

#include "arcfit/arcfit.h"

/*
 * Appends a chain of pieces as arcfit_biarcs does, each proven by arc_piece_deviation, the joints
 * of single arcs rounded to `digits` decimals.  Where single arcs don't do everywhere, it is never
 * more of them than arcfit_biarcs makes.  The axis at a joint may be off the trace's too
 * (arc_axis.h).
 */
void arc_beam_fit(const struct trace *trace, const struct arc_deviation *within, int digits,
                  struct pieces *pieces);

#endif
