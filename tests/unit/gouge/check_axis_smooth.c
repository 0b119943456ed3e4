/* axis_smooth: turns that are known, before and after. */
#include "gouge/axis_smooth.h"

#include <check.h>
#include <stdlib.h>

static const double BALL = 5;

/* A line of n points, 0.5 mm apart, with the axis in the plane of the line at angle(i). */
static struct run line(size_t n, double (*angle)(size_t i))
{
    struct run run = {.radius = BALL};
    for (size_t i = 0; i < n; i++) {
        struct run_point p = {.ball = {0.5 * (double)i, 0, 0}, .normal = {0, 0, 1}};
        double a = angle(i);
        p.axis = vec(sin(a), 0, cos(a));
        p.tip = vec_along(p.ball, -BALL, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

static double angle_of(const struct run_point *p)
{
    return atan2(p->axis.x, p->axis.z);
}

static double turned(const struct run *run)
{
    double sum = 0;
    for (size_t i = 1; i < run->n; i++)
        sum += vec_angle(run->item[i - 1].axis, run->item[i].axis);
    return sum;
}

static double wiggle(size_t i)
{
    return 0.1 * sin(0.3 * (double)i);
}

static double step(size_t i)
{
    return i < 100 ? 0 : 0.6;
}

static double steady(size_t i)
{
    return -0.002 * (double)i;
}

static void check_tips(const struct run *run)
{
    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        ck_assert_double_lt(vec_distance(p->tip, vec_along(p->ball, -BALL, p->axis)), 1e-12);
        ck_assert_double_eq_tol(vec_length(p->axis), 1, 1e-12);
    }
}

START_TEST(a_wiggle_within_the_play_goes)
{
    struct run run = line(300, wiggle);
    ck_assert_double_gt(turned(&run), 5);
    axis_smooth_play(&run, 0.12);
    ck_assert_double_lt(turned(&run), 0.05);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_le(fabs(angle_of(&run.item[i]) - wiggle(i)), 0.12 + 1e-9);
    check_tips(&run);
    array_free(&run);
}
END_TEST

/* From one side of a step to the other, less the play on both sides. */
START_TEST(a_step_is_as_large_as_it_must_be)
{
    struct run run = line(200, step);
    axis_smooth_play(&run, 0.1);
    ck_assert_double_eq_tol(turned(&run), 0.4, 0.02);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_le(fabs(angle_of(&run.item[i]) - step(i)), 0.1 + 1e-9);
    check_tips(&run);
    array_free(&run);
}
END_TEST

START_TEST(no_turn_is_faster_than_it_may_be)
{
    static const double rates[] = {0.2, 0.05, 0.01, 0.001};
    for (int k = 0; k < 4; k++) {
        struct run run = line(200, step);
        ck_assert_double_gt(axis_smooth_fastest(&run), rates[k]);
        double off = axis_smooth_rate(&run, rates[k]), most = 0;
        ck_assert_double_le(axis_smooth_fastest(&run), rates[k]);
        for (size_t i = 0; i < run.n; i++)
            most = fmax(most, fabs(angle_of(&run.item[i]) - step(i)));
        ck_assert_double_eq_tol(off, most, 1e-9);
        ck_assert_double_le(off, 0.6);
        check_tips(&run);
        array_free(&run);
    }
}
END_TEST

START_TEST(what_is_slow_stays)
{
    struct run run = line(200, steady);
    ck_assert_double_eq_tol(axis_smooth_fastest(&run), 0.004 / (1 - 0.004 * BALL), 0.0004);
    ck_assert(axis_smooth_rate(&run, 0.005) == 0);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_eq_tol(angle_of(&run.item[i]), steady(i), 1e-12);
    array_free(&run);
}
END_TEST

START_TEST(a_turn_in_one_place_is_spread)
{
    struct run run = line(200, step);
    run.item[100].ball = run.item[99].ball;
    run.item[100].tip = vec_along(run.item[100].ball, -BALL, run.item[100].axis);
    axis_smooth_rate(&run, 0.05);
    ck_assert_double_le(axis_smooth_fastest(&run), 0.05);
    struct run none = {.radius = BALL};
    ck_assert(axis_smooth_rate(&none, 0.1) == 0);
    axis_smooth_play(&none, 0.1);
    array_free(&run);
}
END_TEST

/* Points unevenly apart, and the rule of every third off by 0.1 radians. */
START_TEST(rules_are_averaged_without_steps)
{
    enum { N = 300 };
    struct run_point point[N] = {{.given = true}};
    struct vec3 rule[N];
    double at[N], worst = 0, x = 0;
    for (int i = 0; i < N; i++) {
        at[i] = x += i % 7 == 0 ? 0.4 : 0.05;
        double a = 0.01 * x + (i % 3 == 0 ? 0.1 : 0);
        point[i].ball = vec(x, 0, 0);
        point[i].normal = i == 150 ? vec(0, 0, 0) : vec(0, 0, 1);
        rule[i] = vec(sin(a), 0, cos(a));
    }
    struct vec3 alone = rule[150];
    axis_smooth_rules(point, N, 2.0 / AXIS_SMOOTH_RULE, 0.08, rule);
    ck_assert_double_lt(vec_distance(rule[150], alone), 1e-15);
    for (int i = 60; i < 240; i++) {
        double a = atan2(rule[i].x, rule[i].z), b = atan2(rule[i - 1].x, rule[i - 1].z);
        if (abs(i - 150) > 1 && i != 150)
            worst = fmax(worst, fabs(a - b - 0.01 * (at[i] - at[i - 1])));
        if (i != 150)
            ck_assert_double_eq_tol(a, 0.01 * at[i] + 0.1 / 3, 0.01);
    }
    ck_assert_double_lt(worst, 0.001);
}
END_TEST

/* On an even bend the mean is the rule itself, and leans little near the ends of a run. */
START_TEST(rules_do_not_lean_where_the_surface_bends)
{
    enum { N = 300 };
    struct run_point point[N] = {{.given = true}};
    struct vec3 rule[N];
    for (int i = 0; i < N; i++) {
        point[i].ball = vec(0.1 * i, 0, 0);
        point[i].normal = vec(0, 0, 1);
        rule[i] = vec(sin(0.005 * i), 0, cos(0.005 * i));
    }
    axis_smooth_rules(point, N, 2, 0.08, rule);
    for (int i = 0; i < N; i++) {
        int end = i < N - 1 - i ? i : N - 1 - i;
        double off = end < 56 ? 0.13 : 0.015; /* 28 points are the least to one side */
        off += end < 200 ? 0.08 : 0;
        ck_assert_double_eq_tol(atan2(rule[i].x, rule[i].z), 0.005 * i, off);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_smooth");
    TCase *tcase = tcase_create("axis_smooth");
    tcase_add_test(tcase, a_wiggle_within_the_play_goes);
    tcase_add_test(tcase, a_step_is_as_large_as_it_must_be);
    tcase_add_test(tcase, no_turn_is_faster_than_it_may_be);
    tcase_add_test(tcase, what_is_slow_stays);
    tcase_add_test(tcase, a_turn_in_one_place_is_spread);
    tcase_add_test(tcase, rules_are_averaged_without_steps);
    tcase_add_test(tcase, rules_do_not_lean_where_the_surface_bends);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
