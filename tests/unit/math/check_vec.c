/* check_vec - vectors in space against what is true of them. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/vec.h"
#include "seed.h"

static uint64_t state = 42;

/* -1 to 1 */
static double next_random(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / (double)(UINT64_C(1) << 52) - 1;
}

static struct vec3 random_unit(void)
{
    for (;;) {
        struct vec3 a = vec(next_random(), next_random(), next_random());
        if (vec_length(a) > 0.1)
            return vec_unit(a);
    }
}

static void same(struct vec3 a, struct vec3 b, double within)
{
    ck_assert_msg(vec_distance(a, b) <= within, "(%g %g %g), not (%g %g %g)", a.x, a.y, a.z, b.x,
                  b.y, b.z);
}

START_TEST(products)
{
    same(vec_cross(vec(1, 0, 0), vec(0, 1, 0)), vec(0, 0, 1), 0);
    for (int i = 0; i < 1000; i++) {
        struct vec3 a = random_unit(), b = random_unit(), c = vec_cross(a, b);
        ck_assert(fabs(vec_dot(a, c)) < 1e-15 && fabs(vec_dot(b, c)) < 1e-15);
        /* Lagrange's identity */
        double d = vec_dot(a, b);
        ck_assert_double_eq_tol(vec_dot(c, c), 1 - d * d, 1e-14);
        ck_assert(fabs(vec_dot(vec_reject(a, b), b)) < 1e-15);
    }
}
END_TEST

START_TEST(angles_are_exact_at_both_ends)
{
    ck_assert_double_eq_tol(vec_angle(vec(1, 0, 0), vec(1, 1e-9, 0)), 1e-9, 1e-18);
    ck_assert_double_eq_tol(vec_angle(vec(1, 0, 0), vec(-1, 1e-9, 0)), PI - 1e-9, 1e-15);
    ck_assert_double_eq_tol(vec_angle(vec(0, 2, 0), vec(0, 0, 7)), PI / 2, 1e-15);
    ck_assert_double_eq(DEGREES(PI), 180);
}
END_TEST

START_TEST(turning)
{
    same(vec_turn(vec(1, 0, 0), vec(0, 0, 1), PI / 2), vec(0, 1, 0), 1e-15);
    for (int i = 0; i < 1000; i++) {
        struct vec3 a = random_unit(), axis = random_unit();
        double angle = 4 * next_random();
        struct vec3 b = vec_turn(a, axis, angle);
        ck_assert_double_eq_tol(vec_length(b), 1, 1e-14);
        ck_assert_double_eq_tol(vec_dot(b, axis), vec_dot(a, axis), 1e-14);
        same(vec_turn(b, axis, -angle), a, 1e-14);
    }
}
END_TEST

START_TEST(great_circles)
{
    for (int i = 0; i < 1000; i++) {
        struct vec3 a = random_unit(), b = random_unit();
        double s = fabs(next_random()), whole = vec_angle(a, b);
        struct vec3 c = vec_slerp(a, b, s);
        ck_assert_double_eq_tol(vec_length(c), 1, 1e-13);
        ck_assert_double_eq_tol(vec_angle(a, c), s * whole, 1e-9);
        ck_assert_double_eq_tol(vec_angle(c, b), (1 - s) * whole, 1e-9);
    }
    /* nearly together, and opposite: still on the sphere, still in proportion */
    struct vec3 near = vec_slerp(vec(1, 0, 0), vec_unit(vec(1, 1e-8, 0)), 0.25);
    ck_assert_double_eq_tol(near.y, 0.25e-8, 1e-16);
    ck_assert_double_eq_tol(vec_angle(vec(1, 0, 0), vec_slerp(vec(1, 0, 0), vec(-1, 0, 0), 0.3)),
                            0.3 * PI, 1e-12);
}
END_TEST

START_TEST(units_and_perpendiculars)
{
    for (int i = 0; i < 3; i++)
        ck_assert_double_eq(vec_coordinate(vec(3, 4, 5), i), 3 + i);
    same(vec_unit(vec(0, 0, 0)), vec(0, 0, 0), 0);
    for (int i = 0; i < 1000; i++) {
        struct vec3 a = random_unit(), p = vec_perpendicular(a);
        ck_assert(fabs(vec_dot(a, p)) < 1e-15);
        ck_assert_double_eq_tol(vec_length(p), 1, 1e-15);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("vec");
    TCase *tests = tcase_create("vec");
    tcase_add_test(tests, products);
    tcase_add_test(tests, angles_are_exact_at_both_ends);
    tcase_add_test(tests, turning);
    tcase_add_test(tests, great_circles);
    tcase_add_test(tests, units_and_perpendiculars);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
