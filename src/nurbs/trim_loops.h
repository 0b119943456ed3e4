/*
 * trim_loops - the curves that trim a patch as polygons in its parameters.
 *
 * Stages: each curve is followed span by span, halved until its chords are near enough (curves in
 * space by their foot points on the surface: pullback); on a surface that closes on itself the
 * loops are moved into the range and split at the seam (Sutherland and Hodgman 1974).
 */
#ifndef CLOUDMILL_TRIM_LOOPS_H
#define CLOUDMILL_TRIM_LOOPS_H

#include "nurbs/patch.h"

/* Closed polygons in the plane of the parameters: the last point of each joins the first, which is
 * not repeated. */
struct uv_polygon {
    size_t n, cap;
    struct uvs *item;
    double off;  /* how far curves in space lie off the surface at most, mm */
    size_t lost; /* loops that do not close on the surface: left out */
};

/*
 * The loops of a patch as polygons whose sides, on the surface, stay within `tolerance` mm of the
 * curve; curves that run backwards are turned round.
 *
 * On a surface that closes on itself, a loop beyond the range is moved by whole turns; one that
 * crosses the seam is split there.  A loop that goes once round, without the seam as part of it,
 * bounds what is on its left; two of them bound what is between them.  Loops of less than three
 * corners are left out, and those that go round more than once, which loops->lost counts.
 */
void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops);

/* True when an odd number of loops go round the place, or an even number where `open`. */
bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at);

/* True when the inside, by the same rule, lies to the right of a loop. */
bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open);

/* How often a loop crosses itself and so bounds two areas; one of less than a thousandth of the
 * other is the end of a curve that reaches a little too far. */
size_t uv_polygon_crossings(const struct uv_polygon *loops);

void uv_polygon_free(struct uv_polygon *loops);

/* A surface for foot points.  On one that closes on itself the parameters go on over its seam,
 * beyond the range. */
struct pullback {
    const struct nurbs *surface;
    bool closed_u, closed_v; /* both sides of the range are one line in space */
};

struct pullback pullback_new(const struct nurbs *surface);

/* The parameters of the point nearest to q on the whole surface. */
struct uv pullback_seek(const struct pullback *p, struct vec3 q);

/* The foot point of q near the guess. */
struct uv pullback_foot(const struct pullback *p, struct vec3 q, struct uv guess);

/* The surface's point at parameters that may be beyond its seam. */
struct vec3 pullback_point(const struct pullback *p, struct uv at);

#endif
