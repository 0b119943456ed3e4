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
    struct axis_time_place place[200] = {{{0}, 0, 0, 0}};
    for (int i = 0; i <= n; i++)
        place[i] =
            (struct axis_time_place){.axis = {length * i / n}, .way = length * i / n, .feed = feed};
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
        {{0}, 0, 50, 0}, {{50}, 50, 50, 1}, {{100, 0, 0, 0, 50 * rate}, 100, 50, 2}};
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

/* How fast, on the whole, X and Y go round a circle of 5 mm ten times, places 0.25 mm apart. */
static double round_a_circle(double feed, double jerk)
{
    enum { N = 1257 };
    static struct axis_time_place place[N];
    static double step[N];
    struct axis_time_limits limits = usual;
    limits.jerk[0] = limits.jerk[1] = jerk;
    for (int i = 0; i < N; i++)
        place[i] = (struct axis_time_place){
            .axis = {5 * cos(0.05 * i), 5 * sin(0.05 * i)}, .way = 0.25 * i, .feed = feed};
    return 0.25 * (N - 1) / axis_time_run(&limits, place, N, step);
}

/* Where both axes bend alike each has 1 / sqrt(2) of it, and there it may be faster. */
START_TEST(a_bend_bounds_the_speed)
{
    const double least = sqrt(3000 * 5), most = least * sqrt(sqrt(2)),
                 by_jerk = cbrt(1e4 * 0.2 * 5);
    ck_assert_double_eq_tol(round_a_circle(0.9 * least, 1e12), 0.9 * least, 2);
    ck_assert_double_gt(round_a_circle(2 * most, 1e12), least - 3);
    ck_assert_double_lt(round_a_circle(1.1 * most, 1e12), 1.03 * most);
    ck_assert_double_eq_tol(round_a_circle(0.99 * by_jerk, 1e4), 0.99 * by_jerk, 0.1);
    ck_assert_double_gt(round_a_circle(50, 1e4), by_jerk - 0.1);
    ck_assert_double_lt(round_a_circle(50, 1e4), 30); /* it speeds up between two places */
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

/* The steps of a way that were told, in their order. */
struct told {
    size_t n;
    double step[MANY];
};

static void tell(void *context, size_t mark, double seconds)
{
    struct told *told = context;
    ck_assert_uint_eq(mark, ++told->n);
    told->step[mark] = seconds;
}

/* Of random ways, smooth or all corners, slow or so fast that the axes need many places to stop: to
 * the bit what they take when all places are known at once; and few are kept where they need not
 * be. */
START_TEST(a_way_that_is_being_made)
{
    static struct axis_time_place place[MANY];
    static double step[MANY];
    static struct told told;
    struct axis_time_way way = {.limits = usual, .step = tell, .context = &told};
    for (int round = 0; round < 24; round++) {
        bool slow = round % 3 == 0;
        double apart = 0.05 + 0.3 * chance(), feed = slow ? 10 : 20 + 600 * chance();
        double bend = round % 4 == 1 ? 1 : 0.02, turn = 0, tilt = 0;
        for (int i = 0; i < MANY; i++) {
            double length = apart * (0.5 + chance());
            feed = i % 700 == 0 && !slow ? 20 + 600 * chance() : feed;
            turn += bend * (chance() - 0.5);
            tilt += 0.5 * bend * (chance() - 0.5);
            place[i] = (struct axis_time_place){
                .way = i > 0 ? place[i - 1].way + length : 0, .feed = feed, .mark = (size_t)i};
            const double by[AXIS_TIME_AXES] = {cos(turn) * length, sin(turn) * length, 0,
                                               tilt * length, 0};
            for (int k = 0; k < AXIS_TIME_AXES && i > 0; k++)
                place[i].axis[k] = place[i - 1].axis[k] + by[k];
        }
        way.limits.jerk[0] = round % 2 ? 1e12 : 3e4;
        int n = round < 20 ? MANY - 997 * round : round - 20;
        told.n = 0;
        for (int i = 0; i < n; i++)
            *axis_time_add(&way) = place[i];
        ck_assert(axis_time_end(&way) == axis_time_run(&way.limits, place, (size_t)n, step));
        ck_assert_uint_eq(told.n, n > 1 ? (size_t)n - 1 : 0);
        for (int i = 1; i < n; i++)
            ck_assert(told.step[i] == step[i]);
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
    tcase_add_test(tcase, a_bend_bounds_the_speed);
    tcase_add_test(tcase, a_way_that_is_being_made);
    tcase_add_test(tcase, a_rapid_is_as_long_as_its_slowest_axis);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
