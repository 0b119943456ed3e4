/* ribs - a rib or a groove on a plane for tests of what follows it. */
#ifndef CLOUDMILL_TEST_RIBS_H
#define CLOUDMILL_TEST_RIBS_H

#include "rough.h"

/* Height exp(-(s / 0.6)^2) times `high` over the plane z = 0, s the distance from a line through
 * the origin that runs 25 degrees from y. */
static const double RIB_COS = 0.90630778703664996, RIB_SIN = 0.42261826174069944;

static inline double rib_off(struct vec3 p)
{
    return p.x * RIB_COS + p.y * RIB_SIN;
}

static inline struct vec3 rib_point(double high, double x, double y)
{
    double s = rib_off(vec(x, y, 0)) / 0.6;
    return vec(x, y, high * exp(-s * s));
}

static inline struct vec3 rib_normal(double high, struct vec3 p)
{
    double s = rib_off(p) / 0.6, slope = -2 * s / 0.6 * high * exp(-s * s);
    return vec_unit(vec(-slope * RIB_COS, -slope * RIB_SIN, 1));
}

/* 2,500 points on 10 x 10 mm about the origin, 0.2 mm apart in the mean. */
static inline struct vec3s rib_cloud(double high, double noise)
{
    struct vec3s p = {0};
    for (int i = 0; i < 2500; i++) {
        double y = 10 * uniform() - 5, x = 10 * uniform() - 5; /* in this order everywhere */
        struct vec3 q = rib_point(high, x, y);
        *array_push(&p) = vec_along(q, noise * normal(), rib_normal(high, q));
    }
    return p;
}

/* Of what noise leaves a quadric through 48 points along the rib: 4 / 48 of its variance at the
 * middle, six deviations for the best of many directions. */
static inline double rib_fit_noise(double sigma)
{
    return 6 * sigma * sqrt(4.0 / 48);
}

/* The deviation of the slope that 48 points have across the rib. */
static inline double rib_slope_noise(double sigma)
{
    return 1.7 * sigma / 0.4 / sqrt(48);
}

/* How far aside of the crest the slope of the fit vanishes, for the rib is no quadric and has
 * noise: five deviations of the slope over the curvature. */
static inline double rib_aside(double noise)
{
    const double curvature = 2 * 0.8 / 0.36;
    return 0.1 + 5 * 6 * rib_slope_noise(noise) / curvature;
}

#endif
