/*
 * post_rewind: retract, turn, return on machines of every kind.  The tool goes up its own axis,
 * turns with the tip at rest, comes down to where it was with the same axis, and the angles are
 * within the travel and those that were asked for.
 */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "planners.h"
#include "post/post_ik.h"
#include "post/post_rewind.h"

enum { MODES = 2 };
static const enum interpolation_mode mode_of[MODES] = {INTERPOLATE_ROTARY, INTERPOLATE_JOINT};

/* Somewhere, leaning 30 to 60 degrees or so, by the first solution. */
static void begin(struct bench *b, int kind, enum interpolation_mode mode)
{
    struct vec3 axis, tip = vec_scale(150 * chance(), random_unit());
    do
        axis = random_unit();
    while (axis.z > 0.85 || axis.z < 0.5);
    bench_begin(b, kind, mode, tip, (double[]){0, 0});
    struct chain_solutions found = chain_angles(&b->machine.chain, axis);
    ck_assert_int_eq(found.n, 2);
    bench_free(b);
    bench_begin(b, kind, mode, tip, found.q[0]);
}

static bool within_travel(const struct bench *b, const double q[])
{
    for (int i = 0; i < 2; i++)
        if (q[i] < b->machine.chain.rotary[i].min - 1e-9 ||
            q[i] > b->machine.chain.rotary[i].max + 1e-9)
            return false;
    return true;
}

/* All moves of the rewind in the plan, from a pose up by so much. */
static void check_moves(const struct bench *b, struct pose start, const double q0[], double up)
{
    const struct nc_move *move = b->plan.move.item;
    size_t n = b->plan.move.n, k = 0;
    struct vec3 top = vec_along(start.p, up, start.a);
    double high = 0;
    for (; k < n && move[k].q[0] == move[0].q[0] && move[k].q[1] == move[0].q[1]; k++) {
        struct vec3 off = vec_sub(bench_tip(b, &move[k]), start.p);
        high = fmax(high, vec_dot(off, start.a));
        ck_assert_double_le(vec_length(vec_cross(off, start.a)), 3e-5); /* up its own axis */
        for (int i = 0; i < 2; i++)
            ck_assert_double_eq_tol(move[k].q[i], q0[i], RADIANS(6e-6));
    }
    ck_assert_double_eq_tol(high, up, 3e-5);
    for (; k < n && vec_distance(bench_tip(b, &move[k]), top) < 3e-5; k++)
        ck_assert_int_eq(move[k].kind, NC_RAPID); /* the turn, the tip at rest */
    ck_assert_uint_lt(k, n);
    ck_assert_int_eq(move[k].kind, NC_RAPID); /* down, 2 mm at feed */
    ck_assert_int_eq(move[n - 1].kind, NC_LINE);
    ck_assert_double_eq_tol(vec_distance(bench_tip(b, &move[n - 2]), start.p), 2, 3e-5);
    for (; k < n; k++) {
        const double *q = move[k].q;
        struct vec3 off = vec_sub(bench_tip(b, &move[k]), start.p);
        ck_assert_double_le(vec_length(vec_cross(off, start.a)), 3e-5);
        ck_assert_double_le(vec_distance(bench_axis(b, q), start.a), 3e-7);
        ck_assert(within_travel(b, q));
        ck_assert_int_eq(move[k].why, NC_WHY_TURN);
    }
    ck_assert_double_le(vec_distance(bench_tip(b, &move[n - 1]), start.p), 3e-5);
    ck_assert_uint_eq(b->plan.total.turns, 1);
}

/* To the other solution, whole turns on: the nearest angles to those asked for that have the axis.
 */
START_TEST(to_angles)
{
    seed = 500 + (uint64_t)_i;
    for (int i = 0; i < 40; i++) {
        struct bench b;
        begin(&b, _i, mode_of[i % MODES]);
        struct pose start = b.planner.state.pose;
        double q0[2] = {b.planner.state.at.q[0], b.planner.state.at.q[1]};
        struct chain_solutions found = chain_angles(&b.machine.chain, start.a);
        double turn = i % 4 < 2 ? 2 * PI : 0;
        double asked[2] = {found.q[1][0] + turn + 0.1 * chance(), found.q[1][1] - 0.1 * chance()};
        double got[2] = {found.q[1][0] + turn, found.q[1][1]};
        ck_assert_int_eq(post_rewind_to(&b.planner, asked), 0);
        check_moves(&b, start, q0, b.machine.retract);
        const struct nc_move *last = &b.plan.move.item[b.plan.move.n - 1];
        if (within_travel(&b, got))
            for (int k = 0; k < 2; k++)
                ck_assert_double_eq_tol(last->q[k], got[k], RADIANS(6e-6));
        bench_free(&b);
    }
}
END_TEST

/* At the end of the first axis's travel the goal is beyond it: after the rewind it is a small turn
 * away, and that within the travel. */
START_TEST(for_a_goal)
{
    seed = 520 + (uint64_t)_i;
    for (int i = 0; i < 40; i++) {
        struct bench b;
        struct machine_pose to;
        begin(&b, _i, mode_of[i % MODES]);
        struct rotary *first = &b.machine.chain.rotary[0];
        struct pose start = b.planner.state.pose, goal = start;
        const double *at = b.planner.state.at.q;
        double beyond[2] = {at[0] + 0.2, at[1]}, q0[2] = {at[0], at[1]};
        first->max = at[0] + 0.1;
        first->min = first->max - 2.2 * PI;
        goal.a = bench_axis(&b, beyond);
        ck_assert_int_eq(post_rewind_for(&b.planner, goal), 0);
        check_moves(&b, start, q0, b.machine.retract);
        ck_assert_int_eq(post_ik_reach(&b.planner, goal, 1, &to), 0);
        double turn = 0;
        for (int k = 0; k < 2; k++)
            turn = fmax(turn, fabs(to.at.q[k] - b.planner.state.at.q[k]));
        ck_assert_double_lt(turn, RADIANS(90));
        ck_assert(within_travel(&b, to.at.q));
        ck_assert_double_le(vec_distance(bench_axis(&b, to.at.q), goal.a), 3e-7);
        bench_free(&b);
    }
}
END_TEST

/* A motion into the end of the travel: with the planner's rewind it is made, without it refused. */
START_TEST(in_a_motion)
{
    seed = 540 + (uint64_t)_i;
    for (int with = 0; with < 2; with++) {
        struct bench b;
        begin(&b, _i, INTERPOLATE_ROTARY);
        struct rotary *first = &b.machine.chain.rotary[0], *second = &b.machine.chain.rotary[1];
        const double *at = b.planner.state.at.q;
        double beyond[2] = {at[0] + 0.6, at[1]};
        struct pose goal = {vec_add(b.planner.state.pose.p, vec(20, 0, 0)), bench_axis(&b, beyond)};
        first->max = at[0] + 0.3;
        first->min = first->max - 2.2 * PI;
        second->min = fmin(0, at[1]) - 0.2; /* no way by the other solution */
        second->max = second->min + fabs(at[1]) + 0.4;
        b.planner.rewind = with ? post_rewind_for : NULL;
        int result = post_rewind_line(&b.planner, goal);
        ck_assert_int_eq(result, with ? 0 : -1);
        ck_assert_int_eq(b.plan.unmet, !with);
        for (size_t k = 0; k < b.plan.move.n; k++)
            ck_assert(within_travel(&b, b.plan.move.item[k].q));
        if (with) {
            const struct nc_move *last = &b.plan.move.item[b.plan.move.n - 1];
            ck_assert_uint_eq(b.plan.total.turns, 1);
            ck_assert_double_le(vec_distance(last->p, goal.p), 1e-5);
            ck_assert_double_le(vec_distance(bench_axis(&b, last->q), goal.a), 3e-7);
        }
        bench_free(&b);
    }
}
END_TEST

/* Up by the machine's retract or, where the axis leads up, above the rapids of the path. */
START_TEST(how_far_up)
{
    struct bench b;
    seed = 560;
    for (int i = 0; i < 20; i++) {
        begin(&b, i % KINDS, INTERPOLATE_ROTARY);
        struct pose at = b.planner.state.pose, up = post_rewind_retracted(&b.planner);
        ck_assert_double_eq_tol(vec_distance(up.p, at.p), 50, 1e-9);
        b.planner.clearance = at.p.z + 100;
        up = post_rewind_retracted(&b.planner);
        ck_assert_double_eq_tol(up.p.z, at.p.z + 100, 1e-9);
        ck_assert_double_le(vec_length(vec_cross(vec_sub(up.p, at.p), at.a)), 1e-9);
        b.planner.clearance = at.p.z + 1;
        up = post_rewind_retracted(&b.planner);
        ck_assert_double_eq_tol(vec_distance(up.p, at.p), 50, 1e-9);
        bench_free(&b);
    }
}
END_TEST

/* Vectors leave the rotary axes to the control: there is nothing to turn to. */
START_TEST(not_with_vectors)
{
    struct bench b;
    seed = 570;
    begin(&b, KIND_TABLE_AC, INTERPOLATE_VECTOR);
    ck_assert_int_eq(post_rewind_for(&b.planner, b.planner.state.pose), -1);
    ck_assert_uint_eq(b.plan.move.n, 0);
    bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_rewind");
    TCase *tests = tcase_create("rewinds");

    tcase_add_loop_test(tests, to_angles, 0, KINDS);
    tcase_add_loop_test(tests, for_a_goal, 0, KINDS);
    tcase_add_loop_test(tests, in_a_motion, 0, KINDS);
    tcase_add_test(tests, how_far_up);
    tcase_add_test(tests, not_with_vectors);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
