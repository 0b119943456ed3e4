/* parallel: each index once, whatever the number of threads. */
#include <check.h>
#include <stdlib.h>

#include "base/parallel.h"

enum { MOST = 5000 };

static int times[MOST];

static void count(void *context, size_t from, size_t to)
{
    size_t *n = context;
    ck_assert_uint_le(to, *n);
    for (size_t i = from; i < to; i++)
        times[i]++;
}

START_TEST(each_index_once)
{
    static const size_t sizes[] = {0, 1, 63, 64, 65, 127, 128, 129, 1000, MOST};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        for (int threads = 0; threads <= 70; threads += threads < 4 ? 1 : 33) {
            size_t n = sizes[k];
            for (size_t i = 0; i < MOST; i++)
                times[i] = 0;
            parallel_for(threads, n, count, &n);
            for (size_t i = 0; i < MOST; i++)
                ck_assert_int_eq(times[i], i < n);
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("parallel");
    TCase *tests = tcase_create("parallel");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, each_index_once);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
