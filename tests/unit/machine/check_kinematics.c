/*
 * kinematics: the published A/C and B/C formulas, inverse against forward on random poses of every
 * kind of machine, precision near the singular direction.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>

#include "chains.h"
#include "machine/machine.h"
#include "ncread/ncread.h"

/* a = (sin C sin A, -cos C sin A, cos A) and (sin B cos C, sin B sin C,
 * cos B), written out. */
START_TEST(published_axis)
{
    struct kinematic_chain ac = chain_of(KIND_TABLE_AC), bc = chain_of(KIND_TABLE_BC);
    seed = 1;
    for (int i = 0; i < 1000; i++) {
        double c = 6 * chance() - 3, t = 6 * chance() - 3;
        const double q[2] = {c, t};
        struct vec3 a = vec(sin(c) * sin(t), -cos(c) * sin(t), cos(t));
        struct vec3 b = vec(sin(t) * cos(c), sin(t) * sin(c), cos(t));
        ck_assert_double_lt(vec_distance(chain_axis(&ac, q), a), 1e-14);
        ck_assert_double_lt(vec_distance(chain_axis(&bc, q), b), 1e-14);
    }
}
END_TEST

/* At zero, at the end that is nearest to it, and 0 where there is no axis. */
START_TEST(zero_within_travel)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    double q[ROTARY_MAX] = {1, 1};

    chain.rotary[0].min = -1;
    chain.rotary[0].max = 2;
    chain.rotary[1].min = 0.3;
    chain.rotary[1].max = 0.9;
    chain_zero(&chain, q);
    ck_assert(q[0] == 0 && q[1] == 0.3);
    chain.rotary[1].min = -0.9;
    chain.rotary[1].max = -0.2;
    chain_zero(&chain, q);
    ck_assert(q[1] == -0.2);
    chain.n = 1;
    chain_zero(&chain, q);
    ck_assert(q[1] == 0);
}
END_TEST

static void same_remainder(double q)
{
    double got = angle_remainder(q), right = remainder(q, 2 * PI);
    ck_assert_msg(got == right && !signbit(got) == !signbit(right), "%a: %a, %a", q, got, right);
}

/* Beside whole and half turns, at zeros of both signs, far off, and anywhere. */
START_TEST(remainder_of_a_turn)
{
    for (int half = -9; half <= 9; half++) {
        same_remainder(half * PI);
        same_remainder(nextafter(half * PI, 100));
        same_remainder(nextafter(half * PI, -100));
    }
    same_remainder(-0.0);
    same_remainder(1e17);
    seed = 3;
    for (int i = 0; i < 100000; i++)
        same_remainder((i % 2 ? 12 : 1000) * (2 * chance() - 1));
}
END_TEST

START_TEST(inverse_is_inverse)
{
    struct kinematic_chain chain = chain_of(_i);
    double worst_axis = 0, worst_tip = 0;
    int reached = 0;
    seed = 2;
    for (int i = 0; i < 100000; i++) {
        struct vec3 axis = random_unit();
        struct vec3 tip = vec_scale(400 * chance(), random_unit());
        struct chain_solutions s = chain_angles(&chain, axis);
        reached += s.n > 0;
        for (int k = 0; k < s.n; k++) {
            struct vec3 linear = chain_linear(&chain, tip, s.q[k]);
            worst_axis = fmax(worst_axis, vec_distance(chain_axis(&chain, s.q[k]), axis));
            worst_tip = fmax(worst_tip, vec_distance(chain_tip(&chain, linear, s.q[k]), tip));
        }
    }
    ck_assert_double_le(worst_axis, 1e-9);
    ck_assert_double_le(worst_tip, 1e-9);
    /* two axes at right angles reach every direction, nutating by 45 degrees the upper half */
    if (_i < KIND_NUTATING_HEAD)
        ck_assert_int_eq(reached, 100000);
    else
        ck_assert_int_le(abs(reached - 50000), 1000);
}
END_TEST

/* The angles that went in come out again, as one of the two. */
START_TEST(angles_come_back)
{
    struct kinematic_chain chain = chain_of(_i);
    seed = 3;
    for (int i = 0; i < 20000; i++) {
        const double q[2] = {6 * chance() - 3, 6 * chance() - 3};
        struct chain_solutions s = chain_angles(&chain, chain_axis(&chain, q));
        double best = 9;
        for (int k = 0; k < s.n; k++)
            best = fmin(best, fmax(fabs(remainder(s.q[k][0] - q[0], 2 * PI)),
                                   fabs(remainder(s.q[k][1] - q[1], 2 * PI))));
        ck_assert_double_lt(best, 1e-9);
    }
}
END_TEST

/* At a tilt of 1e-7 the angle itself is still right to 1e-13; acos would give it to 1e-9. */
START_TEST(near_the_pole)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    const double q[2] = {0.7, 1e-7};
    struct chain_solutions s = chain_angles(&chain, chain_axis(&chain, q));
    double best = fmin(fabs(s.q[0][1] - 1e-7), fabs(s.q[1][1] - 1e-7));
    ck_assert(!s.free);
    ck_assert_double_lt(best, 1e-13);
    s = chain_angles(&chain, vec(0, 0, 1));
    ck_assert(s.free && s.n == 2);
}
END_TEST

/* A table turns the work: what the linear axes must do is what the turned work does. */
START_TEST(table_carries_the_work)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    chain.rotary[0].centre = chain.rotary[1].centre = vec(0, 0, 0);
    const double q[2] = {PI / 2, 0}; /* the tool by +90 about z: the table by -90 */
    struct vec3 linear = chain_linear(&chain, vec(10, 0, 5), q);
    ck_assert_double_lt(vec_distance(linear, vec(0, -10, 5)), 1e-12);
    const double a[2] = {0, PI / 2}; /* the tool points along -y of the work */
    ck_assert_double_lt(vec_distance(chain_axis(&chain, a), vec(0, -1, 0)), 1e-12);
    linear = chain_linear(&chain, vec(0, -10, 0), a);
    ck_assert_double_lt(vec_distance(linear, vec(0, 0, 10)), 1e-12);
}
END_TEST

/* A head with its pivot 100 above the tip leans to 90 degrees: the tip lies 100 aside. */
START_TEST(head_carries_the_tip)
{
    struct kinematic_chain chain = chain_of(KIND_HEAD_HEAD);
    chain.rotary[0].centre = chain.rotary[1].centre = vec(0, 0, 100);
    const double q[2] = {0, PI / 2};
    struct vec3 tip = chain_tip(&chain, vec(1, 2, 3), q);
    ck_assert_double_lt(vec_distance(tip, vec(1, 102, 103)), 1e-12);
}
END_TEST

START_TEST(fewer_axes)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    chain.n = 1;
    chain.rotary[0] = rotary_of(vec(1, 0, 0), vec(0, 0, 0), true);
    struct chain_solutions s = chain_angles(&chain, vec(0, -sin(0.3), cos(0.3)));
    ck_assert_int_eq(s.n, 1);
    ck_assert_double_eq_tol(s.q[0][0], 0.3, 1e-12);
    ck_assert_int_eq(chain_angles(&chain, vec(sin(0.3), 0, cos(0.3))).n, 0);
    chain.n = 0;
    ck_assert_int_eq(chain_angles(&chain, vec(0, 0, 1)).n, 1);
    ck_assert_int_eq(chain_angles(&chain, vec(0, sin(0.3), cos(0.3))).n, 0);
}
END_TEST

static const char *const shipped[] = {
    "table-ac",
    "table-bc",
    "head-ca",
    "head-cb",
    "head-table-bc",
    "nutating-head",
    "nutating-head-table",
    "nutating-table",
    "linuxcnc-xyzac",
    "linuxcnc-xyzbc",
    "table-a",
};
enum { SHIPPED = sizeof shipped / sizeof *shipped };

/* POSES poses of each, as many as the environment says. */
static int poses(int usual)
{
    const char *many = getenv("POSES");
    return many ? atoi(many) : usual;
}

/* The angle between two unit vectors that are close, degrees. */
static double apart(struct vec3 a, struct vec3 b)
{
    return DEGREES(vec_distance(a, b));
}

static void check_pose(const struct kinematic_chain *chain,
                       const struct verify_kinematics *verify_kinematics, struct vec3 tip,
                       struct vec3 axis)
{
    struct chain_solutions s = chain_angles(chain, axis);
    ck_assert_int_gt(s.n, 0);
    for (int k = 0; k < s.n; k++) {
        const double degrees[] = {DEGREES(s.q[k][0]), DEGREES(s.q[k][1])};
        struct vec3 linear = chain_linear(chain, tip, s.q[k]);
        ck_assert_double_le(apart(verify_kinematics_axis_at(verify_kinematics, degrees), axis),
                            1e-9);
        ck_assert_double_le(
            vec_distance(verify_kinematics_tip(verify_kinematics, linear, degrees), tip), 1e-9);
    }
}

/* Inverse, then forward by the reader's matrices, which share no code with it. */
START_TEST(every_machine)
{
    struct machine machine = machine_default();
    struct error error;
    char file[500];
    const char *folder = getenv("SRC");
    snprintf(file, sizeof file, "%s/machines/%s.txt", folder ? folder : ".", shipped[_i]);
    ck_assert_msg(machine_read(&machine, file, &error) == 0, "%s", error.text);
    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    struct verify_kinematics verify_kinematics = ncread_kinematics(&machine);
    seed = 40 + (uint64_t)_i;
    for (int i = 0; i < poses(30000); i++) {
        const double q[2] = {360 * chance() - 180, 360 * chance() - 180};
        check_pose(&machine.chain, &verify_kinematics, vec_scale(500 * chance(), random_unit()),
                   verify_kinematics_axis_at(&verify_kinematics, q));
    }
}
END_TEST

/* Two axes anywhere: what they reach, they reach to the last digits; what they do not reach, by the
 * highest and lowest that the second one brings the tool against the first, is said to be so. */
START_TEST(any_two_axes)
{
    int beyond = 0;
    seed = 60;
    for (int i = 0; i < 300; i++) {
        struct kinematic_chain chain = {.n = 2, .tool = random_unit()};
        struct verify_kinematics verify_kinematics = {.n = 2, .tool = chain.tool};
        int tables = (int)(3 * chance());
        double low = 1, high = -1;
        for (int k = 0; k < 2; k++) {
            struct vec3 centre = vec_scale(300 * chance(), random_unit());
            chain.rotary[k] = rotary_of(random_unit(), centre, k < tables);
            verify_kinematics.axis[k] = (struct verify_kinematics_axis){
                .table = k < tables, .axis = chain.rotary[k].axis, .centre = centre};
        }
        for (int k = 0; k < 3600; k++) {
            const double q[2] = {0, k / 10.0};
            double up =
                vec_dot(chain.rotary[0].axis, verify_kinematics_axis_at(&verify_kinematics, q));
            low = fmin(low, up);
            high = fmax(high, up);
        }
        for (int k = 0; k < 200; k++) {
            struct vec3 axis = random_unit(), tip = vec_scale(300 * chance(), random_unit());
            double up = vec_dot(chain.rotary[0].axis, axis);
            if (up > low + 1e-9 && up < high - 1e-9)
                check_pose(&chain, &verify_kinematics, tip, axis);
            if (up < low - 1e-5 || up > high + 1e-5) {
                ck_assert_int_eq(chain_angles(&chain, axis).n, 0);
                beyond++;
            }
        }
    }
    ck_assert_int_gt(beyond, 1000);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("kinematics");
    TCase *tests = tcase_create("chains");

    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, published_axis);
    tcase_add_test(tests, zero_within_travel);
    tcase_add_loop_test(tests, inverse_is_inverse, 0, KINDS);
    tcase_add_loop_test(tests, angles_come_back, 0, KINDS);
    tcase_add_test(tests, near_the_pole);
    tcase_add_test(tests, table_carries_the_work);
    tcase_add_test(tests, head_carries_the_tip);
    tcase_add_test(tests, fewer_axes);
    tcase_add_loop_test(tests, every_machine, 0, SHIPPED);
    tcase_add_test(tests, remainder_of_a_turn);
    tcase_add_test(tests, any_two_axes);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
