/*
 * arc - circular arcs in space that start with a given tangent.
 *
 * Through A with the unit tangent t and on to B there is one arc: e = B - A, p = e - (e . t) t,
 * R = e^2 / (2 |p|), its centre A + R p / |p|, its turn 2 atan2(|p|, e . t).
 * One whose sagitta is below 1e-6 mm is a straight line.  A place on an arc is s, from 0 at its
 * start to 1 at its end, in proportion to its length.
 */
#ifndef CLOUDMILL_ARC_H
#define CLOUDMILL_ARC_H

#include <stdbool.h>

#include "math/vec.h"

struct arc {
    struct vec3 from, to;
    struct vec3 tangent; /* unit, at `from`; zero when from = to */
    struct vec3 inward;  /* unit, from `from` to the centre; zero: a straight line */
    struct vec3 drift;   /* by how much `to` is off the circle: spread along the arc */
    double radius;       /* mm; 0: a straight line */
    double angle;        /* of turn, radians, 0 to 2 pi; 0: a straight line */
};

struct arc arc_line(struct vec3 from, struct vec3 to);

/* The arc from `from`, where its unit tangent is given, to `to`; the line where that is zero, as of
 * a piece of no length. */
struct arc arc_to(struct vec3 from, struct vec3 tangent, struct vec3 to);

/*
 * The arc as it is read back from a centre and an axis (right-hand rule) with few decimals: `to` is
 * met exactly, by a drift in proportion to s.  from = to is a full circle.
 */
struct arc arc_about(struct vec3 from, struct vec3 to, struct vec3 centre, struct vec3 axis);

bool arc_straight(const struct arc *arc);
struct vec3 arc_centre(const struct arc *arc);
struct vec3 arc_axis(const struct arc *arc);
double arc_length(const struct arc *arc);

struct vec3 arc_at(const struct arc *arc, double s);

/* The same by the sine and cosine of s times half its turn. */
struct vec3 arc_by_half(const struct arc *arc, double s, struct sine_cosine half);

/* Unit tangents at s; the derivative by s is arc_length times as long. */
struct vec3 arc_tangent(const struct arc *arc, double s);

/* Place of the point of the arc that is nearest to p. */
double arc_foot(const struct arc *arc, struct vec3 p);

#endif
