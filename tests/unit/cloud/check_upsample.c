/* upsample: points between those of a sparse cloud lie on its surface, in no hole, and only where
 * the ball asks for them. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "noisy.h"
#include "cloud/upsample.h"
#include "cloud/upsample_surface.h"

static struct vec3s scan;
static struct point_grid point_grid;
static struct vec3s put;

static double wave(double x, double y)
{
    return 3 * sin(x / 4) * cos(y / 6);
}

/* About n points of the wave, but for those in a hole about (hole, 0). */
static struct upsample make_fill(int n, double hole)
{
    struct error error;
    struct vec3s all = {0};
    noisy_seed(3);
    noisy_scan(&all, wave, n, NOISY_RANDOM, 0);
    for (size_t i = 0; i < all.n; i++)
        if (hypot(all.item[i].x - hole, all.item[i].y) > 4)
            *array_push(&scan) = all.item[i];
    array_free(&all);
    ck_assert_int_eq(
        point_grid_make(scan.item, scan.n, sqrt(74 * 54.0 / n), 1, &point_grid, &error), 0);
    return (struct upsample){.point_grid = &point_grid, .radius = 4, .sink = 0.002};
}

static void free_all(void)
{
    point_grid_free(&point_grid);
    array_free(&scan);
    array_free(&put);
}

START_TEST(on_the_surface)
{
    struct upsample fill = make_fill(6000, 5);
    double sum2 = 0, worst = 0;
    ck_assert(upsample_needed(&fill));
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    ck_assert_uint_gt(put.n, 3 * point_grid.n);
    for (size_t i = 0; i < put.n; i++) {
        struct vec3 p = put.item[i];
        double off = p.z - wave(p.x, p.y);
        ck_assert_double_gt(hypot(p.x - 5, p.y), 1.4);
        if (fabs(p.x) > 35 || fabs(p.y) > 25 || hypot(p.x - 5, p.y) < 5)
            continue;
        worst = fmax(worst, fabs(off));
        sum2 += off * off;
    }
    ck_assert_double_lt(worst, 0.025); /* 0.06 by quadrics */
    ck_assert_double_lt(sqrt(sum2 / (double)put.n), 0.001);
}
END_TEST

/* The surface is handed in: a plane that noise of 2 mm may have been off. */
START_TEST(on_a_surface_that_is_given)
{
    struct upsample fill = make_fill(6000, 100);
    size_t i = point_grid.n / 2;
    struct vec3 p = point_grid.point[i];
    struct upsample_surface plane = {
        .q = {.origin = p, .u = {1, 0, 0}, .v = {0, 1, 0}, .w = {0, 0, 1}}};
    fill.noise = 2;
    upsample_on(&fill, i, p, &plane, &put);
    ck_assert_uint_gt(put.n, 0);
    for (size_t k = 0; k < put.n; k++)
        ck_assert_double_eq_tol(put.item[k].z, p.z, 1e-12);
    size_t before = put.n;
    plane.spread = 10; /* mm: none */
    upsample_on(&fill, i, p, &plane, &put);
    ck_assert_uint_eq(put.n, before);
    /* the points do not bear it out, for the wave is steeper, but along the line where both meet */
    fill.noise = plane.spread = 0;
    upsample_on(&fill, i, p, &plane, &put);
    ck_assert_uint_le(put.n, before + before / 8 + 1);
}
END_TEST

/* A surface through all points near that swings 0.19 mm between them, as one of few may: places on
 * it are where it is said to be if it is certain, and as near to the points as noise lets them be
 * if not. */
START_TEST(on_a_surface_that_swings)
{
    const double swing = 0.5, noise = 0.01;
    struct error error;
    size_t middle = 0;
    for (int i = -4; i <= 4; i++)
        for (int k = -4; k <= 4; k++)
            *array_push(&scan) = vec(i, k, 0);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 1, 1, &point_grid, &error), 0);
    while (vec_length(point_grid.point[middle]) > 0)
        middle++;
    const struct upsample fill = {
        .point_grid = &point_grid, .radius = 4, .sink = 0.002, .noise = noise};
    struct upsample_surface surface = {
        .q = {.u = {1, 0, 0}, .v = {0, 1, 0}, .w = {0, 0, 1}, .c = {[1] = swing, [6] = -swing}}};
    for (int certain = 1; certain >= 0; certain--) {
        double highest = 0;
        put.n = 0;
        surface.q.variance = certain ? 0.1 : 0.5;
        upsample_on(&fill, middle, vec(0, 0, 0), &surface, &put);
        ck_assert_uint_gt(put.n, 20);
        for (size_t i = 0; i < put.n; i++)
            highest = fmax(highest, fabs(put.item[i].z));
        if (certain)
            ck_assert_double_gt(highest, 15 * noise);
        else
            ck_assert_double_le(highest, 4 * noise + 1e-9);
    }
}
END_TEST

/*
 * No point of a floor beyond its border by more than a part of a neighbourhood, as sure as any
 * surface; none where a cliff falls off, nor in the corner at its foot, but where a neighbourhood
 * across it looks smooth by chance: under 21 seeds in one scan of three, one, of eight points at
 * most; six in one scan are 1 : 100,000 by Poisson.
 *
 * In the border's corner, a quarter of the directions with 5 points to a mm2, sixteen points reach
 * 3.64 mm at most (3.93 r^2 - 5 sqrt(3.93 r^2) = 16), and a place d farther out has the first of
 * them within 0.4 of the last: d <= 0.4 (d + 3.64).
 */
START_TEST(none_beyond_a_border)
{
    struct error error;
    size_t above = 0;
    noisy_seed(5);
    for (int i = 0; i < 6000; i++) {
        double x = 40 * noisy_uniform(), y = 30 * noisy_uniform();
        double slope = x < 20 ? 0 : x < 22 ? 5 * (x - 20) : 10;
        *array_push(&scan) = vec(x, y, -slope);
    }
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.45, 1, &point_grid, &error), 0);
    struct upsample fill = {.point_grid = &point_grid, .radius = 5, .sink = 0.002};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    ck_assert_uint_gt(put.n, 6000);
    for (size_t i = 0; i < put.n; i++) {
        struct vec3 p = put.item[i];
        double slope = p.x < 20 ? 0 : p.x < 22 ? 5 * (p.x - 20) : 10;
        double out = fmax(fmax(-p.x, p.x - 40), fmax(-p.y, p.y - 30));
        double high = (p.z + slope) / (slope > 0 && slope < 10 ? sqrt(26) : 1);
        ck_assert_double_lt(out, 2.43);
        if (out > 0.05 && (p.x < 19 || p.x > 25))
            ck_assert_double_eq_tol(p.z, -slope, 5 * fill.sink);
        above += high > 0.15;
    }
    ck_assert_uint_le(above, 6 * 8);
}
END_TEST

enum { PITCH = 5, BEND = 32 };

/* Facets that touch a paraboloid 5 mm apart, and meet at 9 degrees. */
static double facets(double x, double y)
{
    double cx = PITCH * round(x / PITCH), cy = PITCH * round(y / PITCH);

    return (cx * cx + cy * cy - 2 * (cx * x + cy * y)) / (2 * BEND);
}

static double hollow_facets(double x, double y)
{
    return -facets(x, y);
}

static bool is_any_near(const struct vec3s *points, double x, double y)
{
    for (size_t i = 0; i < points->n; i++)
        if (hypot(points->item[i].x - x, points->item[i].y - y) < 0.4)
            return true;
    return false;
}

/* Of places amid the scan that no point is near, the share that nothing is put near. */
static double share_open(double (*height)(double x, double y))
{
    struct error error;
    size_t open = 0, between = 0;

    noisy_seed(3);
    noisy_scan(&scan, height, 6000, NOISY_LINES, 0.003);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.8, 1, &point_grid, &error), 0);
    struct upsample fill = {.point_grid = &point_grid, .radius = 3, .sink = 0.002, .lines = true};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    for (int i = -12; i <= 12; i++)
        for (int k = -12; k <= 12; k++) {
            bool far = !is_any_near(&scan, 1.1 * i, 1.1 * k);
            between += far;
            open += far && !is_any_near(&put, 1.1 * i, 1.1 * k);
        }
    free_all();
    return (double)open / (double)between;
}

/* No surface is borne out there by all, and yet the ball must not sink below the points; where it
 * is hollow these keep it off themselves. */
START_TEST(over_blunt_edges)
{
    ck_assert_double_lt(share_open(facets), 0.08); /* a third, without a second look */
    ck_assert_double_gt(share_open(hollow_facets), 0.2);
}
END_TEST

/* Of places amid a scan of points that are 0.8 mm apart, the share that is farther below. */
static double share_below(double (*height)(double x, double y), double far)
{
    const double spacing = 0.8;
    struct error error;
    size_t below = 0, n = 0;

    for (int j = -25; j <= 25; j++)
        for (int i = -25; i <= 25; i++)
            *array_push(&scan) = vec(spacing * i, spacing * j, height(spacing * i, spacing * j));
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, spacing, 1, &point_grid, &error), 0);
    struct upsample fill = {.point_grid = &point_grid, .radius = 3, .sink = 0.002};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    for (size_t i = 0; i < put.n; i++) {
        struct vec3 p = put.item[i];
        if (fmax(fabs(p.x), fabs(p.y)) > 15)
            continue;
        n++;
        below += height(p.x, p.y) - p.z > far;
    }
    ck_assert_uint_gt(n, 50000);
    free_all();
    return (double)below / (double)n;
}

/* Over an edge between points the facets beside it are continued, but for few corners: a surface
 * that bends goes up to 0.03 mm below it, and so did 10 and 3 % of the places. */
START_TEST(up_to_blunt_edges)
{
    ck_assert_double_lt(share_below(facets, 0.008), 0.04);
    ck_assert_double_lt(share_below(facets, 0.016), 0.008);
}
END_TEST

/* No place of the plane z = slope x, so far about the origin along x and y, is farther from those
 * that were put. */
static void check_filled(double slope, double wide, double deep, double most)
{
    for (double y = -deep; y <= deep; y += 0.1)
        for (double x = -wide; x <= wide; x += 0.05) {
            struct vec3 p = vec(x, y, slope * x);
            double least = HUGE_VAL;
            for (size_t k = 0; k < put.n; k++)
                least = fmin(least, vec_distance(put.item[k], p));
            ck_assert_double_le(least, most);
        }
}

/* Points so far apart let the ball sink as far as it may. */
static double gap_of(const struct upsample *fill)
{
    return sqrt(6 * fill->radius * fill->sink);
}

/* A flank of 72 degrees, scanned 0.5 mm apart from above, but for a hole: places are put as far as
 * the next points are, however many that makes; no ball touches the flank between them. */
START_TEST(far_from_a_point)
{
    const double spacing = 0.5, steep = 3;
    struct error error;

    for (int j = -12; j <= 12; j++)
        for (int i = -12; i <= 12; i++)
            if (abs(i) > 0 || abs(j) > 2)
                *array_push(&scan) = vec(spacing * i, spacing * j, steep * spacing * i);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, spacing, 1, &point_grid, &error), 0);
    struct upsample fill = {.point_grid = &point_grid, .radius = 3, .sink = 0.002};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    check_filled(steep, 0.4, 1.2, gap_of(&fill));
}
END_TEST

/* A hole that the ball is wider than, in a scan that is sparse for it, is filled, though those next
 * to it know nothing of what is beyond. */
START_TEST(hole_for_a_small_ball)
{
    const double noise = 0.02;
    struct error error;

    noisy_seed(7 + (unsigned)_i);
    while (scan.n < 640) {
        double x = 24 * (noisy_uniform() - 0.5), y = 24 * (noisy_uniform() - 0.5);
        if (hypot(x, y) > 1.9)
            *array_push(&scan) = vec(x, y, x + noise * noisy_normal());
    }
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 1, 1, &point_grid, &error), 0);
    struct upsample fill = {
        .point_grid = &point_grid, .radius = 2.2, .sink = 0.0025, .noise = noise};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    check_filled(1, 0.5, 0.5, 0.7); /* where the ball sinks 0.1 mm; 0.9 without */
}
END_TEST

/* Points on a line of a scan's border, eight times as close along it as the next line is: the
 * nearest are on two lines, which carry no surface. */
START_TEST(border_of_lines)
{
    struct error error;

    for (int j = 0; j <= 8; j++)
        for (int i = -96; i <= 96; i++)
            *array_push(&scan) = vec(i / 16.0, j / 2.0 - 0.25, 0.7 * i / 16.0);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.18, 1, &point_grid, &error), 0);
    struct upsample fill = {.point_grid = &point_grid, .radius = 0.5, .sink = 0.002, .lines = true};
    for (size_t i = 0; i < point_grid.n; i++)
        upsample_about(&fill, i, &put);
    check_filled(0.7, 4, 0.2, gap_of(&fill));
}
END_TEST

START_TEST(dense_enough)
{
    struct upsample fill = make_fill(20000, 100);
    fill.radius = 100;
    ck_assert(!upsample_needed(&fill));
    fill.radius = 4;
    ck_assert(upsample_needed(&fill));
}
END_TEST

/* Half way between points that are far apart for the ball a place is put, too; but about each of
 * many points no more than memory has room for. */
START_TEST(sparse_for_the_ball)
{
    static const struct {
        int n;
        double radius, least, most;
    } of[] = {{400, 0.5, 1.2, HUGE_VAL}, {20000, 0.02, 0.2, 0.37}};
    struct upsample fill = make_fill(of[_i].n, 100);
    double farthest = 0;
    fill.radius = of[_i].radius;
    for (size_t i = 0; i < point_grid.n; i += point_grid.n / 100) {
        struct vec3 p = point_grid.point[i];
        put.n = 0;
        upsample_about(&fill, i, &put);
        for (size_t k = 0; k < put.n && fabs(p.x) < 30 && fabs(p.y) < 20; k++)
            farthest = fmax(farthest, vec_distance(put.item[k], p));
    }
    ck_assert_double_gt(farthest, of[_i].least);
    ck_assert_double_lt(farthest, of[_i].most);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("upsample");
    TCase *tests = tcase_create("upsample");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_test(tests, on_the_surface);
    tcase_add_test(tests, on_a_surface_that_is_given);
    tcase_add_test(tests, on_a_surface_that_swings);
    tcase_add_test(tests, none_beyond_a_border);
    tcase_add_test(tests, far_from_a_point);
    tcase_add_loop_test(tests, hole_for_a_small_ball, 0, 8);
    tcase_add_test(tests, border_of_lines);
    tcase_add_test(tests, dense_enough);
    tcase_add_loop_test(tests, sparse_for_the_ball, 0, 2);
    tcase_add_test(tests, over_blunt_edges);
    tcase_add_test(tests, up_to_blunt_edges);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
