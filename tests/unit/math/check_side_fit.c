/* flank: planes and quadrics as heights over a shared plane. */
#include <check.h>
#include <stdlib.h>

#include "math/side_fit.h"
#include "rough.h"

START_TEST(plane_through_its_points)
{
    struct vec3s p = {0};
    struct side_fit fitted, told;
    struct vec3 w = vec_unit(vec(0.2, 0.1, 1)),
                n = vec_unit(vec_cross(vec(4, 0, 1), vec(0, 4, -1)));
    rectangle(&p, 30, vec(1, 2, 3), vec(4, 0, 1), vec(0, 4, -1), 0);
    ck_assert_int_eq(side_fit_plane(p.item, p.n, vec(0, 0, 0), w, &fitted), 0);
    told = side_fit_through(vec(1, 2, 3), n, vec(0, 0, 0), w);
    for (int i = 0; i < 20; i++) {
        struct vec3 q = vec(9 * uniform(), 9 * uniform(), 9 * uniform());
        ck_assert_double_eq_tol(side_fit_height(&fitted, q), side_fit_height(&told, q), 1e-9);
        ck_assert_double_eq_tol(vec_dot(vec_sub(side_fit_point(&fitted, q), vec(1, 2, 3)), n), 0,
                                1e-9);
        ck_assert_double_eq_tol(side_fit_above(&fitted, side_fit_point(&fitted, q)), 0, 1e-12);
        ck_assert_double_le(vec_distance(side_fit_normal(&fitted, q), n), 1e-9);
    }
    array_free(&p);
}
END_TEST

/* On a sphere of 20 mm a quadric takes the place of the plane; on a noisy plane it does not. */
START_TEST(bends_where_it_must)
{
    struct vec3 ball[60], centre = vec(0, 0, -20);
    struct vec3s flat = {0};
    struct side_fit f;
    for (int i = 0; i < 60; i++)
        ball[i] = vec_along(centre, 20, vec_unit(vec(0.2 * uniform(), 0.2 * uniform(), 1)));
    ck_assert_int_eq(side_fit_plane(ball, 60, vec(0, 0, 0), vec(0, 0, 1), &f), 0);
    double rms = f.rms;
    side_fit_bend(ball, 60, &f);
    ck_assert_double_lt(f.rms, 0.1 * rms);
    struct vec3 on = vec_along(centre, 20, vec_unit(vec(0.1, 0.1, 1)));
    ck_assert_double_eq_tol(side_fit_above(&f, on), 0, 1e-3);
    ck_assert_double_le(vec_angle(side_fit_normal(&f, on), vec_sub(on, centre)), 1e-3);

    rectangle(&flat, 60, vec(0, 0, 0), vec(4, 0, 0), vec(0, 4, 0), 0.05);
    ck_assert_int_eq(side_fit_plane(flat.item, 60, vec(0, 0, 0), vec(0, 0, 1), &f), 0);
    side_fit_bend(flat.item, 60, &f);
    ck_assert(f.q.c[3] == 0);
    array_free(&flat);
}
END_TEST

START_TEST(a_line_carries_none)
{
    struct vec3 p[10];
    struct side_fit f;
    for (int i = 0; i < 10; i++)
        p[i] = vec(i, i, 1);
    ck_assert_int_eq(side_fit_plane(p, 10, vec(0, 0, 0), vec(0, 0, 1), &f), -1);
    ck_assert_int_eq(side_fit_plane(p, 3, vec(0, 0, 0), vec(0, 0, 1), &f), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("side_fit");
    TCase *tests = tcase_create("side_fit");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, plane_through_its_points);
    tcase_add_test(tests, bends_where_it_must);
    tcase_add_test(tests, a_line_carries_none);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
