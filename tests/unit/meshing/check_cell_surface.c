/* cell_surface: how far a scan of a known surface is from places above and below it. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "meshing/cell_surface.h"

static struct vec3s points;
static struct point_grid grid;
static struct error error;

static void teardown(void)
{
    point_grid_free(&grid);
    array_free(&points);
}

/* A sphere of radius 50 about 0 0 -50: a place's distance is that to its centre less 50. */
START_TEST(sphere)
{
    for (int j = -20; j <= 20; j++)
        for (int i = -20; i <= 20; i++) {
            double x = 0.5 * i + 0.05 * (j % 3), y = 0.5 * j + 0.05 * (i % 3);
            *array_push(&points) = vec(x, y, sqrt(2500 - x * x - y * y) - 50);
        }
    ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &grid, &error), 0);
    for (int threads = 1; threads < 3; threads++) {
        struct cell_surfaces c = cell_surfaces_make(&grid, threads);
        size_t fitted = 0, held = 0;
        for (size_t k = 0; k < grid.columns * grid.rows; k++) {
            fitted += c.fitted[k];
            held += grid.first[k] < grid.first[k + 1];
        }
        ck_assert_uint_gt(fitted, held / 2);
        for (int i = -16; i <= 16; i++) {
            for (double off = -0.1; off < 0.11; off += 0.05) {
                double x = 0.49 * i, y = -0.33 * i;
                struct vec3 out = vec_unit(vec(x, y, sqrt(2500 - x * x - y * y)));
                struct vec3 at = vec_along(vec(0, 0, -50), 50 + off, out);
                ck_assert_double_eq_tol(cell_surfaces_off(&c, at), fabs(off), 2e-4);
            }
        }
        cell_surfaces_free(&c);
    }
}
END_TEST

/* Steps of 3 leave much of any cubic: no cell beside them has one, and the nearest points tell. */
START_TEST(steps)
{
    for (int j = 0; j < 40; j++)
        for (int i = 0; i < 40; i++)
            *array_push(&points) = vec(0.5 * i, 0.5 * j, i < 20 ? 0 : 3);
    ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &grid, &error), 0);
    struct cell_surfaces c = cell_surfaces_make(&grid, 1);
    size_t row = point_grid_row(&grid, 10);
    ck_assert(!c.fitted[row * grid.columns + point_grid_column(&grid, 9.75)]);
    ck_assert(c.fitted[row * grid.columns + point_grid_column(&grid, 4)]);
    ck_assert(c.fitted[row * grid.columns + point_grid_column(&grid, 16)]);
    ck_assert_double_eq_tol(cell_surfaces_off(&c, vec(4, 10, 0.25)), 0.25, 1e-9);
    ck_assert_double_eq_tol(cell_surfaces_off(&c, vec(16, 10, 2.75)), 0.25, 1e-9);
    cell_surfaces_free(&c);
}
END_TEST

/* Too few for any fit: their plane, z = x / 2. */
START_TEST(few)
{
    for (int i = 0; i < 4; i++)
        *array_push(&points) = vec(i % 2, i / 2, 0.5 * (i % 2));
    ck_assert_int_eq(point_grid_make(points.item, points.n, 1, 1, &grid, &error), 0);
    struct cell_surfaces c = cell_surfaces_make(&grid, 1);
    ck_assert_double_eq_tol(cell_surfaces_off(&c, vec(0.5, 0.5, 1.25)), 1 / sqrt(1.25), 1e-12);
    cell_surfaces_free(&c);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cell_surface");
    TCase *tests = tcase_create("cell_surface");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, sphere);
    tcase_add_test(tests, steps);
    tcase_add_test(tests, few);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
