/*
 * proof, against distances by brute force: never below them, and above by no more than is said.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/spline_lsq.h"
#include "base/num.h"
#include "splinefit/spline_bound.h"
#include "trial.h"

static bool printed(double x)
{
    return x == num_round(x, 6);
}

static struct bspline fitted(const struct reference *t, size_t poles)
{
    double *u = malloc(t->n * sizeof *u);
    struct bspline b = spline_new(t, 3, poles);
    struct vec3 *head = spline_heads(t);

    params_fill(PARAMS_CHORD, t->chord, t->n, u);
    knots_fill(KNOTS_AVERAGE, u, t->n, 3, poles, b.knot);
    ck_assert(lsq_fit(&b, u, t->point, head, t->n));
    free(head);
    ck_assert(spline_bound_print(&b, t));
    free(u);
    return b;
}

START_TEST(never_below_the_truth)
{
    for (int turn = 0; turn < 12; turn++) {
        struct run run = trial_motion(60 + 10 * (size_t)turn, 8);
        struct reference t = reference_distinct(&run, turn % 2 == 1);
        struct bspline b = fitted(&t, 5 + (size_t)turn);
        struct deviation proof;

        spline_bound_measure(&b, &t, 1e-4, INFINITY, &proof);
        double point = trial_brute_force(&b, &t, false), other = trial_brute_force(&b, &t, true);
        ck_assert_double_ge(proof.point, point - 2e-5); /* the brute force has chords of its own */
        ck_assert_double_le(proof.point, point + 2.3e-4);
        ck_assert_double_ge(proof.other, other - 2e-5);
        ck_assert_double_le(proof.other, other + 2.3e-4);
        bspline_free(&b);
        reference_free(&t);
        array_free(&run);
    }
}
END_TEST

START_TEST(the_axis_at_matching_places)
{
    struct run run = trial_motion(200, 8);
    struct reference t = reference_distinct(&run, false);
    struct bspline b = fitted(&t, 30);
    struct deviation proof;

    spline_bound_measure(&b, &t, 1e-4, INFINITY, &proof);
    ck_assert_double_lt(proof.axis, 1e-4);
    for (size_t i = 0; i < b.poles; i++) /* all axes off by atan(0.05) about y, nearly */
        b.head[i] = vec_add(b.head[i], vec(5, 0, 0));
    spline_bound_measure(&b, &t, 1e-4, INFINITY, &proof);
    ck_assert_double_gt(proof.axis, 0.04);
    ck_assert_double_lt(proof.axis, 0.06);
    ck_assert_double_gt(proof.other, 0.3); /* 8 mm times that */
    bspline_free(&b);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(printed_digits_and_length)
{
    struct run run = trial_motion(100, 8);
    struct reference t = reference_distinct(&run, false);
    struct bspline b = fitted(&t, 12);
    double length = 0;

    for (int i = 0; i < 10000; i++)
        length += vec_distance(bspline_at(&b, b.pole, b.knot[b.poles] * i / 10000),
                               bspline_at(&b, b.pole, b.knot[b.poles] * (i + 1) / 10000));
    ck_assert_double_eq_tol(b.knot[b.poles], length, 1e-3 * length);
    for (size_t i = 0; i < b.poles + 4; i++)
        ck_assert(printed(b.knot[i]));
    for (size_t i = 0; i < b.poles; i++) {
        ck_assert(printed(b.pole[i].x) && printed(b.pole[i].y) && printed(b.pole[i].z));
        ck_assert(printed(b.head[i].x) && printed(b.head[i].y) && printed(b.head[i].z));
    }
    b.pole[3].y = NAN;
    ck_assert(!spline_bound_print(&b, &t));
    bspline_free(&b);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(knots_that_would_fall_into_one)
{
    struct bspline b = bspline_new(2, 5, false); /* 5e-7 mm between inner knots */
    const double knot[] = {0, 0, 0, 0.5, 0.5 + 2e-9, 1, 1, 1};

    for (size_t i = 0; i < 8; i++)
        b.knot[i] = knot[i];
    for (size_t i = 0; i < 5; i++)
        b.pole[i] = vec(20 * (double)i, 0, 0);
    ck_assert(!spline_bound_print(&b, &(struct reference){.n = 0}));
    bspline_free(&b);
}
END_TEST

START_TEST(stops_at_the_limit)
{
    struct run run = trial_motion(100, 8);
    struct reference t = reference_distinct(&run, false);
    struct bspline b = fitted(&t, 5);
    struct deviation proof;

    spline_bound_measure(&b, &t, 1e-5, 1e-3, &proof);
    ck_assert_double_gt(proof.point, 1e-3);
    bspline_free(&b);
    reference_free(&t);
    array_free(&run);
}
END_TEST

/* A quick look must not turn away what a proof would accept. */
START_TEST(hopeless_is_hopeless)
{
    struct run run = trial_motion(150, 8);
    struct reference t = reference_distinct(&run, false);
    double u[150];
    int turned_away = 0, kept = 0;

    params_fill(PARAMS_CHORD, t.chord, t.n, u);
    for (size_t poles = 5; poles < 25; poles++) {
        struct bspline b = fitted(&t, poles);
        struct deviation proof;
        double scaled[150];

        for (size_t k = 0; k < t.n; k++)
            scaled[k] = u[k] * b.knot[b.poles];
        spline_bound_measure(&b, &t, 1e-4, INFINITY, &proof);
        if (spline_bound_hopeless(&b, &t, scaled, 0.01)) {
            ck_assert_double_gt(proof.point, 0.01);
            turned_away++;
        } else {
            kept++;
        }
        bspline_free(&b);
    }
    ck_assert_int_gt(turned_away, 2);
    ck_assert_int_gt(kept, 2);
    reference_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("spline_bound");
    TCase *tests = tcase_create("spline_bound");

    tcase_set_timeout(tests, 60);

    tcase_add_test(tests, never_below_the_truth);
    tcase_add_test(tests, the_axis_at_matching_places);
    tcase_add_test(tests, printed_digits_and_length);
    tcase_add_test(tests, knots_that_would_fall_into_one);
    tcase_add_test(tests, stops_at_the_limit);
    tcase_add_test(tests, hopeless_is_hopeless);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
