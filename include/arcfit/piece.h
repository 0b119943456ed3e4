/*
 * piece - a piece of a fitted motion: an arc or a line that follows a trace from one place to
 * another, and how far it strays.
 */
#ifndef CLOUDMILL_PIECE_H
#define CLOUDMILL_PIECE_H

#include "curve/arc.h"
#include "arcfit/trace.h"

/* The axis turns on the great circle. */
struct arc_piece {
    struct arc arc;
    double from, to;           /* places */
    struct vec3 axis, axis_to; /* at its ends, unit */
    bool biarc;                /* it and the next one are a biarc */
};

struct arc_piece piece_of(const struct trace *trace, struct arc arc, double from, double to);

struct stray {
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
struct stray piece_stray(const struct trace *trace, const struct arc_piece *piece, int fine,
                         const struct stray *within);

/* No figure of `stray` is above that of `within`. */
bool stray_within(const struct stray *stray, const struct stray *within);

/* The larger of each. */
struct stray stray_worst(struct stray a, struct stray b);

#endif
