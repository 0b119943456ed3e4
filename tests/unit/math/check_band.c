/*
 * band, against products: a factor times its transpose, a matrix times the solution.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/band.h"
#include "math/vec.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* Diagonally dominant, so that it is positive definite. */
static struct band random_band(size_t n, size_t width)
{
    struct band b = band_new(n, width);

    for (size_t i = 0; i < n; i++) {
        for (size_t j = i > width ? i - width : 0; j < i; j++)
            *band_at(&b, i, j) = 2 * chance() - 1;
        *band_at(&b, i, i) = 2 * (double)width + 0.5 + chance();
    }
    return b;
}

static double element(const struct band *b, size_t i, size_t j)
{
    if (j > i)
        return element(b, j, i);
    return i - j > b->width ? 0 : *band_at(b, i, j);
}

START_TEST(solution_times_matrix_is_the_right_side)
{
    enum { COLUMNS = 3 };

    seed = 6;
    for (int turn = 0; turn < 200; turn++) {
        size_t n = 1 + (size_t)(40 * chance()), width = (size_t)(7 * chance());
        width = turn % 2 ? n - 1 : width; /* a full matrix */
        struct band b = random_band(n, width), factor = band_new(n, width);
        double right[COLUMNS * 41], x[COLUMNS * 41];

        for (size_t i = 0; i < n * (width + 1); i++)
            factor.item[i] = b.item[i];
        for (size_t i = 0; i < COLUMNS * n; i++)
            x[i] = right[i] = 20 * chance() - 10;
        ck_assert(band_factor(&factor));
        band_solve(&factor, x, COLUMNS);
        for (size_t i = 0; i < n; i++)
            for (size_t c = 0; c < COLUMNS; c++) {
                double sum = 0;
                for (size_t j = 0; j < n; j++)
                    sum += element(&b, i, j) * x[j * COLUMNS + c];
                ck_assert_double_eq_tol(sum, right[i * COLUMNS + c], 1e-12);
            }
        band_free(&factor);
        band_free(&b);
    }
}
END_TEST

START_TEST(what_is_not_positive_definite)
{
    struct band b = band_new(3, 1); /* 1 1 0 / 1 1 1 / 0 1 1: not even semi-definite */

    for (size_t i = 0; i < 3; i++) {
        *band_at(&b, i, i) = 1;
        if (i > 0)
            *band_at(&b, i, i - 1) = 1;
    }
    ck_assert(!band_factor(&b));
    band_free(&b);
    b = band_new(2, 1); /* zero */
    ck_assert(!band_factor(&b));
    band_free(&b);
}
END_TEST

/* One pivot is below zero, in every row of a full matrix, which is factored several at a time. */
START_TEST(no_pivot_below_zero_in_any_row)
{
    enum { N = 11 };

    for (size_t row = 0; row < N; row++) {
        struct band b = band_new(N, N - 1);
        for (size_t i = 0; i < N; i++)
            *band_at(&b, i, i) = i == row ? -1 : 1;
        ck_assert(!band_factor(&b));
        band_free(&b);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("band");
    TCase *tests = tcase_create("band");

    tcase_add_test(tests, solution_times_matrix_is_the_right_side);
    tcase_add_test(tests, what_is_not_positive_definite);
    tcase_add_test(tests, no_pivot_below_zero_in_any_row);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
