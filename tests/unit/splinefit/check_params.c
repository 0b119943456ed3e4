/*
 * params, by hand and by the worked example 9.1 of Piegl and Tiller, The NURBS Book.
 */
#include <check.h>
#include <stdlib.h>

#include "splinefit/params.h"
#include "math/vec.h"

START_TEST(by_hand)
{
    const double chord[] = {4, 9, 0, 3};
    double u[5];

    params_fill(PARAMS_UNIFORM, chord, 5, u);
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], k / 4.0, 1e-15);
    params_fill(PARAMS_CHORD, chord, 5, u);
    const double by_chord[] = {0, 4 / 16.0, 13 / 16.0, 13 / 16.0, 1};
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], by_chord[k], 1e-15);
    params_fill(PARAMS_CENTRIPETAL, chord, 5, u);
    double sum = 5 + sqrt(3);
    const double centripetal[] = {0, 2 / sum, 5 / sum, 5 / sum, 1};
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], centripetal[k], 1e-15);
}
END_TEST

/* Q = (0,0) (3,4) (-1,4) (-4,0) (-4,-3): u = 0, 5/17, 9/17, 14/17, 1. */
START_TEST(worked_example)
{
    const double chord[] = {5, 4, 5, 3}, expected[] = {0, 5 / 17.0, 9 / 17.0, 14 / 17.0, 1};
    double u[5];

    params_fill(PARAMS_CHORD, chord, 5, u);
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], expected[k], 1e-15);
}
END_TEST

START_TEST(points_in_one_place)
{
    const double chord[] = {0, 0};
    double u[3];

    params_fill(PARAMS_CENTRIPETAL, chord, 3, u);
    ck_assert(u[0] == 0 && u[1] == 0.5 && u[2] == 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("params");
    TCase *tests = tcase_create("params");

    tcase_add_test(tests, by_hand);
    tcase_add_test(tests, worked_example);
    tcase_add_test(tests, points_in_one_place);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
