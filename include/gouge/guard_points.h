/*
 * gouge_points - the surface that the points of a scan stand for, as points that are dense enough
 * to keep a ball off it.
 *
 * A ball sinks between points that are far apart, and rides on the crests of the noise of points
 * that are near.  So points spread by noise are brought to the surfaces of surface_fit.h, one for
 * all points in its middle; and where the scan is sparse, points are put between (upsample.h).
 * Points that noise does not explain (edges, walls, hair) stay as they are.
 */
#ifndef CLOUDMILL_GUARD_POINTS_H
#define CLOUDMILL_GUARD_POINTS_H

#include "base/array.h"
#include "math/point_grid.h"

struct guard_points_options {
    double radius; /* of the ball, mm */
    double sink;   /* how deep it may sink between points, mm */
    double noise;  /* standard deviation of what is taken out, mm (noise.h); 0: nothing */
    double vague;  /* mm: a surface between points that is off them by more is vague */
    double effort; /* effort.h */
    int threads;   /* as of parallel_for */
};

struct guard_points {
    struct vec3s point;
    struct vec3s certain, doubtful; /* points of the scan: does noise leave doubt of the surface? */
    size_t moved, added;            /* points brought to their quadrics, points put between */
    size_t
        vague; /* of a scan without noise: points about which the surface between is vague, ... */
    double worst; /* ... the most that it is off, mm, and where */
    struct vec3 at;
    bool sparse; /* the ball sinks in between points, and more of them would keep it off */
    size_t near; /* points that the surfaces would go through in all, where these are more than the
                    effort allows; else 0 */
};

/* No point moves by more than six standard deviations.  What there are too many points for:
 * EFFORT_GUARD_BETWEEN, EFFORT_GUARD_NEAR, EFFORT_ALONG. */
struct guard_points guard_points_make(const struct point_grid *point_grid,
                                      const struct guard_points_options *rule);

#endif
