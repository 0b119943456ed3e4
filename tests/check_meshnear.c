/* meshnear: distances from triangles by a dense search, and from a mesh by its known plane. */
#include <check.h>
#include <stdlib.h>

#include "meshnear.h"
#include "rough.h"

static struct vec3 anywhere(double size)
{
    return vec(size * uniform(), size * uniform(), size * uniform());
}

START_TEST(triangle_by_brute_force)
{
    for (int round = 0; round < 100; round++) {
        struct vec3 a = anywhere(1), b = anywhere(1), c = anywhere(1), p = anywhere(2);
        double least = HUGE_VAL;
        for (int i = 0; i <= 100; i++)
            for (int j = 0; j <= 100 - i; j++) {
                struct vec3 q = vec_along(vec_along(a, i / 100.0, vec_sub(b, a)), j / 100.0,
                                          vec_sub(c, a));
                least = fmin(least, vec_distance(p, q));
            }
        double distance = meshnear_triangle(p, a, b, c);
        ck_assert_double_le(distance, least + 1e-12);
        ck_assert_double_ge(distance, least - 0.02);
    }
    struct vec3 line = vec(1, 0, 0);
    ck_assert_double_eq_tol(meshnear_triangle(vec(0.5, 2, 0), vec(0, 0, 0), line, line), 2, 1e-12);
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
    meshnear(&m, p, 50, 1, one);
    meshnear(&m, p, 50, 3, three);
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
    tcase_add_test(tests, triangle_by_brute_force);
    tcase_add_test(tests, flat_mesh);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
