/*
 * feet: on a circle and a helix the feet are where they must be, and the distances those of brute
 * force, with a fixed axis and a turning one.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/minimax.h"
#include "trial.h"

/* A curve through the motion by least squares, its feet followed. */
static struct attempt fitted(const struct target *target, int degree, size_t poles)
{
    struct attempt a = trial_attempt(target, degree, poles, 1);
    struct ppform s = ppform_new(&a.curve);
    ppform_curve(&s, &a.curve);
    for (int i = 0; i < 4; i++)
        footpoints_follow(&s, target, &a.feet);
    ppform_free(&s);
    return a;
}

static struct vec3 tool_axis_at(const struct bspline *b, double u)
{
    return vec_unit(vec_sub(bspline_at(b, b->head, u), bspline_at(b, b->pole, u)));
}

/* Least distance of place k from the curve at many places near the foot; of the other end too. */
static double least(const struct attempt *a, const struct target *t, size_t k, bool other)
{
    const struct bspline *b = &a->curve;
    double best = INFINITY, end = b->knot[b->poles], from = other ? a->feet.v[k] : a->feet.u[k];

    for (int i = -2000; i <= 2000; i++) {
        double u = fmin(fmax(from + i * end / 40000, 0), end);
        struct vec3 p = bspline_at(b, b->pole, u);
        if (other)
            p = vec_along(p, t->offset, tool_axis_at(b, u));
        best = fmin(best, vec_distance(p, other ? t->other[k] : t->point[k]));
    }
    return best;
}

START_TEST(as_near_as_by_brute_force)
{
    for (int fixed = 0; fixed < 2; fixed++) {
        struct trial_fit fit = trial_fit_new(200, 8, fixed, false, 80);
        struct target t = fit.target;
        struct attempt a = fit.attempt = fitted(&t, 3, 7);
        size_t kinds = footpoints_kinds(&t);
        double worst = 0;

        ck_assert_uint_eq(kinds, fixed ? 1 : FOOTPOINT_KINDS);
        for (size_t k = 0; k < t.n; k++) {
            const double *off = &a.feet.off[k * kinds];
            ck_assert_double_eq_tol(off[0], least(&a, &t, k, false), 2e-4);
            worst = fmax(worst, off[0]);
            if (fixed)
                continue;
            ck_assert_double_eq_tol(off[1], least(&a, &t, k, true), 2e-4);
            struct vec3 axis = tool_axis_at(&a.curve, t.other_leads ? a.feet.v[k] : a.feet.u[k]);
            ck_assert_double_eq_tol(off[2], vec_distance(axis, t.axis[k]) * 0.01 / 0.02, 1e-6);
            worst = fmax(worst, fmax(off[1], off[2]));
        }
        ck_assert_double_eq_tol(a.feet.worst, worst, 1e-12);
        ck_assert_double_gt(worst, 0.05);
        trial_fit_free(&fit);
    }
}
END_TEST

/* The foothold is perpendicular to the curve, and says how the curve stands there. */
START_TEST(footholds)
{
    struct trial_fit fit = trial_fit_new(200, 8, false, true, 80);
    struct attempt a = fit.attempt = fitted(&fit.target, 4, 9);

    for (size_t k = 1; k + 1 < fit.target.n; k++) {
        const struct footpoint *s = &a.feet.point[k];
        struct vec3 d[2];
        bspline_derivatives(&a.curve, a.curve.pole, s->u, 1, d);
        ck_assert_double_lt(vec_distance(vec_unit(d[1]), s->along), 1e-3);
        ck_assert_double_lt(fabs(vec_dot(s->off, s->along)), 0.02 * vec_length(s->off) + 1e-5);
        ck_assert_double_lt(vec_distance(tool_axis_at(&a.curve, s->u), s->axis), 1e-3);
        ck_assert(a.curve.knot[s->span + 4] <= s->u && s->u <= a.curve.knot[s->span + 5]);
    }
    trial_fit_free(&fit);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feet");
    TCase *tests = tcase_create("feet");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, as_near_as_by_brute_force);
    tcase_add_test(tests, footholds);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
