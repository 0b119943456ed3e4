/* scan_normals: against the normals of a known surface, on random points, on laser lines, with any
 * number of threads and in any order. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "meshing/grid_mesh.h"
#include "panel.h"
#include "meshing/reposition.h"
#include "meshing/scan_normals.h"
#include "seed.h"

static uint64_t state = 9;
static struct vec3s scan;
static struct mesh mesh;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* z = 2 sin(x/6) cos(y/8): curvature radius 18 mm at least. */
static struct vec3 on_wave(double x, double y)
{
    return vec(x, y, 2 * sin(x / 6) * cos(y / 8));
}

static struct vec3 wave_normal(struct vec3 p)
{
    return vec_unit(vec(-cos(p.x / 6) * cos(p.y / 8) / 3, sin(p.x / 6) * sin(p.y / 8) / 4, 1));
}

/* Small facets on a surface, of vertices that need not be points of the scan. */
static void make_mesh(struct vec3 (*on)(double, double))
{
    for (double x = 0.5; x < 39; x += 1.9)
        for (double y = 0.5; y < 29; y += 1.7) {
            int first = (int)mesh.vertex.n;
            *array_push(&mesh.vertex) = on(x, y);
            *array_push(&mesh.vertex) = on(x + 0.5, y);
            *array_push(&mesh.vertex) = on(x, y + 0.5);
            *array_push(&mesh.face) = (struct face){{first, first + 1, first + 2}};
        }
}

static void free_all(void)
{
    array_free(&scan);
    mesh_free(&mesh);
}

/* Sorts the scan. */
static struct scan_normals normals(int neighbours, int threads)
{
    struct point_grid point_grid;
    const struct scan_normals_options how = {.neighbours = neighbours, .threads = threads};
    struct error error;
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.5, threads, &point_grid, &error), 0);
    struct scan_normals r = scan_normals_quadric(&mesh, &point_grid, &how);
    point_grid_free(&point_grid);
    return r;
}

static double worst_angle(void)
{
    double worst = 0;
    for (size_t i = 0; i < mesh.vertex.n; i++)
        worst = fmax(worst, vec_angle(mesh.normal.item[i], wave_normal(mesh.vertex.item[i])));
    return worst;
}

static void random_scan(void)
{
    for (int i = 0; i < 6000; i++)
        *array_push(&scan) = on_wave(40 * uniform(), 30 * uniform());
}

START_TEST(random_points)
{
    random_scan();
    make_mesh(on_wave);
    struct scan_normals r = normals(40, 1);
    ck_assert_uint_eq(r.fitted, mesh.vertex.n);
    ck_assert_uint_eq(r.thin, 0);
    ck_assert_double_lt(worst_angle(), 0.002); /* 0.004 by quadrics */
    ck_assert_double_lt(r.worst, 0.001);
    ck_assert_double_le(r.rms, r.worst);
    ck_assert(r.sigma > 0 && r.sigma < 0.004 / 3);
    ck_assert_uint_eq(mesh.kmax.n, mesh.vertex.n);
}
END_TEST

/* A wave of 1.5 mm radius: 40 points are too many for one quadric, 20 are not. */
static struct vec3 on_tight_wave(double x, double y)
{
    return vec(x, y, 0.6 * sin(x));
}

START_TEST(tight_bends)
{
    for (int i = 0; i < 30000; i++)
        *array_push(&scan) = on_tight_wave(40 * uniform(), 30 * uniform());
    make_mesh(on_tight_wave);
    normals(40, 1);
    double sum2 = 0;
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 truth = vec_unit(vec(-0.6 * cos(mesh.vertex.item[i].x), 0, 1));
        double off = vec_angle(mesh.normal.item[i], truth);
        sum2 += off * off;
    }
    ck_assert_double_lt(sqrt(sum2 / (double)mesh.vertex.n), 0.012); /* 0.017 with 40 */
}
END_TEST

/* Stripes so far apart that the nearest 40 points are on one of them. */
START_TEST(laser_lines)
{
    for (double y = 0; y <= 30; y += 1.5)
        for (double x = 0; x <= 40; x += 0.05)
            *array_push(&scan) = on_wave(x, y + 1e-4 * uniform());
    make_mesh(on_wave);
    struct scan_normals r = normals(40, 1);
    ck_assert_uint_eq(r.thin, 0);
    ck_assert_double_lt(worst_angle(), 0.02);
}
END_TEST

/* One line alone carries no quadric: the normals of the facets stay. */
START_TEST(nothing_but_a_line)
{
    for (double x = 0; x <= 40; x += 0.05)
        *array_push(&scan) = vec(x, 0, 0);
    for (int k = 0; k < 3; k++)
        *array_push(&mesh.vertex) = vec(10 * k, k == 1 ? 0.3 : 0, k == 1 ? 0.4 : 0);
    *array_push(&mesh.face) = (struct face){{0, 2, 1}};
    struct scan_normals r = normals(40, 1);
    ck_assert_uint_eq(r.thin, 3);
    ck_assert_uint_eq(r.fitted, 0);
    ck_assert(r.worst == 0 && r.rms == 0);
    for (size_t i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(vec_distance(mesh.normal.item[i], vec(0, -0.8, 0.6)), 0, 1e-12);
        ck_assert(mesh.kmax.item[i] == 0);
    }
}
END_TEST

/* A vertical wall: the normals stand to the side of the facets, not up. */
START_TEST(side_of_the_facets)
{
    for (int i = 0; i < 2000; i++)
        *array_push(&scan) = vec(0.001 * uniform(), 20 * uniform(), 20 * uniform());
    *array_push(&mesh.vertex) = vec(0, 4, 4);
    *array_push(&mesh.vertex) = vec(0, 12, 5);
    *array_push(&mesh.vertex) = vec(0, 8, 14);
    *array_push(&mesh.face) = (struct face){{0, 2, 1}};
    normals(40, 1);
    for (size_t i = 0; i < 3; i++)
        ck_assert_double_lt(mesh.normal.item[i].x, -0.99);
}
END_TEST

/* Inside of a trough of radius 100 along y. */
static struct vec3 on_trough(double x, double y)
{
    return vec(100 * sin((x - 20) / 100), y, -100 * cos((x - 20) / 100));
}

START_TEST(hollow_is_positive)
{
    for (int i = 0; i < 4000; i++)
        *array_push(&scan) = on_trough(40 * uniform(), 30 * uniform());
    make_mesh(on_trough);
    normals(40, 1);
    for (size_t i = 0; i < mesh.kmax.n; i++)
        ck_assert_double_eq_tol(mesh.kmax.item[i], 0.01, 1e-5);
}
END_TEST

static void add_panel_point(double x, double y)
{
    x = fmin(fmax(x, -37), 37);
    y = fmin(fmax(y, -27), 27);
    *array_push(&scan) = vec(x, y, panel_height(x, y));
}

/* About 17,000 points of the panel: 0 in rows, 1 on laser lines whose stripes are four steps
 * apart, 2 anywhere. */
static void scan_panel(int pattern)
{
    const double step = pattern == 1 ? 0.2421 : 0.4843;
    const double stripe = pattern == 1 ? 4 * step : step;
    for (double y = -27; y <= 27.001; y += stripe)
        for (double x = -37; x <= 37.001; x += step) {
            double right = uniform() - 0.5, up = uniform() - 0.5;
            if (pattern == 2)
                add_panel_point(74 * right, 54 * up);
            else if (pattern == 1)
                add_panel_point(x + 1.2 * step * right, y + 0.8 * step * up);
            else
                add_panel_point(x, y);
        }
}

static void mesh_panel(void)
{
    struct plan_extent f = plan_extent_of(scan.item, scan.n, 0);
    struct error error;
    struct grid g;
    ck_assert_int_eq(grid_make(&f, scan.n, 4, &g, &error), 0);
    size_t *chosen = reposition(&g, scan.item, scan.n, REACH_NEAREST, 1);
    grid_mesh_make(&g, chosen, scan.item, NULL, 1, &mesh);
    free(chosen);
}

/* How deep a ball of 8 mm that touches the mesh at its vertices gouges the true surface. */
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

START_TEST(panel)
{
    scan_panel(_i);
    mesh_panel();
    mesh_normals_facet(&mesh);
    double facet = worst_gouge();
    ck_assert_double_gt(facet, 0.01);
    ck_assert_double_lt(facet, 0.06);
    normals(40, 1);
    ck_assert_double_lt(worst_gouge(), 0.001);
}
END_TEST

/* A regular cloud has many points equally near: neither their order nor the threads matter. */
START_TEST(order_and_threads_do_not_matter)
{
    for (int i = 0; i < 60; i++)
        for (int j = 0; j < 50; j++)
            *array_push(&scan) = on_wave(0.5 * i, 0.5 * j);
    make_mesh(on_wave);
    struct scan_normals one = normals(40, 1);
    struct vec3s normal = mesh.normal;
    struct doubles kmax = mesh.kmax;
    for (int threads = 2; threads < 6; threads++) {
        for (size_t i = scan.n - 1; i > 0; i--) {
            size_t j = (size_t)(uniform() * (double)(i + 1));
            struct vec3 t = scan.item[i];
            scan.item[i] = scan.item[j];
            scan.item[j] = t;
        }
        mesh.normal = (struct vec3s){0};
        mesh.kmax = (struct doubles){0};
        struct scan_normals r = normals(40, threads);
        ck_assert(r.worst == one.worst && r.rms == one.rms && r.at == one.at);
        ck_assert_mem_eq(mesh.normal.item, normal.item, normal.n * sizeof *normal.item);
        ck_assert_mem_eq(mesh.kmax.item, kmax.item, kmax.n * sizeof *kmax.item);
        array_free(&mesh.normal);
        array_free(&mesh.kmax);
    }
    array_free(&normal);
    array_free(&kmax);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("scan_normals");
    TCase *tests = tcase_create("scan_normals");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_test(tests, random_points);
    tcase_add_test(tests, tight_bends);
    tcase_add_test(tests, laser_lines);
    tcase_add_test(tests, nothing_but_a_line);
    tcase_add_test(tests, side_of_the_facets);
    tcase_add_test(tests, hollow_is_positive);
    tcase_add_loop_test(tests, panel, 0, 3);
    tcase_add_test(tests, order_and_threads_do_not_matter);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
