/* transform: points, products and determinants against maps that can be worked out by hand. */
#include <check.h>
#include <stdlib.h>

#include "math/transform.h"

static void expect(struct vec3 got, double x, double y, double z)
{
    ck_assert_double_eq_tol(got.x, x, 1e-12);
    ck_assert_double_eq_tol(got.y, y, 1e-12);
    ck_assert_double_eq_tol(got.z, z, 1e-12);
}

/* A quarter turn about z. */
static const struct transform quarter = {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};

START_TEST(points)
{
    struct transform inch = transform_scale(25.4), shift = transform_shift(vec(1, 2, 3));
    expect(transform_point(&inch, vec(1, -2, 0.5)), 25.4, -50.8, 12.7);
    expect(transform_point(&shift, vec(1, 1, 1)), 2, 3, 4);
    expect(transform_point(&quarter, vec(5, 1, 7)), -1, 5, 7);
    struct vec3 several[2] = {{1, 0, 0}, {0, 1, 0}};
    transform_points(&quarter, several, 2);
    expect(several[0], 0, 1, 0);
    expect(several[1], -1, 0, 0);
}
END_TEST

START_TEST(product_is_right_one_first)
{
    struct transform shift = transform_shift(vec(10, 0, 0));
    struct transform turned_later = transform_product(quarter, shift);
    struct transform shifted_later = transform_product(shift, quarter);
    expect(transform_point(&turned_later, vec(1, 0, 0)), 0, 11, 0);
    expect(transform_point(&shifted_later, vec(1, 0, 0)), 10, 1, 0);
}
END_TEST

START_TEST(identity)
{
    struct transform t = transform_identity(), shift = transform_shift(vec(0, 0, 1e-30));
    ck_assert(transform_is_identity(&t));
    ck_assert(!transform_is_identity(&shift));
    t = transform_scale(1.0000001);
    ck_assert(!transform_is_identity(&t));
}
END_TEST

START_TEST(determinant)
{
    struct transform t = transform_scale(2), mirror = transform_identity();
    ck_assert_double_eq_tol(transform_determinant(&t), 8, 1e-12);
    ck_assert_double_eq_tol(transform_determinant(&quarter), 1, 1e-12);
    mirror.m[1][1] = -1;
    ck_assert_double_eq_tol(transform_determinant(&mirror), -1, 1e-12);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("transform");
    TCase *tests = tcase_create("transform");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, points);
    tcase_add_test(tests, product_is_right_one_first);
    tcase_add_test(tests, identity);
    tcase_add_test(tests, determinant);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
