/* noise: what was put on known surfaces, on every pattern; nothing where there is none. */
#include <check.h>
#include <stdlib.h>

#include "math/point_grid.h"
#include "cloud/noise.h"
#include "noisy.h"
#include "panel.h"

static struct vec3s scan;

static double wave(double x, double y)
{
    return 4 * sin(x * (2 * PI / 20)) * cos(y * (2 * PI / 30));
}

static double roof(double x, double y)
{
    return 12 - 0.5 * fabs(x + 0.2 * y);
}

static double (*const shape[])(double, double) = {panel_height, wave, roof};

/* Steps of 0.4 mm, 2 mm wide or more. */
static double terraces(double x, double y)
{
    return 0.4 * floor((3 * sin(x / 15) * cos(y / 11) + 0.03 * x) / 0.4);
}

/* Even on one side of x = 25, on the other of no shape that points tell. */
static double rough(double x, double y)
{
    return x < 25 ? panel_height(x, y) : panel_height(x, y) + noisy_uniform() * noisy_uniform();
}

/* The whole of it is rough, here more and there less. */
static double leaves(double x, double y)
{
    return panel_height(x, y) + noisy_normal() * 0.02 * exp(2 * sin(x / 9) * cos(y / 7));
}

static struct noise measured_all(void)
{
    struct point_grid point_grid;
    struct error error;
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.48, 2, &point_grid, &error), 0);
    struct noise noise = noise_measure(&point_grid, 2);
    struct noise once = noise_measure(&point_grid, 1);
    ck_assert(noise.sigma == once.sigma && noise.even == once.even);
    point_grid_free(&point_grid);
    array_free(&scan);
    return noise;
}

static double measured(void)
{
    return measured_all().sigma;
}

START_TEST(as_put_on)
{
    const double sigma[] = {0.01, 0.02, 0.05};
    for (int p = NOISY_GRID; p <= NOISY_RANDOM; p++)
        for (int s = 0; s < 3; s++) {
            noisy_seed((unsigned)(7 + s));
            noisy_scan(&scan, shape[_i], 17000, (enum noisy_pattern)p, sigma[s]);
            ck_assert_double_eq_tol(measured() / sigma[s], 1, 0.1);
        }
}
END_TEST

START_TEST(none)
{
    for (int p = NOISY_GRID; p <= NOISY_RANDOM; p++) {
        noisy_seed(3);
        noisy_scan(&scan, shape[_i], 17000, (enum noisy_pattern)p, 0);
        ck_assert_double_lt(measured(), 0.002);
    }
}
END_TEST

/* Pockets with upright walls, 3 mm wide, in a dome of 30 mm. */
static double dome_pockets(double x, double y)
{
    double u = x - 5 * floor(x / 5 + 0.5), v = y - 5 * floor(y / 5 + 0.5);

    return sqrt(900 - x * x - y * y) - 0.4 * (fmax(fabs(u), fabs(v)) < 1.5);
}

static double dome(double x, double y)
{
    return sqrt(900 - x * x - y * y);
}

/* Of points anywhere, 1 mm apart, those over pockets are as far off smooth surfaces as noise would
 * have it, and alike everywhere; but their neighbours are, too. */
START_TEST(what_neighbours_share_is_none)
{
    enum { POINTS = 625, WIDE = 25 };
    struct point_grid grid;
    struct error error;

    for (int noise = 0; noise < 2; noise++) {
        noisy_seed(40 + (unsigned)_i);
        for (int i = 0; i < POINTS; i++) {
            double x = WIDE * (noisy_uniform() - 0.5), y = WIDE * (noisy_uniform() - 0.5);
            double z = noise ? dome(x, y) + 0.1 * noisy_normal() : dome_pockets(x, y);
            *array_push(&scan) = vec(x, y, z);
        }
        ck_assert_int_eq(point_grid_make(scan.item, scan.n, 1, 1, &grid, &error), 0);
        struct noise found = noise_measure(&grid, 1);
        ck_assert(found.sigma > 0.05 && found.alike == (noise == 1));
        point_grid_free(&grid);
        array_free(&scan);
    }
}
END_TEST

/* A dome of some sixty tangent planes, whose edges are as far apart as three points. */
static double dome_facets(double x, double y)
{
    enum { FACETS = 60 };
    double z = HUGE_VAL;

    for (int k = 0; k < FACETS; k++) {
        double r = 13 * sqrt((k + 0.5) / FACETS), t = 2.39996 * k;
        double u = r * cos(t), v = r * sin(t), h = sqrt(400 - u * u - v * v);
        z = fmin(z, h + (u * (u - x) + v * (v - y)) / h);
    }
    return z;
}

/* Of points 1 mm apart, on a grid turned by a little and anywhere: facets without noise are none;
 * with noise as large as what edges are off, what is found may be shape in part or is not noise
 * alone, as it is on a smooth dome. */
START_TEST(facets_and_noise)
{
    enum { ACROSS = 25 };
    enum { FACETTED, BOTH, SMOOTH };
    double a = 0.2 + 0.1 * _i;

    for (int what = FACETTED; what <= SMOOTH; what++) {
        struct point_grid grid;
        struct error error;
        noisy_seed(60 + (unsigned)_i);
        for (int i = 0; i < ACROSS * ACROSS; i++) {
            double u = i % ACROSS - ACROSS / 2, v = i / ACROSS - ACROSS / 2;
            u = _i % 2 ? ACROSS * (noisy_uniform() - 0.5) : u;
            v = _i % 2 ? ACROSS * (noisy_uniform() - 0.5) : v;
            double x = u * cos(a) - v * sin(a), y = u * sin(a) + v * cos(a);
            double z = what == SMOOTH ? dome(x, y) : dome_facets(x, y);
            *array_push(&scan) = vec(x, y, z + (what == FACETTED ? 0 : 0.02 * noisy_normal()));
        }
        ck_assert_int_eq(point_grid_make(scan.item, scan.n, 1, 1, &grid, &error), 0);
        struct noise found = noise_measure(&grid, 1);
        ck_assert(what == BOTH || !found.mixed);
        ck_assert(what == FACETTED ? !found.alike && !(found.even > 0)
                                   : found.alike == (what == SMOOTH || found.mixed));
        point_grid_free(&grid);
        array_free(&scan);
    }
}
END_TEST

START_TEST(a_few_outliers_do_not_count)
{
    noisy_seed(1);
    noisy_scan(&scan, panel_height, 17000, NOISY_RANDOM, 0.02);
    for (size_t i = 0; i < scan.n; i += 100)
        scan.item[i].z += 5 * noisy_uniform();
    ck_assert_double_eq_tol(measured() / 0.02, 1, 0.1);
}
END_TEST

/* Where most places lie over a step, those that do not tell the noise; a fifth of the variance of
 * a variance of ten degrees of freedom is 0.45, its middle one of 400 is known within 5 %. */
START_TEST(over_steps)
{
    const double sigma[] = {0.003, 0.005, 0.01};
    for (int p = NOISY_GRID; p <= NOISY_RANDOM; p += 2)
        for (int s = 0; s < 3; s++) {
            noisy_seed((unsigned)(5 + s));
            noisy_scan(&scan, terraces, 17000, (enum noisy_pattern)p, sigma[s]);
            struct noise noise = measured_all();
            ck_assert(!noise.alike);
            ck_assert_double_gt(noise.sigma, 2 * sigma[s]);
            ck_assert_double_eq_tol(noise.even / sigma[s], 1, 0.15);
        }
}
END_TEST

/* Square pockets 0.25 mm deep: of the places as many as not lie over their walls, which are not far
 * higher than noise. */
static double pockets(double x, double y)
{
    const double pitch = 7, wide = 3.5;
    double u = x - pitch * floor(x / pitch), v = y - pitch * floor(y / pitch);

    return u < wide && v < wide ? 0 : 0.25;
}

START_TEST(over_low_walls)
{
    const double sigma[] = {0.012, 0.015};

    for (int p = NOISY_GRID; p <= NOISY_RANDOM; p++)
        for (int s = 0; s < 2; s++) {
            noisy_seed((unsigned)(20 + s));
            noisy_scan(&scan, pockets, 17000, (enum noisy_pattern)p, sigma[s]);
            struct noise noise = measured_all();
            ck_assert_msg(fabs(noise.even / sigma[s] - 1) < 0.15, "%d %g: %g", p, sigma[s],
                          noise.even);
        }
}
END_TEST

/* Pyramids 16 mm wide: many places lie over an edge, some by little. */
static double pyramids(double x, double y)
{
    double u = x - 16 * floor(x / 16), v = y - 16 * floor(y / 16);
    return 8 - fmax(fabs(u - 8), fabs(v - 8));
}

/* What edges leave at some places runs on into what noise leaves at others. */
START_TEST(over_edges)
{
    const double sigma[] = {0.02, 0.03, 0.04};
    for (int s = 0; s < 3; s++) {
        noisy_seed((unsigned)(5 + s));
        noisy_scan(&scan, pyramids, 17000, NOISY_RANDOM, sigma[s]);
        struct noise noise = measured_all();
        ck_assert(!noise.alike);
        ck_assert_double_eq_tol(noise.even / sigma[s], 1, 0.15);
    }
}
END_TEST

/* Facets that touch a paraboloid 3.5 mm apart and meet at 9 degrees: most places are over an edge,
 * of which the fewest points that carry a quadric leave as much as there is noise. */
static double facets(double x, double y)
{
    double cx = 3.5 * round(x / 3.5), cy = 3.5 * round(y / 3.5);

    return (cx * cx + cy * cy - 2 * (cx * x + cy * y)) / 45;
}

START_TEST(over_blunt_edges)
{
    const double sigma[] = {0.003, 0.005, 0.008};
    for (int p = NOISY_GRID; p <= NOISY_RANDOM; p++)
        for (int s = 0; s < 3; s++) {
            noisy_seed((unsigned)(5 + s));
            noisy_scan(&scan, facets, 17000, (enum noisy_pattern)p, sigma[s]);
            struct noise noise = measured_all();
            ck_assert(!(s < 2 && noise.alike)); /* by the edges alone */
            ck_assert_double_eq_tol((noise.alike ? noise.sigma : noise.even) / sigma[s], 1, 0.2);
        }
}
END_TEST

/* A rough half beside an even one: the even one's.  What is rough here and there, or has edges at
 * few places, has none. */
START_TEST(no_even_places)
{
    double (*const of[])(double, double) = {rough, leaves, roof, terraces, facets};
    for (int k = 0; k < 5; k++) {
        noisy_seed(11);
        noisy_scan(&scan, of[k], 17000, NOISY_RANDOM, k >= 3 ? 0 : 0.005);
        struct noise noise = measured_all();
        if (k == 0)
            ck_assert_double_eq_tol(noise.even / 0.005, 1, 0.15);
        else
            ck_assert_msg(noise.even == 0, "shape %d: %g", k, noise.even);
    }
}
END_TEST

/* At the places where it looks in all points, by the points about these alone. */
START_TEST(by_the_points_about_its_places)
{
    static uint32_t place[NOISE_PLACES];
    static unsigned char near[40000];
    struct point_grid all, about;
    struct error error;
    struct vec3s some = {0};
    noisy_seed(5);
    noisy_scan(&scan, wave, 30000, NOISY_RANDOM, 0.02);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.36, 1, &all, &error), 0);
    const double part = 0.2; /* of the places: others would leave no point out */
    size_t places = (size_t)(part * NOISE_PLACES);
    for (size_t i = 0; i < places; i++)
        place[i] = (uint32_t)noise_place(i * 5 + 2, scan.n);
    struct noise want = noise_measure_at(&all, place, places, 1);
    for (size_t i = 0; i < scan.n; i++)
        for (size_t k = 0; k < places && !near[i]; k++)
            near[i] = vec_distance(scan.item[i], scan.item[place[k]]) < 4.5;
    for (size_t i = 0, k = 0; i < scan.n; i++) {
        if (k < places && place[k] == i)
            place[k++] = (uint32_t)some.n;
        if (near[i])
            *array_push(&some) = scan.item[i];
    }
    ck_assert_int_eq(point_grid_make_in(&all, some.item, some.n, 1, &about, &error), 0);
    struct noise got = noise_measure_at(&about, place, places, 1);
    ck_assert_double_eq(got.sigma, want.sigma);
    ck_assert_double_eq_tol(got.sigma, 0.02, 0.002);
    point_grid_free(&all);
    point_grid_free(&about);
    array_free(&some);
    array_free(&scan);
}
END_TEST

START_TEST(fewer_points_than_it_takes)
{
    for (int i = 0; i < 10; i++)
        *array_push(&scan) = vec(i, i * i % 7, 0);
    ck_assert(measured() == 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("noise");
    TCase *tests = tcase_create("noise");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, as_put_on, 0, 3);
    tcase_add_loop_test(tests, none, 0, 3);
    tcase_add_loop_test(tests, what_neighbours_share_is_none, 0, 16);
    tcase_add_loop_test(tests, facets_and_noise, 0, 8);
    tcase_add_test(tests, a_few_outliers_do_not_count);
    tcase_add_test(tests, over_steps);
    tcase_add_test(tests, over_low_walls);
    tcase_add_test(tests, over_edges);
    tcase_add_test(tests, over_blunt_edges);
    tcase_add_test(tests, no_even_places);
    tcase_add_test(tests, by_the_points_about_its_places);
    tcase_add_test(tests, fewer_points_than_it_takes);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
