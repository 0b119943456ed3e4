/*
 * holder - shank and holder above the ball: a stack of truncated cones about the tool axis.
 *
 * The stack begins at the ball's centre and goes up the tool axis.  Lengths in mm.
 */
#ifndef CLOUDMILL_HOLDER_H
#define CLOUDMILL_HOLDER_H

#include "math/vec.h"

enum { HOLDER_PARTS = 16 };

/* One truncated cone; a cylinder where both radii are equal. */
struct holder_part {
    double low, high; /* radius at its lower and its upper end */
    double length;
};

struct holder {
    int n; /* parts, from the ball's centre upward; 0: no holder */
    struct holder_part part[HOLDER_PARTS];
};

/* Radius of the sphere about the ball's centre that holds the whole stack. */
double holder_reach(const struct holder *holder);

/*
 * Distance of p from the stack above a ball with its centre at `centre`, `axis` the unit vector up
 * the tool: exact, below zero inside, by how far p is from the outside there; HUGE_VAL for an
 * empty stack.
 */
double holder_distance(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                       struct vec3 p);

/*
 * A lower bound of the distance of all places in the box about `middle` that reaches `half` along
 * X, Y and Z: the distance of its middle less its half diagonal; and no place is deeper than it is
 * far from any segment of the outline, which (the distance from a segment is convex) is largest at
 * a corner of the box.
 */
double holder_bound(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                    struct vec3 middle, struct vec3 half);

#endif
