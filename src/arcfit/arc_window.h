/*
 * arc_window - which single arcs can follow a reference from where a chain has come to, and how
 * far.
 */
#ifndef CLOUDMILL_ARC_WINDOW_H
#define CLOUDMILL_ARC_WINDOW_H

#include "arcfit/arcfit.h"

/*
 * The curvatures that an arc may have to follow a reference up to a point of it.
 *
 * An arc from a point in a direction is given by its curvature, a vector across the direction,
 * 1/mm. To meet point V it is 2 p / e^2, with e the way to V and p its part across; to pass V at
 * most d away it lies within 2 d / e^2 of that (to first order in d / |e|).  The arcs that can
 * follow a row of points are the intersection of these discs; here it is enclosed by an octagon. So
 * a window is a guess, on the hopeful side: what it proposes has to be proven
 * (arc_piece_deviation).
 */
struct arc_window {
    size_t point;
    struct vec3 u, v;    /* unit, across: in the plane of the bend, and out of it */
    double lo[4], hi[4]; /* bounds along u, v, (u + v) / sqrt 2, (u - v) / sqrt 2 */
};

struct arc_windows {
    size_t n, cap;
    struct arc_window *item;
};

/*
 * Looks ahead from p beside point `at` of the reference in the unit direction t, with `tolerance`
 * mm.  Returns the last point that an arc may reach (`at`: none).  With `windows` not NULL the
 * window of each point looked at is appended: all of them, but for points that are not even
 * `further` (a part of the way) away than the one before.
 */
size_t arc_look_ahead(const struct reference *reference, size_t at, struct vec3 p, struct vec3 t,
                      double tolerance, double further, struct arc_windows *windows);

/* A curvature in the window, at fractions 0 to 1 of its width along u and along v. */
struct vec3 arc_window_curvature(const struct arc_window *window, double across, double aside);

/* The straight line is among the window's arcs. */
bool arc_window_holds_line(const struct arc_window *window);

#endif
