/* view - projections are turns: lengths along, right-handed. */
#include <check.h>
#include <stdlib.h>

#include "plot/view.h"

START_TEST(frames_are_right_handed)
{
    for (int i = 0; i < VIEW_NAMES; i++) {
        struct view v = view_from((enum view_name)i);
        ck_assert_double_eq_tol(vec_length(v.right), 1, 1e-15);
        ck_assert_double_eq_tol(vec_length(v.up), 1, 1e-15);
        ck_assert_double_eq_tol(vec_distance(vec_cross(v.right, v.up), v.toward), 0, 1e-15);
    }
}
END_TEST

START_TEST(isometric_shortens_all_axes_alike)
{
    struct view v = view_from(VIEW_ISO);
    const struct vec3 axis[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; i++) {
        struct vec3 p = view_point(&v, axis[i]);
        ck_assert_double_eq_tol(hypot(p.x, p.y), sqrt(2.0 / 3), 1e-15);
    }
    ck_assert_double_gt(view_point(&v, axis[2]).y, 0.8);
    ck_assert_double_gt(view_point(&v, axis[2]).z, 0);
}
END_TEST

START_TEST(named_views_show_what_they_say)
{
    struct vec3 p = vec(1, 2, 3);
    struct view v = view_from(VIEW_PLAN);
    ck_assert_double_eq_tol(vec_distance(view_point(&v, p), vec(1, 2, 3)), 0, 1e-15);
    v = view_from(VIEW_FRONT);
    ck_assert_double_eq_tol(vec_distance(view_point(&v, p), vec(1, 3, -2)), 0, 1e-15);
    v = view_from(VIEW_SIDE);
    ck_assert_double_eq_tol(vec_distance(view_point(&v, p), vec(2, 3, 1)), 0, 1e-15);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("view");
    TCase *tests = tcase_create("view");
    tcase_add_test(tests, frames_are_right_handed);
    tcase_add_test(tests, isometric_shortens_all_axes_alike);
    tcase_add_test(tests, named_views_show_what_they_say);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
