/* feature_corner: three planes through a known place meet there, within their triangle only. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "rough.h"

static struct vec3 some_normal(void)
{
    return vec_unit(vec(normal(), normal(), normal()));
}

static struct feature_corner_plane through(struct vec3 place, struct vec3 normal)
{
    struct vec3 off = vec_reject(vec(uniform(), uniform(), uniform()), normal);
    return (struct feature_corner_plane){vec_along(place, 3, off), normal};
}

START_TEST(planes_meet)
{
    const struct vec3 triangle[3] = {{100, 50, 0}, {101, 50, 3}, {100.2, 51, 1}};
    const struct vec3 place = {100.4, 50.3, 7};
    int met = 0;
    for (int i = 0; i < 500; i++) {
        struct vec3 n[3] = {some_normal(), some_normal(), some_normal()}, at;
        struct feature_corner_plane plane[3] = {through(place, n[0]), through(place, n[1]),
                                                through(place, n[2])};
        if (!feature_corner(plane, triangle, &at))
            continue;
        met++;
        ck_assert_double_le(vec_distance(at, place), 1e-9);
    }
    ck_assert_int_ge(met, 350);
}
END_TEST

START_TEST(beside_the_triangle)
{
    const struct vec3 triangle[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const struct vec3 outside[3] = {{0.6, 0.6, 0}, {-0.1, 0.5, 0}, {0.5, -0.1, 0}};
    for (int i = 0; i < 3; i++) {
        struct vec3 at;
        struct feature_corner_plane plane[3] = {through(outside[i], vec(1, 0, 0)),
                                                through(outside[i], vec(0, 1, 0)),
                                                through(outside[i], vec(0, 0, 1))};
        ck_assert(!feature_corner(plane, triangle, &at));
    }
}
END_TEST

/* By 5 degrees is no corner. */
START_TEST(planes_that_hardly_turn)
{
    const struct vec3 triangle[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const struct vec3 place = {0.3, 0.3, 0};
    double turn = 5 * PI / 180;
    struct vec3 at;
    struct feature_corner_plane plane[3] = {through(place, vec(1, 0, 0)),
                                            through(place, vec(cos(turn), sin(turn), 0)),
                                            through(place, vec(0, 0, 1))};
    ck_assert(!feature_corner(plane, triangle, &at));
    plane[1] = through(place, vec(cos(4 * turn), sin(4 * turn), 0));
    ck_assert(feature_corner(plane, triangle, &at));
    struct feature_corner_plane mean = feature_corner_mean(plane[0], plane[1]);
    ck_assert_double_eq_tol(vec_dot(mean.normal, plane[0].normal), cos(2 * turn), 1e-12);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_corner");
    TCase *tests = tcase_create("feature_corner");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, planes_meet);
    tcase_add_test(tests, beside_the_triangle);
    tcase_add_test(tests, planes_that_hardly_turn);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
