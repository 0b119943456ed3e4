/*
 * arcbeam - the fewest single arcs that follow a trace: the tangent-relaxed search.
 *
 * Each arc starts at the point and in the direction where the last one ended, and ends beside a
 * point of the trace, up to 0.85 of the tolerance across: freeing the tangents saves a third of the
 * arcs of any biarc fit (design/3-geometry.md, "tangent-relaxed search").
 *
 * From a point and a direction an arc is told by its curvature, a vector across.  To pass point V at
 * most d away it has to lie within 2 d / e^2 of the curvature 2 p / e^2 that meets V (e: to V, p: the
 * part of e across).  The intersection of these discs over the points ahead says both how far the
 * next arc can reach and which arcs to try.  A beam of chains of equally many arcs is kept, those
 * from which the next arc can reach furthest; each arc kept is proven by trace_stray.
 */
#ifndef CLOUDMILL_ARCBEAM_H
#define CLOUDMILL_ARCBEAM_H

#include "arcfit.h"

/*
 * Appends a chain of pieces as arcfit_biarcs does, joints rounded to `digits` decimals.  Never more
 * of them than arcfit_biarcs makes.
 */
void arcbeam_fit(const struct trace *trace, const struct stray *within, int digits,
                 struct pieces *pieces);

#endif
