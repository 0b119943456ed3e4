/* check_stock_rest - thickness of stock on planes and spheres; blocks around parts. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/stock_block.h"
#include "simulate/stock_rest.h"

/* Points of z = height(x, y) over a square of +-10, `gap` mm apart. */
static struct vec3s surface(double (*height)(double x, double y), double gap)
{
    struct vec3s points = {0};
    int n = (int)(20 / gap + 0.5);
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++) {
            double x = -10 + i * gap, y = -10 + j * gap;
            *array_push(&points) = vec(x, y, height(x, y));
        }
    return points;
}

static double plane(double x, double y)
{
    return 0.5 * x - 0.3 * y;
}

static double dome(double x, double y)
{
    return sqrt(30 * 30 - x * x - y * y) - 30;
}

static double bowl(double x, double y)
{
    return 25 - sqrt(25 * 25 - x * x - y * y);
}

/* An offset along the normal is found again as thickness, on planes and where they curve. */
static const struct {
    double (*height)(double x, double y);
    double offset, within;
} offsets[] = {{plane, 1, 1e-6},  {dome, 0.5, 2e-3}, {dome, 3, 2e-3},
               {bowl, 0.5, 2e-3}, {bowl, 2, 3e-3},   {dome, 0.05, 2e-3}};

START_TEST(offset_is_thickness)
{
    struct vec3s points = surface(offsets[_i].height, 0.25);
    struct stock_options spec = {.kind = STOCK_OFFSET, .allowance = offsets[_i].offset};
    struct stock s = stock_new(&spec, points.item, points.n, 0.1);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        if (fmax(fabs(p.x), fabs(p.y)) < 7)
            ck_assert_double_eq_tol(stock_rest_at(&s, p), offsets[_i].offset, offsets[_i].within);
    }
    stock_free(&s);
    array_free(&points);
}
END_TEST

/* The volume between a sphere and its offset. */
START_TEST(volume_of_an_offset)
{
    struct vec3s points = surface(dome, 0.25);
    struct stock_options spec = {.kind = STOCK_OFFSET, .allowance = 1};
    double want = 0, got = 0;
    struct stock s = stock_new(&spec, points.item, points.n, 0.1);
    for (int j = 0; j < s.ny; j++)
        for (int i = 0; i < s.nx; i++) {
            double x = stock_x(&s, i), y = stock_y(&s, j);
            if (fmax(fabs(x), fabs(y)) > 8)
                continue;
            want += sqrt(31 * 31 - x * x - y * y) - 30;
            got += stock_at(&s, i, j)->high;
        }
    ck_assert_double_eq_tol(got * s.dx * s.dy, want * s.dx * s.dy, 0.2);
    stock_free(&s);
    array_free(&points);
}
END_TEST

static double ridge(double x, double y)
{
    return -fabs(x) + 0 * y;
}

/* Over a ridge the balls of the allowance stand highest that stand on it: it becomes round. */
START_TEST(a_ridge_is_rounded)
{
    const double allowance[] = {1, 6};
    struct vec3s points = surface(ridge, 0.25);
    struct stock_options spec = {.kind = STOCK_OFFSET, .allowance = allowance[_i]};
    struct stock s = stock_new(&spec, points.item, points.n, 0.1);
    double side = sqrt(0.5) * allowance[_i]; /* from here on it is the side that is offset */
    for (int j = 0; j < s.ny; j++)
        for (int i = 0; i < s.nx; i++) {
            double x = fabs(stock_x(&s, i)), y = stock_y(&s, j);
            if (fmax(x, fabs(y)) > 5)
                continue;
            double r2 = allowance[_i] * allowance[_i];
            double z = x < side ? sqrt(r2 - x * x) : sqrt(2 * r2) - x;
            ck_assert_double_eq_tol(stock_at(&s, i, j)->high, z, 0.1);
        }
    stock_free(&s);
    array_free(&points);
}
END_TEST

START_TEST(boxes)
{
    struct vec3s points = surface(plane, 1);
    struct stock_options around = {.kind = STOCK_AROUND, .allowance = 2};
    struct stock s = stock_new(&around, points.item, points.n, 0.5);
    ck_assert_double_eq_tol(stock_volume(&s), 24 * 24 * (16 + 2), 1e-6);
    ck_assert_double_eq(s.bottom, -8);
    ck_assert_double_eq_tol(stock_x(&s, 0), -12 + 0.25, 1e-12);
    stock_free(&s);
    struct stock_options between = {.kind = STOCK_BETWEEN, .low = {1, 2, 3}, .high = {4, 6, 8}};
    s = stock_new(&between, points.item, points.n, 0.5);
    ck_assert_double_eq_tol(stock_volume(&s), 3 * 4 * 5, 1e-6);
    stock_free(&s);
    ck_assert_double_eq_tol(stock_cell(&around, points.item, points.n, 1), 24.0 / 500, 1e-12);
    ck_assert_double_eq_tol(stock_cell(&around, points.item, points.n, 4), 4.0 / 25, 1e-12);
    array_free(&points);
}
END_TEST

/* Grooves in a flat top: the sum follows, percentiles and worst are those of all points. */
static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double flat(double x, double y)
{
    return -4 + 0 * x * y;
}

START_TEST(update_follows_the_cut)
{
    struct vec3s points = surface(flat, 0.25);
    double *thick = mem_alloc(points.n, sizeof *thick);
    struct stock s = stock_box(vec(-10, -10, -6), vec(10, 10, 0), 0.1);
    struct stock_rest left = stock_rest_new(points.item, points.n, &s);
    ck_assert_double_eq_tol(stock_rest_update(&left, &s).worst, 4, 1e-6);
    for (int k = 0; k < 8; k++) {
        double y = -9 + 2.2 * k;
        stock_capsule(&s, vec(-20, y, 0), vec(20, y + 1, 0), 3, 1);
        struct stock_rest_sum sum = stock_rest_update(&left, &s);
        for (size_t i = 0; i < points.n; i++)
            thick[i] = stock_rest_at(&s, points.item[i]);
        qsort(thick, points.n, sizeof *thick, compare);
        ck_assert_double_eq_tol(sum.worst, thick[points.n - 1], 1e-6);
        ck_assert_double_eq_tol(stock_rest_at(&s, sum.at), sum.worst, 1e-6);
        ck_assert_double_eq_tol(sum.part[0], thick[(points.n - 1) / 2], 1e-3);
        ck_assert_double_eq_tol(sum.part[2], thick[(size_t)(0.99 * (double)(points.n - 1) + 0.5)],
                                1e-3);
    }
    stock_rest_free(&left);
    stock_free(&s);
    array_free(&points);
    free(thick);
}
END_TEST

/* Under a roof the stock's upper side is not what stands on the point. */
START_TEST(under_a_roof)
{
    struct stock s = stock_box(vec(-5, -5, -10), vec(5, 5, 10), 0.1);
    stock_capsule(&s, vec(-9, 0, 0), vec(9, 0, 0), 3, 1);
    ck_assert_double_eq_tol(stock_rest_at(&s, vec(0, 0, -4)), 1, 2e-3);
    ck_assert_double_eq_tol(stock_rest_at(&s, vec(0.03, 1, -4)), hypot(4, 1) - 3, 2e-3);
    ck_assert_double_eq(stock_rest_at(&s, vec(0, 0, 0)), 0);
    stock_free(&s);
}
END_TEST

/* What lies under the part is not asked. */
START_TEST(points_under_the_part)
{
    struct vec3s points = surface(flat, 0.5);
    size_t n = points.n;
    for (size_t i = 0; i < n; i++) {
        struct vec3 below = vec_add(points.item[i], vec(0, 0, -3));
        *array_push(&points) = below;
    }
    struct stock s = stock_box(vec(-10, -10, -8), vec(10, 10, 0), 0.2);
    struct stock_rest left = stock_rest_new(points.item, points.n, &s);
    ck_assert_uint_eq(left.points, n);
    ck_assert_double_eq_tol(stock_rest_update(&left, &s).worst, 4, 1e-6);
    stock_rest_free(&left);
    stock_free(&s);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stock_rest");
    TCase *tcase = tcase_create("stock_rest");
    tcase_add_loop_test(tcase, offset_is_thickness, 0, (int)(sizeof offsets / sizeof *offsets));
    tcase_add_loop_test(tcase, a_ridge_is_rounded, 0, 2);
    tcase_add_test(tcase, volume_of_an_offset);
    tcase_add_test(tcase, boxes);
    tcase_add_test(tcase, update_follows_the_cut);
    tcase_add_test(tcase, under_a_roof);
    tcase_add_test(tcase, points_under_the_part);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
