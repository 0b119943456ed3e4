/* trial - see trial.h. */
#include "trial.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/array.h"

enum { TRIAL_KNOTS = 64 };

static struct run_point place(double s, double radius)
{
    struct run_point p = {.tip = vec(60 * s, 8 * sin(5 * s), 4 * cos(4 * s))};

    p.axis = vec_unit(vec(0.4 * sin(3 * s), 0.3 * cos(2 * s), 1));
    p.ball = vec_along(p.tip, radius, p.axis);
    return p;
}

struct run trial_motion(size_t n, double radius)
{
    struct run run = {.radius = radius};

    for (size_t k = 0; k < n; k++)
        *array_push(&run) = place((double)k / (double)(n - 1), radius);
    return run;
}

struct run trial_screw(size_t n, double step)
{
    struct run run = {.radius = 4};
    for (size_t i = 0; i < n; i++) {
        double u = step * (double)i;
        struct vec3 axis = vec(0.3 * cos(u), 0.3 * sin(u), sqrt(1 - 0.09));
        struct vec3 tip = vec(10 * cos(u), 10 * sin(u), 2 * u);
        *array_push(&run) =
            (struct run_point){.tip = tip, .ball = vec_along(tip, 4, axis), .axis = axis};
    }
    return run;
}

double trial_off_chain(struct vec3 q, const struct vec3 *point, size_t n)
{
    double best = INFINITY;

    for (size_t j = 0; j + 1 < n; j++) {
        struct vec3 d = vec_sub(point[j + 1], point[j]);
        double l2 = vec_dot(d, d), t = l2 > 0 ? vec_dot(vec_sub(q, point[j]), d) / l2 : 0;
        best = fmin(best, vec_distance(q, vec_along(point[j], fmin(1, fmax(0, t)), d)));
    }
    return best;
}

double trial_brute_force(const struct bspline *b, const struct reference *t, bool other)
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
        worst = fmax(worst, trial_off_chain(way[i], data, t->n));
    }
    for (size_t k = 0; k + 1 < t->n; k++)
        for (int i = 0; i < PARTS; i++)
            worst = fmax(worst, trial_off_chain(vec_mix(data[k], data[k + 1], (double)i / PARTS),
                                                way, N + 1));
    return worst;
}

struct reference trial_wave(size_t n, double step, double lean, double kink)
{
    struct run run = {.radius = 6};
    for (size_t i = 0; i < n; i++) {
        double x = step * (double)i, past = x - step * (double)(n / 2);
        struct vec3 axis = vec_unit(vec(0, lean * sin(x / 7), 1));
        struct vec3 tip = vec(x, 3 * sin(x / 9) + kink * fmax(0, past), 2 * cos(x / 5));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, run.radius, axis), .axis = axis, .given = true};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

void trial_assert_chain(const struct reference *t, const struct deviation *within,
                        const struct pieces *p)
{
    ck_assert_double_lt(vec_distance(p->item[0].arc.from, t->point[0]), 1e-12);
    ck_assert_double_lt(vec_distance(p->item[p->n - 1].arc.to, t->point[t->n - 1]), 1e-12);
    for (size_t i = 0; i < p->n; i++) {
        struct deviation off = arc_piece_deviation(t, &p->item[i], 8, NULL);
        ck_assert_double_le(off.point, 1.01 * within->point);
        ck_assert_double_le(off.other, 1.01 * within->other);
        ck_assert_double_le(off.axis, within->axis);
        if (i == 0)
            continue;
        const struct arc_piece *before = &p->item[i - 1], *here = &p->item[i];
        ck_assert_double_lt(vec_distance(before->arc.to, here->arc.from), 1e-12);
        ck_assert_double_lt(vec_distance(before->axis_to, here->axis), 1e-12);
        ck_assert_double_le(before->to, here->from);
        ck_assert_double_ge(before->to, here->from);
        double kink = vec_angle(arc_tangent(&before->arc, 1), here->arc.tangent);
        ck_assert_double_le(kink, 1.01 * ARCFIT_KINK);
    }
}

struct candidate trial_candidate(const struct reference *t, const struct deviation *within,
                                 int degree, size_t poles, double power)
{
    struct bspline form = {.degree = degree, .poles = poles};
    struct candidate a = {0};
    double knot[TRIAL_KNOTS] = {0};

    ck_assert(poles + (size_t)degree < TRIAL_KNOTS);
    for (size_t j = (size_t)degree + 1; j <= poles + (size_t)degree; j++) {
        double share = (double)(j - (size_t)degree) / (double)(poles - (size_t)degree);
        knot[j] = t->length[t->n - 1] * fmin(1, pow(share, power));
    }
    ck_assert(candidate_new(t, within, &form, knot, t->length, &a));
    return a;
}

struct trial_fit trial_fit_new(size_t n, double radius, bool fixed, bool centre, size_t parts)
{
    struct trial_fit fit = {.run = trial_motion(n, radius)};

    for (size_t i = 0; fixed && i < fit.run.n; i++)
        fit.run.item[i].axis = vec(0, 0, 1);
    fit.track = reference_distinct(&fit.run, centre);
    fit.target = reference_sample(&fit.track, parts);
    return fit;
}

void trial_fit_free(struct trial_fit *fit)
{
    candidate_free(&fit->candidate);
    reference_free(&fit->target);
    reference_free(&fit->track);
    array_free(&fit->run);
}
