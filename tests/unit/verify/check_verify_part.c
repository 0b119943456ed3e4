/*
 * check_verify_part - the part of an option from each kind of file: points of a cloud as they
 * stand, points on the faces of a mesh and on the trimmed surfaces of a model.
 */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "scratch.h"
#include "verify/verify.h"

#define RADIUS 4.0

static struct vec3s points;
static double spacing;
static size_t corners;
static struct error error;

static void teardown(void)
{
    array_free(&points);
}

/* Reads `content` as a file with that ending. */
static int read_as(const char *ending, const char *content, double unit)
{
    char name[400];
    snprintf(name, sizeof name, "%s%s", scratch_name(), ending);
    FILE *file = fopen(name, "w");
    ck_assert_ptr_nonnull(file);
    fputs(content, file);
    fclose(file);
    points.n = 0;
    error = (struct error){.system = 0};
    struct transform place = transform_scale(unit);
    int result = verify_part_read(name, &place, RADIUS, &points, &spacing, &corners, &error);
    remove(name);
    return result;
}

#define HEAD                                                                          \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n" \
    "property double z\n"

/* A right triangle of 3 and 4: all points are on it, and no place is far from all. */
static void assert_on_triangle(double unit)
{
    double worst = 0;
    ck_assert_double_eq_tol(spacing, sqrt(8 * RADIUS * VERIFY_PART_SINK), 1e-12);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = vec_scale(1 / unit, points.item[i]);
        ck_assert(p.z == 0 && p.x >= -1e-9 && p.y >= -1e-9 && p.x / 3 + p.y / 4 <= 1 + 1e-9);
    }
    for (int i = 0; i <= 30; i++) {
        for (int k = 0; k <= 30 - i; k++) {
            double least = HUGE_VAL;
            for (size_t m = 0; m < points.n; m++)
                least = fmin(
                    least, vec_distance(points.item[m], vec(unit * i / 10, unit * k * 4 / 30, 0)));
            worst = fmax(worst, least);
        }
    }
    ck_assert_double_le(worst, 0.5 * spacing);
}

START_TEST(points_on_the_faces_of_a_mesh)
{
    ck_assert_int_eq(read_as(".off", "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n", 1), 0);
    assert_on_triangle(1);
    ck_assert_int_eq(read_as(".PLY",
                             HEAD "element face 1\nproperty list uchar int vertex_indices\n"
                                  "end_header\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n",
                             2),
                     0);
    assert_on_triangle(2);
    ck_assert_int_eq(read_as(".stl",
                             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 3 0 0\n"
                             "vertex 0 4 0\nendloop\nendfacet\nendsolid a\n",
                             1),
                     0);
    assert_on_triangle(1);
}
END_TEST

START_TEST(points_of_a_cloud_as_they_stand)
{
    ck_assert_int_eq(read_as(".xyz", "0 0 0\n3 0 0\n0 4 0.5\n", 7), 0);
    ck_assert_uint_eq(points.n, 3);
    ck_assert_double_eq(spacing, 0);
    ck_assert_double_eq(points.item[2].z, 0.5);
    ck_assert_int_eq(read_as(".ply", HEAD "end_header\n0 0 0\n3 0 0\n0 4 0.5\n", 7), 0);
    ck_assert_uint_eq(points.n, 3);
    ck_assert_double_eq(spacing, 0);
    ck_assert_double_eq(points.item[2].y, 4);
}
END_TEST

/* Over 10 x 10 mm z = 1.6 u (1 - u) v (1 - v), u = x / 10 and v = y / 10, but for an opening of
 * 4 x 4 mm in its middle. */
static const char surface[] = "nurbs 1\nunit mm\nsurface\ndegree 2 2\npoles 3 3\n"
                              "knots_u 0 0 0 1 1 1\nknots_v 0 0 0 1 1 1\npoints\n"
                              "0 0 0 5 0 0 10 0 0\n0 5 0 5 5 0.4 10 5 0\n0 10 0 5 10 0 10 10 0\n"
                              "loop\n0 0 1 0 1 1 0 1\nloop\n0.3 0.3 0.3 0.7 0.7 0.7 0.7 0.3\nend\n";

START_TEST(points_on_the_surfaces_of_a_model)
{
    ck_assert_msg(read_as(".nurbs", surface, 1) == 0, "%s", error.text);
    ck_assert_double_gt(spacing, 0);
    double low = 10, high = 0;
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        double u = p.x / 10, v = p.y / 10, hole = fmax(fabs(u - 0.5), fabs(v - 0.5));
        ck_assert_double_eq_tol(p.z, 1.6 * u * (1 - u) * v * (1 - v), 0.001);
        ck_assert_double_gt(hole, 0.2 - 1e-6);
        low = fmin(low, fmin(p.x, p.y));
        high = fmax(high, fmax(p.x, p.y));
    }
    ck_assert(fabs(low) < 1e-9 && fabs(high - 10) < 1e-9);
    /* 84 mm2, and no point of a mesh of squares that the spacing asks for is missing */
    ck_assert_double_gt((double)points.n, 84 / (spacing * spacing));
}
END_TEST

static const struct {
    const char *ending, *content, *what;
} bad[] = {{".off", "OFF\n3 0 0\n0 0 0\n3 0 0\n0 4 0\n", "face"},
           {".stl", "solid a\nendsolid a\n", "face"},
           {".ply",
            HEAD
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0\n"
            "0 4 0\n3 0 1 7\n",
            "7"},
           {".igs", "this is no model\n", ""},
           {".nurbs", "surface\n", ""},
           {".xyz", "a b c\n", ""}};

START_TEST(what_is_no_part_is_told)
{
    ck_assert_int_eq(read_as(bad[_i].ending, bad[_i].content, 1), -1);
    ck_assert_msg(strstr(error.text, bad[_i].what) != NULL, "%s", error.text);
    ck_assert_msg(strstr(error.text, bad[_i].ending) != NULL, "%s", error.text);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verify_part");
    TCase *tcase = tcase_create("verify_part");
    tcase_add_checked_fixture(tcase, NULL, teardown);
    tcase_add_test(tcase, points_on_the_faces_of_a_mesh);
    tcase_add_test(tcase, points_of_a_cloud_as_they_stand);
    tcase_add_test(tcase, points_on_the_surfaces_of_a_model);
    tcase_add_loop_test(tcase, what_is_no_part_is_told, 0, (int)(sizeof bad / sizeof *bad));
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
