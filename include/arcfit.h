/*
 * arcfit - the fewest arcs and lines that follow a trace within a tolerance.
 *
 * What comes out is a chain of motions from the first point of the trace to the last, each starting
 * where the one before ended, in its direction (G1: to within ARCFIT_KINK where a line is next to
 * an arc).  Only where nothing else stays within the tolerance it goes straight from point to
 * point, with a kink.
 */
#ifndef CLOUDMILL_ARCFIT_H
#define CLOUDMILL_ARCFIT_H

#include "trace.h"

#define ARCFIT_KINK RADIANS(0.01)

struct motions {
    size_t n, cap;
    struct motion *item;
};

/*
 * Greedy biarcs: from each joint the longest biarc within the tolerance, over 15 ratios of its legs
 * from 0.1 to 10 (design/3-geometry.md, "greedy + rho"); outer joints are points of the trace with
 * its tangents.  A single arc or a line where that reaches as far.  The length is found by doubling
 * and bisection, each try checked in full.
 */
void arcfit_biarcs(const struct trace *trace, const struct stray *within, struct motions *motions);

/*
 * One step of the above from anywhere near point `at` of the trace, in any direction: appends one or
 * two motions and returns the point of the trace at which they end.
 */
size_t arcfit_step(const struct trace *trace, const struct stray *within, size_t at,
                   struct vec3 from, struct vec3 tangent, struct motions *motions);

#endif
