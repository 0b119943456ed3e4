/*
 * guard_points - the surface of a scanned part as points that are dense enough to keep a ball off
 * it.  Of a mesh: guard_mesh.h.
 *
 * A ball sinks between points that are far apart, and rides on the crests of the noise of points
 * that are near.  So the points of a scan that noise spreads are moved to the surfaces of
 * surface_fit.h, one for all points in its middle, and where a sparse scan has edges nearly
 * everywhere, or facets explain nearly all of it better, to facets that meet in these, if they
 * explain more (upsample_surface.h); there points are put between, too (upsample.h), and on the
 * facets of steep flanks (steep_facets.h).  Points that noise does not explain (edges, walls, hair)
 * stay as they are.
 */
#ifndef CLOUDMILL_GUARD_POINTS_H
#define CLOUDMILL_GUARD_POINTS_H

#include "base/array.h"
#include "cloud/edge_points.h"
#include "math/point_grid.h"

struct guard_points_options {
    double radius; /* of the ball, mm */
    double sink;   /* how deep it may sink between points, mm */
    double noise;  /* standard deviation of what is taken out, mm (noise.h); 0: nothing */
    bool edged;    /* it is known by the sides of edges, which are nearly everywhere (sided,
                          noise.h): points move to facets, too, and edges are looked for in the
                          points as they are */
    double rough; /* mm: what smooth surfaces leave, where it cannot be told from noise and is taken
                      as none; else 0 */
    double apart; /* mm: so far points may be off the surface between them that is no noise, as of
                      two sheets half their distance */
    double vague; /* mm: a surface between points that is off them by more is vague */
    double effort; /* effort.h */
    int threads;   /* as of parallel_for */
};

struct guard_points {
    struct vec3s point;
    struct vec3s certain, doubtful; /* points of the scan: does noise leave doubt of the surface? */
    size_t moved, added;            /* points moved to their surfaces, points put between */
    size_t edges;          /* points put on sharp edges that the scan has none on (edge_points.h) */
    struct edge_gaps gaps; /* edges that it does not resolve */
    size_t vague; /* points near which the surface is vague, noise apart, ... */
    double worst; /* ... the most that it is off, mm, and where */
    struct vec3 at;
    double gap; /* mm: what these are apart, on lines from one of these to the next */
    bool sparse; /* the ball sinks in between points, and more of them would keep it off */
    size_t near; /* points that the surfaces would go through in all, where these are more than the
                    effort allows; else 0 */
};

/* Of a scan.  No point moves by more than FAR standard deviations.  What there are too many points
 * for: EFFORT_GUARD_BETWEEN, EFFORT_GUARD_NEAR, EFFORT_ALONG. */
struct guard_points guard_points_of_scan(const struct point_grid *point_grid,
                                         const struct guard_points_options *rule);

#endif
