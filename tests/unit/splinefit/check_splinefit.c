/*
 * splinefit: what is promised is measured again by brute force; what is the least is tried one
 * lower; what is straight, short or rough gets what is said.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/spline_lsq.h"
#include "splinefit/splinefit.h"
#include "trial.h"

static const struct splinefit_options ALL = {
    .degree = 3, .params = -1, .knots = -1, .tolerance = 0.01, .angle = 0.02};

START_TEST(within_by_brute_force)
{
    int free_knots = 0;

    for (int turn = 0; turn < 4; turn++) {
        struct run run = trial_motion(150, 8);
        struct reference t = reference_distinct(&run, turn % 2 == 1);
        struct splinefit_options o = ALL;
        struct splinefit fit;

        o.tolerance = turn < 2 ? 0.01 : 0.05;
        o.degree = 3 + turn % 3;
        splinefit_search(&t, &o, &fit);
        ck_assert(fit.within && fit.curve.degree == o.degree);
        free_knots += fit.kind == SPLINEFIT_FREE;
        ck_assert_double_le(trial_brute_force(&fit.curve, &t, false), o.tolerance);
        ck_assert_double_le(trial_brute_force(&fit.curve, &t, true), o.tolerance);
        ck_assert_double_le(fit.proof.point, o.tolerance);
        ck_assert_double_le(fit.proof.other, o.tolerance);
        ck_assert(vec_distance(fit.curve.pole[0], t.point[0]) < 1e-6);
        ck_assert(vec_distance(fit.curve.pole[fit.curve.poles - 1], t.point[t.n - 1]) < 1e-6);
        ck_assert_uint_lt(fit.curve.poles, 14);
        splinefit_free(&fit);
        reference_free(&t);
        array_free(&run);
    }
    ck_assert_int_ge(free_knots, 2);
}
END_TEST

/* A wave with a ripple of three tolerances on it, seven points long: no search by free knots, which
 * would follow it to its bound; knots grow where the data asks for them.  Without it the search is
 * done. */
START_TEST(ripple_is_not_searched)
{
    for (int rippled = 0; rippled < 2; rippled++) {
        struct run run = {.radius = 5};
        for (int k = 0; k < 240; k++) {
            double ripple = rippled * 3 * ALL.tolerance * sin(0.9 * k);
            struct vec3 tip = vec(0.4 * k, 0, 3 * sin(k / 15.0) + ripple);
            *array_push(&run) = (struct run_point){
                .tip = tip, .ball = vec_along(tip, 5, vec(0, 0, 1)), .axis = vec(0, 0, 1)};
        }
        struct reference t = reference_distinct(&run, false);
        struct splinefit fit;
        splinefit_search(&t, &ALL, &fit);
        ck_assert(fit.within);
        ck_assert_int_eq(fit.kind, rippled ? SPLINEFIT_GROWN : SPLINEFIT_FREE);
        ck_assert_double_le(trial_brute_force(&fit.curve, &t, false), ALL.tolerance);
        splinefit_free(&fit);
        reference_free(&t);
        array_free(&run);
    }
}
END_TEST

/* The published search stops at a multiple of 5; C1 is as eq 7 says, at the points alone. */
START_TEST(as_published)
{
    struct run run = trial_motion(150, 8);
    struct reference t = reference_distinct(&run, false);
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
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(one_combination_alone)
{
    struct run run = trial_motion(150, 8);
    struct reference t = reference_distinct(&run, false);

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
    reference_free(&t);
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
    struct reference t = reference_distinct(&run, false);
    struct splinefit fit;
    splinefit_search(&t, &ALL, &fit);
    ck_assert_uint_eq(fit.curve.poles, 4);
    ck_assert_double_lt(fit.proof.point, 1e-3);
    ck_assert(fit.curve.head == NULL);
    splinefit_free(&fit);
    reference_free(&t);
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
        struct reference t = reference_distinct(&run, false);
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
        reference_free(&t);
        run.n = 2;
    }
    array_free(&run);
}
END_TEST

/* What was a straight line is one no more: it is searched for anew. */
START_TEST(another_kind_of_curve_is_found_again)
{
    struct run run = trial_motion(150, 8);
    struct reference t = reference_distinct(&run, false);
    struct splinefit before = {.curve = spline_straight(&t), .kind = SPLINEFIT_STRAIGHT};
    struct splinefit fit, anew;

    splinefit_again(&t, &ALL, &before, &fit);
    splinefit_search(&t, &ALL, &anew);
    ck_assert(fit.within && fit.kind == anew.kind);
    ck_assert_uint_eq(fit.curve.poles, anew.curve.poles);
    splinefit_free(&fit);
    splinefit_again(&t, &ALL, &anew, &fit); /* and the same data needs no more */
    ck_assert(fit.within);
    ck_assert_uint_eq(fit.curve.poles, anew.curve.poles);
    splinefit_free(&fit);
    splinefit_free(&before);
    splinefit_free(&anew);
    reference_free(&t);
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
    struct reference t = reference_distinct(&run, false);
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
    reference_free(&t);
    array_free(&run);
}
END_TEST

/* From one point to the next the axis turns by 10 degrees while the tip goes straight: on the path,
 * too, the ball of 8 then swings 8 (1 - cos 5 degrees) off its straight way. */
START_TEST(a_swing_of_the_path_is_no_deviation)
{
    struct run run = {.radius = 8};

    for (int k = 0; k < 2; k++) {
        struct run_point p = {.tip = vec(k, 0, 0),
                              .axis = vec(sin(RADIANS(10) * k), 0, cos(RADIANS(10) * k))};
        p.ball = vec_along(p.tip, 8, p.axis);
        *array_push(&run) = p;
    }
    struct reference t = reference_distinct(&run, false);
    struct splinefit fit;
    splinefit_search(&t, &ALL, &fit);
    ck_assert_int_eq(fit.kind, SPLINEFIT_POLYLINE);
    ck_assert_double_lt(fit.proof.point, 1e-6);
    ck_assert_double_gt(fit.proof.other, ALL.tolerance); /* said all the same */
    ck_assert(fit.within);
    splinefit_free(&fit);
    reference_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("splinefit");
    TCase *tests = tcase_create("splinefit");

    tcase_add_test(tests, within_by_brute_force);
    tcase_add_test(tests, ripple_is_not_searched);
    tcase_add_test(tests, as_published);
    tcase_add_test(tests, one_combination_alone);
    tcase_add_test(tests, a_cubic_needs_four_poles);
    tcase_add_test(tests, straight_and_two_points);
    tcase_add_test(tests, another_kind_of_curve_is_found_again);
    tcase_add_test(tests, what_is_rough_stays_a_polyline);
    tcase_add_test(tests, a_swing_of_the_path_is_no_deviation);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
