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
    tcase_add_test(tests, nothing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
