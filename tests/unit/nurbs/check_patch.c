/* patch: lines and curves as they are made, and that all of it is given back. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"

START_TEST(a_line_is_straight)
{
    struct nurbs_curve c = patch_line((struct uv){1, 2}, (struct uv){5, -6});
    for (int i = 0; i <= 8; i++) {
        struct vec3 p = nurbs_curve_point(&c, i / 8.0);
        ck_assert_double_lt(vec_distance(p, vec(1 + i / 2.0, 2 - i, 0)), 1e-14);
    }
    nurbs_curve_free(&c);
}
END_TEST

START_TEST(a_curve_is_a_bezier)
{
    struct nurbs_curve c = patch_curve(3, 4);
    for (int i = 0; i < 4; i++)
        c.pole[i] = (struct nurbs_pole){i == 3, i == 2, i == 1, 1};
    for (int i = 0; i <= 10; i++) {
        double t = i / 10.0, s = 1 - t;
        struct vec3 want = vec(t * t * t, 3 * t * t * s, 3 * t * s * s);
        ck_assert_double_lt(vec_distance(nurbs_curve_point(&c, t), want), 1e-14);
    }
    nurbs_curve_free(&c);
}
END_TEST

START_TEST(size)
{
    struct patches all = {0};
    ck_assert_double_eq(patches_size(&all), 0);
    *array_push(&all) = known_sphere(5); /* its poles are a box of 10 */
    ck_assert_double_lt(fabs(patches_size(&all) - 10 * sqrt(3)), 1e-12);
    *array_push(&all) = known_cylinder(1, 25);
    ck_assert_double_lt(fabs(patches_size(&all) - sqrt(100 + 100 + 900)), 1e-12);
    patches_free(&all);
}
END_TEST

START_TEST(freed_is_empty)
{
    struct patches all = {0};
    for (int i = 0; i < 3; i++) {
        struct patch *p = array_push(&all);
        *p = known_sphere(5);
        struct patch_loop *loop = array_push(&p->loop);
        *loop = (struct patch_loop){0};
        *array_push(loop) = patch_line((struct uv){0, 0}, (struct uv){1, 1});
        *array_push(loop) = patch_curve(2, 3);
    }
    patches_free(&all);
    ck_assert_uint_eq(all.n, 0);
    ck_assert_ptr_null(all.item);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("patch");
    TCase *tests = tcase_create("patch");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_line_is_straight);
    tcase_add_test(tests, a_curve_is_a_bezier);
    tcase_add_test(tests, size);
    tcase_add_test(tests, freed_is_empty);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
