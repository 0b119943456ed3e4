/* plane_fit: exact on planes however they lie, the rms of what is put off them, refused on lines.
 */
#include <check.h>

#include "math/plane_fit.h"
#include "rough.h"

enum { N = 30 };

START_TEST(exact_on_planes)
{
    for (int round = 0; round < 50; round++) {
        struct vec3 n = vec_unit(vec(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5)), p[N];
        struct vec3 u = vec_perpendicular(n), v = vec_cross(n, u), sum = vec(0, 0, 0);
        struct vec3 base = vec(500123, 4649776, 212);
        struct plane_fit plane;
        for (int i = 0; i < N; i++) {
            p[i] = vec_along(vec_along(base, 3 * uniform(), u), uniform(), v);
            sum = vec_along(sum, 1.0 / N, vec_sub(p[i], base));
        }
        ck_assert_int_eq(plane_fit(p, N, &plane), 0);
        ck_assert_double_ge(fabs(vec_dot(plane.normal, n)), 1 - 1e-12);
        ck_assert_double_le(plane.rms, 1e-7);
        ck_assert_double_le(vec_distance(plane.centre, vec_add(base, sum)), 1e-8);
        ck_assert_double_gt(plane.length, plane.width);
    }
}
END_TEST

/* A square's corners, every other one lifted and lowered: the plane stays, the rms is the lift. */
START_TEST(rms_of_a_saddle)
{
    const struct vec3 p[] = {{1, 1, 0.1}, {-1, 1, -0.1}, {-1, -1, 0.1}, {1, -1, -0.1}};
    struct plane_fit plane;
    ck_assert_int_eq(plane_fit(p, 4, &plane), 0);
    ck_assert_double_eq_tol(fabs(plane.normal.z), 1, 1e-12);
    ck_assert_double_eq_tol(plane.rms, 0.1, 1e-12);
    ck_assert_double_eq_tol(plane.width, 1, 1e-12);
}
END_TEST

START_TEST(lines_carry_no_plane)
{
    struct vec3 p[N];
    struct plane_fit plane;
    for (int i = 0; i < N; i++)
        p[i] = vec(i, 2 * i, -i);
    ck_assert_int_eq(plane_fit(p, N, &plane), -1);
    ck_assert_int_eq(plane_fit(p, 2, &plane), -1);
    for (int i = 0; i < N; i++)
        p[i] = vec(1, 2, 3);
    ck_assert_int_eq(plane_fit(p, N, &plane), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("plane_fit");
    TCase *tests = tcase_create("plane_fit");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, exact_on_planes);
    tcase_add_test(tests, rms_of_a_saddle);
    tcase_add_test(tests, lines_carry_no_plane);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
