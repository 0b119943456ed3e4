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

int main(void)
{
    Suite *suite = suite_create("meshnear");
    TCase *tests = tcase_create("meshnear");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, by_brute_force);
    tcase_add_test(tests, flat_mesh);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
