/* triangle_points: no place of a triangle is far from a point, and there are not too many. */
#include <check.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "math/triangle_points.h"
#include "rough.h"

static const struct vec3 triangles[][3] = {{{0, 0, 0}, {10, 0, 0}, {5, 0.05, 0}},
                                           {{0, 0, 0}, {10, 0, 0}, {10, 0.05, 3}},
                                           {{0, 0, 0}, {3, 0, 0}, {10, 1, 0}},
                                           {{0, 0, 0}, {5, 0, 1}, {1, 6, 2}},
                                           {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}}};

START_TEST(no_place_is_far)
{
    const struct vec3 *v = triangles[_i];
    const double spacing = 0.4;
    struct vec3s points = {0};

    for (int k = 0; k < 3; k++)
        *array_push(&points) = v[k];
    triangle_points(v, spacing, &points);
    for (int round = 0; round < 500; round++) {
        double s = fabs(uniform()), t = fabs(uniform()) * (1 - s), nearest = HUGE_VAL;
        struct vec3 p = vec_along(vec_along(v[0], s, vec_sub(v[1], v[0])), t, vec_sub(v[2], v[0]));
        for (size_t i = 0; i < points.n; i++)
            nearest = fmin(nearest, vec_distance(p, points.item[i]));
        ck_assert_double_le(nearest, 0.65 * spacing);
    }
    array_free(&points);
}

START_TEST(not_too_many)
{
    const struct vec3 corner[3] = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    const double spacing = 0.1, area = 6;
    struct vec3s points = {0};

    ck_assert_double_eq(triangle_longest(corner), 5);
    triangle_points(corner, spacing, &points);
    ck_assert_double_gt((double)points.n, area / (spacing * spacing));
    ck_assert_double_lt((double)points.n, 3 * area / (spacing * spacing));
    for (size_t i = 0; i < points.n; i++)
        ck_assert(points.item[i].z == 0 && points.item[i].x >= 0 && points.item[i].y >= 0);
    array_free(&points);
}

int main(void)
{
    Suite *suite = suite_create("triangle_points");
    TCase *tests = tcase_create("triangle_points");

    tcase_add_loop_test(tests, no_place_is_far, 0, sizeof triangles / sizeof *triangles);
    tcase_add_test(tests, not_too_many);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
