/* scan_lines: grids and points anywhere are on no lines; rows three times as far apart as their
 * points are. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/scan_lines.h"
#include "noisy.h"

static double waves(double x, double y)
{
    return sin(x / 5) + cos(y / 7);
}

static double flat(double x, double y)
{
    return 0 * x * y;
}

/* Flanks of a slope on which points of a line are 1.7 times as far apart as in plan. */
static double pyramid(double x, double y)
{
    return -1.4 * fmax(fabs(x - 0.3 * y), fabs(y + 0.3 * x));
}

static bool on_lines(double (*height)(double, double), int n, enum noisy_pattern pattern,
                     double sigma)
{
    struct vec3s scan = {0};
    struct point_grid grid;
    struct error error;
    noisy_scan(&scan, height, n, pattern, sigma);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, sqrt(74 * 54. / n), 1, &grid, &error), 0);
    bool found = scan_lines_found(&grid);
    point_grid_free(&grid);
    array_free(&scan);
    return found;
}

START_TEST(patterns)
{
    static const int number[] = {20, 300, 8000};
    static const double sigma[] = {0, 0.02};
    noisy_seed(3);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            ck_assert(!on_lines(waves, number[i], NOISY_GRID, sigma[k]));
            ck_assert(!on_lines(flat, number[i], NOISY_GRID, sigma[k]));
            ck_assert(i == 0 || !on_lines(waves, number[i], NOISY_RANDOM, sigma[k]));
            ck_assert(i == 0 || on_lines(flat, number[i], NOISY_LINES, sigma[k]));
            ck_assert(i < 2 || on_lines(waves, number[i], NOISY_LINES, sigma[k]));
            ck_assert(i < 2 || on_lines(pyramid, number[i], NOISY_LINES, sigma[k]));
            ck_assert(i < 2 || !on_lines(pyramid, number[i], NOISY_GRID, sigma[k]));
            ck_assert(i < 2 || !on_lines(pyramid, number[i], NOISY_RANDOM, sigma[k]));
        }
}
END_TEST

/* One row, and fewer points than a plane has. */
START_TEST(few)
{
    for (int n = 1; n < 40; n += n < 4 ? 1 : 12) {
        struct vec3 point[40];
        struct point_grid grid;
        struct error error;
        for (int i = 0; i < n; i++)
            point[i] = vec(i, 2 * i, 0);
        ck_assert_int_eq(point_grid_make(point, (size_t)n, 1, 1, &grid, &error), 0);
        ck_assert(scan_lines_found(&grid));
        point_grid_free(&grid);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("scan_lines");
    TCase *tests = tcase_create("scan_lines");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, patterns);
    tcase_add_test(tests, few);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
