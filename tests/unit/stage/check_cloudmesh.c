/* cloudmesh: meshes of a known surface, by each way: vertices on it, facets as near as promised,
 * normals its own, all of it covered; a ball in parts. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "noisy.h"
#include "stage/cloudmesh.h"

static struct vec3s points;
static struct mesh mesh;
static struct cloudmesh result;
static struct error error;

/* z = 2 sin(x / 3) cos(y / 4): bent by a radius of 4.5 at most */
static double height(double x, double y)
{
    return 2 * sin(x / 3) * cos(y / 4);
}

static struct vec3 normal(double x, double y)
{
    return vec_unit(vec(-2.0 / 3 * cos(x / 3) * cos(y / 4), 0.5 * sin(x / 3) * sin(y / 4), 1));
}

/* 16 x 12 mm, a point each 0.4, not quite in rows. */
static void setup(void)
{
    for (int j = 0; j <= 30; j++)
        for (int i = 0; i <= 40; i++) {
            double x = 0.4 * i + 0.03 * (j % 3), y = 0.4 * j + 0.03 * (i % 4);
            *array_push(&points) = vec(x, y, height(x, y));
        }
    mesh = (struct mesh){.origin.ledger = NAN};
}

static void teardown(void)
{
    array_free(&points);
    mesh_free(&mesh);
}

static struct cloudmesh_options usual(void)
{
    return (struct cloudmesh_options){
        .normals = normals_find(true, 0), .effort = 1, .silent = true};
}

static void make(const struct cloudmesh_options *options, double noise)
{
    ck_assert_msg(cloudmesh_make(options, &points, noise, 1, &mesh, &result, &error) == 0, "%s",
                  error.text);
}

/* Vertices and middles of facets off the surface, along z; normals against its own; the plan. */
static void near_surface(double vertex, double facet, double angle, double area)
{
    double covered = 0;
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 p = mesh.vertex.item[i];
        ck_assert_double_eq_tol(p.z, height(p.x, p.y), vertex);
        ck_assert_double_ge(vec_dot(mesh.normal.item[i], normal(p.x, p.y)), cos(angle));
    }
    for (size_t f = 0; f < mesh.face.n; f++) {
        struct vec3 p = vec(0, 0, 0);
        for (int k = 0; k < 3; k++)
            p = vec_along(p, 1.0 / 3, mesh.vertex.item[mesh.face.item[f].v[k]]);
        ck_assert_double_eq_tol(p.z, height(p.x, p.y), facet);
        double twice = mesh_face_cross(&mesh, f).z;
        ck_assert_double_gt(twice, 0); /* none is folded */
        covered += twice / 2;
    }
    ck_assert_double_eq_tol(covered, area, 0.06 * area);
    ck_assert_double_le(covered, area + 1e-6);
}

/* A chord of length t is off a radius of 4.5 by t^2 / 8 / 4.5; of a triangle by t^2 / 6 / 4.5. */
START_TEST(grid)
{
    struct cloudmesh_options options = usual();
    options.spacing = 1;
    make(&options, 0);
    near_surface(0.01, 0.06, 0.03, 16.06 * 12.09);
    ck_assert_double_eq(mesh.origin.spacing, 1);
    ck_assert_uint_eq(mesh.row.n, mesh.vertex.n);
    /* the side of each equilateral triangle within the grid is the spacing, in plan */
    size_t even = 0;
    for (size_t f = 0; f < mesh.face.n; f++) {
        const int *v = mesh.face.item[f].v;
        struct vec3 a = mesh.vertex.item[v[0]], b = mesh.vertex.item[v[1]];
        even += fabs(hypot(a.x - b.x, a.y - b.y) - 1) < 0.05;
    }
    ck_assert_uint_gt(even, mesh.face.n / 2);
    ck_assert_uint_eq(result.creases + result.walls + result.crests, 0);
}
END_TEST

START_TEST(within_an_error)
{
    struct cloudmesh_options options = usual();
    size_t before = 0;
    for (double e = 0.04; e > 0.005; e /= 2) {
        mesh_free(&mesh);
        mesh = (struct mesh){.origin.ledger = NAN};
        options.error = e;
        make(&options, 0);
        ck_assert_double_le(result.rows.worst, e);
        near_surface(0.01, 1.3 * e, 0.08, 16.06 * 12.09);
        ck_assert_uint_gt(mesh.vertex.n, before); /* closer takes more */
        before = mesh.vertex.n;
    }
    ck_assert_uint_lt(before, points.n);
}
END_TEST

START_TEST(other_ways)
{
    struct cloudmesh_options options = usual();
    options.method = CLOUDMESH_DELAUNAY;
    options.keep = 300;
    make(&options, 0);
    ck_assert_uint_eq(mesh.vertex.n, 300);
    near_surface(1e-9, 0.08, 0.03, 16.06 * 12.09);
    mesh_free(&mesh);
    mesh = (struct mesh){.origin.ledger = NAN};
    options = usual();
    options.method = CLOUDMESH_LIN;
    options.spacing = 0.8;
    make(&options, 0);
    near_surface(0.04, 0.06, 0.1, 16.06 * 12.09);
}
END_TEST

/* Even noise along z, up and down: the vertices are nearer than the points. */
START_TEST(rid_of_noise)
{
    struct cloudmesh_options options = usual();
    double sum = 0;
    noisy_seed(3);
    for (size_t i = 0; i < points.n; i++)
        points.item[i].z += 0.03 * (2 * noisy_uniform() - 1);
    options.spacing = 1;
    make(&options, 0.0173); /* of an even spread of 0.03 to both sides: by the root of 3 */
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 p = mesh.vertex.item[i];
        double off = (p.z - height(p.x, p.y)) * normal(p.x, p.y).z;
        sum += off * off;
    }
    double sigma = sqrt(sum / (double)mesh.vertex.n);
    ck_assert_double_lt(sigma, 0.0173 / 2);
    ck_assert_double_lt(sigma, mesh.origin.ledger);
    ck_assert_double_gt(mesh.origin.ledger, 0);
    ck_assert_double_lt(mesh.origin.ledger, 3 * 0.0173);
    ck_assert_str_eq(mesh.origin.maker, "cloud2mesh");
}
END_TEST

/* Half of a ball, whose rim no one projection can see, is one surface of all its parts. */
START_TEST(in_parts)
{
    struct cloudmesh_options options = usual();
    points.n = 0;
    for (int j = 0; j <= 40; j++) {
        double lean = 0.5 * PI * j / 40, rim = 6 * sin(lean);
        int n = (int)(2 * PI * rim / 0.24) + 1;
        for (int i = 0; i < n; i++) {
            double turn = 2 * PI * (i + 0.5 * (j % 2)) / n;
            *array_push(&points) = vec(rim * cos(turn), rim * sin(turn), 6 * cos(lean));
        }
    }
    options.subdivide = true;
    make(&options, 0);
    double area = 0;
    for (size_t i = 0; i < mesh.vertex.n; i++) {
        struct vec3 p = mesh.vertex.item[i];
        ck_assert_double_eq_tol(vec_length(p), 6, 0.02);
        ck_assert_double_gt(vec_dot(mesh.normal.item[i], vec_unit(p)), cos(0.1));
    }
    for (size_t f = 0; f < mesh.face.n; f++)
        area += vec_length(mesh_face_cross(&mesh, f)) / 2;
    ck_assert_double_gt(area, 0.85 * 2 * PI * 36);
    ck_assert_double_lt(area, 1.6 * 2 * PI * 36); /* they overlap by a spacing and a half */
    ck_assert_uint_gt(mesh.origin.part.n, 1);
}
END_TEST

/* A dome on a plane, which it meets in a crease; and a roof, cut off above and below. */
static double dome(double x, double y)
{
    double r2 = (x - 40) * (x - 40) + (y - 30) * (y - 30);
    return sqrt(22 * 22 * 1.2 - fmin(r2, 22 * 22));
}

static double roof(double x, double y)
{
    return fmax(fmin(10 - 0.7 * fabs(x - 40), 6), 2) + 0.15 * fabs(y - 30);
}

/* Scan lines 1 mm apart, a point each 0.25 along them, with even noise: no facet between
 * two lines is far off, whether there is a point over it or not, nor a vertex beside an edge. */
START_TEST(lines_within_an_error)
{
    double (*const surface[2])(double x, double y) = {dome, roof};
    struct cloudmesh_options options = usual();
    double noise = _i == 0 ? 0.005 : 0.02, area = 0, off2 = 0;
    /* that of the dome's rim, and of the roof's sides */
    double slope = _i == 0 ? 22 / sqrt(0.2 * 22 * 22) : hypot(0.7, 0.15);

    noisy_seed(5);
    points.n = 0;
    for (int j = 0; j < 60; j++)
        for (int i = 0; i <= 320; i++) {
            double x = 0.25 * i + 0.002 * (i * 31 % 53), y = 60.0 / 59 * j;
            double off = noise * sqrt(3) * (2 * noisy_uniform() - 1);
            *array_push(&points) = vec(x, y, surface[_i](x, y) + off);
        }
    options.error = 0.05;
    make(&options, noise);
    for (size_t f = 0; f < mesh.face.n; f++) {
        struct vec3 p = vec(0, 0, 0);
        double far = 0;
        for (int k = 0; k < 3; k++)
            p = vec_along(p, 1.0 / 3, mesh.vertex.item[mesh.face.item[f].v[k]]);
        for (int k = 0; k < 3; k++) {
            struct vec3 to = vec_sub(mesh.vertex.item[mesh.face.item[f].v[k]], p);
            far += hypot(to.x, to.y) / 3;
        }
        double off = p.z - surface[_i](p.x, p.y), part = mesh_face_cross(&mesh, f).z / 2;
        area += part;
        off2 += part * off * off;
        /* Vertices on a surface no steeper than that, two lines away at most; and an edge is known
         * to half the distance of lines. */
        ck_assert_double_lt(fabs(off), slope * (fmin(far, 2) + 0.5) + 4 * noise);
    }
    ck_assert_double_eq_tol(area, 80 * 60, 0.01 * 80 * 60);
    ck_assert_double_lt(sqrt(off2 / area), 0.03);
}
END_TEST

START_TEST(no_mesh)
{
    struct cloudmesh_options options = usual();
    for (size_t i = 0; i < points.n; i++)
        points.item[i].y = 0;
    ck_assert_int_eq(cloudmesh_make(&options, &points, 0, 1, &mesh, &result, &error), -1);
    options.error = 0.01;
    ck_assert_int_eq(cloudmesh_make(&options, &points, 0, 1, &mesh, &result, &error), -1);
    teardown();
    setup();
    options = usual();
    options.spacing = 1e-4;
    ck_assert_int_eq(cloudmesh_make(&options, &points, 0, 1, &mesh, &result, &error), -1);
    ck_assert_uint_gt(strlen(error.text), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloudmesh");
    TCase *tests = tcase_create("cloudmesh");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, grid);
    tcase_add_test(tests, within_an_error);
    tcase_add_test(tests, other_ways);
    tcase_add_test(tests, rid_of_noise);
    tcase_add_test(tests, in_parts);
    tcase_add_loop_test(tests, lines_within_an_error, 0, 2);
    tcase_add_test(tests, no_mesh);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
