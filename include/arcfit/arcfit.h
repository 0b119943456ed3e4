/*
 * arcfit - the fewest arcs and lines that follow a trace within a tolerance.
 *
 * What comes out is a chain of pieces from the first point of the trace to the last, each starting
 * where the one before ended, in its direction (G1: to within ARCFIT_KINK where a line is next to
 * an arc).  Only where nothing else stays within the tolerance it goes straight from point to
 * point, with a kink.
 */
#ifndef CLOUDMILL_ARCFIT_H
#define CLOUDMILL_ARCFIT_H

#include "arcfit/arc_piece.h"

#define ARCFIT_KINK RADIANS(0.01)

struct pieces {
    size_t n, cap;
    struct arc_piece *item;
};

/*
 * Greedy biarcs: from each joint the longest biarc within the tolerance, over 15 ratios of its legs
 * from 0.1 to 10 (design/3-geometry.md, "greedy + rho"); outer joints are points of the trace with
 * its tangents.  A single arc or a line where that reaches as far.  The length is found by doubling
 * and bisection, each try checked in full.
 */
void arcfit_biarcs(const struct trace *trace, const struct arc_deviation *within,
                   struct pieces *pieces);

/* Where a chain has come to: near which point of the trace, in what direction, with what axis. */
struct reached {
    size_t at;
    struct vec3 p, tangent, axis;
};

/*
 * One step of the above from anywhere near a point of the trace, in any direction: appends one or
 * two pieces and returns the point of the trace at which they end.
 */
size_t arcfit_step(const struct trace *trace, const struct arc_deviation *within,
                   const struct reached *from, struct pieces *pieces);

/*
 * Paper 1: a biarc for each interval of the trace, the one with the least a + b, whatever its
 * deviation.  Returns in how many intervals that is none, for one of its legs is negative and its
 * arc a loop: those get equal legs (or a line where the points coincide).
 */
size_t arcfit_each(const struct trace *trace, struct pieces *pieces);

#endif
