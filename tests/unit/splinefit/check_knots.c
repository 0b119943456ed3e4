/*
 * knots, against Piegl and Tiller's worked example 9.1 (interpolation) and eqs 9.68, 9.69 by hand;
 * and the reason for averages: each span holds data, whatever the parameters are.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "splinefit/knots.h"
#include "math/vec.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

START_TEST(uniform)
{
    const double u[] = {0, 0.1, 0.2, 0.3, 0.4, 1};
    const double expected[] = {0, 0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1, 1};
    double knot[10];

    knots_fill(KNOTS_UNIFORM, u, 6, 3, 6, knot);
    for (int i = 0; i < 10; i++)
        ck_assert_double_eq_tol(knot[i], expected[i], 1e-15);
}
END_TEST

/* u of example 9.1 with as many poles as points: one inner knot, 28/51. */
START_TEST(average_of_as_many_poles_as_points)
{
    const double u[] = {0, 5 / 17.0, 9 / 17.0, 14 / 17.0, 1};
    double knot[9];

    knots_fill(KNOTS_AVERAGE, u, 5, 3, 5, knot);
    ck_assert_double_eq_tol(knot[4], 28 / 51.0, 1e-15);
    ck_assert(knot[3] == 0 && knot[5] == 1);
}
END_TEST

/*
 * m + 1 = 11 points u_k = (k/10)^2, p = 3, n + 1 = 6: d = 11/3; j = 1: i = 3, alpha = 2/3,
 * knot = 1/3 u_2 + 2/3 u_3; j = 2: i = 7, alpha = 1/3, knot = 2/3 u_6 + 1/3 u_7.
 */
START_TEST(average_by_hand)
{
    double u[11], knot[10];

    for (int k = 0; k <= 10; k++)
        u[k] = k * k / 100.0;
    knots_fill(KNOTS_AVERAGE, u, 11, 3, 6, knot);
    ck_assert_double_eq_tol(knot[4], (0.04 + 2 * 0.09) / 3, 1e-15);
    ck_assert_double_eq_tol(knot[5], (2 * 0.36 + 0.49) / 3, 1e-15);
}
END_TEST

START_TEST(every_span_holds_data)
{
    double u[200], knot[210];

    seed = 5;
    for (int turn = 0; turn < 300; turn++) {
        int degree = 1 + turn % 5;
        size_t n = 20 + (size_t)(180 * chance());
        size_t poles = (size_t)degree + 1 + (size_t)((double)(n - (size_t)degree - 1) * chance());

        u[0] = 0;
        for (size_t k = 1; k < n; k++)
            u[k] = u[k - 1] + (chance() < 0.5 ? 0.001 : 1) * (0.01 + chance());
        for (size_t k = 0; k < n; k++)
            u[k] /= u[n - 1];
        knots_fill(KNOTS_AVERAGE, u, n, degree, poles, knot);
        size_t k = 0;
        for (size_t i = (size_t)degree; i < poles; i++) {
            ck_assert_double_lt(knot[i], knot[i + 1]);
            while (k < n && u[k] < knot[i])
                k++;
            ck_assert(k < n && u[k] <= knot[i + 1]);
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("knots");
    TCase *tests = tcase_create("knots");

    tcase_add_test(tests, uniform);
    tcase_add_test(tests, average_of_as_many_poles_as_points);
    tcase_add_test(tests, average_by_hand);
    tcase_add_test(tests, every_span_holds_data);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
