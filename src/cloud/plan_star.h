/*
 * plan_star - the Delaunay facets of a scan, seen from above, about its steep places.
 *
 * Facets are found about one point at a time, from the points near to it alone: the one next to it
 * makes the first edge, and the point in whose circle with both no other is makes a facet.
 */
#ifndef CLOUDMILL_PLAN_STAR_H
#define CLOUDMILL_PLAN_STAR_H

#include <stdbool.h>

#include "math/point_grid.h"
#include "math/uv.h"

/* Points about one: where there are more they stand over each other, and what is steep was scanned;
 * no corner. */
enum { PLAN_STAR_CROWD = 400, PLAN_STAR_NONE = PLAN_STAR_CROWD };

/* A point seen from another, as from above, and its squared distance so, mm2. */
struct plan_beside {
    struct uv at;
    double far2;
    uint32_t index;
};

/* The points about one, nearest first; itself, and what is right under or over it, is not among
 * them. */
struct plan_about {
    size_t n;
    struct plan_beside item[PLAN_STAR_CROWD];
};

/* Those nearer to point i than `reach`, mm.  False: there are none, or too many. */
bool plan_star_about(const struct point_grid *scan, size_t i, double reach,
                     struct plan_about *about);

/* Of the points about one the corner of the facet to the left of the way from a to b: no point is
 * in the circle of all three; PLAN_STAR_NONE: there is none. */
size_t plan_star_corner(const struct plan_about *about, struct uv a, struct uv b);

/* The corners of the facet that a place is over, found about the points nearest to it, of which
 * those within `reach`, mm, tell.  False: none is, as beside the scan. */
bool plan_star_over(const struct point_grid *scan, struct vec3 place, double reach,
                    size_t corner[3]);

/* Told of a facet: its corners counter-clockwise from above, the points about the first, and room
 * for those about another. */
typedef void plan_star_facet(void *context, const struct plan_about *about, const size_t corner[3],
                             struct plan_about *other);

struct plan_star_options {
    double gap;   /* mm: no circle through a facet's corners is wider */
    double least; /* mm: a way of this length goes up or down by more than 45 degrees ... */
    double near;  /* mm, seen from above: ... from a corner to a point so near */
    int threads;  /* as of parallel_for; facets with one first corner are told of by one */
};

/* Tells of each such facet once. */
void plan_star_facets(const struct point_grid *scan, const struct plan_star_options *options,
                      plan_star_facet *facet, void *context);

#endif
