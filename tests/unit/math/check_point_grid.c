/* point_grid: nearest points against going through all of them, the order of the file, taking out.
 */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/point_grid.h"
#include "seed.h"

enum { N = 3000 };

static uint64_t state;
static struct vec3 point[N];
static struct point_grid point_grid;
static struct error error;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* 0 a sheet, 1 sheet and wall, 2 on a raster (many equally near), 3 a sheet and three points far
 * off, 4 a narrow band from corner to corner. */
static void make_points(int kind)
{
    state = 5;
    for (int i = 0; i < N; i++) {
        double x = 60 * uniform(), y = 40 * uniform(), z = uniform();
        if (kind == 1 && i % 3 == 0)
            x = 30, z *= 40;
        if (kind == 2)
            x = floor(x), y = floor(y), z = 0;
        if (kind == 3 && i < 3)
            x = 1e7 * (i - 1), y = 3e6, z = 1e4;
        if (kind == 4)
            y = x + 0.1 * y;
        point[i] = vec(x, y, z);
    }
    ck_assert_int_eq(point_grid_make(point, N, 0.9, 2, &point_grid, &error), 0);
}

static void free_all(void)
{
    point_grid_free(&point_grid);
}

static double distance2(struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(a, b);
    return vec_dot(d, d);
}

/* The k-th nearest by counting: no more than k stand before it, and it belongs to them. */
static void check_nearest(struct vec3 q, size_t k)
{
    uint32_t index[N];
    double found[N];
    size_t n = point_grid_nearest(&point_grid, q, k, index, found);
    ck_assert_uint_eq(n, k < N ? k : N);
    for (size_t i = 0; i < n; i++) {
        size_t before = 0;
        ck_assert(found[i] == distance2(point[index[i]], q));
        for (uint32_t j = 0; j < N; j++) {
            double d2 = distance2(point[j], q);
            before += d2 < found[i] || (d2 <= found[i] && j < index[i]);
        }
        ck_assert_uint_eq(before, i);
    }
}

START_TEST(nearest)
{
    make_points(_i);
    for (int i = 0; i < 12; i++)
        check_nearest(point[(size_t)(uniform() * N)], 1 + (size_t)i * 5);
    check_nearest(vec(-50, 20, 3), 7); /* from outside */
    check_nearest(vec(100, 90, -30), 20);
    check_nearest(vec(30, 20, 500), 3);
    check_nearest(vec(30, 20, 0), 2 * N);
}
END_TEST

START_TEST(cells_hold_their_points)
{
    make_points(_i);
    size_t cells = point_grid.columns * point_grid.rows;
    ck_assert_uint_eq(point_grid.first[0], 0);
    ck_assert_uint_eq(point_grid.first[cells], N);
    ck_assert_uint_le(cells, N + 64);
    for (size_t c = 0; c < cells; c++)
        for (uint32_t i = point_grid.first[c]; i < point_grid.first[c + 1]; i++) {
            ck_assert_uint_eq(point_grid_row(&point_grid, point[i].y), c / point_grid.columns);
            ck_assert_uint_eq(point_grid_column(&point_grid, point[i].x), c % point_grid.columns);
        }
}
END_TEST

START_TEST(order_of_the_file_does_not_matter)
{
    struct vec3 first[N];
    make_points(_i);
    memcpy(first, point, sizeof first);
    point_grid_free(&point_grid);
    for (size_t i = N - 1; i > 0; i--) {
        size_t j = (size_t)(uniform() * (double)(i + 1));
        struct vec3 t = point[i];
        point[i] = point[j];
        point[j] = t;
    }
    ck_assert_int_eq(point_grid_make(point, N, 0.9, 1, &point_grid, &error), 0);
    ck_assert_mem_eq(first, point, sizeof first);
}
END_TEST

START_TEST(take_out)
{
    unsigned char out[N];
    make_points(0);
    size_t left = 0;
    double x = 0;
    for (int i = 0; i < N; i++) {
        out[i] = uniform() < 0.3;
        left += !out[i];
        x += out[i] ? 0 : point[i].x;
    }
    point_grid_remove(&point_grid, out);
    ck_assert_uint_eq(point_grid.n, left);
    for (size_t i = 0; i < left; i++)
        x -= point[i].x;
    ck_assert_double_eq_tol(x, 0, 1e-7);
    for (size_t c = 0; c < point_grid.columns * point_grid.rows; c++)
        for (uint32_t i = point_grid.first[c]; i < point_grid.first[c + 1]; i++)
            ck_assert_uint_eq(point_grid_row(&point_grid, point[i].y), c / point_grid.columns);
    uint32_t index;
    double d2;
    for (size_t i = 0; i < left; i += 97) {
        ck_assert_uint_eq(point_grid_nearest(&point_grid, point[i], 1, &index, &d2), 1);
        ck_assert_uint_eq(index, i);
    }
}
END_TEST

START_TEST(nothing)
{
    ck_assert_int_eq(point_grid_make(point, 0, 1, 1, &point_grid, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "0 points"));
    point_grid.first = NULL;
}
END_TEST

/* Of so many points three quarters lie so close that none of the parts they are sorted in is copied
 * whole: the same cells, and the same order for another order of the file and number of threads. */
START_TEST(crowded)
{
    enum { MANY = 200000 };
    struct vec3 *many = malloc(MANY * sizeof *many), *other = malloc(MANY * sizeof *other);
    struct point_grid again;
    state = 7;
    for (int i = 0; i < MANY; i++) {
        bool crowd = i % 4 > 0;
        many[i] = vec((crowd ? 50 : 1000) * uniform(), (crowd ? 5 : 1000) * uniform(), uniform());
        other[MANY - 1 - i] = many[i];
    }
    ck_assert_int_eq(point_grid_make(many, MANY, 0.9, 2, &point_grid, &error), 0);
    ck_assert_int_eq(point_grid_make(other, MANY, 0.9, 1, &again, &error), 0);
    ck_assert_mem_eq(many, other, MANY * sizeof *many);
    size_t cells = point_grid.columns * point_grid.rows;
    ck_assert_mem_eq(point_grid.first, again.first, (cells + 1) * sizeof *again.first);
    ck_assert_uint_eq(point_grid.first[cells], MANY);
    for (size_t c = 0; c < cells; c++)
        for (uint32_t i = point_grid.first[c]; i < point_grid.first[c + 1]; i++) {
            ck_assert_uint_eq(point_grid_row(&point_grid, many[i].y), c / point_grid.columns);
            ck_assert_uint_eq(point_grid_column(&point_grid, many[i].x), c % point_grid.columns);
            if (i > point_grid.first[c])
                ck_assert_int_le(vec_compare(&many[i - 1], &many[i]), 0);
        }
    point_grid_free(&again);
    /* in order already: they stay as they are */
    ck_assert_int_eq(point_grid_make(other, MANY, 0.9, 1, &again, &error), 0);
    ck_assert_mem_eq(many, other, MANY * sizeof *many);
    ck_assert_mem_eq(point_grid.first, again.first, (cells + 1) * sizeof *again.first);
    point_grid_free(&again);
    free(many);
    free(other);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("point_grid");
    TCase *tests = tcase_create("point_grid");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, nearest, 0, 5);
    tcase_add_loop_test(tests, cells_hold_their_points, 0, 5);
    tcase_add_loop_test(tests, order_of_the_file_does_not_matter, 0, 5);
    tcase_add_test(tests, take_out);
    tcase_add_test(tests, crowded);
    tcase_add_test(tests, nothing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
