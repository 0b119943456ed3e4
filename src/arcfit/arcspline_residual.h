/*
 * arcspline_residual - how far the points of a trace are off a chain of arcs, and how that changes
 * with its joints.
 */
#ifndef CLOUDMILL_ARCSPLINE_RESIDUAL_H
#define CLOUDMILL_ARCSPLINE_RESIDUAL_H

#include "arcspline.h"

/* A point of a trace, and where the chain passes it. */
struct passed {
    struct vec3 p, other; /* the two ends of the lever */
    struct vec3 u, v;     /* unit, across the way of p */
    struct vec3 s, w;     /* unit, across the way of the other */
    size_t arc;           /* the chain passes on this arc, */
    double part;          /* at this place of it, 0 to 1, */
    double bend;          /* or this one, as a conic (arcspline_residual_slope) */
    struct vec3 at, axis; /* there */
};

struct passing {
    size_t n;
    struct passed *item;
};

/* At most `most` of the points `from` to `to` of a trace, evenly, both ends left out. */
struct passing passing_of(const struct trace *trace, size_t from, size_t to, size_t most);
void passing_free(struct passing *passing);

/*
 * How far all points are off the chain: off[2 i] and off[2 i + 1] along u and v, mm.  With a lever,
 * 2 n more: how far the other end is off along s and w, both ends at the foot of p.  Where the
 * chain passes each point is set.
 */
void arcspline_residual(const struct arcspline *chain, double lever, struct passing *passing,
                        double *off);

/*
 * How much that changes for points [from, to) when the chain becomes `moved`, to first order: the
 * places where the chain passes are kept, for along the arc nothing changes.  An arc is taken as a
 * conic, ((1 - b)^2 P0 + 2 b (1 - b) c M + b^2 P1) / sum, with M where its tangents meet and c the
 * cosine of half its turn: no angle functions are needed.  The change is divided by `by`.
 */
void arcspline_residual_slope(const struct arcspline *moved, double lever,
                              const struct passing *passing, size_t from, size_t to, double by,
                              double *slope);

/* First point that is passed on this arc or a later one. */
size_t passing_first(const struct passing *passing, size_t arc);

#endif
