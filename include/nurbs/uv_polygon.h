/*
 * uv_polygon - closed polygons in the plane of two parameters: what lies inside them.
 */
#ifndef CLOUDMILL_UV_POLYGON_H
#define CLOUDMILL_UV_POLYGON_H

#include "nurbs/nurbs.h"

struct uv_polygon {
    size_t n, cap;
    struct uvs *item; /* closed polygons: the last point joins the first, which is not repeated */
    double off;       /* of curves in space, the farthest that one lies off the surface, mm ... */
    size_t lost;      /* ... and how many loops of them do not close there, and are left out */
};

/* True when an odd number of loops go round the place, or an even number where `open`. */
bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at);

/* True when the inside, by the same rule, lies to the right of a loop. */
bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open);

void uv_polygon_free(struct uv_polygon *loops);

#endif
