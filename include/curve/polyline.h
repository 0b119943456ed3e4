/*
 * polyline - feet on a chain of straight pieces, and its distance from another one that goes the
 * same way.
 */
#ifndef CLOUDMILL_POLYLINE_H
#define CLOUDMILL_POLYLINE_H

#include "math/vec.h"

struct polyline {
    size_t n; /* vertices, at least 1 */
    const struct vec3 *point;
};

/* The foot point of some point on a polyline: at vertex + t (next vertex - vertex). */
struct foot {
    size_t segment;
    double t; /* 0 to 1 */
    double distance;
};

/* Distance of q from `b`, of at least 2 vertices, mm: goes downhill from piece *segment to its
 * neighbours while these are nearer. */
double polyline_descend(struct polyline b, struct vec3 q, size_t *segment);

/*
 * The foot point on `b` of the point q, which is `step` away from a point whose foot is `from`:
 * looked for no further along `b` than it can have moved.
 */
struct foot polyline_foot(struct polyline b, struct foot from, double step, struct vec3 q);

/*
 * The largest distance from any point of `a`, between its vertices too, to `b`: an upper bound that
 * exceeds the truth by at most `slack`.  The search stops as soon as `limit` is passed, and what is
 * returned is then only known to be above it.
 *
 * Both chains start at about the same place and go the same way: the foot point is followed along
 * `b`.  Where `b` comes back near to itself, the distance is that to the branch that belongs there,
 * never less than to the nearest one.
 * `foot`, unless NULL, gets the foot point of each vertex of `a`.
 */
double polyline_distance(struct polyline a, struct polyline b, double limit, double slack,
                         struct foot *foot);

#endif
