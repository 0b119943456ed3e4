/*
 * arc_piece - a piece of a fitted motion: an arc or a line that follows a trace from one place to
 * another, and how far it strays.
 */
#ifndef CLOUDMILL_ARC_PIECE_H
#define CLOUDMILL_ARC_PIECE_H

#include "curve/arc.h"
#include "arcfit/trace.h"

/* The axis turns on the great circle. */
struct arc_piece {
    struct arc arc;
    double from, to;           /* places */
    struct vec3 axis, axis_to; /* at its ends, unit */
    bool biarc;                /* it and the next one are a biarc */
};

struct arc_piece arc_piece_of(const struct trace *trace, struct arc arc, double from, double to);

struct arc_deviation {
    double tracked, other; /* two-sided distances of the two points' paths, mm */
    double axis;           /* between the axes at matching places, radians */
};

/*
 * How far the piece strays from its part of the trace: at the feet of the trace's points, at the
 * ends and at `fine` places between (more on long intervals); from the arc to the trace and from
 * the trace's points to the arc.  With `within` not NULL it stops as soon as one of its figures is
 * exceeded, and returns what it found up to there; and looks between points only where what it
 * found at them does not yet say that all in between is within.
 */
struct arc_deviation arc_piece_deviation(const struct trace *trace, const struct arc_piece *piece,
                                         int fine, const struct arc_deviation *within);

/* No figure of `stray` is above that of `within`. */
bool arc_deviation_within(const struct arc_deviation *stray, const struct arc_deviation *within);

/* The larger of each. */
struct arc_deviation arc_deviation_worst(struct arc_deviation a, struct arc_deviation b);

#endif
