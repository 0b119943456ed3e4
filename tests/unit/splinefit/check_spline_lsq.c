/* Tests of spline_lsq.h: parameters, knots and poles against The NURBS Book and curves that are
 * known, and the measures of paper 2. */
#include "splinefit/spline_lsq.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/vec.h"
#include "seed.h"

START_TEST(by_hand)
{
    const double chord[] = {4, 9, 0, 3};
    double u[5];

    params_fill(PARAMS_UNIFORM, chord, 5, u);
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], k / 4.0, 1e-15);
    params_fill(PARAMS_CHORD, chord, 5, u);
    const double by_chord[] = {0, 4 / 16.0, 13 / 16.0, 13 / 16.0, 1};
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], by_chord[k], 1e-15);
    params_fill(PARAMS_CENTRIPETAL, chord, 5, u);
    double sum = 5 + sqrt(3);
    const double centripetal[] = {0, 2 / sum, 5 / sum, 5 / sum, 1};
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], centripetal[k], 1e-15);
}
END_TEST

/* Q = (0,0) (3,4) (-1,4) (-4,0) (-4,-3): u = 0, 5/17, 9/17, 14/17, 1. */
START_TEST(worked_example)
{
    const double chord[] = {5, 4, 5, 3}, expected[] = {0, 5 / 17.0, 9 / 17.0, 14 / 17.0, 1};
    double u[5];

    params_fill(PARAMS_CHORD, chord, 5, u);
    for (int k = 0; k < 5; k++)
        ck_assert_double_eq_tol(u[k], expected[k], 1e-15);
}
END_TEST

START_TEST(points_in_one_place)
{
    const double chord[] = {0, 0};
    double u[3];

    params_fill(PARAMS_CENTRIPETAL, chord, 3, u);
    ck_assert(u[0] == 0 && u[1] == 0.5 && u[2] == 1);
}
END_TEST

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

START_TEST(uniform)
{
    const double u[] = {0, 0.1, 0.2, 0.3, 0.4, 1};
    const double expected[] = {0, 0, 0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1, 1};
    double knot[10];

    knots_fill(KNOTS_UNIFORM, u, 6, 3, 6, knot);
    for (int i = 0; i < 10; i++)
        ck_assert_double_eq_tol(knot[i], expected[i], 1e-15);
}
END_TEST

/* u of example 9.1 with as many poles as points: one inner knot, 28/51. */
START_TEST(average_of_as_many_poles_as_points)
{
    const double u[] = {0, 5 / 17.0, 9 / 17.0, 14 / 17.0, 1};
    double knot[9];

    knots_fill(KNOTS_AVERAGE, u, 5, 3, 5, knot);
    ck_assert_double_eq_tol(knot[4], 28 / 51.0, 1e-15);
    ck_assert(knot[3] == 0 && knot[5] == 1);
}
END_TEST

/*
 * m + 1 = 11 points u_k = (k/10)^2, p = 3, n + 1 = 6: d = 11/3; j = 1: i = 3, alpha = 2/3,
 * knot = 1/3 u_2 + 2/3 u_3; j = 2: i = 7, alpha = 1/3, knot = 2/3 u_6 + 1/3 u_7.
 */
START_TEST(average_by_hand)
{
    double u[11], knot[10];

    for (int k = 0; k <= 10; k++)
        u[k] = k * k / 100.0;
    knots_fill(KNOTS_AVERAGE, u, 11, 3, 6, knot);
    ck_assert_double_eq_tol(knot[4], (0.04 + 2 * 0.09) / 3, 1e-15);
    ck_assert_double_eq_tol(knot[5], (2 * 0.36 + 0.49) / 3, 1e-15);
}
END_TEST

START_TEST(every_span_holds_data)
{
    double u[200], knot[210];

    seed = 5;
    for (int turn = 0; turn < 300; turn++) {
        int degree = 1 + turn % 5;
        size_t n = 20 + (size_t)(180 * chance());
        size_t poles = (size_t)degree + 1 + (size_t)((double)(n - (size_t)degree - 1) * chance());

        u[0] = 0;
        for (size_t k = 1; k < n; k++)
            u[k] = u[k - 1] + (chance() < 0.5 ? 0.001 : 1) * (0.01 + chance());
        for (size_t k = 0; k < n; k++)
            u[k] /= u[n - 1];
        knots_fill(KNOTS_AVERAGE, u, n, degree, poles, knot);
        size_t k = 0;
        for (size_t i = (size_t)degree; i < poles; i++) {
            ck_assert_double_lt(knot[i], knot[i + 1]);
            while (k < n && u[k] < knot[i])
                k++;
            ck_assert(k < n && u[k] <= knot[i + 1]);
        }
    }
}
END_TEST

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

START_TEST(errors_by_hand)
{
    struct bspline b = bspline_new(1, 2, false);
    const double u[] = {0, 1, 2, 3};
    const struct vec3 point[] = {{0, 0, 0}, {1, 3, 0}, {2, 0, 4}, {3, 0, 0}};

    b.knot[2] = b.knot[3] = 3;
    b.pole[1] = vec(3, 0, 0);
    struct fit_error d = fit_error_of(&b, b.pole, point, u, 4);
    ck_assert_double_eq_tol(d.c1, 4, 1e-15);
    ck_assert_double_eq_tol(d.c2, 5 / 4.0, 1e-15); /* eq 8: sqrt(9 + 16) / 4 */
    ck_assert_double_eq_tol(d.rms, sqrt(25 / 4.0), 1e-15);
    ck_assert_double_eq_tol(d.middle, 2.5, 1e-15); /* (1.5, 1.5, 2) from (1.5, 0, 0) */
    bspline_free(&b);
}
END_TEST

static struct run_point pose(double x, double tilt)
{
    struct vec3 axis = vec(sin(tilt), 0, cos(tilt)), tip = vec(x, 1, 2);
    return (struct run_point){.tip = tip, .ball = vec_along(tip, 8, axis), .axis = axis};
}

START_TEST(curves_of_degree_1)
{
    struct run_point item[] = {pose(0, 0), pose(1, 0.1), pose(3, 0.2)};
    struct run run = {.n = 3, .item = item, .radius = 8};
    struct reference t = reference_distinct(&run, false);
    struct bspline line = spline_straight(&t), chain = spline_polyline(&t);

    ck_assert(line.degree == 1 && line.poles == 2 && line.length == HEAD_LENGTH);
    ck_assert_double_lt(vec_distance(bspline_at(&line, line.pole, 0.5), vec(1.5, 1, 2)), 1e-14);
    ck_assert_uint_eq(chain.poles, 3);
    for (size_t k = 0; k < 3; k++) {
        double u = chain.knot[k + 1];
        ck_assert_double_lt(vec_distance(bspline_at(&chain, chain.pole, u), t.point[k]), 1e-14);
        ck_assert_double_lt(vec_distance(bspline_at(&chain, chain.head, u), spline_head(&t, k)),
                            1e-12);
    }
    bspline_free(&chain);
    bspline_free(&line);
    reference_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("spline_lsq");
    tcase_add_test(t, by_hand);
    tcase_add_test(t, worked_example);
    tcase_add_test(t, points_in_one_place);
    tcase_add_test(t, uniform);
    tcase_add_test(t, average_of_as_many_poles_as_points);
    tcase_add_test(t, average_by_hand);
    tcase_add_test(t, every_span_holds_data);
    tcase_add_test(t, a_spline_gives_its_poles_back);
    tcase_add_test(t, a_cubic_is_met_by_any_knots);
    tcase_add_test(t, nothing_is_less_and_the_ends_are_fixed);
    tcase_add_test(t, spans_without_data);
    tcase_add_test(t, errors_by_hand);
    tcase_add_test(t, curves_of_degree_1);
    Suite *s = suite_create("spline_lsq");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
