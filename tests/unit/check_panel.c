/* check_panel - the tests' exact surface against figures of the generator it was taken from. */
#include <check.h>
#include <stdlib.h>

#include "panel.h"

/* Points and their signed distances as the cloud generator prints them. */
static const struct {
    struct vec3 p;
    double distance;
} known[] = {
    {{23.3320, -5.0161, 20.7707}, 7.999984},  {{22.0547, 24.4477, 6.1389}, -0.499984},
    {{1.1035, 20.6802, 10.8735}, 0.002989},   {{-15.6602, 18.6855, 12.8728}, 2.000008},
    {{-34.7464, -6.3184, 17.4353}, 8.000043}, {{-8.4138, -1.5346, 22.1378}, 7.500034},
    {{-6.5899, 9.1878, 14.1770}, 0.000022},   {{-33.0759, -23.1573, 6.8331}, 0.999991},
    {{-32.4817, 2.8900, 10.0146}, -0.019975}, {{37.6696, -12.7163, 12.3261}, 4.999971},
    {{38.1427, -28.1600, 4.9943}, 3.000046},  {{0.0000, -9.7749, 20.8620}, 8.499987},
};

START_TEST(distances_are_the_generators)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        ck_assert_double_eq_tol(panel_distance(known[i].p), known[i].distance, 2e-6);
}
END_TEST

START_TEST(heights_run_from_0_to_15)
{
    double low = 99, high = -99;
    for (int i = 0; i <= 740; i++)
        for (int k = 0; k <= 540; k++) {
            double z = panel_height(-37 + 0.1 * i, -27 + 0.1 * k);
            low = fmin(low, z);
            high = fmax(high, z);
        }
    ck_assert_double_eq_tol(low, 0, 1e-9);
    ck_assert_double_eq_tol(high, 15, 1e-9);
}
END_TEST

/* The distance can change by no more than the way between two points. */
START_TEST(distance_is_a_distance)
{
    for (int i = 0; i < 200; i++) {
        double x = -40 + 0.4 * i, y = 20 * sin(i);
        double a = panel_distance(vec(x, y, 18)), b = panel_distance(vec(x + 0.01, y, 18.02));
        ck_assert_double_le(fabs(a - b), hypot(0.01, 0.02) + 1e-9);
        ck_assert_double_eq_tol(panel_distance(vec(x, y, panel_height(x, y))), 0, 1e-12);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("panel");
    TCase *tcase = tcase_create("panel");
    tcase_add_test(tcase, distances_are_the_generators);
    tcase_add_test(tcase, heights_run_from_0_to_15);
    tcase_add_test(tcase, distance_is_a_distance);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
