/* Tests of minimax.h: steps against differences, and curves that come near enough. */
#include "splinefit/minimax.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "trial.h"

static const struct deviation WITHIN = {0.01, 0.01, 0.02}, CLOSE = {0.001, 0.001, 0.02};

enum { POLES = 8 };

/* A curve near to a motion, and what its equations are about. */
struct setting {
    struct trial_fit fit;
    struct ppform form;
};

static struct setting setting_new(int degree, bool fixed, double radius)
{
    struct setting s = {.fit = trial_fit_new(120, radius, fixed, false, 60)};

    s.fit.candidate = trial_candidate(&s.fit.target, &WITHIN, degree, POLES, 1.1);
    s.form = ppform_new(&s.fit.candidate.curve);
    ppform_curve(&s.form, &s.fit.candidate.curve);
    for (int i = 0; i < 6; i++)
        footpoints_follow(&s.form, &s.fit.target, &s.fit.candidate.feet);
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

    ppform_curve(&s->form, &s->fit.candidate.curve);
    for (int i = 0; i < 4; i++)
        footpoints_follow(&s->form, &s->fit.target, &s->fit.candidate.feet);
    for (size_t i = kinds; i < (s->fit.target.n - 1) * kinds; i++)
        sum += s->fit.candidate.feet.off[i] * s->fit.candidate.feet.off[i] / 2;
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
            struct bspline *b = &s.fit.candidate.curve;
            struct knots_step step = knots_step_new(b);
            double largest = 0;

            half_sum(&s);
            ppform_slopes(&s.form, b);
            knots_step_equations(&step, &s.form, &s.fit.target, &s.fit.candidate.feet, 2);
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
        struct knots_step step = knots_step_new(&s.fit.candidate.curve);
        double first = half_sum(&s), before = first;

        for (int i = 0; i < 12; i++) {
            struct bspline to = bspline_copy(&s.fit.candidate.curve);
            ppform_slopes(&s.form, &s.fit.candidate.curve);
            knots_step_equations(&step, &s.form, &s.fit.target, &s.fit.candidate.feet, 2);
            ck_assert(knots_step_move(&step, 0.05, 0.01, &s.fit.candidate.curve, &to));
            bspline_free(&s.fit.candidate.curve);
            s.fit.candidate.curve = to;
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

/* y = x^4 / 512 from -4 to 4: no cubic, but a curve of degree 4. */
static struct reference quartic(void)
{
    struct run run = {0};

    for (int k = 0; k <= 400; k++) {
        double x = k / 50.0 - 4;
        struct run_point p = {.tip = vec(x, pow(x, 4) / 512, 0), .axis = vec(0, 0, 1)};
        p.ball = p.tip;
        *array_push(&run) = p;
    }
    struct reference track = reference_distinct(&run, false);
    array_free(&run);
    return track;
}

/* The least distance that a fit reaches, by trying smaller and smaller ones. */
static double reached(const struct reference *t, int degree, size_t poles)
{
    double effort = 1e9, goal = 1;

    for (bool done = true; done; goal *= 0.97) {
        struct candidate a = trial_candidate(t, &CLOSE, degree, poles, 1);
        done = minimax_fit(t, goal, 1, &a, &effort);
        ck_assert(!done || a.feet.worst <= goal);
        candidate_free(&a);
    }
    return goal / 0.97 / 0.97;
}

/* The best curve of one polynomial piece is off by the same amount, to both sides in turn: the norm
 * of the 64th power comes near to that, squares do not. */
START_TEST(the_largest_distances_are_alike)
{
    struct reference track = quartic();
    struct reference t = reference_sample(&track, 200);
    struct candidate a = trial_candidate(&t, &CLOSE, 3, 4, 1);
    double effort = 1e9, goal = reached(&t, 3, 4);
    size_t tops = 0;

    ck_assert(minimax_fit(&t, goal, 1, &a, &effort));
    for (size_t k = 1; k + 1 < t.n; k++)
        tops += a.feet.off[k] > a.feet.off[k - 1] && a.feet.off[k] >= a.feet.off[k + 1] &&
                a.feet.off[k] > 0.9 * a.feet.worst;
    ck_assert_uint_ge(tops, 3);
    candidate_free(&a);
    reference_free(&t);
    reference_free(&track);
}
END_TEST

/* A degree that has the curve itself: all of it goes away. */
START_TEST(what_can_be_exact_becomes_so)
{
    struct reference track = quartic();
    struct reference t = reference_sample(&track, 200);
    struct candidate a = trial_candidate(&t, &CLOSE, 4, 5, 1);
    double effort = 1e9;

    ck_assert(minimax_fit(&t, 1e-4, 1, &a, &effort));
    ck_assert_double_le(a.feet.worst, 1e-4);
    candidate_free(&a);
    reference_free(&t);
    reference_free(&track);
}
END_TEST

START_TEST(out_of_reach_and_out_of_time)
{
    struct reference track = quartic();
    struct reference t = reference_sample(&track, 200);
    struct candidate a = trial_candidate(&t, &CLOSE, 3, 4, 1),
                     b = trial_candidate(&t, &CLOSE, 4, 5, 1);
    double effort = 1e9, none = 0;

    ck_assert(!minimax_fit(&t, 1e-7, 1, &a, &effort));
    ck_assert_double_gt(effort, 1e9 - 200 * 200.0); /* and soon */
    ck_assert(!minimax_fit(&t, 1e-4, 1, &b, &none));
    ck_assert_double_gt(none, -1000.0);
    candidate_free(&a);
    candidate_free(&b);
    reference_free(&t);
    reference_free(&track);
}
END_TEST

/* On other places of the same track the curve is the same, and the feet are near. */
START_TEST(onto_other_places)
{
    struct reference track = quartic();
    struct reference t = reference_sample(&track, 50);
    struct reference fine = reference_sample(&track, 300);
    struct candidate a = trial_candidate(&t, &CLOSE, 3, 6, 1);
    double effort = 1e9;

    minimax_fit(&t, 1e9, 1, &a, &effort);
    struct candidate b = candidate_onto(&a, &t, &fine);
    ck_assert_uint_eq(b.curve.poles, a.curve.poles);
    ck_assert_double_eq_tol(fine.length[b.feet.where], t.length[a.feet.where], 0.1);
    for (size_t k = 0; k < fine.n; k++)
        ck_assert_double_lt(
            vec_distance(bspline_at(&b.curve, b.curve.pole, b.feet.u[k]), fine.point[k]),
            a.feet.worst + 0.02);
    candidate_free(&a);
    candidate_free(&b);
    reference_free(&t);
    reference_free(&fine);
    reference_free(&track);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("minimax");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, the_right_hand_side_is_the_slope);
    tcase_add_test(t, steps_go_down);
    tcase_add_test(t, the_largest_distances_are_alike);
    tcase_add_test(t, what_can_be_exact_becomes_so);
    tcase_add_test(t, out_of_reach_and_out_of_time);
    tcase_add_test(t, onto_other_places);
    Suite *s = suite_create("minimax");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
