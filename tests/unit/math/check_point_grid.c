/* point_grid: every point is in the cell it lies in, taking out, none at all. */
#include <check.h>
#include <string.h>

#include "grid_points.h"

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

/* Some of the points, sorted into the cells of all: these cells hold what they hold of all points,
 * in the same order. */
START_TEST(some_in_the_cells_of_all)
{
    static struct vec3 some[N];
    struct point_grid part;
    size_t n = 0;
    make_points(0);
    struct vec3 low = point[0], high = point[0];
    for (int i = 0; i < N; i++) {
        low = vec(fmin(low.x, point[i].x), fmin(low.y, point[i].y), 0);
        high = vec(fmax(high.x, point[i].x), fmax(high.y, point[i].y), 0);
    }
    struct point_grid cells = point_grid_lattice(low, high, N, point_grid_spacing(&point_grid));
    ck_assert_uint_eq(cells.columns, point_grid.columns);
    ck_assert_uint_eq(cells.rows, point_grid.rows);
    size_t from = cells.rows / 3, to = cells.rows / 2;
    for (int i = N; i-- > 0;)
        if (point_grid_row(&cells, point[i].y) >= from && point_grid_row(&cells, point[i].y) <= to)
            some[n++] = point[i];
    ck_assert_uint_gt(n, 10);
    ck_assert_int_eq(point_grid_make_in(&cells, some, n, 2, &part, &error), 0);
    for (size_t c = 0; c < cells.columns * cells.rows; c++) {
        bool here = c / cells.columns >= from && c / cells.columns <= to;
        uint32_t first = point_grid.first[c], k = point_grid.first[c + 1] - first;
        ck_assert_uint_eq(part.first[c + 1] - part.first[c], here ? k : 0);
        for (uint32_t i = 0; here && i < k; i++) {
            ck_assert_int_eq(vec_compare(&some[part.first[c] + i], &point[first + i]), 0);
            ck_assert_uint_eq(point_grid_cell(&part, point[first + i]), c);
        }
    }
    point_grid_free(&part);
    ck_assert_int_eq(point_grid_make_in(&cells, some, 0, 1, &part, &error), -1);
}
END_TEST

/* A box that is mostly empty: no more cells than four a point. */
START_TEST(a_wide_box)
{
    struct point_grid cells = point_grid_lattice(vec(-1e9, -1e9, 0), vec(1e9, 1e9, 0), 1000, 1);
    ck_assert_uint_le(cells.columns * cells.rows, 4064);
    ck_assert_uint_ge(cells.columns * cells.rows, 900);
    ck_assert_ptr_null(cells.first);
}
END_TEST

START_TEST(nothing)
{
    ck_assert_int_eq(point_grid_make(point, 0, 1, 1, &point_grid, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "0 points"));
    point_grid.first = NULL;
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("point_grid");
    TCase *tests = tcase_create("point_grid");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, cells_hold_their_points, 0, 5);
    tcase_add_test(tests, take_out);
    tcase_add_test(tests, some_in_the_cells_of_all);
    tcase_add_test(tests, a_wide_box);
    tcase_add_test(tests, nothing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
