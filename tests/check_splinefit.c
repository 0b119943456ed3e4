/*
 * splinefit: what is promised is measured again by brute force; what is the least is tried one
 * lower; what is straight, short or rough gets what is said.
 */
#include <check.h>
#include <stdlib.h>

#include "array.h"
#include "splinefit.h"

/* A motion in 5 axes: the tip on a wave, the axis swinging. */
static struct run_point place(double s, double radius)
{
    struct run_point p = {.tip = vec(60 * s, 8 * sin(5 * s), 4 * cos(4 * s))};

    p.axis = vec_unit(vec(0.4 * sin(3 * s), 0.3 * cos(2 * s), 1));
    p.ball = vec_along(p.tip, radius, p.axis);
    return p;
}

static struct run motion(size_t n, double radius)
{
    struct run run = {.radius = radius};

    for (size_t k = 0; k < n; k++)
        *array_push(&run) = place((double)k / (double)(n - 1), radius);
    return run;
}

static double off_chain(struct vec3 q, const struct vec3 *point, size_t n)
{
    double best = INFINITY;

    for (size_t j = 0; j + 1 < n; j++) {
        struct vec3 d = vec_sub(point[j + 1], point[j]);
        double l2 = vec_dot(d, d), t = l2 > 0 ? vec_dot(vec_sub(q, point[j]), d) / l2 : 0;
        best = fmin(best, vec_distance(q, vec_along(point[j], fmin(1, fmax(0, t)), d)));
    }
    return best;
}

/* Distance both ways by brute force: the curve at many places, against the track's polyline. */
static double brute_force(const struct bspline *b, const struct track *t, bool other)
{
    enum { N = 1500, PARTS = 30 };
    static struct vec3 way[N + 1];
    const struct vec3 *data = other ? t->other : t->point;
    double worst = 0;

    for (int i = 0; i <= N; i++) {
        double u = b->knot[b->poles] * i / N;
        struct vec3 p = bspline_at(b, b->pole, u), a = t->axis[0];
        if (b->head != NULL)
            a = vec_unit(vec_sub(bspline_at(b, b->head, u), p));
        way[i] = other ? vec_along(p, t->offset, a) : p;
        worst = fmax(worst, off_chain(way[i], data, t->n));
    }
    for (size_t k = 0; k + 1 < t->n; k++)
        for (int i = 0; i < PARTS; i++)
            worst = fmax(worst,
                         off_chain(vec_mix(data[k], data[k + 1], (double)i / PARTS), way, N + 1));
    return worst;
}

static const struct splinefit_options ALL = {
    .degree = 3, .params = -1, .knots = -1, .tolerance = 0.01, .angle = 0.02};

START_TEST(within_by_brute_force)
{
    for (int turn = 0; turn < 4; turn++) {
        struct run run = motion(150, 8);
        struct track t = track_new(&run, turn % 2 == 1);
        struct splinefit_options o = ALL;
        struct splinefit fit;

        o.tolerance = turn < 2 ? 0.01 : 0.05;
        o.degree = 3 + turn % 3;
        o.free = true;
        splinefit_search(&t, &o, &fit);
        ck_assert(fit.within && fit.kind == SPLINEFIT_FREE && fit.curve.degree == o.degree);
        ck_assert_double_le(brute_force(&fit.curve, &t, false), o.tolerance);
        ck_assert_double_le(brute_force(&fit.curve, &t, true), o.tolerance);
        ck_assert_double_le(fit.proof.point, o.tolerance);
        ck_assert_double_le(fit.proof.other, o.tolerance);
        ck_assert(vec_distance(fit.curve.pole[0], t.point[0]) < 1e-6);
        ck_assert(vec_distance(fit.curve.pole[fit.curve.poles - 1], t.point[t.n - 1]) < 1e-6);
        ck_assert_uint_lt(fit.curve.poles, 14);
        splinefit_free(&fit);
        track_free(&t);
        array_free(&run);
    }
}
END_TEST

/* The published search stops at a multiple of 5; C1 is as eq 7 says, at the points alone. */
START_TEST(as_published)
{
    struct run run = motion(150, 8);
    struct track t = track_new(&run, false);
    struct splinefit fit, default_fit;

    splinefit_paper(&t, &ALL, &fit);
    splinefit_search(&t, &ALL, &default_fit);
    ck_assert_uint_eq(fit.curve.poles % 5, 0);
    ck_assert_uint_le(default_fit.curve.poles, fit.curve.poles);
    ck_assert_double_le(fit.deviation.c1, 0.01);
    double *u = malloc(t.n * sizeof *u), worst = 0;
    params_fill(fit.params, t.chord, t.n, u);
    for (size_t k = 0; k < t.n; k++)
        worst = fmax(worst,
                     vec_distance(t.point[k], bspline_at(&fit.curve, fit.curve.pole,
                                                         u[k] * fit.curve.knot[fit.curve.poles])));
    ck_assert_double_eq_tol(fit.deviation.c1, worst, 1e-12);
    free(u);
    splinefit_free(&default_fit);
    splinefit_free(&fit);
    track_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(one_combination_alone)
{
    struct run run = motion(150, 8);
    struct track t = track_new(&run, false);

    for (int params = 0; params < 3; params++)
        for (int knots = 0; knots < 2; knots++) {
            struct splinefit_options o = ALL;
            struct splinefit fit;
            o.params = params;
            o.knots = knots;
            splinefit_search(&t, &o, &fit);
            ck_assert(fit.within && fit.kind == SPLINEFIT_FITTED);
            ck_assert_int_eq((int)fit.params, params);
            ck_assert_int_eq((int)fit.knots, knots);
            splinefit_free(&fit);
        }
    track_free(&t);
    array_free(&run);
}
END_TEST

/* Points of a cubic at equal steps of its parameter: 4 poles serve, the least there are. */
START_TEST(a_cubic_needs_four_poles)
{
    struct run run = {.radius = 0};

    for (int k = 0; k <= 400; k++) {
        double s = k / 400.0;
        struct run_point p = {.tip = vec(30 * s, 40 * s * (1 - s), 60 * s * (s - 0.5) * (s - 1)),
                              .axis = vec(0, 0, 1)};
        p.ball = p.tip;
        *array_push(&run) = p;
    }
    struct track t = track_new(&run, false);
    struct splinefit fit;
    splinefit_search(&t, &ALL, &fit);
    ck_assert_uint_eq(fit.curve.poles, 4);
    ck_assert_double_lt(fit.proof.point, 1e-3);
    ck_assert(fit.curve.head == NULL);
    splinefit_free(&fit);
    track_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(straight_and_two_points)
{
    struct run run = {.radius = 8};

    for (int k = 0; k < 30; k++) {
        struct run_point p = {.tip = vec(k * 0.5, k * 0.25, 1), .axis = vec(0, 0.6, 0.8)};
        p.ball = vec_along(p.tip, 8, p.axis);
        *array_push(&run) = p;
    }
    for (int turn = 0; turn < 2; turn++) {
        struct track t = track_new(&run, false);
        struct splinefit fit;
        splinefit_search(&t, &ALL, &fit);
        ck_assert(fit.within && fit.kind == SPLINEFIT_STRAIGHT);
        ck_assert(fit.curve.degree == 1 && fit.curve.poles == 2);
        ck_assert_double_lt(fit.proof.point, 2e-4);
        splinefit_free(&fit);
        splinefit_paper(&t, &ALL, &fit);
        ck_assert(fit.kind == (turn == 0 ? SPLINEFIT_FITTED : SPLINEFIT_POLYLINE));
        ck_assert_uint_eq(fit.curve.poles, turn == 0 ? 5 : 2);
        splinefit_free(&fit);
        track_free(&t);
        run.n = 2;
    }
    array_free(&run);
}
END_TEST

/* Corners at every point, by far above the tolerance: only the polyline itself serves. */
START_TEST(what_is_rough_stays_a_polyline)
{
    struct run run = {.radius = 8};

    for (int k = 0; k < 300; k++) {
        struct run_point p = {.tip = vec(k * 0.1, k % 2, k % 3), .axis = vec(0, 0, 1)};
        p.ball = vec_along(p.tip, 8, p.axis);
        *array_push(&run) = p;
    }
    struct track t = track_new(&run, false);
    for (int paper = 0; paper < 2; paper++) {
        struct splinefit fit;
        if (paper)
            splinefit_paper(&t, &ALL, &fit);
        else
            splinefit_search(&t, &ALL, &fit);
        if (fit.kind == SPLINEFIT_POLYLINE) {
            ck_assert(fit.curve.degree == 1);
            ck_assert_uint_eq(fit.curve.poles, 300);
            ck_assert_double_lt(fit.deviation.c1, 1e-6);
        }
        ck_assert(paper || fit.kind == SPLINEFIT_POLYLINE);
        ck_assert(fit.within);
        splinefit_free(&fit);
    }
    track_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("splinefit");
    TCase *tests = tcase_create("splinefit");

    tcase_add_test(tests, within_by_brute_force);
    tcase_add_test(tests, as_published);
    tcase_add_test(tests, one_combination_alone);
    tcase_add_test(tests, a_cubic_needs_four_poles);
    tcase_add_test(tests, straight_and_two_points);
    tcase_add_test(tests, what_is_rough_stays_a_polyline);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
