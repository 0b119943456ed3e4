/* Tests of grown_fit.h: with knots that go one after the other the curve is that of its knots
 * alone, and so is what its spans are off. */
#include "splinefit/grown_fit.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "seed.h"
#include "splinefit/spline_lsq.h"
#include "trial.h"

enum { POINTS = 400, KNOTS = 40, DEGREE = 3 };
static const double TOLERANCE = 0.01, ANGLE = 0.02;

static struct reference wave(bool turns)
{
    struct run run = {.radius = 5};

    for (int k = 0; k < POINTS; k++) {
        double x = 0.2 * k;
        struct vec3 tip = vec(x, sin(x / 9), 0.5 * sin(x / 3));
        struct vec3 axis = vec_unit(vec(0.1 * turns * sin(x / 7), 0, 1));
        *array_push(&run) =
            (struct run_point){.tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis};
    }
    struct reference reference = reference_distinct(&run, false);
    array_free(&run);
    return reference;
}

static struct grown_fit fit_of(const struct reference *t, const struct vec3 *head)
{
    struct grown_fit fit = grown_fit_new(t, head, DEGREE);

    fit.tolerance = TOLERANCE;
    fit.angle = ANGLE;
    fit.between = true;
    return fit;
}

/* By the solver that takes all points at once. */
static void assert_least_squares(const struct reference *t, const struct vec3 *head,
                                 const struct bspline *curve)
{
    struct bspline other = spline_new(t, DEGREE, curve->poles);

    for (size_t i = 0; i <= curve->poles + DEGREE; i++)
        other.knot[i] = curve->knot[i];
    ck_assert(lsq_fit(&other, t->length, t->point, head, t->n));
    for (size_t i = 0; i < curve->poles; i++) {
        ck_assert_double_lt(vec_distance(other.pole[i], curve->pole[i]), 1e-8);
        if (head)
            ck_assert_double_lt(vec_distance(other.head[i], curve->head[i]), 1e-8);
    }
    bspline_free(&other);
}

/* By a fit that knows nothing of the knots before. */
static void assert_alone(const struct reference *t, const struct vec3 *head,
                         const struct grown_fit *grown, const double *inner, size_t n, double worst)
{
    struct grown_fit alone = fit_of(t, head);
    const double part = 1e-4;

    ck_assert_double_eq_tol(grown_fit_knots(&alone, inner, n, HUGE_VAL), worst, part);
    for (size_t s = 0; s + DEGREE < alone.curve.poles; s++)
        ck_assert_double_eq_tol(alone.off[s], grown->off[s], part);
    grown_fit_free(&alone);
}

/* The axis stands still, or turns. */
START_TEST(knots_go_one_after_the_other)
{
    struct reference t = wave(_i == 1);
    struct vec3 *head = _i == 1 ? spline_heads(&t) : NULL;
    struct grown_fit fit = fit_of(&t, head);
    double inner[KNOTS], last = t.length[t.n - 1];
    unsigned seed = (unsigned)seed_begin(4711);
    size_t n = KNOTS;

    for (size_t k = 0; k < n; k++)
        inner[k] = last * (double)(k + 1) / (KNOTS + 1);
    for (; n > 4; n--) {
        double worst = grown_fit_knots(&fit, inner, n, HUGE_VAL);
        assert_least_squares(&t, head, &fit.curve);
        assert_alone(&t, head, &fit, inner, n, worst);
        seed = seed * 1103515245u + 12345u;
        for (size_t k = (seed >> 16) % n; k + 1 < n; k++)
            inner[k] = inner[k + 1];
    }
    grown_fit_free(&fit);
    free(head);
    reference_free(&t);
}
END_TEST

/* Above what is enough the figure may be too small, and the next one is right all the same. */
START_TEST(what_is_too_much_is_told)
{
    struct reference t = wave(false);
    struct grown_fit fit = fit_of(&t, NULL);
    double few[] = {20, 40}, other[] = {25, 50};

    double worst = grown_fit_knots(&fit, few, 2, HUGE_VAL);
    ck_assert_double_gt(worst, 5);
    ck_assert_double_gt(grown_fit_knots(&fit, few, 2, 1), 1);
    ck_assert_double_eq_tol(grown_fit_knots(&fit, few, 2, HUGE_VAL), worst, 1e-9);
    ck_assert_double_gt(grown_fit_knots(&fit, other, 2, HUGE_VAL), 5);
    grown_fit_free(&fit);
    reference_free(&t);
}
END_TEST

/* More poles than places, or spans without any: no curve. */
START_TEST(what_is_not_determined_is_told)
{
    struct reference t = wave(false);
    struct grown_fit fit = fit_of(&t, NULL);
    double close[] = {10, 10.01, 10.02, 10.03, 10.04};

    ck_assert_double_infinite(grown_fit_knots(&fit, close, 5, HUGE_VAL));
    ck_assert_double_finite(grown_fit_knots(&fit, close, 1, HUGE_VAL));
    grown_fit_free(&fit);
    reference_free(&t);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("grown_fit");
    TCase *tcase = tcase_create("grown_fit");

    tcase_add_loop_test(tcase, knots_go_one_after_the_other, 0, 2);
    tcase_add_test(tcase, what_is_too_much_is_told);
    tcase_add_test(tcase, what_is_not_determined_is_told);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
