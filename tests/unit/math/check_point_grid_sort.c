/* point_grid_sort: the cells, and the order in them, for any order of the file and any number of
 * threads. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "grid_points.h"

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
    Suite *suite = suite_create("point_grid_sort");
    TCase *tests = tcase_create("point_grid_sort");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, order_of_the_file_does_not_matter, 0, 5);
    tcase_add_test(tests, crowded);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
