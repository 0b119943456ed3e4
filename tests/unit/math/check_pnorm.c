/* Tests of pnorm.h: the squares of the vectors are the powers, and change as they say. */
#include "math/pnorm.h"

#include <check.h>
#include <math.h>

START_TEST(the_sum_of_powers_is_that_of_squares)
{
    double off[] = {0.3, -0.4, 1.2, 0.5, 0, 0}, held[3] = {0.1, 0.2, -0.3};
    for (int half = 1; half < 9; half += 3) {
        double sum = 0.01 + 0.04 + 0.09;
        for (int i = 0; i < 3; i++) {
            struct pnorm_vector v = pnorm_vector_of(off[2 * i], off[2 * i + 1], half, 0.8);
            sum += v.x * v.x + v.y * v.y;
            double d = hypot(off[2 * i], off[2 * i + 1]);
            ck_assert_double_eq_tol(hypot(v.x, v.y), pow(d / 0.8, half), 1e-9);
        }
        ck_assert_double_eq_tol(pnorm_cost(off, 3, held, half, 0.8), sum, 1e-9);
    }
}
END_TEST

START_TEST(vectors_change_as_they_say)
{
    for (int half = 1; half < 9; half += 3) {
        double x = 0.3, y = -0.4, step = 1e-6;
        struct pnorm_vector v = pnorm_vector_of(x, y, half, 0.8),
                            right = pnorm_vector_of(x + step, y, half, 0.8),
                            up = pnorm_vector_of(x, y + step, half, 0.8);
        ck_assert_double_eq_tol((right.x - v.x) / step, v.xx, 1e-4);
        ck_assert_double_eq_tol((right.y - v.y) / step, v.xy, 1e-4);
        ck_assert_double_eq_tol((up.x - v.x) / step, v.xy, 1e-4);
        ck_assert_double_eq_tol((up.y - v.y) / step, v.yy, 1e-4);
    }
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("pnorm");
    tcase_add_test(t, the_sum_of_powers_is_that_of_squares);
    tcase_add_test(t, vectors_change_as_they_say);
    Suite *s = suite_create("pnorm");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
