/* effort: bounds grow with it, and the effort that is asked for is enough and no more. */
#include <check.h>
#include <stdlib.h>

#include "base/effort.h"

START_TEST(bounds_grow)
{
    size_t most = effort_most(EFFORT_CREASES, 1);
    ck_assert_uint_eq(effort_most(EFFORT_CREASES, 0), most);
    ck_assert_uint_eq(effort_most(EFFORT_CREASES, 3), 3 * most);
    ck_assert(effort_covers(EFFORT_CREASES, 1, most));
    ck_assert(!effort_covers(EFFORT_CREASES, 1, most + 1));
}
END_TEST

START_TEST(enough_is_enough)
{
    for (int bound = EFFORT_CREASES; bound <= EFFORT_GUARD_NEAR; bound++) {
        for (size_t n = 1; n < 100000000; n += n / 3 + 1) {
            double effort = effort_for((enum effort_bound)bound, n);
            ck_assert(effort_covers((enum effort_bound)bound, effort, n));
            if (effort > 1)
                ck_assert(!effort_covers((enum effort_bound)bound, effort - 1, n));
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("effort");
    TCase *all = tcase_create("all");
    tcase_add_test(all, bounds_grow);
    tcase_add_test(all, enough_is_enough);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
