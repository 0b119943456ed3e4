/*
 * polyline - feet on a chain of straight pieces, and its distance from another one that goes the
 * same way.
 */
#ifndef CLOUDMILL_POLYLINE_H
#define CLOUDMILL_POLYLINE_H

#include "base/array.h"
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

/* Vertices first to last that are in one place, as where a tool turns its axis. */
struct stay {
    size_t first, last;
};

struct stays {
    size_t n, cap;
    struct stay *item;
};

/* Appends the long ones: what is short is soon walked past. */
void polyline_find_stays(struct polyline b, struct stays *stays);

/* The last vertex of the one that vertex i is in; i itself: it is in none. */
size_t polyline_stay_end(const struct stays *stays, size_t i);

/* Distance of q from `b`, of at least 2 vertices, mm: goes downhill from piece *segment to its
 * neighbours while these are nearer, past each of its stays at once. */
double polyline_descend(struct polyline b, const struct stays *stays, struct vec3 q,
                        size_t *segment);

/* Foot points on one polyline, looked for one after the other. */
struct polyline_feet {
    struct polyline b;
    size_t walked;                /* pieces so far, but for a few of each */
    struct polyline_boxes *boxes; /* once these were very many: else NULL */
};

/* On `b`, which stays where it is until polyline_feet_free. */
struct polyline_feet polyline_feet_on(struct polyline b);
void polyline_feet_free(struct polyline_feet *feet);

/*
 * The foot point of the point q, which is `step` away from a point whose foot is `from`: looked for
 * no further along the polyline than it can have moved.  Where very many pieces are within that,
 * they are told to be too far away by boxes around many of them.
 */
struct foot polyline_foot(struct polyline_feet *feet, struct foot from, double step, struct vec3 q);

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
