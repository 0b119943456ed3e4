/* Tests of footpoints.h: polynomials and their slopes against the curve, feet against brute force.
 */
#include "splinefit/footpoints.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "seed.h"
#include "trial.h"

static const struct deviation WITHIN = {0.01, 0.01, 0.02};

static unsigned long seed = 1;

static double random_number(void)
{
    seed = (seed * 1103515245 + 12345) % 2147483648UL;
    return (double)seed / 2147483648.0;
}

static struct bspline random_curve(int degree, size_t poles, bool with_head)
{
    struct bspline b = bspline_new(degree, poles, with_head);
    size_t p = (size_t)degree;

    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(random_number(), random_number(), random_number());
        if (with_head)
            b.head[i] = vec(random_number(), random_number(), random_number());
    }
    for (size_t j = p + 1; j <= poles + p; j++)
        b.knot[j] = j <= poles ? b.knot[j - 1] + 0.1 + random_number() : b.knot[poles];
    return b;
}

START_TEST(same_as_de_boor)
{
    for (int degree = 1; degree <= 6; degree++)
        for (int head = 0; head < 2; head++) {
            struct bspline b = random_curve(degree, (size_t)degree + 6, head == 1);
            struct ppform f = ppform_new(&b);
            size_t near = 0;

            ppform_curve(&f, &b);
            for (int k = 0; k <= 100; k++) {
                double u = b.knot[b.poles] * k / 100, value[6], first[6], second[6];
                struct vec3 d[3];
                near = ppform_span(&f, near, u);
                ppform_at(&f, near, u, value, first, second);
                bspline_derivatives(&b, b.pole, u, 2, d);
                ck_assert_double_eq_tol(value[0], d[0].x, 1e-12);
                ck_assert_double_eq_tol(first[1], d[1].y, 1e-10);
                if (degree > 1)
                    ck_assert_double_eq_tol(second[2], d[2].z, 1e-9);
                if (head == 1)
                    ck_assert_double_eq_tol(value[4], bspline_at(&b, b.head, u).y, 1e-12);
            }
            ppform_free(&f);
            bspline_free(&b);
        }
}
END_TEST

/* The x of the derivative by knot j at u, from the span's polynomial. */
static double slope_at(const struct ppform *f, size_t j, double u)
{
    size_t p = (size_t)f->degree, span = ppform_span(f, 0, u);
    double s = ppform_place(f, span, u), power = 1, sum = 0;

    if (j < span + 1 || j > span + 2 * p)
        return 0;
    const double *c = &f->slope[(span * 2 * p + j - span - 1) * (p + 1) * (size_t)f->width];
    for (size_t k = 0; k <= p; k++, power *= s)
        sum += c[k * (size_t)f->width] * power;
    return sum;
}

START_TEST(derivatives_by_knots)
{
    for (int degree = 2; degree <= 5; degree++) {
        struct bspline b = random_curve(degree, (size_t)degree + 7, degree % 2 == 0);
        struct ppform f = ppform_new(&b);

        ppform_curve(&f, &b);
        ppform_slopes(&f, &b);
        for (size_t j = (size_t)degree + 1; j < b.poles; j++)
            for (int k = 1; k < 60; k++) {
                double u = b.knot[b.poles] * k / 60, knot = b.knot[j], step = 1e-6;
                if (fabs(u - knot) < 1e-3)
                    continue;
                b.knot[j] = knot + step;
                double after = bspline_at(&b, b.pole, u).x;
                b.knot[j] = knot - step;
                double before = bspline_at(&b, b.pole, u).x;
                b.knot[j] = knot;
                ck_assert_double_eq_tol(slope_at(&f, j, u), (after - before) / (2 * step), 1e-7);
            }
        ppform_free(&f);
        bspline_free(&b);
    }
}
END_TEST

/* A curve through the motion by least squares, its feet followed. */
static struct candidate fitted(const struct reference *target, int degree, size_t poles)
{
    struct candidate a = trial_candidate(target, &WITHIN, degree, poles, 1);
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
static double least(const struct candidate *a, const struct reference *t, size_t k, bool other)
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
        struct reference t = fit.target;
        struct candidate a = fit.candidate = fitted(&t, 3, 7);
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
    struct candidate a = fit.candidate = fitted(&fit.target, 4, 9);

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
    seed = seed_begin(seed);
    TCase *t = tcase_create("footpoints");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, same_as_de_boor);
    tcase_add_test(t, derivatives_by_knots);
    tcase_add_test(t, as_near_as_by_brute_force);
    tcase_add_test(t, footholds);
    Suite *s = suite_create("footpoints");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
