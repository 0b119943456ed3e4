/* smooth_up: a rippled line becomes smooth within its bounds, never below; what is smooth stays. */
#include <check.h>
#include <stdlib.h>

#include "gouge/smooth_up.h"
#include "base/array.h"
#include "noisy.h"

enum { N = 200 };

static const double LENGTH = 2.5; /* mm: waves that stay are six times as long */

static struct vec3 point[N], up[N];
static double most[N], rise[N];

/* Envelope of balls of 5 over points `gap` mm apart, on a curve of radius 40; sampled unevenly. */
static void make(double gap)
{
    double x = 0;

    noisy_seed(4);
    for (int i = 0; i < N; i++) {
        double from = x / gap - floor(x / gap) - 0.5;
        up[i] = vec_unit(vec(-x / 40, 0, 1));
        point[i] = vec(x, 0, x * x / 80 + 5 - gap * gap * from * from / 10);
        most[i] = 0.005;
        x += 0.05 + 0.1 * noisy_uniform();
    }
}

/* Sum of squared curvature along the points, raised or not. */
static double bending(bool raised)
{
    double sum = 0;

    for (int i = 1; i + 1 < N; i++) {
        struct vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = vec_along(point[i + k - 1], raised ? rise[i + k - 1] : 0, up[i + k - 1]);
        double a = vec_distance(p[0], p[1]), b = vec_distance(p[1], p[2]);
        struct vec3 d =
            vec_sub(vec_scale(1 / b, vec_sub(p[2], p[1])), vec_scale(1 / a, vec_sub(p[1], p[0])));
        sum += vec_dot(d, d) * 2 / (a + b);
    }
    return sum;
}

START_TEST(ripple)
{
    make(0.6); /* ripples of 0.009 mm */
    smooth_up(point, up, most, LENGTH, N, rise);
    for (int i = 0; i < N; i++) {
        ck_assert_double_ge(rise[i], 0);
        ck_assert_double_le(rise[i], most[i]);
    }
    ck_assert_double_eq(rise[0], 0);
    ck_assert_double_eq(rise[N - 1], 0);
    ck_assert_double_lt(bending(true), 0.5 * bending(false));
}
END_TEST

START_TEST(small_ripple_goes)
{
    make(0.3); /* 0.002 mm, within the bounds */
    smooth_up(point, up, most, LENGTH, N, rise);
    ck_assert_double_lt(bending(true), 0.12 * bending(false));
}
END_TEST

START_TEST(stays)
{
    for (int i = 0; i < N; i++) { /* straight */
        point[i] = vec(0.1 * i, 0.02 * i, 1);
        up[i] = vec(0, 0, 1);
        most[i] = 0.01;
    }
    smooth_up(point, up, most, LENGTH, N, rise);
    for (int i = 0; i < N; i++)
        ck_assert_double_lt(rise[i], 1e-9);
    make(0.6);
    for (int i = 0; i < N; i++)
        most[i] = 0;
    smooth_up(point, up, most, LENGTH, N, rise);
    for (int i = 0; i < N; i++)
        ck_assert_double_eq(rise[i], 0);
    smooth_up(point, up, most, LENGTH, 2, rise); /* nothing between */
    ck_assert_double_eq(rise[1], 0);
}
END_TEST

/* Points in one place bend nothing to infinity. */
START_TEST(twice_in_one_place)
{
    make(0.6);
    point[50] = point[51];
    smooth_up(point, up, most, LENGTH, N, rise);
    for (int i = 0; i < N; i++)
        ck_assert(rise[i] >= 0 && rise[i] <= most[i]);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("smooth_up");
    TCase *tests = tcase_create("smooth_up");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, ripple);
    tcase_add_test(tests, small_ripple_goes);
    tcase_add_test(tests, stays);
    tcase_add_test(tests, twice_in_one_place);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
