/*
 * arcspline_optimize - the joints of a chain of arcs moved until its largest distance from a trace
 * is small: least squares of the distances' powers by Levenberg and Marquardt's method, the p-norm
 * for p from 2 to 120 (design/3-geometry.md, "best found").
 */
#ifndef CLOUDMILL_ARCSPLINE_OPTIMIZE_H
#define CLOUDMILL_ARCSPLINE_OPTIMIZE_H

#include "arcspline_residual.h"

struct arcspline_optimize {
    const struct trace *trace;
    struct arcspline chain;
    struct passing passing; /* what it is to pass */
    double tolerance;       /* mm, of the tracked point */
    double lever;    /* mm to the other end; 0: that is not looked at, the axis stands still */
    double other;    /* tolerance there, mm */
    bool start_held; /* the tangent at the start may not turn */
    bool end_held;   /* the tangent at the end shall be `end` */
    struct vec3 end;
    size_t stage; /* norm that it has come to: 0 to begin with; from 3 on (p = 24) nearly there */
};

/*
 * Moves inner joints, axes there, and the tangent at the start, until no point is off by more than
 * `enough` of its tolerance.  Returns the largest part of a tolerance, above 1 where it gave up;
 * it does so early where there is no hope.  Called again with less, it goes on from there.
 */
double arcspline_optimize_settle(struct arcspline_optimize *m, double enough);

#endif
