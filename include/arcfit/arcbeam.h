/*
 * arcbeam - the fewest single arcs that follow a trace: the tangent-relaxed search.
 *
 * Each arc starts at the point and in the direction where the last one ended, and ends beside a
 * point of the trace, up to 0.85 of the tolerance across: freeing the tangents saves a third of the
 * arcs of any biarc fit (design/3-geometry.md, "tangent-relaxed search").  Of the chains with
 * equally many arcs a beam is kept: those from which the next arc can reach furthest (outlook.h).
 */
#ifndef CLOUDMILL_ARCBEAM_H
#define CLOUDMILL_ARCBEAM_H

#include "arcfit/arcfit.h"

/*
 * Appends a chain of pieces as arcfit_biarcs does, each proven by piece_stray, the joints of
 * single arcs rounded to `digits` decimals.  Where single arcs don't do everywhere, it is never
 * more of them than arcfit_biarcs makes.  The axis at a joint may be off the trace's too (swing.h).
 */
void arcbeam_fit(const struct trace *trace, const struct stray *within, int digits,
                 struct pieces *pieces);

#endif
