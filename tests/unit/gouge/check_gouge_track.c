/* gouge_track: along a way over a wavy ground, there and back and beside, it says what the guard
 * says, digit by digit. */
#include "gouge/gouge_track.h"

#include <check.h>
#include <stdlib.h>

static const double BALL = 3;

static double ground(double x, double y)
{
    return 0.8 * sin(x / 2) * cos(y / 3);
}

static struct gouge_check *make_ground(void)
{
    struct vec3s points = {0};
    for (int i = -60; i <= 60; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.2 * i, 0.2 * k, ground(0.2 * i, 0.2 * k));
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

/* Place s of a way that touches here and there, is bent, and turns round where s does. */
static struct vec3 on_way(double s, double beside)
{
    double x = s, y = 2 * sin(s / 4) + beside;
    return vec(x, y, BALL + ground(x, y) + 0.1 * sin(3 * s));
}

START_TEST(it_says_what_the_guard_says)
{
    struct gouge_check *guard = make_ground();
    struct gouge_track track = {0};
    size_t deep = 0, asked = 0;

    for (int round = 0; round < 4; round++)
        for (double s = -9, step = 0.07; s<9; s += step, step = step> 1.4 ? 0.001 : 1.3 * step) {
            struct vec3 a = on_way(round == 2 ? -s : s, 0.004 * round);
            struct vec3 b = on_way(round == 2 ? -s - step : s + step, 0.004 * round);
            double radius = BALL - 0.001 * round;
            double found = gouge_track_depth(&track, guard, a, b, radius);
            ck_assert_double_eq(found, gouge_depth_along(guard, a, b, radius));
            deep += found > 0;
            asked++;
        }
    ck_assert_uint_gt(deep, asked / 4);
    ck_assert_uint_lt(deep, asked);
    ck_assert_uint_lt(track.beside.n, asked); /* some pieces served again */
    gouge_track_free(&track);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gouge_track");
    TCase *tests = tcase_create("gouge_track");
    tcase_add_test(tests, it_says_what_the_guard_says);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
