/* mesh_coverage: points over and under a ring of facets, those in its middle and outside left out.
 */
#include <check.h>
#include <stdlib.h>

#include "mesh/mesh_distance.h"
#include "rough.h"

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
    Suite *suite = suite_create("meshcover");
    TCase *tests = tcase_create("meshcover");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_ring);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
