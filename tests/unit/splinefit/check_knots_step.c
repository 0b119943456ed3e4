/*
 * knots_step, and the pulls and moments that it is made of: the equations are the derivatives, by
 * differences, of the sum that is to become small; a step makes that smaller.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/knots_step.h"
#include "splinefit/minimax.h"
#include "trial.h"

enum { POLES = 8 };

/* A curve near to a motion, and what its equations are about. */
struct setting {
    struct trial_fit fit;
    struct ppform form;
};

static struct setting setting_new(int degree, bool fixed, double radius)
{
    struct setting s = {.fit = trial_fit_new(120, radius, fixed, false, 60)};

    s.fit.attempt = trial_attempt(&s.fit.target, degree, POLES, 1.1);
    s.form = ppform_new(&s.fit.attempt.curve);
    ppform_curve(&s.form, &s.fit.attempt.curve);
    for (int i = 0; i < 6; i++)
        footpoints_follow(&s.form, &s.fit.target, &s.fit.attempt.feet);
    return s;
}

static void setting_free(struct setting *s)
{
    ppform_free(&s->form);
    trial_fit_free(&s->fit);
}

/* Half the sum of the squares of all distances but those at the ends, which are fixed, in parts of
 * nothing: after feet were followed anew on the curve as it now is. */
static double half_sum(struct setting *s)
{
    size_t kinds = footpoints_kinds(&s->fit.target);
    double sum = 0;

    ppform_curve(&s->form, &s->fit.attempt.curve);
    for (int i = 0; i < 4; i++)
        footpoints_follow(&s->form, &s->fit.target, &s->fit.attempt.feet);
    for (size_t i = kinds; i < (s->fit.target.n - 1) * kinds; i++)
        sum += s->fit.attempt.feet.off[i] * s->fit.attempt.feet.off[i] / 2;
    return sum;
}

/* The derivative of half the sum by *value, by a difference. */
static double slope_by(struct setting *s, double *value, double step)
{
    double before = *value;

    *value = before + step;
    double more = half_sum(s);
    *value = before - step;
    double less = half_sum(s);
    *value = before;
    half_sum(s);
    return (more - less) / (2 * step);
}

/* With power 2 the right-hand side is the slope downwards, for poles, heads and knots. */
START_TEST(the_right_hand_side_is_the_slope)
{
    for (int degree = 2; degree <= 5; degree++)
        for (int fixed = 0; fixed < 2; fixed++) {
            struct setting s = setting_new(degree, fixed, 8);
            struct bspline *b = &s.fit.attempt.curve;
            struct knots_step step = knots_step_new(b);
            double largest = 0;

            half_sum(&s);
            ppform_slopes(&s.form, b);
            knots_step_equations(&step, &s.form, &s.fit.target, &s.fit.attempt.feet, 2);
            for (size_t i = 0; i < step.unknowns; i++)
                largest = fmax(largest, fabs(step.right[i]));
            for (size_t i = 1; i + 1 < b->poles; i++) {
                double found = -step.right[step.pole[i] + 1];
                ck_assert_double_eq_tol(found, slope_by(&s, &b->pole[i].y, 1e-5), 2e-3 * largest);
                if (b->head == NULL)
                    continue;
                found = -step.right[step.pole[i] + 3];
                ck_assert_double_eq_tol(found, slope_by(&s, &b->head[i].x, 1e-4), 2e-3 * largest);
            }
            for (size_t j = (size_t)degree + 1; j < b->poles; j++)
                ck_assert_double_eq_tol(-step.right[step.knot[j]], slope_by(&s, &b->knot[j], 1e-4),
                                        2e-3 * largest);
            knots_step_free(&step);
            setting_free(&s);
        }
}
END_TEST

/* A step makes the sum smaller, and by far once steps are repeated. */
START_TEST(steps_go_down)
{
    for (int fixed = 0; fixed < 2; fixed++) {
        struct setting s = setting_new(3, fixed, 8);
        struct knots_step step = knots_step_new(&s.fit.attempt.curve);
        double first = half_sum(&s), before = first;

        for (int i = 0; i < 12; i++) {
            struct bspline to = bspline_copy(&s.fit.attempt.curve);
            ppform_slopes(&s.form, &s.fit.attempt.curve);
            knots_step_equations(&step, &s.form, &s.fit.target, &s.fit.attempt.feet, 2);
            ck_assert(knots_step_move(&step, 0.05, 0.01, &s.fit.attempt.curve, &to));
            bspline_free(&s.fit.attempt.curve);
            s.fit.attempt.curve = to;
            double after = half_sum(&s);
            ck_assert_double_le(after, before * 1.001);
            before = after;
        }
        ck_assert_double_lt(before, 0.7 * first);
        knots_step_free(&step);
        setting_free(&s);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("knotstep");
    TCase *tests = tcase_create("knotstep");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, the_right_hand_side_is_the_slope);
    tcase_add_test(tests, steps_go_down);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
