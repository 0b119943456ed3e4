/*
 * post_motion: straight motions of random length and turn on machines of every kind, in each way in
 * which a control interpolates.  What the control makes of the blocks is followed in small steps by
 * formulas of this file: it keeps the tolerance, and where a motion was divided it had to be.
 */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "planners.h"
#include "post/post_ik.h"
#include "post/post_block.h"
#include "post/post_motion.h"
#include "post/post_straight.h"

enum { STEPS = 200, MODES = 3 };

static const enum interpolation_mode mode_of[MODES] = {INTERPOLATE_VECTOR, INTERPOLATE_ROTARY,
                                                       INTERPOLATE_JOINT};

/* On the great circle from a to b. */
static struct vec3 slerp(struct vec3 a, struct vec3 b, double s)
{
    double angle = atan2(vec_length(vec_cross(a, b)), vec_dot(a, b));
    if (angle < 1e-9)
        return a;
    return vec_unit(vec_add(vec_scale(sin((1 - s) * angle), a), vec_scale(sin(s * angle), b)));
}

/* Where tip and axis are at s of a block between two blocks' ends. */
static struct pose by_control(const struct bench *b, const struct block_pose *from,
                              const struct block_pose *to, double s)
{
    enum interpolation_mode mode = b->planner.follow.mode;
    const double q[2] = {from->q[0] + s * (to->q[0] - from->q[0]),
                         from->q[1] + s * (to->q[1] - from->q[1])};
    struct vec3 p = vec_add(vec_scale(1 - s, from->p), vec_scale(s, to->p));
    if (mode == INTERPOLATE_JOINT)
        p = chain_tip(&b->machine.chain, p, q);
    if (mode == INTERPOLATE_VECTOR)
        return (struct pose){p, slerp(vec_unit(from->a), vec_unit(to->a), s)};
    return (struct pose){p, bench_axis(b, q)};
}

/* The motion that is meant: straight, its axis on the great circle. */
struct meant {
    struct pose from, to;
};

/* How far the block is off it, at the tip and the ball and at the axis, each place against that of
 * the motion beside it. */
static struct pose_deviation off(const struct bench *b, struct meant m,
                                 const struct block_pose *from, const struct block_pose *to)
{
    struct vec3 way = vec_sub(m.to.p, m.from.p);
    double length2 = vec_dot(way, way), ball = b->planner.follow.ball;
    struct pose_deviation most = {0, 0};
    for (int i = 0; i <= STEPS; i++) {
        struct pose is = by_control(b, from, to, (double)i / STEPS);
        double t = vec_dot(vec_sub(is.p, m.from.p), way) / length2;
        t = fmin(1, fmax(0, t));
        struct pose want = {vec_along(m.from.p, t, way), slerp(m.from.a, m.to.a, t)};
        most.point = fmax(most.point, vec_distance(is.p, want.p));
        most.point = fmax(
            most.point, vec_distance(vec_along(is.p, ball, is.a), vec_along(want.p, ball, want.a)));
        most.axis = fmax(most.axis, vec_distance(is.a, want.a));
    }
    return most;
}

static struct block_pose end_of(const struct bench *b, size_t move)
{
    return nc_plan_pose(&b->plan, &b->machine.chain, &b->plan.move.item[move]);
}

/* Up to 60 mm and, in one of three, up to 35 degrees; well off the singular direction. */
static struct pose any_goal(struct pose from, int i)
{
    double far = i % 3 ? 0.04 : 0.6;
    struct pose to = {vec_along(from.p, 1 + 60 * chance(), random_unit()), from.a};
    do
        to.a = vec_unit(vec_along(from.a, far * chance(), random_unit()));
    while (to.a.z > 0.95 || to.a.z < 0.4);
    return to;
}

static void begin(struct bench *b, int kind, enum interpolation_mode mode)
{
    struct vec3 axis;
    do
        axis = random_unit();
    while (axis.z > 0.9 || axis.z < 0.5);
    bench_begin(b, kind, mode, vec_scale(200 * chance(), random_unit()), (double[]){0, 0});
    struct chain_solutions found = chain_angles(&b->machine.chain, axis);
    ck_assert_int_gt(found.n, 0);
    bench_free(b);
    bench_begin(b, kind, mode, vec_scale(200 * chance(), random_unit()), found.q[0]);
    b->planner.follow.ball = 5;
}

/* Divided until it keeps the tolerance, and not further.  A short way with a wide turn (SEED=1)
 * also at the ball, which is elsewhere where the tip runs ahead of the axis. */
START_TEST(divided)
{
    int kind = _i / MODES, parts = 0, done = 0;
    seed = 400 + (uint64_t)_i;
    for (int i = 0; i < 60; i++) {
        struct bench b;
        begin(&b, kind, mode_of[_i % MODES]);
        struct meant m = {b.planner.state.pose, any_goal(b.planner.state.pose, i)};
        struct motion motion = motion_line(m.from, m.to);
        struct block_pose start = b.planner.state.at, at = start;
        if (post_motion_along(&b.planner, &motion, 0, 1) != 0) {
            bench_free(&b);
            continue; /* a turn that no block can make, without a way to rewind */
        }
        struct pose_deviation allowed = b.planner.allowed;
        for (size_t k = 0; k < b.plan.move.n; k++) {
            struct block_pose to = end_of(&b, k);
            struct pose_deviation d = off(&b, m, &at, &to);
            ck_assert_int_eq(b.plan.move.item[k].kind, NC_LINE);
            ck_assert_double_le(d.point, 1.02 * allowed.point);
            ck_assert_double_le(d.axis, 1.02 * allowed.axis);
            at = to;
        }
        struct pose end = by_control(&b, &at, &at, 0);
        ck_assert_double_le(vec_distance(end.p, m.to.p), 3e-5);
        ck_assert_double_le(vec_distance(end.a, m.to.a), 1e-6);
        if (b.plan.move.n > 1) { /* in one block it would be off */
            struct pose_deviation d = off(&b, m, &start, &at);
            ck_assert(d.point > 0.9 * allowed.point || d.axis > 0.9 * allowed.axis);
        }
        parts += (int)b.plan.move.n;
        done++;
        bench_free(&b);
    }
    /* few cannot be; of the twenty that turn far, more than half by 10 degrees and more, some have
     * to be divided, unless the control turns the axis as it is meant */
    ck_assert_int_ge(done, 45);
    ck_assert_int_ge(parts, done + (mode_of[_i % MODES] == INTERPOLATE_VECTOR ? 0 : 5));
}
END_TEST

/* One after another, as in a pass: what the bound lets through keeps the tolerance, and it lets
 * through nearly all that does by half. */
START_TEST(one_block)
{
    int kind = _i / MODES, taken = 0, good = 0, missed = 0;
    seed = 430 + (uint64_t)_i;
    struct bench b;
    begin(&b, kind, mode_of[_i % MODES]);
    for (int i = 0; i < 600; i++) {
        struct pose from = b.planner.state.pose;
        struct pose to = {vec_along(from.p, 0.2 + 4 * chance(), random_unit()), from.a};
        double far = i % 4 ? 0.004 : 0.08;
        do
            to.a = vec_unit(vec_along(from.a, far * chance(), random_unit()));
        while (to.a.z > 0.93 || to.a.z < 0.45);
        if (vec_length(to.p) > 250)
            to.p = vec_scale(0.98, from.p);
        struct block_pose at = b.planner.state.at;
        size_t moves = b.plan.move.n;
        bool one = post_straight_one(&b.planner, &to) == 0;
        if (one && b.plan.move.n > moves) {
            struct block_pose end = end_of(&b, moves);
            struct pose_deviation d = off(&b, (struct meant){from, to}, &at, &end);
            ck_assert_double_le(d.point, b.planner.allowed.point);
            ck_assert_double_le(d.axis, b.planner.allowed.axis);
            taken++;
        } else if (!one) {
            struct motion motion = motion_line(from, to);
            ck_assert_int_eq(post_motion_along(&b.planner, &motion, 0, 1), 0);
            struct block_pose end = end_of(&b, b.plan.move.n - 1);
            struct pose_deviation d = off(&b, (struct meant){from, to}, &at, &end);
            bool half =
                d.point < b.planner.allowed.point / 2 && d.axis < b.planner.allowed.axis / 2;
            missed += half;
        }
        good++;
    }
    ck_assert_int_gt(taken, 200);
    ck_assert_int_lt(missed, good / 50);
    bench_free(&b);
}
END_TEST

/* The tip stands while the axes turn: without tool-centre-point control in small steps. */
START_TEST(turned_in_place)
{
    seed = 470 + (uint64_t)_i;
    for (int mode = 0; mode < MODES; mode++) {
        struct bench b;
        begin(&b, _i, mode_of[mode]);
        const double *now = b.planner.state.at.q, q[2] = {now[0] + 2, now[1] - 0.3};
        struct vec3 tip = b.planner.state.pose.p;
        post_block_turn(&b.planner, q);
        size_t n = b.plan.move.n;
        ck_assert_uint_eq(n, mode_of[mode] == INTERPOLATE_JOINT ? 58 : 1); /* 2 radians by 2 deg */
        for (size_t k = 0; k < n; k++) {
            const struct nc_move *move = &b.plan.move.item[k];
            ck_assert_int_eq(move->kind, NC_RAPID);
            ck_assert_double_le(vec_distance(bench_tip(&b, move), tip), 3e-5);
        }
        for (int i = 0; i < 2; i++)
            ck_assert_double_eq_tol(b.plan.move.item[n - 1].q[i], q[i], RADIANS(6e-6));
        bench_free(&b);
    }
}
END_TEST

/* A quarter of a circle in XY that a control knows stays one block; one that knows none gets
 * chords, and the circle is never further off than the tolerance. */
START_TEST(arc_or_chords)
{
    struct bench b;
    double r = 20;
    for (int known = 0; known < 2; known++) {
        bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(r, 0, 0), (double[]){0, 0});
        b.plan.ability.arcs = known ? NC_ARCS_CENTRE : NC_ARCS_NONE;
        b.plan.ability.radius_error = 0.005;
        struct pose from = b.planner.state.pose, to = {vec(0, r, 0), from.a};
        struct motion motion = motion_arc(from, to, vec(0, 0, 0), vec(0, 0, 1));
        ck_assert_int_eq(post_motion_along(&b.planner, &motion, 0, 1), 0);
        ck_assert_uint_eq(b.plan.total.arcs, (size_t)known);
        ck_assert_uint_eq(b.plan.total.chorded, (size_t)!known);
        struct vec3 at = from.p;
        for (size_t k = 0; k < b.plan.move.n && !known; k++) {
            struct vec3 next = b.plan.move.item[k].p;
            double sag = r - vec_length(vec_mix(at, next, 0.5));
            ck_assert_double_le(sag, b.planner.allowed.point);
            at = next;
        }
        size_t least = 1; /* sag = r (1 - cos(half the angle)) */
        while (r * (1 - cos(PI / 4 / (double)least)) > b.planner.allowed.point)
            least++;
        ck_assert_uint_ge(b.plan.move.n, known ? 1 : least);
        ck_assert_uint_le(b.plan.move.n, known ? 1 : least + 1);
        ck_assert_double_le(vec_distance(b.plan.move.item[b.plan.move.n - 1].p, to.p), 1e-5);
        bench_free(&b);
    }
}
END_TEST

/* Arcs of any radius and angle as chords: equal ones, and one fewer would be too far off. */
START_TEST(fewest_chords)
{
    seed = 700;
    for (int i = 0; i < 200; i++) {
        struct bench b;
        double r = exp(log(0.03) + chance() * log(3000)), angle = 0.3 + 2.7 * chance();
        bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(r, 0, 0), (double[]){0, 0});
        b.plan.ability.arcs = NC_ARCS_NONE;
        struct pose from = b.planner.state.pose,
                    to = {vec(r * cos(angle), r * sin(angle), 0), from.a};
        struct motion motion = motion_arc(from, to, vec(0, 0, 0), vec(0, 0, 1));
        ck_assert_int_eq(post_motion_along(&b.planner, &motion, 0, 1), 0);
        size_t least = 1;
        while (r * (1 - cos(angle / 2 / (double)least)) > b.planner.allowed.point)
            least++;
        ck_assert_uint_ge(b.plan.move.n, least);
        ck_assert_uint_le(b.plan.move.n, least + 1 + least / 8);
        struct vec3 at = from.p;
        for (size_t k = 0; k < b.plan.move.n; k++) {
            struct vec3 next = b.plan.move.item[k].p;
            double chord = 2 * r * sin(angle / 2 / (double)b.plan.move.n);
            ck_assert_double_eq_tol(vec_distance(at, next), chord, 3e-5);
            at = next;
        }
        bench_free(&b);
    }
}
END_TEST

/* A tool so near to the singular direction that it is said as that turns no axis, whatever its
 * bearing does, and the motion stays one block. */
START_TEST(said_as_pole)
{
    struct bench b;
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_VECTOR, vec(10, 0, 5), (double[]){0.3, 0});
    b.planner.state.feed = 3000;
    b.plan.ability.feed_max = 1e9;
    b.planner.near_pole = post_ik_near_pole(&b.planner);
    double near = 0.5 * b.planner.near_pole;
    ck_assert_double_gt(near, 0);
    struct pose from = {vec(10, 0, 5), vec_unit(vec(near, 0, 1))},
                to = {vec(11, 0, 5), vec_unit(vec(0, near, 1))};
    struct motion lead = motion_line(b.planner.state.pose, from), motion = motion_line(from, to);
    ck_assert_int_eq(post_motion_along(&b.planner, &lead, 0, 1), 0);
    size_t before = b.plan.move.n;
    ck_assert_int_eq(post_motion_along(&b.planner, &motion, 0, 1), 0);
    ck_assert_uint_eq(b.plan.move.n, before + 1);
    bench_free(&b);
}
END_TEST

/* Past the singular direction beside it, vectors turn an axis far in a short part of the way: that
 * part is slow by itself.  At the F of each block no axis is too fast over any 0.02 mm or half of a
 * block, by small steps. */
START_TEST(slow_beside_pole)
{
    struct bench b;
    const double q[2] = {0.3, RADIANS(6)};
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_VECTOR, vec(10, 0, 5), q);
    struct pose from = b.planner.state.pose;
    struct vec3 aside = vec_unit(vec(-from.a.y, from.a.x, 0));
    struct pose to = {vec(14, 1, 5),
                      vec_unit(vec_along(vec(-from.a.x, -from.a.y, from.a.z), 0.006, aside))};
    struct motion motion = motion_line(from, to);
    double feed = 3000, minutes = 0, slowest = HUGE_VAL;
    b.planner.state.feed = feed;
    b.plan.ability.feed_max = 1e9;
    b.planner.allowed.axis = RADIANS(0.001);
    ck_assert_int_eq(post_motion_along(&b.planner, &motion, 0, 1), 0);
    struct block_pose at = {.p = from.p, .a = from.a, .q = {q[0], q[1]}};
    double turned = PI / 2 - atan2(from.a.y, from.a.x);
    double rapid = b.machine.rapid[b.machine.letter[0]];
    for (size_t k = 0; k < b.plan.move.n; k++) {
        struct block_pose end = end_of(&b, k);
        double length = vec_distance(at.p, end.p), f = b.plan.move.item[k].feed;
        int looks = (int)fmax(2, ceil(length / 0.02));
        ck_assert_double_ge(length, 0.0199);
        for (int i = 1; i <= looks; i++) {
            double last = turned;
            for (int j = 1; j <= 50; j++) { /* the bearing of the tool, in small steps */
                struct vec3 a = vec_slerp(at.a, end.a, (i - 1 + j / 50.0) / looks);
                double now = PI / 2 - atan2(a.y, a.x);
                turned += remainder(now - turned, PI); /* of either solution */
            }
            double least = DEGREES(fabs(turned - last)) / rapid;
            ck_assert_double_le(least, 1.02 * length / looks / f);
        }
        minutes += length / f;
        slowest = fmin(slowest, f);
        at = end;
    }
    ck_assert_int_gt((int)b.plan.move.n, 2);
    ck_assert_double_le(minutes, 0.3 * vec_distance(from.p, to.p) / slowest);
    bench_free(&b);
}
END_TEST

/* Between two directions that lean far, one on either side, the shortest way of a vector leans
 * further than both: rapids go by way of a third, and stay within the travel that leans. */
START_TEST(rapids_within_travel)
{
    const double most = RADIANS(120);
    int by_way = 0;
    seed = 900 + (uint64_t)_i;
    for (int i = 0; i < 200; i++) {
        struct bench b;
        const double q[2] = {2 * PI * chance() - PI, RADIANS(100 + 19.9 * chance())};
        const double end[2] = {2 * PI * chance() - PI, RADIANS(100 + 19.9 * chance())};
        bench_begin(&b, _i, INTERPOLATE_VECTOR, vec(30, 10, 90), q);
        b.machine.chain.rotary[1].min = -most;
        b.machine.chain.rotary[1].max = most;
        b.planner.near = ik_near_table(&b.machine.chain);
        struct pose to = {vec(-20, 40, 90), bench_axis(&b, end)};
        struct vec3 pole = bench_axis(&b, (double[]){0, 0});
        ck_assert_int_eq(post_motion_rapid(&b.planner, to), 0);
        struct block_pose at = {.p = vec(30, 10, 90), .a = bench_axis(&b, q)};
        for (size_t k = 0; k < b.plan.move.n; k++) {
            struct block_pose next = end_of(&b, k);
            for (int j = 0; j <= STEPS; j++) {
                struct pose is = by_control(&b, &at, &next, (double)j / STEPS);
                ck_assert_double_le(acos(vec_dot(is.a, pole)), most + 1e-6);
                ck_assert_double_eq_tol(is.p.z, 90, 1e-4);
            }
            at = next;
        }
        ck_assert_double_le(vec_distance(at.p, to.p), 3e-5);
        ck_assert_double_le(vec_distance(at.a, to.a), 1e-6);
        by_way += b.plan.move.n > 1;
        bench_free(&b);
    }
    /* at 110 degrees each, the great circle leans to 120 where they are 102 apart: tan 20 / tan 30
     * is the cosine of half of it; 43 % of random pairs are further, 200 of them within 5 sigma */
    ck_assert_int_gt(by_way, 50);
    ck_assert_int_lt(by_way, 122);
}
END_TEST

/* Half a last digit goes up or down as what comes after it is: a place that is named again, as the
 * end of a curve is, makes no block for that; one a digit of the path aside does. */
START_TEST(named_again)
{
    int kind = _i / MODES, otherwise = 0, aside = 0;
    seed = 460 + (uint64_t)_i;
    struct bench b;
    begin(&b, kind, mode_of[_i % MODES]);
    const int digits = b.plan.ability.digits.linear;
    const double digit = pow(10, -digits);
    for (int i = 0; i < 200; i++) {
        struct vec3 c = vec_scale(100 * chance(), random_unit());
        struct pose to = {vec((floor(c.x / digit) + 0.5) * digit,
                              (floor(c.y / digit) + 0.5) * digit,
                              (floor(c.z / digit) + 0.5) * digit),
                          b.planner.state.pose.a};
        struct motion there = motion_line(b.planner.state.pose, to);
        ck_assert_int_eq(post_motion_along(&b.planner, &there, 0, 1), 0);
        size_t moves = b.plan.move.n;
        for (double by = 1e-12; by > -2e-12; by -= 2e-12) {
            struct pose again = {vec_add(to.p, vec(by, by, by)), to.a};
            ck_assert_int_eq(post_straight_one(&b.planner, &again), 0);
            ck_assert_uint_eq(b.plan.move.n, moves);
            otherwise += vec_distance(vec_round(again.p, digits), b.planner.state.at.p) > digit / 2;
        }
        struct pose other = {vec_add(to.p, vec(1e-6, -1e-6, 1e-6)), to.a};
        ck_assert_int_eq(post_straight_one(&b.planner, &other), 0);
        aside += b.plan.move.n > moves;
    }
    if (mode_of[_i % MODES] != INTERPOLATE_JOINT) { /* there the axes' places are other digits */
        ck_assert_int_gt(otherwise, 100);
        ck_assert_int_gt(aside, 100);
    }
    bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_motion");
    TCase *tests = tcase_create("motions");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, slow_beside_pole);
    tcase_add_loop_test(tests, divided, 0, KINDS * MODES);
    tcase_add_loop_test(tests, one_block, 0, KINDS * MODES);
    tcase_add_loop_test(tests, named_again, 0, KINDS * MODES);
    tcase_add_loop_test(tests, turned_in_place, 0, KINDS);
    tcase_add_test(tests, arc_or_chords);
    tcase_add_test(tests, fewest_chords);
    tcase_add_test(tests, said_as_pole);
    tcase_add_loop_test(tests, rapids_within_travel, 0, KIND_NUTATING_HEAD);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
