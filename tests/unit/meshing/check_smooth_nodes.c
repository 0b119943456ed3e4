/* smooth_nodes: vertices and normals on known surfaces from noisy scans of every pattern. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "meshing/grid_mesh.h"
#include "noisy.h"
#include "panel.h"
#include "meshing/reposition.h"
#include "meshing/smooth_nodes.h"

static struct vec3s scan;
static struct mesh mesh;
static struct point_grid point_grid;

static void make_scan(double (*height)(double, double), enum noisy_pattern pattern, double sigma,
                      double t)
{
    struct error error;
    struct grid g;
    noisy_seed(21);
    noisy_scan(&scan, height, 17000, pattern, sigma);
    struct plan_extent f = plan_extent_of(scan.item, scan.n, 0);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.48, 1, &point_grid, &error), 0);
    ck_assert_int_eq(grid_make(&f, scan.n, t, &g, &error), 0);
    size_t *chosen = reposition(&g, scan.item, scan.n, REACH_NEAREST, 1);
    grid_mesh_make(&g, chosen, scan.item, NULL, 1, &mesh);
    free(chosen);
}

static void free_all(void)
{
    array_free(&scan);
    mesh_free(&mesh);
    point_grid_free(&point_grid);
}

/* How deep a ball of 8 mm that touches the mesh at its vertices gouges the true panel. */
static double worst_gouge(void)
{
    const double radius = 8;
    double worst = 0;
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 centre = vec_along(mesh.vertex.item[i], radius, mesh.normal.item[i]);
        worst = fmax(worst, radius - panel_distance(centre));
    }
    return worst;
}

/* 0.01 mm and one and a half deviations, over 1,200 vertices; the points themselves are off by
 * more than three. */
START_TEST(panel)
{
    const double sigma[] = {0.01, 0.02, 0.05};
    for (int k = 0; k < 3; k++) {
        make_scan(panel_height, (enum noisy_pattern)_i, sigma[k], 2);
        double before = 0;
        for (size_t i = 0; i < mesh.vertex.n; i++)
            before = fmax(before, fabs(panel_distance(mesh.vertex.item[i])));
        ck_assert_double_gt(before, 2.8 * sigma[k]);
        struct smooth_nodes r = smooth_nodes(
            &mesh, &point_grid, &(struct smooth_nodes_options){sigma[k], 0, 0, 2, false});
        ck_assert_uint_eq(r.moved, mesh.vertex.n);
        ck_assert_double_lt(worst_gouge(), 0.01 + 1.5 * sigma[k]);
        ck_assert_double_lt(r.error, 0.4 * sigma[k]);
        double sum2 = 0;
        for (size_t i = 0; i < mesh.vertex.n; i++)
            sum2 += pow(panel_distance(mesh.vertex.item[i]), 2) / (double)mesh.vertex.n;
        ck_assert_double_lt(sqrt(sum2), 0.4 * sigma[k]);
        free_all();
    }
}
END_TEST

static double tilted(double x, double y)
{
    return 3 * x - 0.3 * y;
}

/* What bends nowhere takes wide neighbourhoods, on a steep slope too. */
START_TEST(plane)
{
    const struct vec3 normal = vec_unit(vec(-3, 0.3, 1));
    make_scan(tilted, NOISY_RANDOM, 0.02, 4);
    struct smooth_nodes r =
        smooth_nodes(&mesh, &point_grid, &(struct smooth_nodes_options){0.02, 0, 0, 2, false});
    ck_assert_uint_ge(r.typical, 180);
    ck_assert_uint_eq(r.moved, mesh.vertex.n);
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        ck_assert_double_lt(vec_distance(mesh.normal.item[i], normal), 0.04);
        ck_assert_double_lt(fabs(vec_dot(mesh.vertex.item[i], normal)), 0.03);
        ck_assert_double_lt(fabs(mesh.kmax.item[i]), 0.05);
    }
}
END_TEST

static double fold(double x, double y)
{
    return -fabs(x + 0.2 * y);
}

/* On an edge no quadric holds: no vertex is pulled off it by more than the noise. */
START_TEST(edge)
{
    make_scan(fold, NOISY_RANDOM, 0.01, 2);
    smooth_nodes(&mesh, &point_grid, &(struct smooth_nodes_options){0.01, 0, 0, 2, false});
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 p = mesh.vertex.item[i];
        ck_assert_double_lt(fabs(p.z - fold(p.x, p.y)) / sqrt(2.04), 0.08);
    }
}
END_TEST

/* Points far off among the neighbours pull nothing. */
START_TEST(outliers)
{
    make_scan(panel_height, NOISY_RANDOM, 0.02, 4);
    for (size_t i = 0; i < point_grid.n; i += 40)
        point_grid.point[i].z += 1 + noisy_uniform();
    smooth_nodes(&mesh, &point_grid, &(struct smooth_nodes_options){0.02, 0, 0, 2, false});
    ck_assert_double_lt(worst_gouge(), 0.01 + 1.5 * 0.02);
}
END_TEST

START_TEST(threads_do_not_matter)
{
    make_scan(panel_height, NOISY_LINES, 0.02, 4);
    struct mesh first = mesh, second = {0};
    for (size_t i = 0; i < mesh.vertex.n; i++)
        *array_push(&second.vertex) = mesh.vertex.item[i];
    second.face = mesh.face;
    smooth_nodes(&first, &point_grid, &(struct smooth_nodes_options){0.02, 60, 0, 1, false});
    smooth_nodes(&second, &point_grid, &(struct smooth_nodes_options){0.02, 60, 0, 5, false});
    ck_assert_mem_eq(first.vertex.item, second.vertex.item,
                     first.vertex.n * sizeof *first.vertex.item);
    ck_assert_mem_eq(first.normal.item, second.normal.item,
                     first.vertex.n * sizeof *first.normal.item);
    second.face = (struct faces){0};
    mesh_free(&second);
    mesh = first;
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("smooth_nodes");
    TCase *tests = tcase_create("smooth_nodes");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, panel, 0, 3);
    tcase_add_test(tests, plane);
    tcase_add_test(tests, edge);
    tcase_add_test(tests, outliers);
    tcase_add_test(tests, threads_do_not_matter);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
