/*
 * pullback - foot points on a surface that may close on itself and may have poles.
 *
 * On a surface that closes on itself the parameters go on over its seam, beyond the range.  A pole
 * is a side of the range that is one point in space: there the parameter along the side says
 * nothing.
 */
#ifndef CLOUDMILL_PULLBACK_H
#define CLOUDMILL_PULLBACK_H

#include "nurbs/nurbs.h"

/* The sides of the range, as indices of pullback.pole. */
enum pullback_side { PULLBACK_U_LOW, PULLBACK_U_HIGH, PULLBACK_V_LOW, PULLBACK_V_HIGH };

struct pullback {
    const struct nurbs *surface;
    bool closed_u, closed_v; /* both sides of the range are one line in space */
    double size;             /* of the surface, by its samples, mm */
    bool is_pole[4];
    struct vec3 pole[4];
    size_t across, along; /* samples in u and in v ... */
    struct vec3 *sample;  /* ... [v * across + u], NULL until they are needed */
};

/* The caller frees it (pullback_free). */
struct pullback pullback_new(const struct nurbs *surface);

/* The parameters of the point nearest to q on the whole surface. */
struct uv pullback_seek(struct pullback *p, struct vec3 q);

/* The same by as many whole turns further that it is nearest to the guess in the parameters. */
struct uv pullback_seek_near(struct pullback *p, struct vec3 q, struct uv guess);

/* The foot point of q near the guess. */
struct uv pullback_foot(const struct pullback *p, struct vec3 q, struct uv guess);

/* The surface's point at parameters that may be beyond its seam. */
struct vec3 pullback_point(const struct pullback *p, struct uv at);

/* The side whose pole is at q, within `near` mm; -1: none is. */
int pullback_pole(const struct pullback *p, struct vec3 q, double near);

void pullback_free(struct pullback *p);

#endif
