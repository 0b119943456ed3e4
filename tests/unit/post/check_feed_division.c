/* check_feed_division - against every division of a motion into up to three parts, tried. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "post/feed_division.h"
#include "seed.h"

static const double SECOND = 1 / 60.0;

static uint32_t state;

static double chance(double from, double to)
{
    state = state * 1664525u + seed_step_32();
    return from + (to - from) * (double)(state >> 8) / (1 << 24);
}

/* Even spans 1 mm long, with the seconds that each takes. */
static struct feed_spans spans_of(const double seconds[], size_t n)
{
    struct feed_spans spans = {0};

    for (size_t i = 0; i < n; i++)
        *array_push(&spans) =
            (struct feed_span){(double)(i + 1) / (double)n, 1, seconds[i] * SECOND};
    return spans;
}

static double division(const double seconds[], size_t n)
{
    struct feed_spans spans = spans_of(seconds, n);
    double s = feed_division(&spans);

    array_free(&spans);
    return s;
}

START_TEST(what_is_even_stays_whole)
{
    ck_assert_double_eq(division((double[]){3, 3, 3, 3}, 4), 1);
    ck_assert_double_eq(division((double[]){3}, 1), 1);
    ck_assert_double_eq(division(NULL, 0), 1);
    /* a tenth of the time, and 0.2 seconds */
    ck_assert_double_eq(division((double[]){3, 3, 3, 3, 2.5}, 5), 1);
    ck_assert_double_eq(division((double[]){0.1, 0.1, 0.01}, 3), 1);
}
END_TEST

START_TEST(a_slow_end_goes_by_itself)
{
    ck_assert_double_eq_tol(division((double[]){9, 1, 1, 1}, 4), 0.25, 1e-12);
    ck_assert_double_eq_tol(division((double[]){1, 1, 1, 9}, 4), 0.75, 1e-12);
}
END_TEST

/* One place does not help where both ends are slow. */
START_TEST(what_is_slow_at_both_ends_is_divided)
{
    ck_assert_double_eq_tol(division((double[]){9, 1, 1, 1, 9}, 5), 0.2, 1e-12);
    double many[2000];
    for (int i = 0; i < 2000; i++)
        many[i] = i < 100 || i >= 1900 ? 0.9 : 0.1;
    double s = division(many, 2000);
    ck_assert_double_ge(s, 0.05 - 1e-12);
    ck_assert_double_le(s, 0.05 + 8.0 / 2000);
}
END_TEST

static double cost(const double seconds[], size_t from, size_t to)
{
    double most = 0;

    for (size_t i = from; i < to; i++)
        most = fmax(most, seconds[i]);
    return most * (double)(to - from);
}

/* Every way: what is returned is the first place of one that costs least, if it saves enough. */
START_TEST(no_other_division_is_better)
{
    state = (uint32_t)_i + 1;
    enum { N = 12 };
    double seconds[N], whole, one, two;
    size_t at_one = N, at_two = N;

    for (int i = 0; i < N; i++)
        seconds[i] = exp(chance(-3, 3));
    whole = one = two = cost(seconds, 0, N);
    for (size_t i = 1; i < N; i++) {
        double sum = cost(seconds, 0, i) + cost(seconds, i, N);
        at_one = sum < one ? i : at_one;
        one = fmin(one, sum);
        for (size_t k = i + 1; k < N; k++) {
            sum = cost(seconds, 0, i) + cost(seconds, i, k) + cost(seconds, k, N);
            at_two = sum < two ? i : at_two;
            two = fmin(two, sum);
        }
    }
    double expected = 1;
    if (whole - one > fmax(0.1 * whole, 0.2))
        expected = (double)at_one / N;
    else if (whole - two > fmax(0.1 * whole, 0.4))
        expected = (double)at_two / N;
    ck_assert_double_eq_tol(division(seconds, N), expected, 1e-12);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feed_division");
    TCase *tcase = tcase_create("feed_division");
    tcase_add_test(tcase, what_is_even_stays_whole);
    tcase_add_test(tcase, a_slow_end_goes_by_itself);
    tcase_add_test(tcase, what_is_slow_at_both_ends_is_divided);
    tcase_add_loop_test(tcase, no_other_division_is_better, 0, 50);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
