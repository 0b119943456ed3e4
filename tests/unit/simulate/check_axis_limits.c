/* check_axis_limits - travel, turns, speeds and times of moves that are worked out by hand. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/axis_limits.h"

static const struct axis_limits limits = {
    .min = {-100, -100, -100, -30, -360, -360},
    .max = {100, 100, 100, 30, 360, 360},
    .rapid = {6000, 6000, 6000, 600, 600, 600},
};

/* One straight move of the tip, A and C turning evenly. */
static struct axis_use one(struct vec3 to, double a, double feed, bool inverse)
{
    struct nc_motion motion = {.kinematics = verify_kinematics_trunnion('A', 1)};
    *array_push(&motion.piece) = (struct nc_piece){.interpolation = AXIS_ROTARY_LINEAR,
                                                   .feed = feed,
                                                   .inverse = inverse,
                                                   .p = {{0, 0, 0}, to},
                                                   .q = {{0, 0, 0}, {0, a, 0}}};
    struct axis_use load = axis_limits_check(&motion, &limits);
    nc_motion_free(&motion);
    return load;
}

START_TEST(time_is_way_by_feed)
{
    struct axis_use load = one(vec(30, 40, 0), 0, 500, false);
    ck_assert_double_eq_tol(load.cut_time, 0.1, 1e-12);
    ck_assert_double_eq_tol(load.cut_length, 50, 1e-9);
    ck_assert_uint_eq(load.beyond + load.fast + load.no_feed, 0);
    ck_assert_double_eq_tol(one(vec(30, 40, 0), 0, 4, true).cut_time, 0.25, 1e-12);
}
END_TEST

START_TEST(a_turn_takes_its_time)
{
    /* 20 degrees in 1 mm at 500: 10000 degrees a minute, the axis makes 600 */
    struct axis_use load = one(vec(1, 0, 0), 20, 500, false);
    ck_assert_uint_eq(load.fast, 1);
    ck_assert_int_eq(load.speed.axis, 3);
    ck_assert_double_eq_tol(load.speed.value, 10000.0 / 600, 1e-6);
    ck_assert_double_eq_tol(load.cut_time, 20.0 / 600, 1e-9);
    ck_assert_double_eq_tol(load.jump.value, 20, 1e-9);
    ck_assert_double_eq_tol(load.turn_rate.value, 20, 1e-6);
}
END_TEST

/* C turns on a whole circle of the tip, as fast as it can, or 3 % faster. */
START_TEST(an_arc_is_as_long_as_it_is)
{
    const double radius = 0.02, turn = 10;
    for (int i = 0; i < 2; i++) {
        double feed = 2 * PI * radius * 600 / turn * (i ? 1.03 : 1);
        struct nc_motion motion = {.kinematics = verify_kinematics_trunnion('A', 1)};
        *array_push(&motion.arc) = (struct nc_motion_arc){{0, 0, 0}, {0, 0, 1}, 2 * PI};
        *array_push(&motion.piece) = (struct nc_piece){.shape = SHAPE_ARC,
                                                       .interpolation = AXIS_ROTARY_LINEAR,
                                                       .feed = feed,
                                                       .p = {{radius, 0, 0}, {radius, 0, 0}},
                                                       .q = {{0, 0, 0}, {0, turn, 0}}};
        struct axis_use load = axis_limits_check(&motion, &limits);
        ck_assert_uint_eq(load.fast, (size_t)i);
        ck_assert_double_eq_tol(load.cut_time, turn / 600, 1e-4);
        nc_motion_free(&motion);
    }
}
END_TEST

/* At the pole a spline's words turn C by 30 degrees over 1 mm, which the tool's direction there
 * does not show: 3 s at C's largest speed. */
START_TEST(a_spline_at_the_pole_turns_by_its_words)
{
    static const double knot[] = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int i = 0; i < 2; i++) {
        struct nc_motion motion = {.kinematics = verify_kinematics_trunnion('A', 1)};
        struct nc_motion_spline spline = {.order = 4, .n = 4};
        spline.knot = mem_alloc(8, sizeof(double));
        spline.p = mem_alloc(4, sizeof(struct vec3));
        spline.q = mem_alloc(4, sizeof(struct vec3));
        for (int k = 0; k < 8; k++)
            spline.knot[k] = knot[k];
        for (int k = 0; k < 4; k++) {
            spline.p[k] = vec(k / 3.0, 0, 0);
            spline.q[k] = vec(10 * k, 0, 0);
        }
        struct nc_piece piece = {.interpolation = AXIS_ROTARY_LINEAR, .feed = i ? 22 : 19};
        nc_motion_add_spline(&motion, spline, &piece);
        struct axis_use load = axis_limits_check(&motion, &limits);
        ck_assert_uint_eq(load.fast, (size_t)i);
        ck_assert_double_eq_tol(load.cut_time, i ? 1 / 20.0 : 1 / 19.0, 1e-9);
        ck_assert_double_eq_tol(load.high[5], 30, 1e-9);
        nc_motion_free(&motion);
    }
}
END_TEST

START_TEST(travel_is_kept)
{
    ck_assert_uint_eq(one(vec(100, 0, 0), 0, 500, false).beyond, 0);
    struct axis_use load = one(vec(101, 0, 0), 0, 500, false);
    ck_assert_uint_eq(load.beyond, 1);
    ck_assert_int_eq(load.travel.axis, 0);
    load = one(vec(1, 0, 0), 31, 500, false);
    ck_assert_int_eq(load.travel.axis, 3);
    /* the table turns the point beside it: y 90 by A 30 lifts the linear axes to z -45 */
    load = one(vec(0, 90, 0), 30, 500, false);
    ck_assert_double_eq_tol(load.low[2], -45, 1e-9);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_limits");
    TCase *tcase = tcase_create("axis_limits");
    tcase_add_test(tcase, time_is_way_by_feed);
    tcase_add_test(tcase, a_turn_takes_its_time);
    tcase_add_test(tcase, an_arc_is_as_long_as_it_is);
    tcase_add_test(tcase, a_spline_at_the_pole_turns_by_its_words);
    tcase_add_test(tcase, travel_is_kept);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
