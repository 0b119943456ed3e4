/*
 * tool_shape - the tool above its ball, as what judges a program sees it: the body of revolution of
 * flute, shank and holder about the tool axis, and how far a place is from it.
 *
 * The radius over the height above the ball's centre is a list of spans, one on top of the other,
 * each a truncated cone; where two parts are at one height the larger counts.  Written for the
 * judge alone: what guards paths has formulas of its own (gouge/holder.h).  Lengths in mm.
 */
#ifndef CLOUDMILL_TOOL_SHAPE_H
#define CLOUDMILL_TOOL_SHAPE_H

#include <stdbool.h>

#include "math/vec.h"

enum { TOOL_SPANS = 64 };

/* From height `low` to `high`, the radius going from `from` to `to` in proportion. */
struct tool_span {
    double low, high;
    double from, to;
};

struct tool_shape {
    int n; /* spans, from the ball's centre upward; 0: the ball alone */
    struct tool_span span[TOOL_SPANS];
};

/* Joins a truncated cone to the tool, none of its radii or heights below zero; false: the outline
 * would get more than TOOL_SPANS spans, and nothing is changed. */
bool tool_shape_add(struct tool_shape *shape, struct tool_span cone);

/* The largest distance of any place of it from the ball's centre; its largest radius. */
double tool_shape_reach(const struct tool_shape *shape);
double tool_shape_widest(const struct tool_shape *shape);

/* The radius at a height; 0 above and below all. */
double tool_shape_radius(const struct tool_shape *shape, double height);

/*
 * Signed distance of p from the tool whose ball has its centre at `centre`, `axis` the unit vector
 * up the tool: outside how far the nearest place of the body is, inside (below zero) how far p is
 * from the outside; HUGE_VAL if there is nothing above the ball.
 */
double tool_shape_distance(const struct tool_shape *shape, struct vec3 centre, struct vec3 axis,
                           struct vec3 p);

/* No place of the box about `middle` that reaches `half` along X, Y and Z is nearer than this. */
double tool_shape_bound(const struct tool_shape *shape, struct vec3 centre, struct vec3 axis,
                        struct vec3 middle, struct vec3 half);

#endif
