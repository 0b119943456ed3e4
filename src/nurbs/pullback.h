/*
 * pullback - a curve near a surface as places in the surface's parameters.
 *
 * On a surface that closes on itself the places go on over its seam, beyond the range.
 */
#ifndef CLOUDMILL_PULLBACK_H
#define CLOUDMILL_PULLBACK_H

#include "nurbs/nurbs.h"

struct pullback {
    const struct nurbs *surface;
    bool closed_u, closed_v; /* both sides of the range are one line in space */
};

struct pullback pullback_new(const struct nurbs *surface);

/* The place nearest to q on the whole surface. */
struct uv pullback_seek(const struct pullback *p, struct vec3 q);

/* The foot point of q near the guess. */
struct uv pullback_foot(const struct pullback *p, struct vec3 q, struct uv guess);

/* The surface's point of a place that may be beyond its seam. */
struct vec3 pullback_point(const struct pullback *p, struct uv at);

#endif
