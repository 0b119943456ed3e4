/*
 * trace - what a motion on arcs has to follow.
 *
 * A trace is a run seen from the point that is programmed: the tip (or the ball's centre), with the
 * other end of the lever along the tool axis, the centre (or the tip), beside it.  Between its
 * points both go straight.  A place on a trace is an index with a fraction: 3.5 is halfway between
 * points 3 and 4.
 */
#ifndef CLOUDMILL_TRACE_H
#define CLOUDMILL_TRACE_H

#include <stdbool.h>

#include "curve/run.h"
#include "math/vec.h"

struct trace {
    size_t n;
    struct vec3 *p;     /* the tracked point */
    struct vec3 *other; /* p + lever * axis */
    struct vec3 *axis;
    struct vec3 *tangent; /* of p (run_tangents; a tip is not bound to the surface) */
    double *length;       /* of p's path from the start, mm */
    double lever;         /* mm: the radius when the tip is tracked, minus it for the centre */
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

/* Distance of q from the straight lines between n points, mm: goes from line *k to its neighbours
 * while these are nearer. */
double trace_distance(const struct vec3 *line, size_t n, struct vec3 q, size_t *k);

/* The interval between points that holds the place, and how far into it that is. */
size_t trace_interval(const struct trace *trace, double place, double *part);

#endif
