/* axis_time: ways whose times are known by hand. */
#include "machine/axis_time.h"
#include "seed.h"

#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

static const struct axis_time_limits usual = {.speed = {500, 500, 500, 120, 120},
                                              .acceleration = {3000, 3000, 3000, 1000, 1000},
                                              .jerk = {1e12, 1e12, 1e12, 1e12, 1e12},
                                              .smoothing = 0.2};

/* A straight way of X in n steps at a feed. */
static double straight(double length, double feed, int n)
{
    struct axis_time_place place[200] = {{{0}, 0, 0}};
    for (int i = 0; i <= n; i++)
        place[i] = (struct axis_time_place){{length * i / n}, length * i / n, feed};
    double step[200];
    return axis_time_run(&usual, place, (size_t)n + 1, step);
}

START_TEST(a_line_speeds_up_and_slows_down)
{
    /* v / a more than length / v */
    for (int n = 1; n < 200; n += 33) {
        ck_assert_double_eq_tol(straight(600, 50, n), 600 / 50.0 + 50 / 3000.0, 1e-9);
        /* too short for the feed: 2 sqrt(length / a) */
        ck_assert_double_eq_tol(straight(0.3, 50, n), 2 * sqrt(0.3 / 3000), 1e-9);
        /* the axis is slower than the feed */
        ck_assert_double_eq_tol(straight(6000, 900, n), 6000 / 500.0 + 500 / 3000.0, 1e-9);
    }
}
END_TEST

/* C turns by `rate` degrees a mm on the second half of 100 mm along X. */
static double with_turn(double rate, double jerk, double step[3])
{
    struct axis_time_limits limits = usual;
    struct axis_time_place place[3] = {
        {{0}, 0, 50}, {{50}, 50, 50}, {{100, 0, 0, 0, 50 * rate}, 100, 50}};
    limits.jerk[4] = jerk;
    return axis_time_run(&limits, place, 3, step);
}

START_TEST(a_corner_of_an_axis_slows_down)
{
    double step[3], none = 100 / 50.0 + 50 / 3000.0;
    ck_assert_double_eq_tol(with_turn(0, 1e12, step), none, 1e-9);
    /* over the mean of the steps: 50 mm; sqrt(1000 / (1 / 50)) is more than the feed */
    ck_assert_double_gt(with_turn(1, 1e12, step), none);
    /* 4 degrees a mm: 120 / 4 = 30 mm/s */
    double slow = with_turn(4, 1e12, step);
    ck_assert_double_gt(slow, 50 / 50.0 + 50 / 30.0);
    ck_assert_double_lt(slow, 50 / 50.0 + 50 / 30.0 + 0.4);
    ck_assert_double_eq_tol(step[1] + step[2], slow, 1e-9);
    ck_assert_double_gt(with_turn(1, 100, step), with_turn(1, 1e12, step));
}
END_TEST

static unsigned long long seed = 11;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

enum { MANY = 30000 };

/* Of random ways, smooth or all corners, slow or so fast that the axes need many places to stop: to
 * the bit what they take when all places are known at once; and few are kept where they need not
 * be. */
START_TEST(a_way_that_is_being_made)
{
    static struct axis_time_place place[MANY];
    static double step[MANY];
    struct axis_time_way way = {.limits = usual};
    for (int round = 0; round < 24; round++) {
        bool slow = round % 3 == 0;
        double apart = 0.05 + 0.3 * chance(), feed = slow ? 10 : 20 + 600 * chance();
        double bend = round % 4 == 1 ? 1 : 0.02, turn = 0, tilt = 0;
        for (int i = 0; i < MANY; i++) {
            double length = apart * (0.5 + chance());
            feed = i % 700 == 0 && !slow ? 20 + 600 * chance() : feed;
            turn += bend * (chance() - 0.5);
            tilt += 0.5 * bend * (chance() - 0.5);
            place[i] = (struct axis_time_place){.way = i > 0 ? place[i - 1].way + length : 0,
                                                .feed = feed};
            const double by[AXIS_TIME_AXES] = {cos(turn) * length, sin(turn) * length, 0,
                                               tilt * length, 0};
            for (int k = 0; k < AXIS_TIME_AXES && i > 0; k++)
                place[i].axis[k] = place[i - 1].axis[k] + by[k];
        }
        way.limits.jerk[0] = round % 2 ? 1e12 : 3e4;
        int n = round < 20 ? MANY - 997 * round : round - 20;
        for (int i = 0; i < n; i++)
            axis_time_add(&way, &place[i]);
        ck_assert(axis_time_end(&way) == axis_time_run(&way.limits, place, (size_t)n, step));
        if (round == 0)
            ck_assert_uint_lt(way.cap, MANY / 4);
    }
    ck_assert_uint_ge(way.cap, MANY / 8); /* some had to be kept */
    axis_time_free(&way);
}
END_TEST

START_TEST(a_rapid_is_as_long_as_its_slowest_axis)
{
    const double from[AXIS_TIME_AXES] = {0, 0, 0, 0, 0}, to[AXIS_TIME_AXES] = {100, 0, 50, 0, 90};
    ck_assert_double_eq_tol(axis_time_rapid(&usual, from, to), 90 / 120.0 + 120 / 1000.0, 1e-9);
    ck_assert_double_eq_tol(axis_time_rapid(&usual, to, to), 0, 1e-12);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_time");
    TCase *tcase = tcase_create("axis_time");
    tcase_add_test(tcase, a_line_speeds_up_and_slows_down);
    tcase_add_test(tcase, a_corner_of_an_axis_slows_down);
    tcase_add_test(tcase, a_way_that_is_being_made);
    tcase_add_test(tcase, a_rapid_is_as_long_as_its_slowest_axis);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
