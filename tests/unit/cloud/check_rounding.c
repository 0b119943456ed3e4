/* rounding: steps that heights were rounded to, and what is no rounding. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "cloud/rounding.h"
#include "noisy.h"
#include "panel.h"

enum { POINTS = 12000 };

static struct vec3s scan;
static double spacing;

static void make_scan(void)
{
    noisy_seed(5);
    noisy_scan(&scan, panel_height, POINTS, NOISY_RANDOM, 0);
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
    for (size_t i = 0; i < scan.n; i++) {
        x0 = fmin(x0, scan.item[i].x);
        x1 = fmax(x1, scan.item[i].x);
        y0 = fmin(y0, scan.item[i].y);
        y1 = fmax(y1, scan.item[i].y);
    }
    spacing = sqrt((x1 - x0) * (y1 - y0) / (double)scan.n);
}

static void round_heights(double step, double decimals)
{
    for (size_t i = 0; i < scan.n; i++) {
        double z = 7.3 + step * round(scan.item[i].z / step);
        scan.item[i].z = decimals > 0 ? round(z / decimals) * decimals : z;
    }
}

/* Found as it is, and where the decimals of the file have rounded it again; finer and coarser steps
 * than count are not. */
START_TEST(steps)
{
    const double parts[] = {0.03, 0.05, 0.1, 0.25, 0.4};

    make_scan();
    double step = parts[_i % 5] * spacing, decimals = _i < 5 ? 0 : step / 40;
    ck_assert_double_eq(rounding_step(scan.item, scan.n, spacing), 0);
    round_heights(step, decimals);
    double found = rounding_step(scan.item, scan.n, spacing);
    if (_i % 5 == 0 || _i % 5 == 4)
        ck_assert_double_eq(found, 0);
    else
        ck_assert_double_eq_tol(found, step, 1e-3 * step + decimals);
    array_free(&scan);
}
END_TEST

/* One height in between, and all are as they are. */
START_TEST(one_between)
{
    make_scan();
    round_heights(0.1 * spacing, 0);
    scan.item[scan.n - 3].z += 0.04 * spacing;
    ck_assert_double_eq(rounding_step(scan.item, scan.n, spacing), 0);
    array_free(&scan);
}
END_TEST

/* A few levels are the part; so are levels with much between them. */
START_TEST(levels)
{
    make_scan();
    for (size_t i = 0; i < scan.n; i++)
        scan.item[i].z = (_i ? 40 : 0.1) * spacing * floor(scan.item[i].x / 10) +
                         0.1 * spacing * (double)(i % 2);
    ck_assert_double_eq(rounding_step(scan.item, scan.n, spacing), 0);
    array_free(&scan);
}
END_TEST

/* Within half a step, evenly, each place its own way, and as far from where it was as is said. */
START_TEST(spread)
{
    double sum = 0, sum2 = 0, most = 0, off2 = 0;
    struct vec3s was = {0}, rounded = {0};

    make_scan();
    vec3s_add(&was, scan.item, scan.n);
    double step = 0.1 * spacing;
    round_heights(step, 0);
    vec3s_add(&rounded, scan.item, scan.n);
    rounding_spread(step, rounded.item, rounded.n, scan.item);
    for (size_t i = 0; i < scan.n; i++) {
        double by = (scan.item[i].z - rounded.item[i].z) / step;
        double off = scan.item[i].z - 7.3 - was.item[i].z;
        ck_assert(scan.item[i].x == was.item[i].x && scan.item[i].y == was.item[i].y);
        sum += by;
        sum2 += by * by;
        off2 += off * off;
        most = fmax(most, fabs(by));
    }
    double n = (double)scan.n;
    ck_assert_double_le(most, 0.5);
    ck_assert_double_eq_tol(sum / n, 0, 0.01);
    ck_assert_double_eq_tol(sum2 / n, 1.0 / 12, 0.003);
    ck_assert_double_eq_tol(sqrt(off2 / n), step / sqrt(6), 0.02 * step);
    ck_assert_double_eq(rounding_step(was.item, 0, spacing), 0);
    array_free(&was);
    array_free(&rounded);
    array_free(&scan);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rounding");
    TCase *tests = tcase_create("rounding");
    SRunner *runner = srunner_create(suite);

    tcase_add_loop_test(tests, steps, 0, 10);
    tcase_add_test(tests, one_between);
    tcase_add_loop_test(tests, levels, 0, 2);
    tcase_add_test(tests, spread);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
