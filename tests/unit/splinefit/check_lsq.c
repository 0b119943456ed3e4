/*
 * lsq, against what is known: data from a B-spline gives its poles back, data from a cubic
 * polynomial is met by any knots, and elsewhere the sum of squares is least (no change of a pole
 * makes it less).
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "splinefit/knots.h"
#include "splinefit/lsq.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static struct vec3 random_point(void)
{
    double x = 20 * chance() - 10, y = 20 * chance() - 10, z = 20 * chance() - 10;
    return vec(x, y, z);
}

/* Knots from random parameters, so that each span holds data. */
static struct bspline random_frame(int degree, size_t poles, bool head, double *u, size_t n)
{
    struct bspline b = bspline_new(degree, poles, head);

    u[0] = 0;
    for (size_t k = 1; k < n; k++)
        u[k] = u[k - 1] + 0.1 + chance();
    for (size_t k = 0; k < n; k++)
        u[k] /= u[n - 1];
    knots_fill(KNOTS_AVERAGE, u, n, degree, poles, b.knot);
    return b;
}

START_TEST(a_spline_gives_its_poles_back)
{
    double u[120];
    struct vec3 point[120], head[120];

    seed = 7;
    for (int turn = 0; turn < 200; turn++) {
        int degree = 1 + turn % 5;
        size_t poles = (size_t)degree + 1 + (size_t)(20 * chance());
        size_t n = 2 * poles + (size_t)(60 * chance());
        struct bspline truth = random_frame(degree, poles, true, u, n);

        for (size_t i = 0; i < poles; i++) {
            truth.pole[i] = random_point();
            truth.head[i] = vec_add(truth.pole[i], vec(chance(), chance(), 100));
        }
        for (size_t k = 0; k < n; k++) {
            point[k] = bspline_at(&truth, truth.pole, u[k]);
            head[k] = bspline_at(&truth, truth.head, u[k]);
        }
        struct bspline got = bspline_copy(&truth);
        for (size_t i = 0; i < poles; i++)
            got.pole[i] = got.head[i] = vec(0, 0, 0);
        ck_assert(lsq_fit(&got, u, point, head, n));
        for (size_t i = 0; i < poles; i++) {
            ck_assert_double_lt(vec_distance(got.pole[i], truth.pole[i]), 1e-8);
            ck_assert_double_lt(vec_distance(got.head[i], truth.head[i]), 1e-8);
        }
        bspline_free(&got);
        bspline_free(&truth);
    }
}
END_TEST

START_TEST(a_cubic_is_met_by_any_knots)
{
    double u[60];
    struct vec3 point[60];

    seed = 8;
    for (int turn = 0; turn < 50; turn++) {
        struct bspline b = random_frame(3, 4 + (size_t)(turn % 20), false, u, 60);

        for (size_t k = 0; k < 60; k++) {
            double t = 4 * u[k] - 2;
            point[k] = vec(t * t * t - t, 2 * t * t + 1, 3 - t);
        }
        ck_assert(lsq_fit(&b, u, point, NULL, 60));
        for (int k = 0; k <= 100; k++) {
            double t = 4 * k / 100.0 - 2;
            struct vec3 p = bspline_at(&b, b.pole, k / 100.0);
            ck_assert_double_lt(vec_distance(p, vec(t * t * t - t, 2 * t * t + 1, 3 - t)), 1e-11);
        }
        bspline_free(&b);
    }
}
END_TEST

static double sum_of_squares(const struct bspline *b, const double *u, const struct vec3 *point)
{
    double sum = 0;

    for (size_t k = 0; k < 60; k++) {
        struct vec3 off = vec_sub(bspline_at(b, b->pole, u[k]), point[k]);
        sum += vec_dot(off, off);
    }
    return sum;
}

START_TEST(nothing_is_less_and_the_ends_are_fixed)
{
    double u[60];
    struct vec3 point[60];

    seed = 9;
    for (int turn = 0; turn < 50; turn++) {
        struct bspline b = random_frame(1 + turn % 4, 6 + (size_t)(turn % 20), false, u, 60);

        for (size_t k = 0; k < 60; k++)
            point[k] = random_point();
        ck_assert(lsq_fit(&b, u, point, NULL, 60));
        ck_assert(vec_distance(b.pole[0], point[0]) == 0);
        ck_assert(vec_distance(b.pole[b.poles - 1], point[59]) == 0);
        double least = sum_of_squares(&b, u, point);
        for (size_t i = 1; i + 1 < b.poles; i++) {
            struct vec3 kept = b.pole[i];
            b.pole[i] = vec_along(kept, 1e-3, vec_unit(random_point()));
            ck_assert_double_gt(sum_of_squares(&b, u, point), least);
            b.pole[i] = kept;
        }
        bspline_free(&b);
    }
}
END_TEST

/* All data in the first half of the knots' range: the poles of the second half are free. */
START_TEST(spans_without_data)
{
    double u[40];
    struct vec3 point[40];
    struct bspline b = bspline_new(3, 12, false);

    seed = 10;
    for (size_t k = 0; k < 40; k++) {
        u[k] = k < 39 ? (double)k / 80 : 1;
        point[k] = random_point();
    }
    knots_fill(KNOTS_UNIFORM, u, 40, 3, 12, b.knot);
    ck_assert(!lsq_fit(&b, u, point, NULL, 40));
    ck_assert(!lsq_fit(&b, u, point, NULL, 11)); /* more poles than points */
    bspline_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lsq");
    TCase *tests = tcase_create("lsq");

    tcase_add_test(tests, a_spline_gives_its_poles_back);
    tcase_add_test(tests, a_cubic_is_met_by_any_knots);
    tcase_add_test(tests, nothing_is_less_and_the_ends_are_fixed);
    tcase_add_test(tests, spans_without_data);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
