/*
 * verify_surface: of points about a known surface what is off it is taken out, noise too, and what
 * lies under a roof is marked; no point, and a scan that is believed as it is.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/settle.h"
#include "cloud/steep_facets.h"
#include "math/kdtree.h"
#include "noisy.h"
#include "verify/verify.h"

enum { POINTS = 6000, STRAYS = 12 };

static double bowl(double x, double y)
{
    return (x * x + y * y) / 160;
}

/* Its distance to first order. */
static double off_bowl(struct vec3 p)
{
    return (p.z - bowl(p.x, p.y)) * noisy_up(bowl, p.x, p.y).z;
}

static struct vec3s point;
static struct verify_surface surface;
static struct error error;

static void setup(void)
{
    point = (struct vec3s){0};
    surface = (struct verify_surface){0};
}

static void teardown(void)
{
    verify_surface_free(&surface);
    array_free(&point);
}

static int find(double noise, int threads)
{
    return verify_surface_find(&point, noise, 3, threads, &surface, &error);
}

static double rms_off(void)
{
    double sum2 = 0;
    for (size_t i = 0; i < point.n; i++)
        sum2 += off_bowl(point.item[i]) * off_bowl(point.item[i]);
    return sqrt(sum2 / (double)point.n);
}

/* Strays 5 to 9 mm above are gone, and no other point (of a hundred one may happen to lie where a
 * flank continued would be: two are allowed); the noise is known to a tenth, and of what is left, a
 * fit to the points about each, less than half stays. */
START_TEST(strays_and_noise)
{
    const double sigma = 0.02 * (_i / 2);
    noisy_seed(4);
    noisy_scan(&point, bowl, POINTS, NOISY_RANDOM, sigma);
    size_t n = point.n;
    struct vec3s strays = {0};
    for (int i = 0; i < STRAYS; i++) {
        struct vec3 *p = &point.item[(2 * (size_t)i + 1) * n / (2 * STRAYS)];
        p->z += 5 + 4 * noisy_uniform();
        *array_push(&strays) = *p;
    }
    ck_assert_int_eq(find(-1, 1 + _i % 2), 0);
    ck_assert_uint_ge(surface.outliers.n, STRAYS - 2);
    ck_assert_uint_eq(point.n, n - surface.outliers.n);
    for (size_t i = 0, k = 0; i < surface.outliers.n; i++, k++) { /* in the order of the points */
        while (k < STRAYS && vec_distance(surface.outliers.item[i], strays.item[k]) > 0)
            k++;
        ck_assert_uint_lt(k, STRAYS);
    }
    ck_assert_double_le(fabs(surface.noise - sigma), 0.1 * sigma);
    ck_assert_double_eq(surface.sheets, 0);
    if (surface.outliers.n == STRAYS)
        ck_assert_double_le(rms_off(), 0.5 * sigma + 1e-12);
    for (size_t i = 0; i < point.n; i++)
        ck_assert(!surface.under[i]);
    array_free(&strays);
}
END_TEST

/* Noise 0: every point is as it was, in any order; noise said: that is taken. */
START_TEST(as_it_is_said)
{
    noisy_seed(5);
    noisy_scan(&point, bowl, POINTS, NOISY_GRID, 0.02);
    point.item[1000].z += 7;
    size_t n = point.n;
    double before = rms_off();
    ck_assert_int_eq(find(0, 1), 0);
    ck_assert_uint_eq(point.n, n);
    ck_assert_uint_eq(surface.outliers.n, 0);
    ck_assert_double_eq(surface.noise, 0);
    ck_assert_double_eq_tol(rms_off(), before, 1e-12);
    verify_surface_free(&surface);
    ck_assert_ptr_null(surface.under);
    ck_assert_int_eq(find(0.03, 1), 0);
    ck_assert_double_eq(surface.noise, 0.03);
    ck_assert_uint_eq(surface.outliers.n, 1);
    ck_assert_uint_eq(point.n, n - 1);
    ck_assert_double_le(rms_off(), 0.5 * before);
}
END_TEST

START_TEST(hardly_a_point)
{
    ck_assert_int_eq(find(-1, 2), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found 0 points"));
    for (int i = 0; i < 3; i++) /* a point, twice, and two in one place seen from above */
        *array_push(&point) = vec(1, 2, i < 2 ? 3 : 4);
    ck_assert_int_eq(find(-1, 1), 0);
    ck_assert_uint_eq(point.n + surface.outliers.n, 3);
    for (size_t i = 0; i < point.n; i++)
        ck_assert(!surface.under[i]);
}
END_TEST

/* A floor under a roof that is wider all round: what is under it, away from its border by a cell
 * and more, is out of reach, and all others are not. */
START_TEST(under_a_roof)
{
    for (double y = -10; y <= 10; y += 0.25)
        for (double x = -10; x <= 10; x += 0.25) {
            *array_push(&point) = vec(x, y, 0);
            if (fabs(x) < 4 && fabs(y) < 4)
                *array_push(&point) = vec(x + 0.1, y + 0.1, 8);
        }
    ck_assert_int_eq(find(0, 2), 0);
    size_t under = 0, inner = 0;
    for (size_t i = 0; i < point.n; i++) {
        struct vec3 p = point.item[i];
        bool within = p.z < 4 && fabs(p.x) < 3 && fabs(p.y) < 3;
        inner += within;
        under += within && surface.under[i];
        ck_assert(!surface.under[i] || (p.z < 4 && fabs(p.x) < 4.2 && fabs(p.y) < 4.2));
    }
    ck_assert_uint_gt(inner, 500);
    ck_assert_uint_eq(under, inner);
}
END_TEST

/* Beyond a rim a slope goes on, which keeps a ball off as it does for who makes the path; a plate
 * ends. */
START_TEST(beyond_a_rim)
{
    const double slope = _i;

    for (int i = 0; i <= 40; i++)
        for (int k = 0; k <= 40; k++)
            *array_push(&point) = vec(i / 4.0, k / 4.0, -slope * i / 4.0);
    ck_assert_int_eq(find(0, 1), 0);
    size_t on = 0, off = 0;
    for (size_t i = 0; i < surface.curtain.n; i++) {
        struct vec3 p = surface.curtain.item[i];
        bool beyond = p.x > 10.01 && p.y > 1 && p.y < 9;
        on += beyond && fabs(p.z + slope * p.x) < 0.01;
        off += beyond && p.z > -slope * p.x + 0.01;
    }
    ck_assert(slope > 0 ? on > 30 : on == 0);
    ck_assert_uint_eq(off, 0);
}
END_TEST

/* A head over shoulders that slope, as a scanner above sees it. */
static double bust(double x, double y)
{
    double r = hypot(x, y);

    return r < 12 ? 30 + sqrt(144 - r * r) : 12 - 0.8 * (r - 12) + 0.4 * cos(x);
}

static const double SPACING = 0.6, BALL = 3, NOISE = 0.03;

static void scan_bust(unsigned seed)
{
    noisy_seed(seed);
    for (int i = 0; i < (int)(40 * 40 / (SPACING * SPACING)); i++) {
        double x = 40 * noisy_uniform() - 20, y = 40 * noisy_uniform() - 20;
        *array_push(&point) = vec(x + NOISE * noisy_normal(), y + NOISE * noisy_normal(),
                                  bust(x, y) + NOISE * noisy_normal());
    }
}

/* Places on steep facets of the scan, its points where they are without noise. */
static struct kdtree *facets_of(const struct vec3s *scan)
{
    struct vec3s made = {0};
    struct point_grid grid;
    struct vec3 *as_is = mem_alloc(scan->n, sizeof *as_is),
                *place = mem_alloc(scan->n, sizeof *place);
    const struct steep_facets_options options = {
        .place = place, .radius = BALL, .sink = 0.002, .noise = NOISE, .threads = 1};

    memcpy(as_is, scan->item, scan->n * sizeof *as_is);
    ck_assert_int_eq(point_grid_make(as_is, scan->n, SPACING, 1, &grid, &error), 0);
    for (size_t i = 0; i < scan->n; i++)
        place[i] = settle_point(&grid, NOISE, grid.point[i]);
    steep_facets(&grid, &options, &made);
    struct kdtree *tree = kdtree_new(made.item, made.n);
    point_grid_free(&grid);
    array_free(&made);
    free(place);
    free(as_is);
    return tree;
}

/* Who judges finds a ball between points of a flank only on facets that it was kept off, though he
 * moves the points to where they are without noise: of those moved others would meet, where the
 * head stands far over the shoulders. */
START_TEST(flanks_as_scanned)
{
    size_t astray = 0;

    scan_bust(7 + (unsigned)_i);
    struct kdtree *tree = facets_of(&point);
    ck_assert_int_eq(find(NOISE, 1), 0);
    for (size_t k = 0; k < surface.steep.n; k++)
        astray +=
            !kdtree_any_beside(tree, surface.steep.item[k], surface.steep.item[k], SPACING / 2);
    ck_assert_uint_gt(surface.steep.n, 100);
    ck_assert_uint_eq(astray, 0);
    kdtree_free(tree);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verify_surface");
    TCase *tests = tcase_create("verify_surface");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_loop_test(tests, strays_and_noise, 0, 4);
    tcase_add_test(tests, as_it_is_said);
    tcase_add_test(tests, hardly_a_point);
    tcase_add_test(tests, under_a_roof);
    tcase_add_loop_test(tests, beyond_a_rim, 0, 2);
    tcase_add_loop_test(tests, flanks_as_scanned, 0, 4);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
