/*
 * link_retract - from the end of a cut to the clearance plane, clear of the part with the whole
 * tool, and how high that plane is; an approach is the same reversed.
 */
#ifndef CLOUDMILL_LINK_RETRACT_H
#define CLOUDMILL_LINK_RETRACT_H

#include "gouge/link.h"

enum { LINK_LEGS = 4 };

/* A way of the ball's centre from a point to the clearance plane, with the point's own axis; an
 * approach is the same reversed. */
struct retract {
    bool clear;                /* it leads there, and the whole tool touches nothing */
    bool rapid;                /* from at[0] on it is so far from everything that it may be rapid */
    size_t n;                  /* of at */
    struct vec3 at[LINK_LEGS]; /* at[0]: the approach distance off the point, or if it is rapid from
                                  there as far as the ball is off the part, by 0.3 R or most of that
                                  distance; corners; and last with the tip on the clearance plane */
};

/*
 * Along the tool axis, if that leads up; what the ball does along its own axis the shank above it
 * has done before, so that this is free wherever the tool fits at all.  Where it is not clear:
 * straight up in z, along the normal, between these; then bent ways, first to any side (out beside
 * the part if it is flat), from there up or along the axis.  The first that is clear at rapid; if
 * there is none, the first that is clear at feed; else not `clear`.  One that leads far aside, as
 * along a flat axis, goes on only until it is clear straight up, if that is shorter by a fifth.
 * Without a guard along the axis.
 */
struct retract link_retract(const struct link_options *options, const struct run_point *p);

/*
 * True if the axis leans further off z on the great circle from `from` to `to`, by a hundredth of a
 * radian or more, than at both its ends: one of them leans beyond the horizontal, and the tool
 * would dip into what is below.  Then *way is where it turns by way of instead: half-way round,
 * and half as far off z as the more upright one.  All unit.
 */
bool link_axis_dips(struct vec3 from, struct vec3 to, struct vec3 *way);

/*
 * The least z of the tip, no less than options.clearance, at which no part of the tool reaches down
 * to the guard's top while its axis has any angle from `least` to `most` (radians) off z.
 */
double link_height(const struct link_options *options, double least, double most);

#endif
