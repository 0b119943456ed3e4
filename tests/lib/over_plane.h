/*
 * over_plane - a ball in rows over a plane, and the verdict on it: what it cuts, leaves and gouges
 * is known.
 */
#ifndef CLOUDMILL_TEST_OVER_PLANE_H
#define CLOUDMILL_TEST_OVER_PLANE_H

#include "base/array.h"
#include "verify/verify.h"

#define RADIUS 4.0

static const struct axis_limits wide = {.min = {-1e3, -1e3, -1e3, -360, -360, -360},
                                        .max = {1e3, 1e3, 1e3, 360, 360, 360},
                                        .rapid = {1e5, 1e5, 1e5, 1e5, 1e5, 1e5}};

/* Points of z = 0 over a square of +-10, 0.5 mm apart. */
static inline struct vec3s plane(void)
{
    struct vec3s points = {0};
    for (int i = -20; i <= 20; i++)
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(0.5 * i, 0.5 * k, 0);
    return points;
}

static inline void move_to(struct nc_motion *motion, struct vec3 *at, struct vec3 to, bool rapid)
{
    struct vec3 up = vec(0, 0, 1);
    size_t line = motion->piece.n + 1;
    *array_push(&motion->piece) = (struct nc_piece){.rapid = rapid,
                                                    .block = 10 * (int)line,
                                                    .line = line,
                                                    .feed = 1000,
                                                    .p = {*at, to},
                                                    .q = {up, up}};
    *at = to;
}

/* Rows of the tip 0.25 mm apart over the plane, at `height`; a rapid from row to row at `over`. */
static inline struct nc_motion rows(double height, double over)
{
    struct nc_motion motion = {.name = "rows", .kinematics.tool = {0, 0, 1}};
    struct vec3 at = {-16, -11, 20};
    for (int k = -44; k <= 44; k++) {
        move_to(&motion, &at, vec(-16, 0.25 * k, over), true);
        move_to(&motion, &at, vec(-16, 0.25 * k, height), false);
        move_to(&motion, &at, vec(16, 0.25 * k, height), false);
        move_to(&motion, &at, vec(16, 0.25 * k, over), true);
    }
    return motion;
}

/* So much may be `left`, of that by `rows`. */
static inline struct verdict judge_left(const struct nc_motion *motion, const struct vec3s *part,
                                        const struct stock_options *stock, double left, double rows)
{
    struct verify_program program = {.file = "rows",
                                     .control = "by hand",
                                     .machine = "none",
                                     .motion = motion,
                                     .part = part,
                                     .post = -1,
                                     .axis = -1,
                                     .made_for = ""};
    struct verify_options options = {.radius = RADIUS,
                                     .tolerance = 0.01,
                                     .left = left,
                                     .rows = rows,
                                     .band = 1,
                                     .tool = {1, {{0, 10, RADIUS, RADIUS}}},
                                     .stock = stock,
                                     .cell = 0.25,
                                     .limits = wide,
                                     .threads = 1};
    return verify_run(&program, &options);
}

static inline struct verdict judge(const struct nc_motion *motion, const struct vec3s *part,
                                   const struct stock_options *stock)
{
    return judge_left(motion, part, stock, 0.05, 0.05);
}

#endif
