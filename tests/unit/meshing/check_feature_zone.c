/* feature_zone: near places along a line and off them, whatever their height. */
#include <check.h>
#include <math.h>
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
    zone = feature_zone_make(NULL, 0, 2);
    ck_assert(!feature_zone_near(&zone, 0, 0));
    feature_zone_free(&zone);
}
END_TEST

/* Near to places anywhere, by all of them one by one; in a plan that is long and narrow, too, where
 * squares are wider than that reaches. */
START_TEST(anywhere)
{
    for (int wide = 1; wide <= 1000; wide *= 1000) {
        struct vec3 place[60];
        unsigned found = 0;
        for (int i = 0; i < 60; i++)
            place[i] = vec(i * 7 % 60 * wide, i * 13 % 60, i);
        struct feature_zone zone = feature_zone_make(place, 60, 1.5);
        for (double x = -4.1 * wide; x < 64 * wide; x += 0.37 * wide)
            for (double y = -4.1; y < 64; y += 0.59) {
                bool near = false;
                for (int i = 0; i < 60; i++)
                    near |= hypot(x - place[i].x, y - place[i].y) < 1.5 * 1.5;
                ck_assert(feature_zone_near(&zone, x, y) == near);
                found += near;
            }
        ck_assert_uint_gt(found, 10);
        feature_zone_free(&zone);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_zone");
    TCase *tests = tcase_create("feature_zone");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, line);
    tcase_add_test(tests, anywhere);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
