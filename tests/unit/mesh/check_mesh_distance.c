/* mesh_distance: distances from facets by a dense search, and from a mesh by its known plane. */
#include <check.h>
#include <stdlib.h>

#include "mesh/mesh_distance.h"
#include "rough.h"

static struct vec3 anywhere(double size)
{
    return vec(size * uniform(), size * uniform(), size * uniform());
}

/* Facets of any shape and size anywhere, slender ones among them. */
START_TEST(by_brute_force)
{
    for (int round = 0; round < 20; round++) {
        struct mesh m = {0};
        struct vec3 p = anywhere(2);
        double least = HUGE_VAL, distance;
        for (int f = 0; f < 12; f++) {
            struct vec3 a = anywhere(1), b = anywhere(1),
                        c = f % 3 ? anywhere(1) : vec_mix(a, b, 1.01);
            for (int i = 0; i <= 100; i++)
                for (int j = 0; j <= 100 - i; j++) {
                    struct vec3 q =
                        vec_along(vec_along(a, i / 100.0, vec_sub(b, a)), j / 100.0, vec_sub(c, a));
                    least = fmin(least, vec_distance(p, q));
                }
            int v = (int)m.vertex.n;
            *array_push(&m.vertex) = a;
            *array_push(&m.vertex) = b;
            *array_push(&m.vertex) = c;
            *array_push(&m.face) = (struct face){{v, v + 1, v + 2}};
        }
        mesh_distance(&m, &p, 1, 1, &distance);
        ck_assert_double_le(distance, least + 1e-12);
        ck_assert_double_ge(distance, least - 0.02);
        mesh_free(&m);
    }
}
END_TEST

START_TEST(flat_mesh)
{
    struct mesh m = {0};
    struct vec3 p[50];
    double one[50], three[50];
    for (int i = 0; i < 100; i++)
        *array_push(&m.vertex) = vec(i % 10, i / 10, 3);
    for (int i = 0; i < 89; i++)
        if (i % 10 < 9)
            *array_push(&m.face) = (struct face){{i, i + 1, i + 10}};
    for (int i = 0; i < 50; i++)
        p[i] = vec(1 + floor(7 * uniform()) + 0.2, 1 + floor(7 * uniform()) + 0.2, 6 * uniform());
    mesh_distance(&m, p, 50, 1, one);
    mesh_distance(&m, p, 50, 3, three);
    for (int i = 0; i < 50; i++) {
        ck_assert_double_eq_tol(one[i], fabs(p[i].z - 3), 1e-9);
        ck_assert_double_eq(one[i], three[i]);
    }
    mesh_free(&m);
}
END_TEST

/* mesh_coverage: points over and under a ring of facets, those in its middle and outside left out.
 */

enum { SIDES = 6, POINTS = 5000 };

/* A hexagon of circumradius 10 with a hexagonal hole of 4, steep between them. */
static struct mesh ring(void)
{
    struct mesh m = {0};
    for (int i = 0; i < SIDES; i++) {
        double a = PI / 3 * i;
        *array_push(&m.vertex) = vec(10 * cos(a), 10 * sin(a), 0);
        *array_push(&m.vertex) = vec(4 * cos(a), 4 * sin(a), 30);
    }
    for (int i = 0; i < SIDES; i++) {
        int out = 2 * i, next = 2 * ((i + 1) % SIDES);
        *array_push(&m.face) = (struct face){{out, next, next + 1}};
        *array_push(&m.face) = (struct face){{out, next + 1, out + 1}};
    }
    return m;
}

/* The largest of the distances from the middle across the sides, by the apothem of radius 1. */
static double across(struct vec3 p)
{
    double most = 0;
    for (int i = 0; i < SIDES; i++)
        most = fmax(most, p.x * cos(PI / 3 * (i + 0.5)) + p.y * sin(PI / 3 * (i + 0.5)));
    return most / cos(PI / 6);
}

START_TEST(a_ring)
{
    struct mesh m = ring();
    struct vec3s p = {0}, covered = {0};
    struct error error;
    size_t inside = 0;
    for (int i = 0; i < POINTS; i++) {
        *array_push(&p) = vec(24 * uniform() - 12, 24 * uniform() - 12, 100 * uniform());
        inside += across(p.item[i]) <= 10 && across(p.item[i]) >= 4;
    }
    for (int i = 0; i < SIDES; i++) { /* its corners belong to it */
        *array_push(&p) = vec_add(m.vertex.item[2 * i], vec(0, 0, -7));
        inside++;
    }
    ck_assert_int_eq(mesh_coverage(&m, p.item, p.n, 0.3, &covered, &error), 0);
    ck_assert_uint_eq(covered.n, inside);
    for (size_t i = 0; i < covered.n; i++) {
        ck_assert_double_le(across(covered.item[i]), 10 + 1e-9);
        ck_assert_double_ge(across(covered.item[i]), 4 - 1e-9);
    }
    ck_assert_int_eq(mesh_coverage(&m, NULL, 0, 0.3, &covered, &error), 0);
    ck_assert_uint_eq(covered.n, inside);
    mesh_free(&m);
    array_free(&p);
    array_free(&covered);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_distance");
    TCase *tests = tcase_create("mesh_distance");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, by_brute_force);
    tcase_add_test(tests, flat_mesh);
    tcase_add_test(tests, a_ring);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
