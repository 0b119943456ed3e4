/*
 * minimax - p-norms rising from 2 to 64.
 */
#include "minimax.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "knots_step.h"
#include "lsq.h"

enum { POWER_MAX = 64, TRIES = 6, AHEAD = 100 };
static const double SETTLED = 0.002; /* a step that gains less than this is the last of its power */
static const double NEAREST = 0.02;  /* knots, in parts of the mean span */

struct work {
    const struct target *target;
    struct attempt *best;
    struct attempt trial;
    struct ppform form;
    struct knots_step step;
    double nearest, damping;
    int patience;
    double *effort;
};

bool attempt_start(const struct target *target, const struct bspline *form, const double *knot,
                   const double *u, struct attempt *attempt)
{
    attempt->curve = bspline_new(form->degree, form->poles, target->axis != NULL);
    attempt->curve.length = TRACK_LENGTH;
    attempt->feet = footpoints_new(target);
    memcpy(attempt->curve.knot, knot, (form->poles + (size_t)form->degree + 1) * sizeof *knot);
    memcpy(attempt->feet.u, u, target->n * sizeof *u);
    struct vec3 *head = NULL;
    if (target->axis != NULL) {
        memcpy(attempt->feet.v, u, target->n * sizeof *u);
        head = mem_alloc(target->n, sizeof *head);
        for (size_t k = 0; k < target->n; k++)
            head[k] = vec_along(target->point[k], TRACK_LENGTH, target->axis[k]);
    }
    bool done = lsq_fit(&attempt->curve, u, target->point, head, target->n);
    free(head);
    return done;
}

void attempt_free(struct attempt *attempt)
{
    bspline_free(&attempt->curve);
    footpoints_free(&attempt->feet);
}

/* The mean of the distances by the norm, in parts of `reference`: (mean of r^power)^(1 / power). */
static double mean_of(const struct target *target, const struct footpoints *feet, int power,
                      double reference)
{
    size_t n = target->n * footpoints_kinds(target);
    double sum = 0;

    for (size_t i = 0; i < n; i++) {
        double r = feet->off[i] / reference;
        for (int k = 1; k < power; k *= 2)
            r *= r;
        sum += r;
    }
    sum /= (double)n;
    for (int k = 1; k < power; k *= 2)
        sum = sqrt(sum);
    return sum;
}

static void swap(struct attempt *a, struct attempt *b)
{
    struct attempt c = *a;
    *a = *b;
    *b = c;
}

struct attempt attempt_copy(const struct attempt *a, const struct target *target)
{
    struct attempt copy = {bspline_copy(&a->curve), footpoints_new(target)};

    footpoints_copy(&copy.feet, &a->feet, target);
    return copy;
}

/* v at the places `to` of values at the places `from`, straight between them. */
static void spread(const struct target *from, const double *value, const struct target *to,
                   double *v)
{
    size_t at = 0;

    for (size_t k = 0; k < to->n; k++) {
        while (at + 2 < from->n && from->at[at + 1] < to->at[k])
            at++;
        double part = (to->at[k] - from->at[at]) / (from->at[at + 1] - from->at[at]);
        v[k] = value[at] + part * (value[at + 1] - value[at]);
    }
}

struct attempt attempt_onto(const struct attempt *a, const struct target *from,
                            const struct target *to)
{
    struct attempt moved = {bspline_copy(&a->curve), footpoints_new(to)};
    double where = from->at[a->feet.where];

    moved.feet.worst = a->feet.worst;
    while (moved.feet.where + 1 < to->n && to->at[moved.feet.where] < where)
        moved.feet.where++;

    spread(from, a->feet.u, to, moved.feet.u);
    if (to->axis != NULL)
        spread(from, a->feet.v, to, moved.feet.v);
    return moved;
}

/* One step that makes the mean smaller, with as much damping as it takes.  Returns what part of it
 * was gained, 0: none could be found. */
static double improve(struct work *w, int power)
{
    double reference = w->best->feet.worst;
    double before = mean_of(w->target, &w->best->feet, power, reference);

    ppform_curve(&w->form, &w->best->curve);
    ppform_slopes(&w->form, &w->best->curve);
    knots_step_equations(&w->step, &w->form, w->target, &w->best->feet, power);
    for (int i = 0; i < TRIES; i++, w->damping *= 8) {
        if (!knots_step_move(&w->step, w->damping, w->nearest, &w->best->curve, &w->trial.curve))
            continue;
        ppform_curve(&w->form, &w->trial.curve);
        footpoints_copy(&w->trial.feet, &w->best->feet, w->target);
        footpoints_follow(&w->form, w->target, &w->trial.feet);
        *w->effort -= (double)(w->target->n * footpoints_kinds(w->target));
        double after = mean_of(w->target, &w->trial.feet, power, reference);
        if (!(after < before))
            continue;
        if (i == 0)
            w->damping = fmax(w->damping / 4, 1e-7);
        swap(w->best, &w->trial);
        return 1 - after / before;
    }
    w->damping = 1e-3;
    return 0;
}

/* True when the mean would stay above the goal even if the next steps gained as much as the last.
 */
static bool hopeless(double mean, double gain, double goal, int patience)
{
    for (int i = 0; i < AHEAD * patience && mean > goal; i++)
        mean *= 1 - gain;
    return mean > goal;
}

static bool climb(struct work *w, double goal)
{
    const struct footpoints *feet = &w->best->feet;

    for (int power = 2; power <= POWER_MAX; power *= 2) {
        int most = w->patience * (power == 2 || power == POWER_MAX ? 40 : 20);
        double settled = (power == 2 ? SETTLED / 4 : SETTLED) / w->patience;
        double gain = 1;
        for (int i = 0; i < most && gain > settled; i++) {
            if (feet->worst <= goal)
                return true;
            gain = improve(w, power);
            if (*w->effort < 0 ||
                hopeless(mean_of(w->target, feet, power, 1), gain, goal, w->patience))
                return false;
        }
        if (!(feet->worst > goal))
            return feet->worst <= goal;
    }
    return false;
}

bool minimax_fit(const struct target *target, double goal, int patience, struct attempt *attempt,
                 double *effort)
{
    struct work w = {
        .target = target, .best = attempt, .damping = 1e-3, .patience = patience, .effort = effort};

    w.form = ppform_new(&attempt->curve);
    ppform_curve(&w.form, &attempt->curve);
    footpoints_follow(&w.form, target, &attempt->feet);
    w.trial = attempt_copy(attempt, target);
    w.step = knots_step_new(&attempt->curve);
    w.nearest = NEAREST * target->at[target->n - 1] / (double)w.form.spans;
    bool reached = climb(&w, goal);
    knots_step_free(&w.step);
    attempt_free(&w.trial);
    ppform_free(&w.form);
    return reached;
}
