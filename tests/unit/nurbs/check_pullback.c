/* pullback: foot points on a sphere and a torus from anywhere, and over the seam of a cylinder. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "known.h"
#include "nurbs/pullback.h"

static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

START_TEST(seek)
{
    struct patch p = known_torus(20, 5);
    struct pullback on = pullback_new(&p.surface);
    ck_assert(on.closed_u && on.closed_v);
    for (int i = 0; i < 100; i++) {
        double a = uniform(0, 2 * PI), b = uniform(0, 2 * PI), r = 5 + uniform(-2, 3);
        double d = 20 + r * cos(b);
        struct vec3 q = {d * cos(a), d * sin(a), r * sin(b)};
        struct vec3 foot = pullback_point(&on, pullback_seek(&on, q));
        ck_assert_double_lt(fabs(vec_distance(foot, q) - fabs(r - 5)), 1e-9);
    }
    patch_free(&p);
}
END_TEST

/* Three times round: the parameter goes on rising, a turn of 4 each time. */
START_TEST(over_the_seam)
{
    struct patch p = known_cylinder(10, 20);
    struct pullback on = pullback_new(&p.surface);
    struct uv at = {0.01, 0.5}, first;
    ck_assert(on.closed_u && !on.closed_v);
    for (int way = 1; way >= -1; way -= 2) {
        at = first = pullback_foot(&on, vec(10, 0.2, 10), (struct uv){0.01, 0.5});
        for (int i = 1; i <= 300; i++) {
            double a = way * 6 * PI * i / 300 + atan2(0.2, 10);
            struct vec3 q = vec(10.3 * cos(a), 10.3 * sin(a), 10);
            struct uv next = pullback_foot(&on, q, at);
            ck_assert_double_gt(way * (next.u - at.u), 0);
            ck_assert_double_lt(way * (next.u - at.u), 0.1);
            ck_assert_double_lt(fabs(vec_distance(pullback_point(&on, next), q) - 0.3), 1e-9);
            at = next;
        }
        ck_assert_double_lt(fabs(at.u - first.u - way * 12), 1e-9);
    }
    patch_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("pullback");
    TCase *tests = tcase_create("pullback");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, seek);
    tcase_add_test(tests, over_the_seam);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
