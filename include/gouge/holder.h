/*
 * holder - shank and holder above the ball: a stack of truncated cones about the tool axis.
 *
 * The stack begins at the ball's centre and goes up the tool axis.  Lengths in mm.
 */
#ifndef CLOUDMILL_HOLDER_H
#define CLOUDMILL_HOLDER_H

#include <stdbool.h>

#include "math/vec.h"

/* Of a stack that is given; the union of one with a cylinder has up to HOLDER_MOST. */
enum { HOLDER_PARTS = 16, HOLDER_MOST = 3 * HOLDER_PARTS };

/* One truncated cone; a cylinder where both radii are equal. */
struct holder_part {
    double low, high; /* radius at its lower and its upper end */
    double length;
};

struct holder {
    int n; /* parts, from the ball's centre upward; 0: no holder */
    struct holder_part part[HOLDER_MOST];
};

/* What a tool is above its ball: a cylinder of the ball's radius as long as it cuts, and what is
 * given above, both from the ball's centre upward. */
struct tool_body {
    bool ball_only;      /* neither is looked at */
    double flute;        /* length of the cylinder, mm; 0: none */
    struct holder above; /* shank and holder; n = 0: none given */
};

/* The usual one, when nothing is given: TOOL_FLUTE radii of flute, no holder. */
enum { TOOL_FLUTE = 4 };
struct tool_body tool_body_usual(double radius);

/* The stack that is kept clear: at each height the larger of both radii; empty with ball_only. */
struct holder tool_body_profile(const struct tool_body *body, double radius);

/* The stack wider by `margin` mm and, for each mm of height, by `slope` mm, and as much longer at
 * its upper end. */
struct holder holder_widened(const struct holder *holder, double margin, double slope);

/* The stack with `by` mm more at its upper end, and its steps outward so much lower: points so far
 * apart on a line do not let one of these corners by.  As it is, if it has too many parts. */
struct holder holder_cornered(const struct holder *holder, double by);

/* Radius of the sphere about the ball's centre that holds the whole stack. */
double holder_reach(const struct holder *holder);

/*
 * Distance of p from the stack above a ball with its centre at `centre`, `axis` the unit vector up
 * the tool: exact, below zero inside, by how far p is from the outside there; HUGE_VAL for an
 * empty stack.
 */
double holder_distance(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                       struct vec3 p);

/* The same where it is less than `below`; else something that is not. */
double holder_distance_below(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                             struct vec3 p, double below);

/*
 * A lower bound of the distance of all places in the box about `middle` that reaches `half` along
 * X, Y and Z: the distance of its middle less its half diagonal; and no place is deeper than it is
 * far from any segment of the outline, which (the distance from a segment is convex) is largest at
 * a corner of the box, nor than it is beside the outline at its own height.  Of cylinders, and of
 * those about other parts, by how far the box reaches across and along them; a flat box by how far
 * across itself, too.
 */
double holder_bound(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                    struct vec3 middle, struct vec3 half);

/* The same where it is not above `below`; else maybe a lower bound that is had more quickly, and
 * is above `below` but for rounding. */
double holder_bound_below(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                          struct vec3 middle, struct vec3 half, double below);

#endif
