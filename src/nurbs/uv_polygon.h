/*
 * uv_polygon - closed polygons in the plane of the parameters: what is inside, which way they run,
 * whether they cross themselves.
 */
#ifndef CLOUDMILL_UV_POLYGON_H
#define CLOUDMILL_UV_POLYGON_H

#include "nurbs/patch.h"

/* Closed polygons in the plane of the parameters: the last point of each joins the first, which is
 * not repeated. */
struct uv_polygon {
    size_t n, cap;
    struct uvs *item;
    double gap;         /* the largest one between curves of a loop, mm (trim_gap.h) ... */
    struct vec3 gap_at; /* ... and where */
    double off;         /* how far curves in space lie off the surface at most, mm */
    size_t lost;        /* loops that do not close on the surface: left out */
    bool open;          /* directed loops on a surface without borders that are all holes in it */
    enum patch_side side;
};

/* True when an odd number of loops go round the place, or an even number where `open`. */
bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at);

/* The sides of all loops by rows of v, for asking about many places. */
struct uv_rows {
    double from, height; /* of the first row, and of each */
    size_t n;
    size_t *first;        /* [n + 1] in `side` */
    struct uv (*side)[2]; /* from, to */
};

void uv_rows_make(const struct uv_polygon *loops, struct uv_rows *rows);

/* As uv_polygon_inside, and the same answer. */
bool uv_rows_inside(const struct uv_rows *rows, bool open, struct uv at);

void uv_rows_free(struct uv_rows *rows);

/* Of a loop, in the parameters: positive where it runs counter-clockwise. */
double uv_loop_area(const struct uvs *loop);

/* True when the inside, by the same rule, lies to the right of a loop. */
bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open);

/* How often a loop crosses itself and so bounds two areas; one of less than a thousandth of the
 * other is the end of a curve that reaches a little too far, and so is one that is narrower than
 * the tolerance, mm, on the surface.  Ways that meet in a corner and part again do not cross. */
size_t uv_polygon_crossings(const struct uv_polygon *loops, const struct nurbs *surface,
                            double tolerance);

void uv_polygon_free(struct uv_polygon *loops);

#endif
