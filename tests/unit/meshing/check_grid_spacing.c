/* grid_spacing on a cylinder, whose facets are off by t^2 / 8 R. */
#include "meshing/grid_spacing.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"

static const double R = 12, OFF = 0.03;

static double uniform(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

/* A part of a cylinder about x, 60 x 60 mm and flat beside it, with noise evenly in +-noise. */
static struct vec3s scan(double spacing, double noise)
{
    struct vec3s points = {0};
    unsigned state = 5;

    for (double x = 0; x < 60; x += spacing)
        for (double a = -1.2; a < 1.2; a += spacing / R) {
            double r = R + noise * (2 * uniform(&state) - 1);
            *array_push(&points) = vec(x + 0.3 * spacing * uniform(&state), r * sin(a), r * cos(a));
        }
    return points;
}

static double needed(double spacing, double noise, double sigma)
{
    struct vec3s points = scan(spacing, noise);
    struct grid_spacing_options options = {spacing, 60, sigma, 1};
    double t = grid_spacing_needed(points.item, points.n, &options);

    array_free(&points);
    return t;
}

START_TEST(it_follows_from_the_surface_not_from_the_points)
{
    double exact = sqrt(8 * R * OFF); /* 1.70 */

    for (double spacing = 0.1; spacing < 0.6; spacing *= 1.5) {
        double t = needed(spacing, 0, 0);
        ck_assert_double_le(t, 1.1 * exact);
        ck_assert_double_ge(t, 0.6 * exact);
    }
}
END_TEST

START_TEST(noise_that_is_known_does_not_count)
{
    double t = needed(0.3, 0.03, 0.03 / sqrt(3));

    ck_assert_double_le(t, 1.3 * sqrt(8 * R * OFF));
    ck_assert_double_ge(t, 0.6 * sqrt(8 * R * OFF));
    ck_assert_double_eq(needed(0.3, 0.03, 0), 0.6); /* taken for a rough surface */
}
END_TEST

START_TEST(it_is_no_less_than_twice_the_points_spacing)
{
    ck_assert_double_eq(needed(1.5, 0, 0), 3);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("grid_spacing");
    TCase *tests = tcase_create("grid_spacing");
    tcase_set_timeout(tests, 30);
    tcase_add_test(tests, it_follows_from_the_surface_not_from_the_points);
    tcase_add_test(tests, noise_that_is_known_does_not_count);
    tcase_add_test(tests, it_is_no_less_than_twice_the_points_spacing);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
