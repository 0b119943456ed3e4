/* mesh: the three normals against surfaces whose normals are known. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/mesh.h"

static struct mesh mesh;

static void add_vertex(struct vec3 p, int row, int col)
{
    *array_push(&mesh.vertex) = p;
    *array_push(&mesh.row) = row;
    *array_push(&mesh.col) = col;
}

static void add_face(int a, int b, int c)
{
    *array_push(&mesh.face) = (struct face){{a, b, c}};
}

enum { ROWS = 9, COLS = 12 };

/* A triangular grid of spacing t, cut to a rectangle, on z(x, y); columns are oblique. */
static void triangular_grid(double t, double (*z)(double, double))
{
    int first[ROWS];
    for (int r = 0; r < ROWS; r++) {
        first[r] = -(r / 2);
        for (int k = 0; k < COLS; k++) {
            int c = first[r] + k;
            double x = t * (c + 0.5 * r), y = t * r * sqrt(3) / 2;
            add_vertex(vec(x, y, z(x, y)), r, c);
        }
    }
    for (int r = 0; r + 1 < ROWS; r++)
        for (int k = 0; k + 1 < COLS; k++) {
            int a = r * COLS + k, up = a + COLS; /* odd rows stand half a step to the right */
            if (r % 2 == 0) {
                add_face(a, a + 1, up);
                add_face(up, a + 1, up + 1);
            } else {
                add_face(a, a + 1, up + 1);
                add_face(a, up + 1, up);
            }
        }
}

static void expect_normal(size_t i, struct vec3 n, double within)
{
    struct vec3 got = mesh.normal.item[i];
    ck_assert_double_eq_tol(vec_length(got), 1, 1e-12);
    ck_assert_msg(vec_angle(got, n) <= within, "vertex %zu: %g %g %g, off by %g rad", i, got.x,
                  got.y, got.z, vec_angle(got, n));
}

static double plane(double x, double y)
{
    return 0.5 * x - 0.25 * y + 3;
}

static double ball(double x, double y)
{
    return sqrt(400 - x * x - y * y);
}

static void clear(void)
{
    mesh_free(&mesh);
    mesh = (struct mesh){0};
}

START_TEST(cross_is_twice_the_area)
{
    add_vertex(vec(1, 1, 1), 0, 0);
    add_vertex(vec(4, 1, 1), 0, 1);
    add_vertex(vec(1, 3, 1), 1, 0);
    add_face(0, 1, 2);
    struct vec3 c = mesh_face_cross(&mesh, 0);
    ck_assert_double_eq(c.x, 0);
    ck_assert_double_eq(c.y, 0);
    ck_assert_double_eq(c.z, 6);
}
END_TEST

/* Every way must give a plane's own normal, at the borders too. */
START_TEST(plane_is_exact)
{
    struct vec3 n = vec_unit(vec(-0.5, 0.25, 1));
    struct error error;
    triangular_grid(2, plane);
    mesh_normals_facet(&mesh);
    for (size_t i = 0; i < mesh.vertex.n; i++)
        expect_normal(i, n, 1e-12);
    mesh_normals_gouraud(&mesh);
    for (size_t i = 0; i < mesh.vertex.n; i++)
        expect_normal(i, n, 1e-12);
    ck_assert_int_eq(mesh_normals_central(&mesh, &error), 0);
    for (size_t i = 0; i < mesh.vertex.n; i++)
        expect_normal(i, n, 1e-12);
    ck_assert_uint_eq(mesh.normal.n, mesh.vertex.n);
}
END_TEST

/* On a sphere the error of facet and central normals falls with the square of the spacing. */
START_TEST(sphere_within_t_squared)
{
    double worst[2][2];
    for (int k = 0; k < 2; k++) {
        double t = k ? 0.25 : 0.5;
        for (int way = 0; way < 2; way++) {
            struct error error;
            clear();
            triangular_grid(t, ball);
            if (way == 0)
                mesh_normals_facet(&mesh);
            else
                ck_assert_int_eq(mesh_normals_central(&mesh, &error), 0);
            worst[way][k] = 0;
            for (int r = 1; r + 1 < ROWS; r++)
                for (int c = 1; c + 1 < COLS; c++) {
                    size_t i = (size_t)(r * COLS + c);
                    double off = vec_angle(mesh.normal.item[i], mesh.vertex.item[i]);
                    worst[way][k] = fmax(worst[way][k], off);
                }
        }
    }
    for (int way = 0; way < 2; way++) {
        ck_assert_double_lt(worst[way][0], 0.5 * 0.5 / 400);
        ck_assert_double_lt(worst[way][1], 0.3 * worst[way][0] + 1e-9);
    }
}
END_TEST

/* Eq 8 is the mean of unit normals: a large facet counts no more than a small one. */
START_TEST(facets_count_alike)
{
    add_vertex(vec(0, 0, 0), 0, 0);
    add_vertex(vec(100, 0, 0), 0, 1);
    add_vertex(vec(0, 100, 0), 1, 0);
    add_vertex(vec(0, 0, 1), 0, 2);
    add_face(0, 1, 2); /* +z, area 5000 */
    add_face(0, 2, 3); /* +x, area 50 */
    add_face(1, 1, 2); /* no area */
    add_face(2, 2, 2);
    mesh_normals_facet(&mesh);
    expect_normal(0, vec_unit(vec(1, 0, 1)), 1e-12);
    expect_normal(1, vec(0, 0, 1), 1e-12);
    expect_normal(3, vec(1, 0, 0), 1e-12);
}
END_TEST

START_TEST(no_facet_points_up)
{
    add_vertex(vec(0, 0, 0), 0, 0);
    add_vertex(vec(1, 0, 0), 0, 1);
    add_vertex(vec(0, 1, 0), 1, 0);
    add_vertex(vec(9, 9, 9), 5, 5);
    add_face(0, 1, 2); /* the same facet from both sides: the normals cancel */
    add_face(0, 2, 1);
    mesh_normals_facet(&mesh);
    for (size_t i = 0; i < 4; i++)
        expect_normal(i, vec(0, 0, 1), 1e-12);
}
END_TEST

/* Eq 7: the neighbours' normals without the vertex's own, each once though two facets share it. */
START_TEST(gouraud_is_the_neighbours_mean)
{
    add_vertex(vec(0, 0, 0), 0, 0);
    add_vertex(vec(1, 0, 0), 0, 1);
    add_vertex(vec(0, 1, 0), 1, 0);
    add_vertex(vec(-1, 0, 0), 0, -1);
    add_face(0, 1, 2);
    add_face(0, 2, 3);
    struct vec3 own[] = {vec(0, 0, 1), vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)};
    for (int i = 0; i < 4; i++)
        *array_push(&mesh.normal) = own[i];
    mesh_normals_gouraud(&mesh);
    expect_normal(0, vec_unit(vec(1, 1, 1)), 1e-12);
    expect_normal(1, vec_unit(vec(0, 1, 1)), 1e-12);
    expect_normal(2, vec_unit(vec(1, 0, 2)), 1e-12);
}
END_TEST

START_TEST(gouraud_alone_keeps_its_own)
{
    add_vertex(vec(0, 0, 0), 0, 0);
    *array_push(&mesh.normal) = vec(1, 0, 0);
    mesh_normals_gouraud(&mesh);
    expect_normal(0, vec(1, 0, 0), 0);
}
END_TEST

START_TEST(central_needs_rows)
{
    struct error error;
    add_vertex(vec(0, 0, 0), 0, 0);
    array_free(&mesh.row);
    ck_assert_int_eq(mesh_normals_central(&mesh, &error), -1);
    clear();
    ck_assert_int_eq(mesh_normals_central(&mesh, &error), -1);
}
END_TEST

/* One row alone has no column; rows and columns may be any ints, also the largest. */
START_TEST(central_needs_neighbours)
{
    struct error error;
    for (int c = 0; c < 5; c++)
        add_vertex(vec(c, 0, 0), 2147483647, 2147483643 + c);
    ck_assert_int_eq(mesh_normals_central(&mesh, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "row 2147483647, column 2147483643"));
    ck_assert_uint_eq(mesh.normal.n, 0);
}
END_TEST

/* Two facets of a slope: the one normal that points down becomes that of the facets. */
START_TEST(no_normal_points_down)
{
    const struct vec3 p[] = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {1, 1, 1}};
    struct mesh m = {0};
    for (int i = 0; i < 4; i++) {
        *array_push(&m.vertex) = p[i];
        *array_push(&m.normal) = i == 2 ? vec(0.6, 0, -0.8) : vec(0, 0, 1);
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    *array_push(&m.face) = (struct face){{1, 3, 2}};
    ck_assert_uint_eq(mesh_normals_seen(&m), 1);
    ck_assert_double_le(vec_distance(m.normal.item[2], vec_unit(vec(-1, 0, 1))), 1e-12);
    ck_assert_double_eq(m.normal.item[0].z, 1);
    ck_assert_uint_eq(mesh_normals_seen(&m), 0);
    mesh_free(&m);
}
END_TEST

/* A level facet and an upright one of the same area. */
START_TEST(steep_part)
{
    const struct vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct mesh m = {0};
    for (int i = 0; i < 4; i++)
        *array_push(&m.vertex) = p[i];
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    ck_assert_double_eq(mesh_steep_part(&m, vec(0, 0, 1)), 0);
    *array_push(&m.face) = (struct face){{0, 1, 3}};
    ck_assert_double_eq(mesh_steep_part(&m, vec(0, 0, 1)), 0.5);
    mesh_free(&m);
}
END_TEST

/* One facet faces down; the whole of a tetrahedron faces all around. */
START_TEST(facing)
{
    const struct vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const struct face face[] = {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}};
    struct mesh m = {0};
    for (int i = 0; i < 4; i++)
        *array_push(&m.vertex) = p[i];
    ck_assert_double_eq(vec_length(mesh_facing(&m)), 0);
    *array_push(&m.face) = face[0];
    ck_assert_double_eq(vec_distance(mesh_facing(&m), vec(0, 0, -1)), 0);
    *array_push(&m.face) = face[1];
    ck_assert_double_eq(vec_distance(mesh_facing(&m), vec(0, -0.5, -0.5)), 0);
    *array_push(&m.face) = face[2];
    *array_push(&m.face) = face[3];
    ck_assert_double_eq(vec_length(mesh_facing(&m)), 0);
    mesh_free(&m);
}
END_TEST

/* Normals across their facets give way to these, those to the other side are turned. */
START_TEST(normals_turned)
{
    const struct vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const struct vec3 n[] = {{0, 0, -1}, {1, 0, 0}, {0.8, 0, -0.3}};
    struct mesh m = {0};
    for (int i = 0; i < 3; i++) {
        *array_push(&m.vertex) = p[i];
        *array_push(&m.normal) = n[i];
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    ck_assert_uint_eq(mesh_normals_turn(&m), 2);
    ck_assert_double_eq(vec_distance(m.normal.item[0], vec(0, 0, 1)), 0);
    ck_assert_double_eq(vec_distance(m.normal.item[1], n[1]), 0);
    ck_assert_double_eq(vec_distance(m.normal.item[2], vec(0, 0, 1)), 0);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh");
    TCase *tests = tcase_create("mesh");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clear, clear);
    tcase_add_test(tests, cross_is_twice_the_area);
    tcase_add_test(tests, plane_is_exact);
    tcase_add_test(tests, sphere_within_t_squared);
    tcase_add_test(tests, facets_count_alike);
    tcase_add_test(tests, no_facet_points_up);
    tcase_add_test(tests, gouraud_is_the_neighbours_mean);
    tcase_add_test(tests, gouraud_alone_keeps_its_own);
    tcase_add_test(tests, central_needs_rows);
    tcase_add_test(tests, central_needs_neighbours);
    tcase_add_test(tests, no_normal_points_down);
    tcase_add_test(tests, steep_part);
    tcase_add_test(tests, facing);
    tcase_add_test(tests, normals_turned);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
