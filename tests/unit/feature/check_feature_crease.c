/* feature_test: a roof is sharp, with noise and without; a rib is not, though two planes lie
 * along its flanks. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "ribs.h"

/* Planes with this slope to both sides of the y axis, meeting at the height `high`, judged at five
 * places of a cloud. */
static int sharp_places(const struct vec3s *p, double noise, double slope, double high,
                        struct vec3 along)
{
    struct point_grid scan;
    struct error error;
    ck_assert_int_eq(point_grid_make(p->item, p->n, 0.2, 1, &scan, &error), 0);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2, .noise = noise};
    struct vec3 up = {0, 0, 1}, across = {along.y, -along.x, 0};
    int sharp = 0;
    for (int i = -2; i <= 2; i++) {
        struct vec3 at = vec_along(vec(0, 0, high), i, along);
        struct side_fit sheet[2];
        for (int k = 0; k < 2; k++) {
            struct vec3 normal = vec_unit(vec_along(up, k ? slope : -slope, across));
            sheet[k] = side_fit_through(at, normal, at, up);
        }
        sharp += feature_test_sharp(&cloud, sheet, up, at, along);
    }
    point_grid_free(&scan);
    return sharp;
}

START_TEST(roofs)
{
    const double noise[] = {0, 0.02, 0.05};
    for (int i = 0; i < 3; i++) {
        struct vec3s p = {0};
        rectangle(&p, 1250, vec(0, -5, 0), vec(5, 0, -2.5), vec(0, 10, 0), noise[i]);
        rectangle(&p, 1250, vec(0, -5, 0), vec(-5, 0, -2.5), vec(0, 10, 0), noise[i]);
        ck_assert_int_ge(sharp_places(&p, noise[i], 0.5, 0, vec(0, 1, 0)), 4);
        array_free(&p);
    }
}
END_TEST

/* The planes that touch a rib where it is steepest meet 0.17 mm over it. */
START_TEST(ribs)
{
    const double noise[] = {0, 0.02, 0.05};
    for (int i = 0; i < 3; i++) {
        struct vec3s p = rib_cloud(0.8, noise[i]);
        ck_assert_int_eq(sharp_places(&p, noise[i], 1.14, 0.97, vec(-RIB_SIN, RIB_COS, 0)), 0);
        array_free(&p);
    }
}
END_TEST

START_TEST(no_points)
{
    struct vec3s p = {0};
    rectangle(&p, 20, vec(-1, -1, 0), vec(2, 0, 0), vec(0, 2, 0), 0);
    ck_assert_int_eq(sharp_places(&p, 0, 0.5, 0, vec(0, 1, 0)), 0);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_crease");
    TCase *tests = tcase_create("feature_crease");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, roofs);
    tcase_add_test(tests, ribs);
    tcase_add_test(tests, no_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
