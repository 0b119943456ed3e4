/* least_planes: facets that meet over each other's edges, through the points of a neighbourhood. */
#include <check.h>
#include <stdlib.h>

#include "math/least_planes.h"
#include "rough.h"

enum { MANY = LEAST_PLANES_POINTS, TRIES = 40 };

static struct vec3 local[MANY];

static struct vec3 in_disc(void)
{
    for (;;) {
        struct vec3 p = vec(2 * uniform() - 1, 2 * uniform() - 1, 0);
        if (hypot(p.x, p.y) < 1)
            return p;
    }
}

/* The lowest of n planes that turn down all round, through a place near the middle. */
static double roof(int n, double turn, struct vec3 top, double x, double y)
{
    double lowest = HUGE_VAL;

    for (int k = 0; k < n; k++) {
        double t = turn + 2 * PI * k / n;
        lowest = fmin(lowest, -0.1 * ((x - top.x) * cos(t) + (y - top.y) * sin(t)));
    }
    return lowest + 0.3 * x;
}

/* How many of the roofs are found to the last digits. */
static int count_found(int planes)
{
    int found = 0;

    for (int k = 0; k < TRIES; k++) {
        double turn = PI * uniform(), worst = 0;
        struct vec3 top = vec_scale(0.3, in_disc());
        struct least_planes fit;
        for (int i = 0; i < MANY; i++) {
            local[i] = in_disc();
            local[i].z = roof(planes, turn, top, local[i].x, local[i].y);
        }
        ck_assert_int_eq(least_planes_fit(local, MANY, 1e-9, &fit), 0);
        for (int i = 0; i < MANY && fit.rms < 1e-9; i++) {
            struct vec3 p = in_disc();
            worst = fmax(worst,
                         fabs(least_planes_at(&fit, p.x, p.y) - roof(planes, turn, top, p.x, p.y)));
        }
        found += fit.rms < 1e-9 && worst < 1e-7;
    }
    return found;
}

/* Starts are few: what is missed is told by its rms.  Under 61 seeds no roof of two planes was, at
 * most one of 40 of three, and four of four. */
START_TEST(roofs_as_they_are)
{
    ck_assert_int_eq(count_found(2), TRIES);
    ck_assert_int_ge(count_found(3), TRIES - 4);
    ck_assert_int_ge(count_found(4), TRIES - 12);
}
END_TEST

/* What is left of a roof with noise is the noise, 58 degrees of freedom; three standard deviations
 * of it are missed by chance once in 370 times, and a start may be missed, too. */
START_TEST(noise_is_left)
{
    const double sigma = 0.003;
    int good = 0;

    for (int k = 0; k < TRIES; k++) {
        struct least_planes fit;
        for (int i = 0; i < MANY; i++) {
            local[i] = in_disc();
            local[i].z = roof(2, 1, vec(0, 0, 0), local[i].x, local[i].y) + sigma * normal();
        }
        ck_assert_int_eq(least_planes_fit(local, MANY, 1.3 * sigma, &fit), 0);
        good += fabs(fit.rms / sigma - 1) < 3 / sqrt(2 * 58.) &&
                fabs(least_planes_at(&fit, 0, 0)) < 3 * sigma;
    }
    ck_assert_int_ge(good, TRIES - 6);
}
END_TEST

/* The lowest of any planes bends down: the best of them for a valley |u| of a disc is level, which
 * leaves sqrt(1 / 4 - (4 / 3 pi)^2) = 0.265. */
START_TEST(valleys_are_none)
{
    struct least_planes fit;

    for (int i = 0; i < MANY; i++) {
        local[i] = in_disc();
        local[i].z = fabs(local[i].x);
    }
    ck_assert(least_planes_fit(local, MANY, 0, &fit) != 0 || fit.rms > 0.15);
}
END_TEST

/* Each plane takes five points, not on a line. */
START_TEST(none_through_few_points)
{
    struct least_planes fit;

    for (int i = 0; i < MANY; i++) {
        local[i] = in_disc();
        local[i].z = -fabs(local[i].x);
    }
    ck_assert_int_ne(least_planes_fit(local, 9, 0, &fit), 0);
    for (int i = 0; i < MANY; i++)
        local[i].y = 2 * local[i].x;
    ck_assert_int_ne(least_planes_fit(local, MANY, 0, &fit), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("least_planes");
    TCase *tests = tcase_create("least_planes");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, roofs_as_they_are);
    tcase_add_test(tests, noise_is_left);
    tcase_add_test(tests, valleys_are_none);
    tcase_add_test(tests, none_through_few_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
