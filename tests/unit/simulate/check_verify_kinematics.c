/* check_verify_kinematics - the matrices of the reader against the chain of the writer, and each
 * inverse. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>

#include "machine/kinematics.h"
#include "machine/machine.h"
#include "ncread/ncread.h"
#include "simulate/verify_kinematics.h"
#include "seed.h"

static const char *const machines[] = {
    "machines/table-ac.txt",       "machines/table-bc.txt",
    "machines/head-ca.txt",        "machines/head-cb.txt",
    "machines/head-table-bc.txt",  "machines/nutating-head.txt",
    "machines/nutating-table.txt", "machines/linuxcnc-xyzac.txt",
    "machines/table-a.txt",        "machines/nutating-head-table.txt"};

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + seed_step_32();
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

static struct machine machine_of(const char *name)
{
    struct machine m = machine_default();
    struct error error;
    char path[300];
    const char *src = getenv("SRC");
    snprintf(path, sizeof path, "%s/%s", src ? src : ".", name);
    ck_assert_msg(machine_read(&m, path, &error) == 0, "%s", error.text);
    /* centres off the zero point: they count */
    ck_assert(machine_set(&m, "centre.A=3 -40 12", &error) == 0);
    ck_assert(machine_set(&m, "centre.B=-7 5 90", &error) == 0);
    ck_assert(machine_set(&m, "centre.C=11 2 -30", &error) == 0);
    ck_assert_msg(machine_finish(&m, &error) == 0, "%s", error.text);
    return m;
}

START_TEST(matrices_agree_with_the_chain)
{
    unsigned state = 7;
    struct machine m = machine_of(machines[_i]);
    struct verify_kinematics kinematics = ncread_kinematics(&m);
    ck_assert_int_eq(kinematics.n, m.chain.n);
    for (int trial = 0; trial < 200; trial++) {
        double q[2] = {random_in(&state, -180, 180), random_in(&state, -90, 90)};
        double radians[2] = {RADIANS(q[0]), RADIANS(q[1])};
        struct vec3 p = vec(random_in(&state, -90, 90), random_in(&state, -90, 90), 10);
        struct vec3 a = chain_axis(&m.chain, radians), tip = chain_tip(&m.chain, p, radians);
        ck_assert_double_lt(vec_distance(a, verify_kinematics_axis_at(&kinematics, q)), 1e-12);
        ck_assert_double_lt(vec_distance(tip, verify_kinematics_tip(&kinematics, p, q)), 1e-10);
        ck_assert_double_lt(
            vec_distance(p, verify_kinematics_linear(&kinematics,
                                                     verify_kinematics_tip(&kinematics, p, q), q)),
            1e-10);
    }
}
END_TEST

START_TEST(angles_are_found_again)
{
    unsigned state = 11;
    struct machine m = machine_of(machines[_i]);
    struct verify_kinematics kinematics = ncread_kinematics(&m);
    for (int i = 0; i < kinematics.n; i++) {
        kinematics.axis[i].min = -500;
        kinematics.axis[i].max = 500;
    }
    for (int trial = 0; trial < 200; trial++) {
        double q[2] = {random_in(&state, -400, 400), random_in(&state, 5, 80)}, found[2] = {0};
        if (kinematics.n < 2)
            q[1] = 0;
        double near[2] = {q[0] + 1, q[1] - 1};
        ck_assert(verify_kinematics_angles(&kinematics, verify_kinematics_axis_at(&kinematics, q),
                                           near, 1e-5, found));
        for (int i = 0; i < kinematics.n; i++)
            ck_assert_double_lt(fabs(found[i] - q[i]), 1e-5);
    }
}
END_TEST

START_TEST(an_axis_out_of_reach_is_said)
{
    struct machine m = machine_of("machines/table-a.txt");
    struct verify_kinematics kinematics = ncread_kinematics(&m);
    double near[2] = {0, 0}, q[2] = {0, 0};
    ck_assert(!verify_kinematics_angles(&kinematics, vec_unit(vec(1, 0, 1)), near, 0.01, q));
}
END_TEST

int main(void)
{
    const int n = sizeof machines / sizeof *machines;
    Suite *suite = suite_create("verify_kinematics");
    TCase *tcase = tcase_create("verify_kinematics");
    tcase_add_loop_test(tcase, matrices_agree_with_the_chain, 0, n);
    tcase_add_loop_test(tcase, angles_are_found_again, 0, n);
    tcase_add_test(tcase, an_axis_out_of_reach_is_said);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
