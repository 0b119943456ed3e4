/*
 * delaunay_mesh: few points within an error of all, holes and bays open, borders kept; all points
 * as by the triangulation itself.
 */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "mesh/mesh_distance.h"
#include "meshing/delaunay_mesh.h"
#include "meshing/scan_border.h"
#include "seed.h"

static uint64_t state = 5;

static double chance(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* A wave over a disc of radius 30 with a hole of radius 6, and a bay; or on a lattice. */
static struct vec3s cloud(bool regular)
{
    struct vec3s points = {0};

    for (int i = 0; i < 14400; i++) {
        double x = 0.5 * (i % 120) - 30, y = 0.5 * (i / 120) - 30;
        if (!regular) {
            x += 0.4 * chance();
            y += 0.4 * chance();
        }
        bool bay = fabs(y) < 4 && x > 12;
        if (hypot(x, y) < 30 && hypot(x, y) > 6 && !bay)
            *array_push(&points) = vec(x, y, 2 * sin(x / 6) * cos(y / 5));
    }
    return points;
}

static double area_of(const struct mesh *mesh)
{
    double area = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        double z = mesh_face_cross(mesh, f).z / 2;
        ck_assert_double_gt(z, 0);
        area += z;
    }
    return area;
}

/* No facet has its middle where there are no points. */
static void check_open(const struct mesh *mesh)
{
    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 m = vec(0, 0, 0);
        for (int k = 0; k < 3; k++)
            m = vec_along(m, 1 / 3.0, mesh->vertex.item[mesh->face.item[f].v[k]]);
        ck_assert(hypot(m.x, m.y) > 5.5);
        ck_assert(!(fabs(m.y) < 3 && m.x > 13));
    }
}

static double worst_of(const struct mesh *mesh, const struct vec3s *points)
{
    double *distance = malloc(points->n * sizeof *distance), worst = 0;

    mesh_distance(mesh, points->item, points->n, 1, distance);
    for (size_t i = 0; i < points->n; i++)
        worst = fmax(worst, distance[i]);
    free(distance);
    return worst;
}

START_TEST(within_an_error)
{
    for (int regular = 0; regular < 2; regular++) {
        struct vec3s points = cloud(regular == 1);
        struct mesh all = {0}, few = {0}, fewer = {0};
        struct delaunay_mesh_options how = {2, 0, 0};

        delaunay_mesh_make(points.item, points.n, &how, &all);
        ck_assert_uint_eq(all.vertex.n, points.n);
        check_open(&all);
        how.error = 0.01;
        delaunay_mesh_make(points.item, points.n, &how, &few);
        check_open(&few);
        ck_assert_double_le(worst_of(&few, &points), 0.01 + 1e-9);
        ck_assert_uint_lt(few.vertex.n, points.n / 2);
        how.error = 0.1;
        delaunay_mesh_make(points.item, points.n, &how, &fewer);
        check_open(&fewer);
        ck_assert_double_le(worst_of(&fewer, &points), 0.1 + 1e-9);
        ck_assert_uint_lt(fewer.vertex.n, few.vertex.n / 2);
        ck_assert_double_eq_tol(area_of(&few), area_of(&all), 0.01 * area_of(&all));
        ck_assert_double_eq_tol(area_of(&fewer), area_of(&all), 0.02 * area_of(&all));
        mesh_free(&all);
        mesh_free(&few);
        mesh_free(&fewer);
        array_free(&points);
    }
}
END_TEST

START_TEST(so_many)
{
    struct vec3s points = cloud(false);
    size_t count[] = {300, 1000, 5000};
    double before = HUGE_VAL;

    for (int i = 0; i < 3; i++) {
        struct mesh mesh = {0};
        struct delaunay_mesh_options how = {2, 0, count[i]};
        delaunay_mesh_make(points.item, points.n, &how, &mesh);
        ck_assert_uint_eq(mesh.vertex.n, count[i]);
        double worst = worst_of(&mesh, &points);
        ck_assert_double_lt(worst, before);
        before = worst;
        mesh_free(&mesh);
    }
    array_free(&points);
}
END_TEST

/* Of a plane nothing is needed but its border, whose corners are few. */
START_TEST(plane)
{
    struct vec3s points = {0};
    struct mesh mesh = {0};
    struct delaunay_mesh_options how = {2, 1e-6, 0};

    for (int i = 0; i < 2500; i++)
        *array_push(&points) = vec(i % 50, i / 50, 0.25 * (i % 50) - 0.5 * (i / 50));
    delaunay_mesh_make(points.item, points.n, &how, &mesh);
    ck_assert_uint_eq(mesh.vertex.n, 4);
    ck_assert_uint_eq(mesh.face.n, 2);
    ck_assert_double_eq_tol(area_of(&mesh), 49 * 49, 1e-9);
    mesh_free(&mesh);
    array_free(&points);
}
END_TEST

START_TEST(borders)
{
    struct vec3s points = cloud(false);
    struct scan_border border = scan_border_find(points.item, points.n, 2);
    double area = 0;

    ck_assert_uint_eq(border.n, 2);
    for (size_t k = 0; k < border.n; k++) {
        const struct ints *loop = &border.item[k];
        double own = 0;
        for (size_t i = 0; i < loop->n; i++) {
            struct vec3 a = points.item[loop->item[i]];
            struct vec3 b = points.item[loop->item[(i + 1) % loop->n]];
            own += (a.x * b.y - a.y * b.x) / 2;
        }
        area += own;
        bool *keep = malloc(loop->n * sizeof *keep);
        scan_border_thin(loop, points.item, 0.5, keep);
        size_t kept = 0;
        for (size_t i = 0; i < loop->n; i++)
            kept += keep[i];
        ck_assert(kept >= 3 && kept < loop->n / 3);
        free(keep);
    }
    ck_assert_double_eq_tol(area, PI * (900 - 36) - 8 * 17.7, 60); /* a hole counts negative */
    scan_border_free(&border);
    array_free(&points);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("delaunay_mesh");
    TCase *tests = tcase_create("mesh");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, within_an_error);
    tcase_add_test(tests, so_many);
    tcase_add_test(tests, plane);
    tcase_add_test(tests, borders);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
