/* feature_zone: near places along a line and off them, whatever their height. */
#include <check.h>
#include <stdlib.h>

#include "meshing/feature_zone.h"

START_TEST(line)
{
    struct vec3 place[21];
    for (int i = 0; i < 21; i++)
        place[i] = vec(3, i, 40 * i);
    struct feature_zone zone = feature_zone_make(place, 21, 2);
    for (int i = 0; i < 21; i++) {
        ck_assert(feature_zone_clear(&zone, 3.59, i));
        ck_assert(!feature_zone_clear(&zone, 2.39, i));
        ck_assert(feature_zone_near(&zone, 0.01, i));
        ck_assert(!feature_zone_near(&zone, 6.2, i));
        ck_assert(feature_zone_clear(&zone, 3.2, i + 0.5 * (i < 20)));
    }
    ck_assert(!feature_zone_near(&zone, 3, -3.01));
    feature_zone_free(&zone);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_zone");
    TCase *tests = tcase_create("feature_zone");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, line);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
