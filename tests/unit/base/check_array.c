/* array: what was put in stays, over small and large blocks. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

START_TEST(grows_and_keeps)
{
    struct sizes a = {0};
    for (size_t i = 0; i < 3000000; i++) /* 24 MB: through several large blocks */
        *array_push(&a) = i * i;
    ck_assert_uint_eq(a.n, 3000000);
    ck_assert_uint_ge(a.cap, a.n);
    size_t other = 0;
    for (size_t i = 0; i < a.n; i++)
        other += a.item[i] != i * i;
    ck_assert_uint_eq(other, 0);
    array_free(&a);
    ck_assert_ptr_null(a.item);
    ck_assert_uint_eq(a.n + a.cap, 0);
    *array_push(&a) = 7; /* and it may be used again */
    ck_assert_uint_eq(a.item[0], 7);
    array_free(&a);
}
END_TEST

START_TEST(reserve_keeps_too)
{
    struct ints a = {0};
    *array_push(&a) = 42;
    array_reserve(&a, 5000000);
    ck_assert_uint_ge(a.cap, 5000000);
    ck_assert_uint_eq(a.n, 1);
    ck_assert_int_eq(a.item[0], 42);
    int *before = a.item;
    array_reserve(&a, 100);
    ck_assert_ptr_eq(a.item, before);
    array_free(&a);
}
END_TEST

START_TEST(memory_is_zero)
{
    unsigned char *p = mem_alloc(1000, 3);
    for (size_t i = 0; i < 3000; i++)
        ck_assert_uint_eq(p[i], 0);
    free(p);
    p = mem_alloc(0, 0);
    ck_assert_ptr_nonnull(p);
    free(p);
    char *s = mem_string("abc\0def", 5);
    ck_assert_mem_eq(s, "abc\0d", 6);
    free(s);
}
END_TEST

/* Each rank of values in no order, of which many are equal, as sorting has it. */
START_TEST(selects_as_sorting_does)
{
    enum { N = 101 };
    double value[N], sorted[N];

    for (size_t k = 0; k < N; k++) {
        for (size_t i = 0; i < N; i++)
            sorted[i] = value[i] = (double)(i * 37 % N / (1 + k % 4));
        doubles_sort(sorted, N);
        ck_assert(doubles_select(value, N, k) == sorted[k]);
    }
    ck_assert(doubles_select(sorted, 1, 0) == sorted[0]);
}
END_TEST

/* More than any memory: the process says so and ends with 1. */
START_TEST(too_much_ends_the_process)
{
    struct doubles a = {0};
    array_reserve(&a, SIZE_MAX / 16);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("array");
    TCase *tests = tcase_create("array");
    SRunner *runner = srunner_create(suite);

    tcase_add_test(tests, grows_and_keeps);
    tcase_add_test(tests, reserve_keeps_too);
    tcase_add_test(tests, memory_is_zero);
    tcase_add_test(tests, selects_as_sorting_does);
    if (srunner_fork_status(runner) == CK_FORK) /* else it would end here */
        tcase_add_exit_test(tests, too_much_ends_the_process, 1);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
