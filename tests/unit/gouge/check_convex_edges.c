/* convex_edges: on all edges of a cube, on none inside out; not where a crease ends or is a valley.
 */
#include <check.h>
#include <stdlib.h>

#include "mesh/crease_normals.h"
#include "shapes.h"
#include "gouge/convex_edges.h"

static struct vec3s sampled(const struct mesh *mesh, double spacing)
{
    struct vec3s points = {0};
    convex_edges_sample(mesh, spacing, &points);
    return points;
}

static int on_face(double x, double size)
{
    return fabs(x) < 1e-12 || fabs(x - size) < 1e-12;
}

START_TEST(edges_of_a_cube)
{
    struct mesh cube = shape_cube(10);
    crease_normals(&cube);
    struct vec3s points = sampled(&cube, 1);
    ck_assert_uint_eq(points.n, 12 * 11);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        ck_assert_int_ge(on_face(p.x, 10) + on_face(p.y, 10) + on_face(p.z, 10), 2);
    }
    array_free(&points);
    points = sampled(&cube, 0.99);
    ck_assert_uint_eq(points.n, 12 * 12); /* no further apart than asked for */
    array_free(&points);
    mesh_free(&cube);
}
END_TEST

START_TEST(none_inside_out)
{
    struct mesh cube = shape_cube(10);
    for (size_t f = 0; f < cube.face.n; f++) {
        int *v = cube.face.item[f].v, swap = v[1];
        v[1] = v[2];
        v[2] = swap;
    }
    crease_normals(&cube);
    struct vec3s points = sampled(&cube, 1);
    ck_assert_uint_eq(points.n, 0);
    mesh_free(&cube);
}
END_TEST

/* Two slopes, each with vertices of its own on the line x = 0; z there is `top`, beside it 0. */
static struct mesh roof(double top, bool split)
{
    struct mesh m = {0};
    const double x[4] = {-5, 0, 0, 5};
    for (int i = 0; i < 8; i++)
        *array_push(&m.vertex) = vec(x[i / 2], i % 2 * 4, i / 2 == 1 || i / 2 == 2 ? top : 0);
    int r = split ? 4 : 2;
    const struct face faces[] = {{{0, 2, 3}}, {{0, 3, 1}}, {{r, 6, 7}}, {{r, 7, r + 1}}};
    for (int f = 0; f < 4; f++)
        *array_push(&m.face) = faces[f];
    return m;
}

START_TEST(roof_and_valley)
{
    const struct {
        double top;
        bool split;
        size_t points;
    } cases[] = {{2, true, 5}, {-2, true, 0}, {0, true, 0}, {2, false, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct mesh m = roof(cases[i].top, cases[i].split);
        struct vec3s points = sampled(&m, 1);
        ck_assert_uint_eq(points.n, cases[i].points);
        for (size_t k = 0; k < points.n; k++)
            ck_assert_double_lt(vec_distance(points.item[k], vec(0, points.item[k].y, 2)), 1e-12);
        array_free(&points);
        mesh_free(&m);
    }
}
END_TEST

/* A crease that runs out has one vertex at its end. */
START_TEST(crease_that_ends)
{
    struct mesh m = roof(2, true);
    m.face.item[3].v[2] = m.face.item[1].v[1]; /* the vertex at y = 4 */
    struct vec3s points = sampled(&m, 1);
    ck_assert_uint_eq(points.n, 5);
    array_free(&points);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sharpedges");
    TCase *tests = tcase_create("sharpedges");
    tcase_add_test(tests, edges_of_a_cube);
    tcase_add_test(tests, none_inside_out);
    tcase_add_test(tests, roof_and_valley);
    tcase_add_test(tests, crease_that_ends);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
