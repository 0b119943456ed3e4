/* guard_mesh: points on the convex edges of meshes and nowhere else; slivers have them all over. */
#include "gouge/guard_mesh.h"
#include "mesh/mesh_repair_steps.h"
#include "shapes.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "seed.h"

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static struct vec3s sampled(const struct mesh *mesh, double spacing)
{
    struct vec3s points = {0};
    guard_points_of_edges(mesh, spacing, NULL, &points);
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

/* A fan of slivers, each with its longest side to the one before: none has another's side for
 * sampled that is not. */
START_TEST(slivers_have_points_everywhere)
{
    enum { FACETS = 40 };
    const double spacing = 0.25;
    struct mesh m = {0};
    struct vec3s points = {0};
    *array_push(&m.vertex) = vec(0, 0, 0);
    for (int k = 0; k <= FACETS; k++)
        *array_push(&m.vertex) = vec_scale(10 - 0.05 * k, vec(cos(0.015 * k), sin(0.015 * k), 0));
    for (int k = 1; k <= FACETS; k++)
        *array_push(&m.face) = (struct face){{0, k, k + 1}};
    for (size_t i = 0; i < m.vertex.n; i++)
        *array_push(&m.normal) = vec(0, 0, 1);
    const struct guard_mesh_options how = {spacing, 1e6, GUARD_CURVED, 1};
    ck_assert_double_eq(guard_points_of_mesh(&m, NULL, &how, &points), spacing);
    for (int i = 0; i < 2000; i++) {
        double far = uniform(0, 8), turn = uniform(0, 0.015 * FACETS), nearest = HUGE_VAL;
        struct vec3 at = vec(far * cos(turn), far * sin(turn), 0);
        for (size_t k = 0; k < points.n; k++)
            nearest = fmin(nearest, vec_distance(points.item[k], at));
        ck_assert_double_le(nearest, spacing);
    }
    array_free(&points);
    mesh_free(&m);
}
END_TEST

/* A hollow of facets: the curved triangle lies below.  Where the normals are the facets' own means
 * no point does, nor where facets alone count, and where both are judged by, none does by more than
 * GUARD_OFF. */
START_TEST(facets_count_as_they_are_judged)
{
    const double radius = 5, size = 2;
    struct mesh m = {0};
    for (int i = 0; i < 3; i++) {
        double turn = 2 * PI * i / 3;
        struct vec3 p = {size * cos(turn), size * sin(turn), 0};
        *array_push(&m.vertex) = p;
        *array_push(&m.normal) = vec_unit(vec(-p.x, -p.y, sqrt(radius * radius - size * size)));
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    for (int facets = GUARD_CURVED; facets <= GUARD_FLAT; facets++) {
        const struct guard_mesh_options how = {0.2, 1e6, facets, 1};
        struct vec3s points = {0};
        double lowest = 0;
        guard_points_of_mesh(&m, NULL, &how, &points);
        for (size_t i = 0; i < points.n; i++)
            lowest = fmin(lowest, points.item[i].z);
        ck_assert_uint_gt(points.n, 100);
        if (facets == GUARD_CURVED)
            ck_assert_double_lt(fabs(lowest + radius - sqrt(radius * radius - size * size)), 0.02);
        else
            ck_assert_double_eq_tol(lowest, facets == GUARD_NEAR ? -GUARD_OFF : 0, 1e-6);
        array_free(&points);
    }
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("guard_mesh");
    TCase *tcase = tcase_create("guard_mesh");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, edges_of_a_cube);
    tcase_add_test(tcase, none_inside_out);
    tcase_add_test(tcase, roof_and_valley);
    tcase_add_test(tcase, crease_that_ends);
    tcase_add_test(tcase, slivers_have_points_everywhere);
    tcase_add_test(tcase, facets_count_as_they_are_judged);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
