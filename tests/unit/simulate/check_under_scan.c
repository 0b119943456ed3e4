/*
 * check_under_scan - a tool under a level sheet of points: how deep the upright lines below these
 * are in it, against all points looked at one by one, and depths that are known.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"
#include "seed.h"
#include "simulate/under_scan.h"

#define R 3.0
#define ALLOWED 0.2

static const struct tool_shape shaft = {1, {{0, 12, R, R}}};

/* Points 0.5 mm apart from x = 0 on, at z = 0. */
static struct vec3s sheet(void)
{
    struct vec3s p = {0};
    for (int i = 0; i <= 40; i++)
        for (int j = -20; j <= 20; j++)
            *array_push(&p) = vec(i / 2.0, j / 2.0, 0);
    return p;
}

static void go(struct nc_motion *motion, struct vec3 from, struct vec3 to, struct vec3 axis)
{
    struct nc_piece piece = {
        .interpolation = AXIS_GREAT_CIRCLE, .p = {from, to}, .q = {axis, axis}};
    *array_push(&motion->piece) = piece;
}

static struct under_scan find_above(struct nc_motion *motion, const struct tool_shape *tool,
                                    double bottom, int threads)
{
    struct vec3s roof = sheet();
    const struct under_scan_options options = {motion, tool, R, ALLOWED, bottom, threads};
    motion->track = NC_MOTION_CENTRE;
    struct under_scan found = under_scan_find(&options, roof.item, roof.n);
    array_free(&roof);
    return found;
}

static struct under_scan find(struct nc_motion *motion, const struct tool_shape *tool, int threads)
{
    return find_above(motion, tool, -HUGE_VAL, threads);
}

/* Below a bottom at z = -5 nothing is known: there the rim's line is as near as its lower end. */
START_TEST(the_ball_below_the_bottom)
{
    const struct tool_shape none = {.n = 0};
    for (double x = -2; x < -0.2; x += 0.4)
        for (double z = -9; z < 0; z += 0.7) {
            struct nc_motion motion = {.name = NULL};
            go(&motion, vec(-20, 0, z), vec(x, 0, z), vec(0, 0, 1));
            double depth = R - hypot(x, fmax(0, -5 - z));
            struct under_scan found = find_above(&motion, &none, -5, 1);
            ck_assert_double_eq_tol(found.depth, depth > ALLOWED ? depth : 0, 1e-5);
            nc_motion_free(&motion);
        }
}
END_TEST

/* The ball alone comes from beside: deep by its radius less the way that is left to the sheet's
 * rim.  Level with the sheet or over it nothing is under it. */
START_TEST(the_ball_from_beside)
{
    const struct tool_shape none = {.n = 0};
    for (double x = -4; x < -0.2; x += 0.5)
        for (double z = -9; z <= 1; z += 2.5) {
            struct nc_motion motion = {.name = NULL};
            go(&motion, vec(-20, 0, z), vec(x, 0, z), vec(0, 0, 1));
            struct under_scan found = find(&motion, &none, 1);
            if (z < 0 && R + x > ALLOWED) {
                ck_assert_double_eq_tol(found.depth, R + x, 1e-5);
                ck_assert_double_eq_tol(found.at.x, x, 1e-9);
                ck_assert_double_eq(found.height, 0);
                ck_assert_uint_eq(found.pieces, 1);
            } else {
                ck_assert_double_eq(found.depth, 0);
                ck_assert_uint_eq(found.pieces, 0);
            }
            nc_motion_free(&motion);
        }
}
END_TEST

/* The ball far beside the sheet, its shaft under it: found as the shaft, in its piece. */
START_TEST(the_shaft)
{
    struct nc_motion motion = {.name = NULL};
    go(&motion, vec(-30, 0, -5), vec(-20, 0, -5), vec(1, 0, 0));
    go(&motion, vec(-20, 0, -5), vec(-10, 0, -5), vec(1, 0, 0));
    go(&motion, vec(-10, 0, -5), vec(-10, 5, -5), vec(0, 0, 1));
    struct under_scan found = find(&motion, &shaft, 1);
    ck_assert_uint_eq(found.piece, 1);
    ck_assert_uint_eq(found.pieces, 1);
    ck_assert_double_gt(found.height, 8);
    ck_assert_double_eq(found.width, R);
    ck_assert_double_eq_tol(found.depth, 2, R / 8); /* of a sphere no further out than its end */
    nc_motion_free(&motion);
}
END_TEST

/* Never deeper than all points say in a place of the way, and not much less; the same for any
 * number of threads. */
START_TEST(against_all_points)
{
    const double apart = R / 4; /* half of it along the way, half up the tool */
    struct vec3s roof = sheet();
    unsigned state = 5;
    for (int trial = 0; trial < 40; trial++) {
        struct nc_motion motion = {.name = NULL};
        double v[6], want = 0, sure = 0;
        for (int i = 0; i < 6; i++) {
            state = state * 1664525u + seed_step_32();
            v[i] = (state >> 8) / 16777216.0;
        }
        struct vec3 from = vec(-15 + 20 * v[0], -12 + 24 * v[1], -12 + 14 * v[2]);
        struct vec3 axis = vec_unit(vec(2 * v[3] - 1, 2 * v[4] - 1, v[5]));
        struct vec3 to = vec_add(from, vec(4 * v[5], 4 * v[3], 0));
        go(&motion, from, to, axis);
        for (double s = 0; s <= 1; s += 1.0 / 16)
            for (double h = 0; h <= 12; h += 0.5) {
                struct vec3 at = vec_along(vec_mix(from, to, s), h, axis);
                for (size_t i = 0; i < roof.n; i++) {
                    double in = R - hypot(roof.item[i].x - at.x, roof.item[i].y - at.y);
                    want = at.z < 0 ? fmax(want, in) : want;
                    sure = at.z < -apart && h >= R && h <= 12 - R ? fmax(sure, in) : sure;
                }
            }
        struct under_scan found = find(&motion, &shaft, 1), again = find(&motion, &shaft, 3);
        ck_assert_double_le(found.depth, want + 0.3);
        ck_assert_double_ge(found.depth, sure <= ALLOWED + apart ? 0 : sure - apart);
        ck_assert_double_eq(found.depth, again.depth);
        nc_motion_free(&motion);
    }
    array_free(&roof);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("under_scan");
    TCase *tests = tcase_create("under_scan");
    tcase_add_test(tests, the_ball_below_the_bottom);
    tcase_add_test(tests, the_ball_from_beside);
    tcase_add_test(tests, the_shaft);
    tcase_add_test(tests, against_all_points);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
