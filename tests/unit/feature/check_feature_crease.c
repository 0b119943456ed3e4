/* feature_crease: where and how an edge of a mesh crosses a ridge, from the points alone.
 * feature_test: a roof is sharp, with noise and without; a rib is not, though two planes lie
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

/* An edge across the ridge of a roof of slope `slope`, from x0 to x1, with the normals of the sides
 * (`known`) or upright ones. */
static struct feature crease_at(double slope, double x0, double x1, double y, bool known)
{
    struct vec3s p = {0};
    struct point_grid scan;
    struct error error;
    rectangle(&p, 1500, vec(0, -4, 0), vec(4, 0, -4 * slope), vec(0, 8, 0), 0);
    rectangle(&p, 1500, vec(0, -4, 0), vec(-4, 0, -4 * slope), vec(0, 8, 0), 0);
    ck_assert_int_eq(point_grid_make(p.item, p.n, 0.15, 1, &scan, &error), 0);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.15};
    struct vec3 a = vec(x0, y, -slope * fabs(x0)), b = vec(x1, y + 0.2, -slope * fabs(x1));
    struct vec3 left = vec_unit(vec(-slope, 0, 1)), right = vec_unit(vec(slope, 0, 1));
    struct feature f = feature_crease(&cloud, a, b, known && x0 < 0 ? left : right,
                                      known && x1 < 0 ? left : right);
    point_grid_free(&scan);
    array_free(&p);
    return f;
}

START_TEST(across_a_ridge)
{
    for (int i = -2; i <= 2; i++)
        for (int known = 0; known < 2; known++) {
            double slope = 0.5, share = 0.5 + 0.15 * i, y = 0.7 * i;
            struct feature f = crease_at(slope, -1.2 * share, 1.2 * (1 - share), y, known);
            ck_assert_int_eq(f.kind, FEATURE_CREASE);
            ck_assert_double_lt(vec_distance(f.place[0], vec(0, y + 0.2 * share, 0)), 1e-6);
            ck_assert_double_lt(vec_distance(f.place[0], f.place[1]), 1e-12);
            ck_assert_double_eq_tol(fabs(f.along.y), 1, 1e-9);
            for (int k = 0; k < 2; k++) {
                double sign = k ? 1 : -1, x = k ? 1.2 * (1 - share) : -1.2 * share;
                struct vec3 normal = vec_unit(vec(sign * slope, 0, 1));
                ck_assert_double_lt(vec_distance(f.normal[k], normal), 1e-6);
                ck_assert_double_lt(vec_distance(f.end[k], normal), 1e-6);
                ck_assert_double_eq_tol(f.foot[k].x, x, 1e-6);
                ck_assert_double_eq_tol(f.foot[k].z, -slope * fabs(x), 1e-6);
            }
            ck_assert_double_gt(f.known, 0.4); /* 72 points */
            ck_assert_double_lt(f.known, 1.2);
        }
}
END_TEST

/* On one side alone, on a plane, and at a roof whose sides turn by 7 degrees is none; by 10 there
 * is one. */
START_TEST(no_crease)
{
    ck_assert_int_eq(crease_at(0.5, 0.4, 1.4, 0, true).kind, FEATURE_NONE);
    ck_assert_int_eq(crease_at(0.5, -1.6, -0.7, 0, true).kind, FEATURE_NONE);
    ck_assert_int_eq(crease_at(0, -0.6, 0.6, 0, true).kind, FEATURE_NONE);
    ck_assert_int_eq(crease_at(tan(RADIANS(3.5)), -0.6, 0.6, 0, true).kind, FEATURE_NONE);
    ck_assert_int_eq(crease_at(tan(RADIANS(5)), -0.6, 0.6, 0, true).kind, FEATURE_CREASE);
}
END_TEST

/* A side of eight points is enough for its plane, one of seven is not: rows along a ridge. */
START_TEST(fewest)
{
    for (int few = 7; few <= 8; few++) {
        struct vec3s p = {0};
        struct point_grid scan;
        struct error error;
        for (int i = 0; i < 9; i++)
            for (int k = -4; k < 4; k++)
                *array_push(&p) = vec(-0.1 - 0.2 * i, 0.2 * k + 0.1, -0.5 * (0.1 + 0.2 * i));
        for (int k = 0; k < few; k++) {
            double x = 0.1 + 0.2 * (k / 4);
            *array_push(&p) = vec(x, 0.2 * (k % 4) - 0.3, -0.5 * x);
        }
        ck_assert_int_eq(point_grid_make(p.item, p.n, 0.2, 1, &scan, &error), 0);
        struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2};
        struct feature f = feature_crease(&cloud, vec(-0.5, 0, -0.25), vec(0.3, 0, -0.15),
                                          vec_unit(vec(-0.5, 0, 1)), vec_unit(vec(0.5, 0, 1)));
        ck_assert_int_eq(f.kind, few < 8 ? FEATURE_NONE : FEATURE_CREASE);
        point_grid_free(&scan);
        array_free(&p);
    }
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
    tcase_add_test(tests, across_a_ridge);
    tcase_add_test(tests, no_crease);
    tcase_add_test(tests, fewest);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
