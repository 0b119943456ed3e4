/* surface_fit: feet and normals on known surfaces, about places of every kind, from noisy points.
 */
#include <check.h>
#include <stdlib.h>

#include "noisy.h"
#include "math/surface_fit.h"

static const double SIGMA = 0.02;

static struct vec3s scan;
static struct point_grid point_grid;
static struct surface_fit_hood *hood;

static double saddle(double x, double y)
{
    return (x * x - y * y) / 60;
}

static double wave(double x, double y)
{
    return 4 * sin(x * (2 * PI / 20)) * cos(y * (2 * PI / 30));
}

static double fold(double x, double y)
{
    return -0.5 * fabs(x + 0.2 * y);
}

static void make_scan(double (*height)(double, double), enum noisy_pattern pattern)
{
    struct error error;
    noisy_seed(5);
    noisy_scan(&scan, height, 17000, pattern, SIGMA);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.48, 1, &point_grid, &error), 0);
    hood = surface_fit_hood_new();
}

static void free_all(void)
{
    surface_fit_hood_free(hood);
    point_grid_free(&point_grid);
    array_free(&scan);
}

/* Within the cloud by 2 mm. */
static bool is_inside(struct vec3 p)
{
    return fabs(p.x) < 35 && fabs(p.y) < 25;
}

/* The bend of the wave that no cubic follows: over a disc of radius r the best cubic lies A
 * (kx^2 + ky^2)^2 / 64 * r^4 / 6 off at the middle, for r^4 is r^2 R^2 - R^4 / 6 by least squares.
 */
static double wave_off(double r)
{
    double kx = 2 * PI / 20, ky = 2 * PI / 30, k2 = kx * kx + ky * ky;
    return 4 * k2 * k2 / 64 * pow(r, 4) / 6;
}

/* Feet of many places are off by no more than five of the deviations that the fit itself names, and
 * normals, which have two directions to be off in, by six (one of 270,000 is by more than five, and
 * twenty seeds look at as many); and twice what no cubic follows, for at the border the points lie
 * to one side.  Returns how many of these deviations they are off in the mean of squares. */
static double look_all_over(double (*height)(double, double), size_t neighbours)
{
    struct surface_fit_options rule = {&point_grid, SIGMA, neighbours, false, false};
    double sum2 = 0, named2 = 0, n = 0;
    for (size_t i = 0; i < scan.n; i += 17) {
        struct surface_fit fit;
        struct vec3 p = scan.item[i];
        if (!is_inside(p))
            continue;
        ck_assert(surface_fit_at(&rule, p, vec(0, 0, 1), hood, &fit));
        ck_assert(surface_fit_holds(&fit, SIGMA));
        struct vec3 foot = quadric_nearest(&fit.q, p), up = noisy_up(height, foot.x, foot.y);
        double off = (foot.z - height(foot.x, foot.y)) * up.z, named = SIGMA * sqrt(fit.q.variance);
        double bent = height == wave ? 2 * wave_off(fit.reach) : 0;
        ck_assert_double_lt(fabs(off), 5 * named + bent);
        ck_assert_double_lt(vec_distance(quadric_normal(&fit.q), up),
                            6 * SIGMA * sqrt(fit.q.tilt) + bent / fit.reach);
        sum2 += off * off;
        named2 += off * off / (named * named);
        n++;
    }
    ck_assert_double_lt(sqrt(sum2 / n), 0.4 * SIGMA);
    return sqrt(named2 / n);
}

/* The deviations named are the true ones: some 180 neighbourhoods that do not meet tell that to
 * 1 / sqrt(2 * 180) = 5 %. */
START_TEST(smooth_surfaces)
{
    double (*const height[])(double, double) = {saddle, wave};
    make_scan(height[_i / 3], (enum noisy_pattern)(_i % 3));
    double named = look_all_over(height[_i / 3], 96);
    if (_i / 3 == 0)
        ck_assert_double_eq_tol(named, 1, 0.2);
}
END_TEST

/* What is nearly flat takes many points, what bends few. */
START_TEST(as_many_points_as_agree)
{
    size_t typical[2];
    for (int k = 0; k < 2; k++) {
        make_scan(k ? wave : saddle, NOISY_RANDOM);
        struct surface_fit_options rule = {&point_grid, SIGMA, 0, false, false};
        struct vec3s up = {0};
        for (size_t i = 0; i < scan.n; i++)
            *array_push(&up) = vec(0, 0, 1);
        typical[k] = surface_fit_typical(&rule, scan.item, up.item, scan.n, 2);
        ck_assert_uint_eq(typical[k], surface_fit_typical(&rule, scan.item, up.item, scan.n, 1));
        array_free(&up);
        free_all();
    }
    ck_assert_uint_gt(typical[0], typical[1]);
    ck_assert_uint_ge(typical[1], 32);
    make_scan(saddle, NOISY_RANDOM);
}
END_TEST

/* Near an edge the neighbourhood shrinks, or noise does not explain the points. */
START_TEST(not_across_an_edge)
{
    make_scan(fold, NOISY_RANDOM);
    struct surface_fit_options rule = {&point_grid, SIGMA, 200, false, false};
    size_t seen = 0;
    for (size_t i = 0; i < scan.n; i++) {
        struct surface_fit fit;
        struct vec3 p = scan.item[i];
        double from_edge = fabs(p.x + 0.2 * p.y);
        if (!is_inside(p) || from_edge < 1.5 || from_edge > 2)
            continue;
        ck_assert(surface_fit_at(&rule, p, vec(0, 0, 1), hood, &fit));
        if (surface_fit_holds(&fit, SIGMA)) {
            struct vec3 foot = quadric_nearest(&fit.q, p);
            ck_assert_double_lt(fabs(foot.z - fold(foot.x, foot.y)), 4 * SIGMA);
        }
        seen++;
    }
    ck_assert_uint_gt(seen, 100);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("surface_fit");
    TCase *tests = tcase_create("surface_fit");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, smooth_surfaces, 0, 6);
    tcase_add_test(tests, as_many_points_as_agree);
    tcase_add_test(tests, not_across_an_edge);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
