/*
 * check_machine_time - the least time of moves whose time is known: a line from standstill to
 * standstill, a circle that its acceleration bounds, a rotary axis that its speed bounds, a turn
 * about a tip that stands.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/machine_time.h"

static const struct axis_limits limits = {
    .min = {-1e6, -1e6, -1e6, -1e6, -1e6, -1e6},
    .max = {1e6, 1e6, 1e6, 1e6, 1e6, 1e6},
    .rapid = {60000, 60000, 60000, 600, 600, 600}}; /* 1000 mm/s, 10 degrees/s */

static struct machine_time_options options_of(double jerk)
{
    return (struct machine_time_options){.limits = &limits,
                                         .acceleration = {1000, 1000, 1000, 1e5, 1e5, 1e5},
                                         .jerk = {jerk, jerk, jerk, 1e12, 1e12, 1e12},
                                         .smoothing = 0.2};
}

static struct nc_motion one(struct nc_piece piece)
{
    struct nc_motion motion = {.kinematics = verify_kinematics_trunnion('A', 1)};
    *array_push(&motion.piece) = piece;
    return motion;
}

/* 100 mm at 100 mm/s with 1000 mm/s^2: 1.1 s; with a jerk of 10000 mm/s^3 0.1 s more. */
START_TEST(a_line)
{
    struct nc_motion motion = one((struct nc_piece){
        .interpolation = AXIS_ROTARY_LINEAR, .feed = 6000, .p = {{0, 0, 0}, {100, 0, 0}}});
    struct machine_time_options options = options_of(1e12);
    struct machine_time time = machine_time_of(&motion, &options);
    ck_assert_double_eq_tol(60 * time.least, 1.1, 0.01);
    ck_assert_double_eq_tol(60 * time.programmed, 1, 1e-9);
    machine_time_free(&time);
    options = options_of(10000);
    time = machine_time_of(&motion, &options);
    ck_assert_double_eq_tol(60 * time.least, 1.3, 0.02); /* both ramps */
    machine_time_free(&time);
    motion.piece.item[0].rapid = true; /* 2 sqrt(100 / 1000), its top speed is not reached */
    options = options_of(1e12);
    time = machine_time_of(&motion, &options);
    ck_assert_double_eq_tol(60 * time.rapid, 2 * sqrt(0.1), 1e-6);
    machine_time_free(&time);
    nc_motion_free(&motion);
}
END_TEST

/* A circle of 40 at 400 mm/s: v^2 / R <= 1000 leaves 200 mm/s, reached in 0.2 s over 20 mm; a bend
 * of 40 is felt by one axis or the other, which leaves it 200 at least. */
START_TEST(a_circle)
{
    struct nc_motion motion = one((struct nc_piece){.interpolation = AXIS_ROTARY_LINEAR,
                                                    .shape = SHAPE_ARC,
                                                    .feed = 24000,
                                                    .p = {{40, 0, 0}, {40, 0, 0}}});
    *array_push(&motion.arc) = (struct nc_motion_arc){{0, 0, 0}, {0, 0, 1}, 2 * PI};
    struct machine_time_options options = options_of(1e12);
    struct machine_time time = machine_time_of(&motion, &options);
    double round = 2 * PI * 40 / 200;
    ck_assert_double_gt(60 * time.least, round * 0.85);
    ck_assert_double_lt(60 * time.least, round + 0.4);
    ck_assert_double_gt(time.slow, 0);
    machine_time_free(&time);
    nc_motion_free(&motion);
}
END_TEST

/* 90 degrees of C over 100 mm at 100 mm/s, with 10 degrees/s: 9 s. */
START_TEST(a_turn)
{
    struct nc_motion motion = one((struct nc_piece){.interpolation = AXIS_ROTARY_LINEAR,
                                                    .feed = 6000,
                                                    .p = {{0, 0, 0}, {0, 0, 100}},
                                                    .q = {{0, 0, 0}, {90, 0, 0}}});
    struct machine_time_options options = options_of(1e12);
    struct machine_time time = machine_time_of(&motion, &options);
    ck_assert_double_eq_tol(60 * time.least, 9, 0.1);
    ck_assert_double_eq_tol(time.turn[5], 90, 1e-6);
    ck_assert_double_eq_tol(time.slow, 1, 0.01);
    ck_assert_uint_eq(time.worst[0], 0);
    ck_assert_double_eq_tol(time.lost[0], 8, 0.1);
    machine_time_free(&time);
    nc_motion_free(&motion);
}
END_TEST

/* 90 degrees of C at 540 degrees a minute: 10 s, in a program in inches, too, whose F has been
 * taken for inches; and with F along all axes, 40 mm beside it: hypot(90, 40) in as long. */
START_TEST(a_tip_that_stands)
{
    struct nc_piece turn = {.interpolation = AXIS_ROTARY_LINEAR,
                            .feed = 540,
                            .p = {{0, 0, 0}, {0, 0, 0}},
                            .q = {{0, 0, 0}, {90, 0, 0}}};
    for (int inch = 0; inch < 2; inch++) {
        struct nc_motion motion = one(turn);
        struct axis_limits all = limits;
        struct machine_time_options options = options_of(1e12);
        motion.unit = inch ? 25.4 : 1;
        motion.piece.item[0].feed *= motion.unit;
        options.limits = &all;
        struct machine_time time = machine_time_of(&motion, &options);
        ck_assert_double_eq_tol(60 * time.least, 10, 0.2);
        machine_time_free(&time);
        all.combined = true;
        motion.piece.item[0].p[1].z = 40 * motion.unit;
        motion.piece.item[0].feed = 540 * hypot(90, 40) / 90 * motion.unit;
        time = machine_time_of(&motion, &options);
        ck_assert_double_eq_tol(60 * time.least, 10, 0.3);
        machine_time_free(&time);
        nc_motion_free(&motion);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("machine_time");
    TCase *tcase = tcase_create("machine_time");
    tcase_add_test(tcase, a_line);
    tcase_add_test(tcase, a_circle);
    tcase_add_test(tcase, a_turn);
    tcase_add_test(tcase, a_tip_that_stands);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
