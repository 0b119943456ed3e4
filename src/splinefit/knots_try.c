/*
 * knots_try - from knots to a proven curve.
 */
#include "knots_try.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum { PROOFS = 6, ROUGH_PER_POLE = 8, FINER = 4, FEW_PER_POLE = 5, FEW_FINER = 2, FEW_LEAST = 64 };
static const double RESOLUTION = 0.002; /* of a proof, in parts of the tolerance */
static const double MARGIN = 0.001;     /* parts of the tolerance that are kept for it */
static const double SLOWEST = 0.1;      /* of the mean speed */
static const double NEAR = 0.1;         /* parts of the tolerance: feet to begin with */
static const double COARSE = 1.05;      /* parts of the tolerance */

static void aim(struct knots_trials *t, size_t parts, size_t finer)
{
    const struct free_knots_options *o = t->options;

    target_free(&t->rough);
    target_free(&t->fine);
    attempt_free(&t->failed);
    t->parts = parts;
    t->rough = target_new(t->track, parts, o->tolerance, o->angle);
    t->fine = target_new(t->track, finer * parts, o->tolerance, o->angle);
    free(t->knot);
    t->knot = mem_alloc(2 * t->rough.n + 32, sizeof *t->knot);
}

void knots_trials_aim(struct knots_trials *t, size_t parts, size_t poles)
{
    if (t->rough.n > 0 && poles * ROUGH_PER_POLE <= t->parts)
        return;
    parts = t->parts > parts ? t->parts : parts;
    while (poles * ROUGH_PER_POLE > parts)
        parts *= 2;
    aim(t, parts, FINER);
}

void knots_trials_aim_few(struct knots_trials *t, size_t poles)
{
    size_t parts = FEW_PER_POLE * poles;

    aim(t, parts > FEW_LEAST ? parts : FEW_LEAST, FEW_FINER);
}

void knots_trials_free(struct knots_trials *t)
{
    attempt_free(&t->failed);
    attempt_free(&t->served);
    target_free(&t->rough);
    target_free(&t->fine);
    free(t->knot);
}

static void keep(struct attempt *place, struct attempt *attempt)
{
    attempt_free(place);
    *place = *attempt;
    *attempt = (struct attempt){0};
}

/* Speed by the parameter of the point that moves more: the tracked one, or the other end of the
 * radius, which is nearly in proportion between the point and the head. */
static double speed_at(const struct bspline *curve, const struct target *target, double u)
{
    struct vec3 point[2], head[2];

    bspline_derivatives(curve, curve->pole, u, 1, point);
    if (!target->other_leads)
        return vec_length(point[1]);
    bspline_derivatives(curve, curve->head, u, 1, head);
    return vec_length(vec_mix(point[1], head[1], target->offset / TRACK_LENGTH));
}

/* True when the curve nowhere comes near to a stop, which a control would have to brake for. */
static bool runs_on(const struct bspline *curve, const struct target *target)
{
    enum { PARTS_OF_SPAN = 8 };
    double least = INFINITY, sum = 0, start = curve->knot[0];

    for (size_t i = (size_t)curve->degree; i < curve->poles; i++)
        for (int k = 0; k <= PARTS_OF_SPAN; k++) {
            double width = curve->knot[i + 1] - curve->knot[i];
            double speed = speed_at(curve, target, curve->knot[i] + width * k / PARTS_OF_SPAN);
            least = fmin(least, speed);
            sum += speed * width / (PARTS_OF_SPAN + 1);
        }
    return least > SLOWEST * sum / (curve->knot[curve->poles] - start);
}

/* True when the attempt, which is on `fine`, keeps the tolerance on its printed digits. */
static bool prove(struct knots_trials *t, struct attempt *attempt)
{
    const struct free_knots_options *o = t->options;
    double goal = (1 - MARGIN) * o->tolerance;

    for (int i = 0; i < PROOFS && minimax_fit(&t->fine, goal, t->patience, attempt, &t->effort);
         i++) {
        struct bspline curve = bspline_copy(&attempt->curve);
        struct spline_bound proof = {INFINITY, INFINITY, INFINITY};
        t->effort -= (double)t->track->n;
        if (spline_bound_print(&curve))
            spline_bound_measure(&curve, t->track, RESOLUTION * o->tolerance, INFINITY, &proof);
        if (spline_bound_keeps(&proof, o->tolerance, o->angle) && runs_on(&curve, &t->fine)) {
            bspline_free(&t->curve);
            t->curve = curve;
            t->proof = proof;
            return true;
        }
        bspline_free(&curve);
        double over = fmax(fmax(proof.point, proof.other) / o->tolerance, proof.axis / o->angle);
        if (!(over < 2)) {
            t->coarse = true;
            return false;
        }
        t->coarse = t->coarse || over > COARSE;
        goal = fmin(goal, attempt->feet.worst) * (1 - MARGIN) / over;
    }
    return false;
}

/* The attempt on `fine`, and back again. */
static bool prove_fine(struct knots_trials *t, struct attempt *attempt)
{
    struct attempt fine = attempt_onto(attempt, &t->rough, &t->fine);
    bool done = prove(t, &fine);

    attempt_free(attempt);
    *attempt = attempt_onto(&fine, &t->fine, &t->rough);
    attempt_free(&fine);
    return done;
}

bool knots_try_serves(struct knots_trials *t, struct attempt *attempt)
{
    double goal = (1 - MARGIN) * t->options->tolerance;
    bool done =
        minimax_fit(&t->rough, goal, t->patience, attempt, &t->effort) && prove_fine(t, attempt);

    if (done)
        keep(&t->served, attempt);
    else if (t->failed.curve.poles != attempt->curve.poles ||
             attempt->feet.worst < t->failed.feet.worst)
        keep(&t->failed, attempt);
    attempt_free(attempt);
    return done;
}

bool knots_try_from_knots(struct knots_trials *t, size_t poles, const double *u)
{
    struct attempt attempt = {0};
    struct bspline form = {.degree = t->options->degree, .poles = poles};

    if (t->effort > 0 && attempt_start(&t->rough, &form, t->knot, u, &attempt))
        return knots_try_serves(t, &attempt);
    attempt_free(&attempt);
    return false;
}

bool knots_try_from_curve(struct knots_trials *t, const struct bspline *before)
{
    const struct target *target = &t->rough;
    struct attempt attempt = {bspline_copy(before), footpoints_new(target)};
    struct track places = *t->track;
    size_t last = before->poles - 1, end = places.n - 1;

    attempt.curve.pole[0] = places.point[0];
    attempt.curve.pole[last] = places.point[end];
    if (before->head != NULL) {
        attempt.curve.head[0] = places.head[0];
        attempt.curve.head[last] = places.head[end];
    }
    places.n = target->n;
    places.point = target->point;
    bool done =
        spline_bound_feet(&attempt.curve, &places, NEAR * target->tolerance, attempt.feet.u);
    if (done && before->head != NULL)
        memcpy(attempt.feet.v, attempt.feet.u, target->n * sizeof *attempt.feet.u);
    if (done)
        return knots_try_serves(t, &attempt);
    attempt_free(&attempt);
    return false;
}

struct attempt knots_try_one_more(const struct knots_trials *t, const struct attempt *from)
{
    struct attempt more = attempt_copy(from, &t->rough);
    double u = more.feet.u[more.feet.where];

    size_t span = bspline_span(more.curve.degree, more.curve.poles, more.curve.knot, u);
    double start = more.curve.knot[span], width = more.curve.knot[span + 1] - start;
    u = fmin(fmax(u, start + 0.25 * width), start + 0.75 * width);
    bspline_insert(&more.curve, u);
    return more;
}

bool knots_try_without(struct knots_trials *t, const struct attempt *from, size_t j)
{
    const double *knot = from->curve.knot;
    size_t knots = from->curve.poles + (size_t)t->options->degree + 1;
    double *u = mem_alloc(t->rough.n, sizeof *u);

    memcpy(u, from->feet.u, t->rough.n * sizeof *u);
    memcpy(t->knot, knot, j * sizeof *knot);
    memcpy(t->knot + j, knot + j + 1, (knots - j - 1) * sizeof *knot);
    bool done = knots_try_from_knots(t, from->curve.poles - 1, u);
    free(u);
    return done;
}
