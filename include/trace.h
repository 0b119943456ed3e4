/*
 * trace - what a motion on arcs has to follow, and how far it strays.
 *
 * A trace is a run seen from the point that is programmed: the tip (or the ball's centre), with the
 * other end of the lever along the tool axis, the centre (or the tip), beside it.  Between its
 * points both go straight.  A place on a trace is an index with a fraction: 3.5 is halfway between
 * points 3 and 4.
 */
#ifndef CLOUDMILL_TRACE_H
#define CLOUDMILL_TRACE_H

#include <stdbool.h>

#include "arc.h"
#include "run.h"
#include "vec.h"

struct trace {
    size_t n;
    struct vec3 *p;      /* the tracked point */
    struct vec3 *other;  /* p + lever * axis */
    struct vec3 *axis;
    struct vec3 *tangent; /* of p (run_tangents; a tip is not bound to the surface) */
    double *length;      /* of p's path from the start, mm */
    double lever;        /* mm: the radius when the tip is tracked, minus it for the centre */
};

/*
 * Of the n points of a run from `from` on; `centre`: the ball's centre is tracked, not the tip.
 * `forward`: the tangents are those of paper 1 (run_tangents).
 */
struct trace trace_of(const struct run *run, size_t from, size_t n, bool centre, bool forward);
void trace_free(struct trace *trace);

struct vec3 trace_point(const struct trace *trace, double place);
struct vec3 trace_axis(const struct trace *trace, double place);

/* The tool axis is the same at the points `from` to `to`. */
bool trace_axis_still(const struct trace *trace, size_t from, size_t to);

/* Place nearest to q: the next minimum of the distance, downhill from `place`. */
double trace_place(const struct trace *trace, struct vec3 q, double place);

/* A piece of the fitted motion: an arc or a line from one place of a trace to another; the axis turns on the great circle. */
struct piece {
    struct arc arc;
    double from, to;           /* places */
    struct vec3 axis, axis_to; /* at its ends, unit */
    bool biarc;                /* it and the next one are a biarc */
};

struct piece trace_piece(const struct trace *trace, struct arc arc, double from, double to);

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
struct stray trace_stray(const struct trace *trace, const struct piece *piece, int fine,
                         const struct stray *within);

/* No figure of `stray` is above that of `within`. */
bool stray_within(const struct stray *stray, const struct stray *within);

/* The larger of each. */
struct stray stray_worst(struct stray a, struct stray b);

#endif
