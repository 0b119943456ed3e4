/*
 * trim_crossings - where a loop of trimming crosses itself, in the parameters of its surface.
 *
 * A part that it cuts off counts unless it is as narrow as the tolerance on the surface, or tiny
 * beside the rest: chords of curves that run close beside each other may cross where these do not.
 */
#ifndef CLOUDMILL_TRIM_CROSSINGS_H
#define CLOUDMILL_TRIM_CROSSINGS_H

#include "math/uv.h"
#include "nurbs/nurbs.h"

/* The places in which a loop crosses itself so that it counts; `tolerance` in mm. */
size_t trim_crossings(const struct uvs *loop, const struct nurbs *s, double tolerance);

/* Leaves out one part of a loop that crosses itself, if it does not count; false: there is none. */
bool trim_crossings_drop(const struct nurbs *s, double tolerance, struct uvs *loop);

#endif
