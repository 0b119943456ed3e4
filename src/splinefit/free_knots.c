/*
 * free_knots - starts and counts.
 */
#include "free_knots.h"

#include <stdlib.h>

#include "base/array.h"
#include "knots_init.h"
#include "knots_try.h"

enum {
    ONE_BY_ONE = 12,
    LEFT_OUT = 12,
    EXCHANGES = 8,
    FEW = 16,
    MANY = 40,
    ROUGH_POINTS = 4,
    UNEVEN_POINTS = 6,
    UNEVEN_KNOWN = 12,
    PATIENCE = 5,
    TRIALS = 2,      /* of uneven data that may fail */
    PLACES = 4,      /* points that a pole known to be needed counts for */
    FINEST = 50,     /* part of a count that is worth no more trials */
    MORE_AGAIN = 16, /* part of a curve's poles that it may get more */
    PARTS = 64,
    PARTS_FINEST = 6000
};
static const double WORTH_IT = 5; /* tolerances off: nearer is worth to be moved about */
static const double NEARLY = 2;   /* nearer than this is worth more patience */
static const double EFFORT = 6e4, EFFORT_PER_POINT = 2500; /* distances times steps, at most */
static const double EFFORT_UNEVEN = 400; /* the same per point, from where on the data is uneven */

/* Knots spread by what the data asks for. */
static bool serves_spread(struct knots_trials *t, size_t poles)
{
    return knots_init_spread(&t->rough, t->options->degree, poles, t->knot) &&
           knots_try_from_knots(t, poles, t->rough.at);
}

/* The starts that know nothing of other attempts. */
static bool serves_anew(struct knots_trials *t, size_t poles)
{
    int degree = t->options->degree;

    knots_init_uniform(&t->rough, degree, poles, t->knot);
    if (knots_try_from_knots(t, poles, t->rough.at))
        return true;
    if (poles < (size_t)degree + 2 || !knots_init_spread(&t->rough, degree, poles, t->knot))
        return false;
    if (knots_try_from_knots(t, poles, t->rough.at))
        return true;
    knots_init_spread(&t->rough, degree, poles, t->knot);
    knots_init_mean(&t->rough, degree, poles, t->knot);
    return knots_try_from_knots(t, poles, t->rough.at);
}

/* With one knot less: up to `tries` of those that are missed least. */
static bool serves_with_one_less(struct knots_trials *t, const struct attempt *from, int tries)
{
    struct attempt attempt = attempt_copy(from, &t->rough);
    size_t first = (size_t)t->options->degree + 1, poles = attempt.curve.poles;
    double *missed = mem_alloc(poles, sizeof *missed);
    bool done = false;

    for (size_t j = first; j < poles; j++)
        missed[j] = knots_init_missed(&attempt.curve, j);
    for (int i = 0; i < tries && !done; i++) {
        size_t least = first;
        for (size_t j = first; j < poles; j++)
            if (missed[j] < missed[least])
                least = j;
        if (poles <= first || !isfinite(missed[least]))
            break;
        missed[least] = INFINITY;
        done = knots_try_without(t, &attempt, least);
    }
    free(missed);
    attempt_free(&attempt);
    return done;
}

/* How many knots are worth a try to be left out. */
static int tries(const struct knots_trials *t)
{
    return t->curve.poles <= FEW ? LEFT_OUT : t->curve.poles <= MANY ? LEFT_OUT / 2 : 1;
}

/*
 * The best that failed, with a knot more where it is worst and then one less elsewhere, as long as
 * that makes it better.
 */
static bool serves_by_exchange(struct knots_trials *t)
{
    int most = t->curve.poles <= FEW ? EXCHANGES : t->curve.poles <= MANY ? 1 : 0;

    for (int i = 0; i < most && t->effort > 0; i++) {
        double before = t->failed.feet.worst;
        if (t->failed.curve.poles + 1 != t->curve.poles ||
            !(before < WORTH_IT * t->options->tolerance))
            break;
        struct attempt more = knots_try_one_more(t, &t->failed);
        minimax_fit(&t->rough, t->options->tolerance, 1, &more, &t->effort);
        bool done = serves_with_one_less(t, &more, tries(t));
        attempt_free(&more);
        if (done)
            return true;
        if (!(t->failed.feet.worst < 0.998 * before))
            break;
    }
    return false;
}

static size_t next_count(size_t poles)
{
    return poles < ONE_BY_ONE ? poles + 1 : poles + poles / 4;
}

static bool serves_with_one_more(struct knots_trials *t)
{
    struct attempt more = knots_try_one_more(t, &t->failed);
    return knots_try_serves(t, &more);
}

/* A pole for every few points and still to do: the curve would follow the noise of the data. */
static bool is_rough(const struct knots_trials *t, size_t poles, size_t points)
{
    return poles > FEW && poles * points > t->track->n;
}

/* Upwards until a count serves.  Returns the last one that did not. */
static size_t search_upwards(struct knots_trials *t, size_t parts, size_t least)
{
    size_t failed = least - 1;

    for (size_t n = least; n < (t->options->known ? t->options->known : t->track->n) &&
                           t->curve.poles == 0 && t->effort > 0 && !is_rough(t, n, ROUGH_POINTS);
         n = next_count(n)) {
        if (is_rough(t, n, UNEVEN_POINTS))
            t->effort = fmin(t->effort, EFFORT_UNEVEN * (double)t->track->n);
        knots_trials_aim(t, parts, n);
        if (!(t->failed.curve.poles + 1 == n && serves_with_one_more(t)) && !serves_anew(t, n))
            failed = n;
    }
    return failed;
}

static void bisect(struct knots_trials *t, size_t failed)
{
    while (t->curve.poles > failed + 1 && t->effort > 0) {
        size_t n = failed + (t->curve.poles - failed) / 2;
        if (!serves_anew(t, n))
            failed = n;
    }
}

/* The nearest that failed, with more patience. */
static bool serves_by_patience(struct knots_trials *t)
{
    bool done = false;

    if (t->failed.curve.poles + 1 == t->curve.poles &&
        t->failed.feet.worst < NEARLY * t->options->tolerance) {
        struct attempt again = attempt_copy(&t->failed, &t->rough);
        t->patience = PATIENCE;
        done = knots_try_serves(t, &again);
        t->patience = 1;
    }
    return done;
}

/*
 * Of uneven data, where a curve that serves is found soon, but one that does not is long in
 * failing: down from the count that is known, and none gets much of the effort.  Only knots spread
 * by the data are a start that comes near.
 */
static void search_uneven(struct knots_trials *t, size_t least)
{
    size_t serves = t->options->known, failed = least - 1;
    double most = EFFORT_UNEVEN * fmax((double)t->track->n, PLACES * (double)serves);
    double left = fmin(t->effort, most), each = left / TRIALS;

    knots_trials_aim_few(t, serves);
    while (serves - failed > 1 + serves / FINEST && left > 0) {
        size_t n = failed < least ? serves * 3 / 5 : failed + (serves - failed) / 2;
        n = n < least ? least : n;
        t->effort = each;
        if (serves_spread(t, n))
            serves = n;
        else
            failed = n;
        left -= each - t->effort;
    }
    t->effort = left;
}

static void search_counts(struct knots_trials *t, size_t parts)
{
    size_t least = (size_t)t->options->degree + 1;

    least = least < 3 ? 3 : least;
    if (is_rough(t, t->options->known, UNEVEN_KNOWN)) {
        search_uneven(t, least);
    } else {
        size_t failed = search_upwards(t, parts, least);
        if (t->curve.poles > ONE_BY_ONE)
            bisect(t, failed);
    }
    while (t->curve.poles > least && t->effort > 0 && !is_rough(t, t->curve.poles, UNEVEN_POINTS) &&
           (serves_with_one_less(t, &t->served, tries(t)) || serves_by_patience(t) ||
            serves_by_exchange(t)))
        ;
}

bool free_knots_search(const struct track *track, const struct free_knots_options *options,
                       struct bspline *curve, struct spline_bound *proof, bool *cut)
{
    double effort = EFFORT + EFFORT_PER_POINT * (double)track->n;

    *curve = (struct bspline){0};
    for (size_t parts = PARTS; parts <= PARTS_FINEST; parts *= 4) {
        struct knots_trials t = {
            .track = track, .options = options, .effort = effort, .patience = 1};
        search_counts(&t, parts);
        if (t.curve.poles > 0 && (curve->poles == 0 || t.curve.poles < curve->poles)) {
            bspline_free(curve);
            *curve = t.curve;
            *proof = t.proof;
        } else {
            bspline_free(&t.curve);
        }
        effort = t.effort;
        bool coarse = t.coarse;
        knots_trials_free(&t);
        if (!coarse || curve->poles > 0 || parts > track->n)
            break;
    }
    *cut = effort <= 0;
    return curve->poles > 0;
}

bool free_knots_again(const struct track *track, const struct free_knots_options *options,
                      const struct bspline *before, struct bspline *curve,
                      struct spline_bound *proof)
{
    struct knots_trials t = {.track = track, .options = options, .patience = 1};
    size_t most = before->poles + before->poles / MORE_AGAIN + 2;

    *curve = (struct bspline){0};
    if ((track->head != NULL) != (before->head != NULL))
        return false;
    t.effort = EFFORT_UNEVEN * (double)track->n;
    knots_trials_aim_few(&t, most);
    bool done = knots_try_from_curve(&t, before);
    while (!done && t.failed.curve.poles > 0 && t.failed.curve.poles < most && t.effort > 0)
        done = serves_with_one_more(&t);
    if (done) {
        *curve = t.curve;
        *proof = t.proof;
    }
    knots_trials_free(&t);
    return done;
}
