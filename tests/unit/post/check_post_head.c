/* check_post_head - the sum of the ledger: what stages spent, the post's share in the program's
 * unit, the control's smoothing, and the chord where the path names one. */
#include <check.h>

#include "math/elementary.h"
#include "post/post_head.h"

static double sum_of(double chord, double spent, double unit, double smoothing)
{
    struct ledger_entry entry[2] = {{NULL, 0.012, false}, {NULL, 0.003, true}};
    struct path path = {.head = {.chord = chord, .ledger = {.n = 2, .item = entry}}};
    struct nc_plan plan = {.ability = {.unit = unit, .smoothing = smoothing}};
    plan.total.spent.point = spent;
    return nc_ledger_sum(&path, &plan);
}

START_TEST(every_share_counts_once)
{
    ck_assert_double_eq_tol(sum_of(NAN, 0, 1, 0), 0.015, 1e-15);
    ck_assert_double_eq_tol(sum_of(NAN, 0.002, 1, 0), 0.017, 1e-15);
    ck_assert_double_eq_tol(sum_of(0.004, 0.002, 1, 0), 0.021, 1e-15);
    ck_assert_double_eq_tol(sum_of(0.004, 0.002, 1, 0.05), 0.071, 1e-15);
    ck_assert_double_eq_tol(sum_of(NAN, 0.002, 1, 0.05), 0.067, 1e-15);
}
END_TEST

/* The post's share is in the program's unit, the others in mm. */
START_TEST(inches_are_mm_in_the_ledger)
{
    ck_assert_double_eq_tol(sum_of(0.004, 0.0001, 25.4, 0.05), 0.015 + 0.00254 + 0.054, 1e-15);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_head");
    TCase *tests = tcase_create("post_head");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, every_share_counts_once);
    tcase_add_test(tests, inches_are_mm_in_the_ledger);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
