/*
 * interpolation: deviations that can be worked out by hand, against the measured ones; bounds and
 * measures of random blocks against a look at a thousand places.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "machine/interpolation.h"
#include "seed.h"

/* C carried by A, both centres at the origin. */
static struct kinematic_chain table_ac(void)
{
    return (struct kinematic_chain){
        .n = 2,
        .master = 1,
        .tool = {0, 0, 1},
        .rotary = {{{0, 0, 1}, {0, 0, 0}, true, -9, 9}, {{1, 0, 0}, {0, 0, 0}, true, -9, 9}}};
}

static struct block_pose station(const struct kinematic_chain *chain, struct vec3 p, double c,
                                 double a)
{
    const double q[2] = {c, a};
    return (struct block_pose){.p = p, .a = chain_axis(chain, q), .q = {c, a}};
}

/* Great circle between vectors: the motion of the path itself. */
START_TEST(vectors_are_exact)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_VECTOR, &chain, 8};
    struct block_pose from = station(&chain, vec(0, 0, 0), 0, 0.5);
    struct block_pose to = station(&chain, vec(10, 0, 0), 1, 0.7);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    struct pose_deviation d = interpolation_block(&f, &from, &to, &m, 0, 1);
    ck_assert_double_lt(d.point, 1e-12);
    ck_assert_double_lt(d.axis, 1e-12);
}
END_TEST

/*
 * A at 0.5, C from -0.3 to 0.3: the rotary axes keep the tilt of 0.5; in the middle the great
 * circle stands at atan(tan 0.5 cos 0.3).
 */
START_TEST(rotary_words_leave_the_great_circle)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_ROTARY, &chain, 8};
    struct block_pose from = station(&chain, vec(0, 0, 0), -0.3, 0.5);
    struct block_pose to = station(&chain, vec(10, 0, 0), 0.3, 0.5);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    double off = 0.5 - atan(tan(0.5) * cos(0.3));
    struct pose_deviation d = interpolation_block(&f, &from, &to, &m, 0, 1);
    ck_assert_double_eq_tol(d.axis, off, 1e-9);
    ck_assert_double_eq_tol(d.point, 8 * 2 * sin(off / 2), 1e-9);
}
END_TEST

/*
 * Without TCP, C turning by 0.2 at a radius of 50 while the linear axes go straight: the point is
 * off by the sagitta 50 (1 - cos 0.1), the work's turn being that of the chord.
 */
START_TEST(joints_leave_the_straight_line)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_JOINT, &chain, 0};
    struct vec3 p = vec(50, 0, 0);
    const double q0[2] = {-0.1, 0}, q1[2] = {0.1, 0};
    struct block_pose from = {.p = chain_linear(&chain, p, q0), .a = {0, 0, 1}, .q = {-0.1, 0}};
    struct block_pose to = {.p = chain_linear(&chain, p, q1), .a = {0, 0, 1}, .q = {0.1, 0}};
    struct motion m = motion_line((struct pose){p, {0, 0, 1}}, (struct pose){p, {0, 0, 1}});
    struct pose_deviation d = interpolation_block(&f, &from, &to, &m, 0, 1);
    ck_assert_double_eq_tol(d.point, 50 * (1 - cos(0.1)), 1e-6);
}
END_TEST

START_TEST(chord_of_an_arc)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_VECTOR, &chain, 0};
    struct block_pose from = station(&chain, vec(10, 0, 0), 0, 0);
    struct block_pose to = station(&chain, vec(0, 10, 0), 0, 0);
    struct motion m = motion_arc((struct pose){from.p, from.a}, (struct pose){to.p, to.a},
                                 vec(0, 0, 0), vec(0, 0, 1));
    struct pose_deviation d = interpolation_block(&f, &from, &to, &m, 0, 1);
    ck_assert_double_eq_tol(d.point, 10 - sqrt(50), 1e-9);
    double point;
    d = interpolation_curve(&f, &from, &to, &m, &m, 0, 1, &point);
    ck_assert_double_lt(d.point, 1e-12);
    ck_assert_double_lt(point, 1e-12);
}
END_TEST

/* A curve as printed that leaves what is meant more and more: most of all at its end. */
START_TEST(the_end_of_a_curve_counts)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_ROTARY, &chain, 0};
    struct block_pose from = station(&chain, vec(0, 0, 0), 0, 0);
    struct block_pose to = station(&chain, vec(10, 0.1, 0), 0, 0);
    struct motion meant =
        motion_line((struct pose){from.p, from.a}, (struct pose){vec(10, 0, 0), to.a});
    struct motion printed = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    double point;
    struct pose_deviation d = interpolation_curve(&f, &from, &to, &printed, &meant, 0, 1, &point);
    ck_assert_double_eq_tol(d.point, 0.1, 1e-9);
    ck_assert_double_eq_tol(point, 0.1, 1e-12);
}
END_TEST

/* The tool turns over the pole on one spot: its two ends alone would look right. */
START_TEST(a_turn_on_the_spot_is_seen)
{
    struct kinematic_chain chain = table_ac();
    struct interpolation f = {INTERPOLATE_ROTARY, &chain, 8};
    struct block_pose from = station(&chain, vec(0, 0, 0), PI, 0.5);
    struct block_pose to = station(&chain, vec(1e-5, 0, 0), 0, -0.5);
    struct motion m = motion_line((struct pose){from.p, from.a}, (struct pose){to.p, to.a});
    struct pose_deviation d = interpolation_block(&f, &from, &to, &m, 0, 1);
    ck_assert_double_gt(d.axis, 0.3);
}
END_TEST

static uint64_t seed;

/* -1 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 4503599627370496.0 - 1;
}

static struct vec3 random_vec(double size)
{
    double x = chance(), y = chance();
    return vec(size * x, size * y, size * chance());
}

static struct kinematic_chain random_chain(void)
{
    struct kinematic_chain chain = {.n = 2, .master = 1, .tool = vec_unit(random_vec(1))};
    int tables = (int)(1.5 + 1.4999 * chance());
    for (int i = 0; i < 2; i++)
        chain.rotary[i] = (struct rotary){.axis = vec_unit(random_vec(1)),
                                          .centre = random_vec(200),
                                          .table = i < tables,
                                          .min = -99,
                                          .max = 99};
    return chain;
}

static struct machine_pose stance_at(const struct kinematic_chain *chain, struct vec3 p,
                                     const double q[])
{
    struct machine_pose s = {{p, chain_axis(chain, q), {q[0], q[1]}}, chain_turned(chain, q)};
    return s;
}

/* Where the block is at s, by the chain itself, less where the motion is: {point or ball, axis}. */
static struct pose_deviation off_at(const struct interpolation *f, const struct machine_pose *a,
                                    const struct machine_pose *b, const struct motion *m, double s)
{
    const double q[2] = {a->at.q[0] + s * (b->at.q[0] - a->at.q[0]),
                         a->at.q[1] + s * (b->at.q[1] - a->at.q[1])};
    struct pose at = {vec_mix(a->at.p, b->at.p, s), chain_axis(f->chain, q)};
    struct pose wanted = motion_at(m, s);
    if (f->mode == INTERPOLATE_JOINT)
        at.p = chain_tip(f->chain, at.p, q);
    struct vec3 e = vec_sub(at.p, wanted.p);
    struct vec3 ball = vec_along(e, f->ball, vec_sub(at.a, wanted.a));
    return (struct pose_deviation){fmax(vec_length(e), vec_length(ball)),
                                   vec_angle(at.a, wanted.a)};
}

struct block {
    struct machine_pose from, to;
    struct motion motion;
};

/* A block as ncpost would make it: both ends right but for the printed digits. */
static struct block random_block(const struct interpolation *f, double turn)
{
    double q0[2] = {3 * chance(), 3 * chance()};
    double q1[2] = {q0[0] + turn * chance(), q0[1] + turn * chance()};
    struct vec3 p0 = random_vec(100), p1 = vec_add(p0, vec(4 + 3 * chance(), chance(), 0));
    struct pose start = {p0, chain_axis(f->chain, q0)}, goal = {p1, chain_axis(f->chain, q1)};
    for (int i = 0; i < 2; i++) {
        q0[i] += 1e-5 * chance();
        q1[i] += 1e-5 * chance();
    }
    if (f->mode == INTERPOLATE_JOINT) {
        p0 = chain_linear(f->chain, p0, q0);
        p1 = chain_linear(f->chain, p1, q1);
    }
    p0 = vec_add(p0, random_vec(5e-4));
    p1 = vec_add(p1, random_vec(5e-4));
    return (struct block){stance_at(f->chain, p0, q0), stance_at(f->chain, p1, q1),
                          motion_line(start, goal)};
}

static struct pose_deviation dense(const struct interpolation *f, const struct block *b)
{
    struct pose_deviation worst = {0, 0};
    for (int i = 0; i <= 1000; i++)
        worst = pose_deviation_worst(worst, off_at(f, &b->from, &b->to, &b->motion, i / 1000.0));
    return worst;
}

/* Never below what 1001 places show; and, unless it is the rough one of small turns, no more than
 * some percent above. */
START_TEST(bounds_hold)
{
    int finite = 0;
    seed = 11;
    for (int i = 0; i < 3000; i++) {
        struct kinematic_chain chain = random_chain();
        struct interpolation f = {_i ? INTERPOLATE_JOINT : INTERPOLATE_ROTARY, &chain,
                                  8 * chance()};
        struct block b = random_block(&f, pow(10, -1.5 + 1.5 * chance()));
        struct pose_deviation close = {0, 1}, rough = {1, 1};
        struct pose_deviation worst = dense(&f, &b);
        struct pose_deviation most =
            interpolation_line(&f, &b.from, &b.to, b.motion.from, b.motion.to, close);
        ck_assert_double_ge(most.point, worst.point - 1e-12);
        ck_assert_double_ge(most.axis, worst.axis - 1e-12);
        if (most.axis < HUGE_VAL) {
            finite++;
            if (!_i)
                ck_assert_double_le(most.axis, 1.5 * worst.axis + 0.06);
        }
        double turn = fabs(b.to.at.q[0] - b.from.at.q[0]) + fabs(b.to.at.q[1] - b.from.at.q[1]);
        if (turn < 0.01) {
            ck_assert_double_le(most.axis, 1.1 * worst.axis + (_i ? 1e-4 : 4e-5));
            ck_assert_double_le(most.point, 1.1 * worst.point + 2e-3);
        }
        most = interpolation_line(&f, &b.from, &b.to, b.motion.from, b.motion.to, rough);
        ck_assert_double_ge(most.point, worst.point - 1e-12);
        ck_assert_double_ge(most.axis, worst.axis - 1e-12);
    }
    ck_assert_int_gt(finite, 2000);
}
END_TEST

/* Between its ends a block never strays by more than the bend, at the same time of both; and where
 * axes turn alone the bound is not far off. */
START_TEST(bends_hold)
{
    double nearest = 0;
    seed = 13;
    for (int i = 0; i < 3000; i++) {
        struct kinematic_chain chain = random_chain();
        struct interpolation f = {_i ? INTERPOLATE_JOINT : INTERPOLATE_ROTARY, &chain,
                                  8 * chance()};
        struct block b = random_block(&f, pow(10, -1.5 + 1.5 * chance()));
        struct pose_deviation bend = interpolation_bend(&f, &b.from.at, &b.to.at);
        double slack = 1e-4 * bend.axis + 1e-9, ends[3] = {0}, most[3] = {0};
        for (int k = 0; k <= 100; k++) {
            struct pose at = interpolation_pose(&f, &b.from.at, &b.to.at, k / 100.0);
            struct pose wanted = motion_at(&b.motion, k / 100.0);
            struct vec3 tip = vec_sub(at.p, wanted.p), axis = vec_sub(at.a, wanted.a);
            double off[3] = {vec_length(tip), vec_length(vec_along(tip, f.ball, axis)),
                             vec_length(axis)};
            for (int j = 0; j < 3; j++) {
                most[j] = fmax(most[j], off[j]);
                ends[j] = k % 100 ? ends[j] : fmax(ends[j], off[j]);
            }
        }
        ck_assert_double_le(most[0], ends[0] + bend.point + slack);
        ck_assert_double_le(most[1], ends[1] + bend.point + slack * fabs(f.ball));
        ck_assert_double_le(most[2], ends[2] + bend.axis + slack);
        nearest = fmax(nearest, (most[2] - ends[2]) / bend.axis);
    }
    ck_assert_double_gt(nearest, 0.25);
}
END_TEST

/* The measure finds the peak of blocks that turn far: near the pole it is narrow.  The ball does
 * not count, nor, with it, the time: the tip goes straight. */
START_TEST(peaks_are_found)
{
    seed = 12;
    for (int i = 0; i < 2000; i++) {
        struct kinematic_chain chain = random_chain();
        struct interpolation f = {INTERPOLATE_ROTARY, &chain, 0};
        struct block b = random_block(&f, 9);
        struct pose_deviation worst = dense(&f, &b);
        struct pose_deviation d = interpolation_block(&f, &b.from.at, &b.to.at, &b.motion, 0, 1);
        ck_assert_double_ge(d.axis, 0.97 * worst.axis - 2e-3);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("interpolation");
    TCase *tests = tcase_create("blocks");

    tcase_add_test(tests, vectors_are_exact);
    tcase_add_test(tests, rotary_words_leave_the_great_circle);
    tcase_add_test(tests, joints_leave_the_straight_line);
    tcase_add_test(tests, chord_of_an_arc);
    tcase_add_test(tests, the_end_of_a_curve_counts);
    tcase_add_test(tests, a_turn_on_the_spot_is_seen);
    tcase_add_loop_test(tests, bounds_hold, 0, 2);
    tcase_add_loop_test(tests, bends_hold, 0, 2);
    tcase_add_test(tests, peaks_are_found);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
