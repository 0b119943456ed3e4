/*
 * post_ik: the words of random poses on machines of every kind, in each way in which a control
 * interpolates, read back by formulas of their own: the pose within the digits, within the travel,
 * and no other angles (found by trying) are nearer.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "chains.h"
#include "planners.h"
#include "post/post_ik.h"
#include "turnsearch.h"

enum { MODES = 3 };
static const enum interpolation_mode mode_of[MODES] = {INTERPOLATE_VECTOR, INTERPOLATE_ROTARY,
                                                       INTERPOLATE_JOINT};

static struct vec3 any_axis(double least, double most)
{
    struct vec3 axis;
    do
        axis = random_unit();
    while (axis.z < least || axis.z > most);
    return axis;
}

static bool whole(double x)
{
    return fabs(x - round(x)) < 1e-5;
}

/* The least travel to any angles within the travel that have the axis. */
static double least_travel(const struct bench *b, struct vec3 axis, const double from[])
{
    struct angles all = angles_all(&b->machine.chain, axis);
    double least = HUGE_VAL;
    for (int k = 0; k < all.n; k++)
        least = fmin(least, angles_way(&b->machine.chain, from, all.q[k]));
    return least;
}

START_TEST(read_back)
{
    int kind = _i / MODES;
    enum interpolation_mode mode = mode_of[_i % MODES];
    seed = 600 + (uint64_t)_i;
    for (int i = 0; i < 60; i++) {
        struct bench b;
        struct machine_pose got;
        const double q[2] = {4 * chance() - 2, 0.2 + 0.8 * chance()};
        bench_begin(&b, kind, mode, vec_scale(300 * chance(), random_unit()), q);
        struct pose to = {vec_scale(300 * chance(), random_unit()), any_axis(0.35, 0.98)};
        ck_assert_int_eq(post_ik_reach(&b.planner, to, 1, &got), 0);
        struct vec3 tip = got.at.p, a = bench_axis(&b, got.at.q);
        if (mode == INTERPOLATE_JOINT)
            tip = chain_tip(&b.machine.chain, tip, got.at.q);
        ck_assert_double_le(vec_distance(tip, to.p), 1.5e-5);
        ck_assert_double_le(vec_distance(a, to.a),
                            2.1e-7); /* two axes, half of 1e-5 degrees each */
        ck_assert(whole(1e5 * got.at.p.x) && whole(1e5 * got.at.p.y) && whole(1e5 * got.at.p.z));
        for (int k = 0; k < 2; k++)
            ck_assert(whole(1e5 * DEGREES(got.at.q[k])));
        if (mode == INTERPOLATE_VECTOR) {
            ck_assert(whole(1e8 * got.at.a.x) && whole(1e8 * got.at.a.y));
            ck_assert_double_le(vec_distance(got.at.a, to.a), 1e-8);
        }
        for (int k = 0; k < 2; k++)
            ck_assert(got.at.q[k] >= b.machine.chain.rotary[k].min - 1e-9 &&
                      got.at.q[k] <= b.machine.chain.rotary[k].max + 1e-9);
        if (i % 3 == 0) {
            double least = least_travel(&b, to.a, b.planner.state.at.q);
            double is = angles_way(&b.machine.chain, b.planner.state.at.q, got.at.q);
            ck_assert_double_eq_tol(is, least, 1e-6);
        }
        bench_free(&b);
    }
}
END_TEST

/* The usual case says how far its rounding is off: no less than it is, and no guess. */
START_TEST(rounding)
{
    int kind = _i / MODES, near = 0;
    seed = 630 + (uint64_t)_i;
    for (int i = 0; i < 300; i++) {
        struct bench b;
        struct machine_pose got;
        struct pose_deviation off;
        const double q[2] = {4 * chance() - 2, 0.2 + 0.8 * chance()};
        bench_begin(&b, kind, mode_of[_i % MODES], vec_scale(300 * chance(), random_unit()), q);
        b.plan.ability.digits = (struct machine_digits){3, 2, 5, 3, 3};
        struct pose to = b.planner.state.pose;
        to.p = vec_along(to.p, chance(), random_unit());
        to.a = vec_unit(vec_along(to.a, 0.02 * chance(), random_unit()));
        if (post_ik_reach_near(&b.planner, &to, &got, &off)) {
            struct vec3 tip = got.at.p, a = bench_axis(&b, got.at.q);
            if (mode_of[_i % MODES] == INTERPOLATE_VECTOR)
                a = vec_unit(got.at.a);
            if (mode_of[_i % MODES] == INTERPOLATE_JOINT)
                tip = chain_tip(&b.machine.chain, tip, got.at.q);
            ck_assert_double_eq_tol(off.point, vec_distance(tip, to.p), 1e-9);
            ck_assert_double_eq_tol(off.axis, vec_distance(a, to.a), 1e-9);
            near++;
        }
        bench_free(&b);
    }
    ck_assert_int_gt(near, 200);
}
END_TEST

/* Beside the singular direction by 2 degrees a vector leads the first axis about by what the tool's
 * bearing turns, counted in steps so small that no other solution is near; where its travel ends
 * before, no block can be. */
START_TEST(followed_past_pole)
{
    struct bench b;
    struct machine_pose got;
    double q[2] = {0.3, RADIANS(20)};
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_VECTOR, vec(1, 2, 3), q);
    struct vec3 a = b.planner.state.pose.a, aside = vec_unit(vec(-a.y, a.x, 0));
    struct vec3 past = vec_unit(vec_along(vec(-a.x, -a.y, a.z), RADIANS(4), aside));
    struct motion line = motion_line(b.planner.state.pose, (struct pose){vec(2, 2, 3), past});
    double bearing = 0, last = atan2(a.y, a.x);
    for (int i = 1; i <= 5000; i++) {
        struct vec3 at = motion_at(&line, i / 5000.0).a;
        double now = atan2(at.y, at.x);
        bearing += remainder(now - last, 2 * PI);
        last = now;
    }
    ck_assert_double_gt(fabs(bearing), RADIANS(150));
    for (int way = 0; way < 2; way++) {
        ck_assert_int_eq(post_ik_reach(&b.planner, line.to, 1, &got), 0);
        ck_assert(post_ik_follow(&b.planner, &line, 0, 1, &got));
        double turn = got.at.q[0] - b.planner.state.at.q[0];
        ck_assert_double_eq_tol(fabs(turn), fabs(bearing), 1e-5);
        ck_assert_double_le(vec_distance(bench_axis(&b, got.at.q), past), 1e-6);
        double *end = turn > 0 ? &b.machine.chain.rotary[0].max : &b.machine.chain.rotary[0].min;
        *end = b.planner.state.at.q[0] + turn * 0.9;
        ck_assert_int_eq(post_ik_reach(&b.planner, line.to, 1, &got), 0); /* the other solution */
        ck_assert(!post_ik_follow(&b.planner, &line, 0, 1, &got));
        *end = b.planner.state.at.q[0] + turn * 1.1;
    }
    b.planner.follow.mode = INTERPOLATE_ROTARY;
    ck_assert(post_ik_follow(&b.planner, &line, 0, 1, &got));
    bench_free(&b);
}
END_TEST

/* The axes at s of a motion to this axis, which the look ahead has aimed. */
static void aimed_at(struct bench *b, struct nc_aim aim, double s, struct vec3 axis, double c,
                     double a)
{
    struct machine_pose got;
    b->planner.aim = aim;
    ck_assert_int_eq(post_ik_reach(&b->planner, (struct pose){vec(4, 5, 6), axis}, s, &got), 0);
    ck_assert_double_eq_tol(got.at.q[0], c, 1e-7);
    ck_assert_double_eq_tol(got.at.q[1], a, 1e-7);
    ck_assert_double_lt(vec_distance(got.at.p, vec(4, 5, 6)), 1e-9);
}

/* As the look ahead found: past the singular direction evenly from before it to behind it, whatever
 * the axis; elsewhere the solution nearest to what was found between two places, or where the tool
 * turns, to what is found behind the turn. */
START_TEST(aimed)
{
    static const double from[2] = {0.2, 0.4}, s[] = {7, 0.2, 0.3, 0.6, 1}, at_once[] = {7, 0};
    const struct ik_plan_place past[] = {{.q = {0.2, 0.4}},
                                         {.q = {9, 9}, .passed = true},
                                         {.q = {9, 9}, .passed = true},
                                         {.q = {0.8, -0.6}},
                                         {.q = {1, 1}}};
    const struct ik_plan_place turn[] = {{.q = {0.2, 0.4}, .turn = true}, {.q = {0.2 + PI, -0.4}}};
    const struct ik_plan_place no_turn[] = {turn[1], {.q = {0.2 + 2 * PI, 0.4}}};
    static const double places[] = {0.1, 0.2, 0.25, 0.3, 0.45, 0.59};
    struct bench b;
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(1, 2, 3), from);
    struct vec3 up = vec(0, 0, 1), was = bench_axis(&b, from);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        double t = places[i] / 0.6;
        aimed_at(&b, (struct nc_aim){5, past, s}, places[i], up, 0.2 + 0.6 * t, 0.4 - t);
    }
    struct vec3 then = bench_axis(&b, (const double[]){0.9, 0.2});
    aimed_at(&b, (struct nc_aim){5, past, s}, 0.8, then, 0.9, 0.2);
    aimed_at(&b, (struct nc_aim){5, past, s}, 1, bench_axis(&b, past[4].q), 1, 1);
    /* both solutions have this axis, and so has a whole turn */
    aimed_at(&b, (struct nc_aim){2, turn, s}, 0.01, was, 0.2 + PI, -0.4);
    aimed_at(&b, (struct nc_aim){2, no_turn, s}, 0.01, was, 0.2 + PI, -0.4);
    aimed_at(&b, (struct nc_aim){2, no_turn, s}, 0.19, was, 0.2 + 2 * PI, 0.4);
    aimed_at(&b, (struct nc_aim){2, no_turn, at_once}, 0, was, 0.2 + 2 * PI, 0.4);
    bench_free(&b);
}
END_TEST

/* Out of the travel, of a rotary axis or a slide: the axis and where are named. */
START_TEST(out_of_travel)
{
    struct bench b;
    struct machine_pose got;
    double q[2] = {0, 0.3};
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(1, 2, 3), q);
    b.planner.state.pass = 4;
    b.planner.state.line = 17;
    b.machine.chain.rotary[1].min = -0.5;
    b.machine.chain.rotary[1].max = 0.5;
    struct pose to = {vec(5, 6, 7), vec(sin(0.7), 0, cos(0.7))};
    ck_assert_int_eq(post_ik_reach(&b.planner, to, 1, &got), -1);
    ck_assert(b.plan.unmet);
    ck_assert_msg(strstr(b.error.text, "bench:17: pass 4: axis A") != NULL, "%s", b.error.text);
    ck_assert(strstr(b.error.text, "5.000 6.000 7.000") && strstr(b.error.text, "40.107"));
    bench_free(&b);

    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(1, 2, 3), q);
    b.machine.max[MACHINE_Z] = 400;
    b.planner.safe_radius = post_ik_safe_radius(&b.machine);
    to = (struct pose){vec(0, 0, 500), bench_axis(&b, q)};
    ck_assert_int_eq(post_ik_reach(&b.planner, to, 1, &got), -1);
    ck_assert_msg(strstr(b.error.text, "axis Z") != NULL, "%s", b.error.text);
    bench_free(&b);
}
END_TEST

/* A machine of a kind with the default travel. */
static struct machine slides_of(int kind)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    m.chain = chain_of(kind);
    return m;
}

static struct block_pose any_place(const struct kinematic_chain *chain, double far)
{
    struct block_pose s = {.p = vec_scale(far * chance(), random_unit()),
                           .q = {4 * chance() - 2, 2 * chance() - 1}};
    s.a = chain_axis(chain, s.q);
    return s;
}

/* Within what post_ik_safe_radius says no slide is over, whatever the angles; beyond it, where it
 * is over by more than half of the last digit. */
START_TEST(slides_within)
{
    int over = 0;
    const double half = 0.5e-2;
    struct nc_plan plan = {.ability = {.digits = {2, 3, 6, 3, 1}}};
    seed = 320 + (uint64_t)_i;
    for (int i = 0; i < 3000; i++) {
        struct machine m = slides_of(_i);
        m.max[MACHINE_X] = 400 + 400 * chance();
        m.min[MACHINE_Z] = -300 - 400 * chance();
        struct nc_planner planner = {
            .machine = &m, .plan = &plan, .safe_radius = post_ik_safe_radius(&m)};
        struct block_pose at = any_place(&m.chain, 1200);
        struct vec3 linear = chain_linear(&m.chain, at.p, at.q);
        int found = post_ik_linear_over(&planner, at.p, at.q);
        bool x = linear.x > m.max[MACHINE_X] + half, z = linear.z < m.min[MACHINE_Z] - half;
        ck_assert_int_eq(found, x ? MACHINE_X : z ? MACHINE_Z : -1);
        over += found >= 0;
    }
    ck_assert_int_gt(over, 100);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_ik");
    TCase *tests = tcase_create("poses");

    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, read_back, 0, KINDS * MODES);
    tcase_add_loop_test(tests, rounding, 0, KINDS * MODES);
    tcase_add_test(tests, followed_past_pole);
    tcase_add_test(tests, aimed);
    tcase_add_test(tests, out_of_travel);
    tcase_add_loop_test(tests, slides_within, 0, KINDS);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
