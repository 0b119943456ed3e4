/*
 * deviation, by hand: a straight line and four points beside it.
 */
#include <check.h>
#include <stdlib.h>

#include "splinefit/deviation.h"

START_TEST(by_hand)
{
    struct bspline b = bspline_new(1, 2, false);
    const double u[] = {0, 1, 2, 3};
    const struct vec3 point[] = {{0, 0, 0}, {1, 3, 0}, {2, 0, 4}, {3, 0, 0}};

    b.knot[2] = b.knot[3] = 3;
    b.pole[1] = vec(3, 0, 0);
    struct deviation d = deviation_of(&b, b.pole, point, u, 4);
    ck_assert_double_eq_tol(d.c1, 4, 1e-15);
    ck_assert_double_eq_tol(d.c2, 5 / 4.0, 1e-15); /* eq 8: sqrt(9 + 16) / 4 */
    ck_assert_double_eq_tol(d.rms, sqrt(25 / 4.0), 1e-15);
    ck_assert_double_eq_tol(d.middle, 2.5, 1e-15); /* (1.5, 1.5, 2) from (1.5, 0, 0) */
    bspline_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("deviation");
    TCase *tests = tcase_create("deviation");

    tcase_add_test(tests, by_hand);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
