/* grid: paper 1, eqs 2 to 6, worked out by hand, and that the grid covers its cloud. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "meshing/grid.h"

static struct plan_extent box(double width, double height)
{
    return (struct plan_extent){1, 0, 10, 10 + width, -5, -5 + height};
}

START_TEST(corner_and_counts)
{
    struct grid g;
    struct error error;
    double height = 9 * sqrt(3); /* leans over by 9; rows are 2 sqrt(3) apart at t = 4 */
    struct plan_extent f = box(31, height);
    ck_assert_int_eq(grid_make(&f, 1000, 4, &g, &error), 0);
    ck_assert_double_eq_tol(g.x, 10 - 9, 1e-12); /* eq 2 */
    ck_assert_double_eq_tol(g.y, -5, 1e-12);
    ck_assert_int_eq(g.rows, 5 + 1);     /* eq 6: h = 4.5, rounded up, and the lowest */
    ck_assert_int_eq(g.columns, 10 + 1); /* 31 + 9 = 40 = 10 t exactly: no column more */
    ck_assert_uint_eq(grid_nodes(&g), 66);
    struct vec3 node = grid_node(&g, 3, 2); /* 3 e1 + 2 e2 */
    ck_assert_double_eq_tol(node.x, 1 + 12 + 4, 1e-12);
    ck_assert_double_eq_tol(node.y, -5 + 4 * sqrt(3), 1e-12);
}
END_TEST

/* All sides of the triangles are t. */
START_TEST(equilateral)
{
    struct grid g;
    struct error error;
    struct plan_extent f = box(20, 20);
    ck_assert_int_eq(grid_make(&f, 1000, 1.7, &g, &error), 0);
    struct vec3 a = grid_node(&g, 4, 5), b = grid_node(&g, 5, 5), c = grid_node(&g, 4, 6);
    ck_assert_double_eq_tol(vec_distance(a, b), 1.7, 1e-12);
    ck_assert_double_eq_tol(vec_distance(b, c), 1.7, 1e-12);
    ck_assert_double_eq_tol(vec_distance(c, a), 1.7, 1e-12);
}
END_TEST

/* The box lies inside the parallelogram of the nodes, whatever its shape. */
START_TEST(covers)
{
    struct error error;
    for (double width = 0.1; width < 300; width *= 1.7)
        for (double height = 0.1; height < 300; height *= 1.9) {
            struct plan_extent f = box(width, height);
            struct grid g;
            ck_assert_int_eq(grid_make(&f, 1000000, 3, &g, &error), 0);
            struct vec3 low = grid_node(&g, 0, 0), last = grid_node(&g, g.columns - 1, g.rows - 1);
            double lean = height / sqrt(3), above = last.y - f.ymax;
            ck_assert_double_eq_tol(low.y, f.ymin, 1e-12);
            ck_assert(above >= -1e-8 && above < 3);
            /* left side at the height of the top left corner, right side at the bottom right one */
            ck_assert_double_eq_tol(low.x + lean, f.xmin, 1e-9);
            ck_assert_double_ge(grid_node(&g, g.columns - 1, 0).x, f.xmax - 1e-8);
        }
}
END_TEST

START_TEST(absurd)
{
    struct grid g;
    struct error error;
    struct plan_extent far = box(9e8, 9e8), wide = box(100, 100);
    ck_assert_int_eq(grid_make(&far, 601, 4, &g, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "spacing 4 mm"));
    ck_assert_ptr_nonnull(strstr(error.text, "9e+08 x 9e+08 mm"));
    ck_assert_int_eq(grid_make(&wide, 601, 1e-300, &g, &error), -1);
    ck_assert_int_eq(grid_make(&wide, 100000000, 0.001, &g, &error), -1); /* 1.8e10 nodes */
    ck_assert_int_eq(grid_make(&wide, 3, 1e300, &g, &error), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("grid");
    TCase *tests = tcase_create("grid");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, corner_and_counts);
    tcase_add_test(tests, equilateral);
    tcase_add_test(tests, covers);
    tcase_add_test(tests, absurd);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
