/*
 * freeknots - starts, counts, and the proof.
 */
#include "freeknots.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "knotstart.h"
#include "minimax.h"

enum {
    ONE_BY_ONE = 12,
    PROOFS = 6,
    LEFT_OUT = 12,
    EXCHANGES = 8,
    FEW = 16,
    MANY = 40,
    PARTS = 96,
    PARTS_FINEST = 6000,
    PARTS_PER_POLE = 10
};
static const double RESOLUTION = 0.001; /* of a proof, in parts of the tolerance */
static const double MARGIN = 0.001;     /* parts of the tolerance that are kept for it */
static const double SLOWEST = 0.02;     /* of the mean speed */
static const double WORTH_IT = 5;       /* tolerances off: nearer is worth to be moved about */
static const double COARSE = 1.05;      /* parts of the tolerance */

struct search {
    const struct track *track;
    const struct freeknots_options *options;
    struct target target;
    struct attempt failed; /* the last count that did not serve: the nearest to it */
    struct attempt served; /* the least count that did, as it was before printing */
    struct bspline curve;  /* and as printed */
    struct proof proof;
    double *knot; /* of a start */
    size_t parts; /* places of the target, about */
    bool coarse;  /* a curve that kept the tolerance at them did not keep it between */
};

static void keep(struct attempt *place, struct attempt *attempt)
{
    attempt_free(place);
    *place = *attempt;
    *attempt = (struct attempt){0};
}

/*
 * True when the curve nowhere comes near to a stop, which a control would have to brake for: its
 * speed by the printed parameter is never below a fiftieth of the mean, which is 1.  (Not asked of
 * a point that hardly moves while the axis turns.)
 */
static bool runs_on(const struct bspline *curve, bool turns)
{
    enum { PARTS_OF_SPAN = 8 };

    for (size_t i = (size_t)curve->degree; i < curve->poles && !turns; i++)
        for (int k = 0; k <= PARTS_OF_SPAN; k++) {
            struct vec3 d[2];
            double part = (double)k / PARTS_OF_SPAN;
            double u = curve->knot[i] + part * (curve->knot[i + 1] - curve->knot[i]);
            bspline_derivatives(curve, curve->pole, u, 1, d);
            if (!(vec_length(d[1]) > SLOWEST))
                return false;
        }
    return true;
}

/* True when the attempt keeps the tolerance on its printed digits; if need be it is moved on. */
static bool prove(struct search *s, struct attempt *attempt)
{
    const struct freeknots_options *o = s->options;
    double goal = (1 - MARGIN) * o->tolerance;

    for (int i = 0; i < PROOFS && minimax_fit(&s->target, goal, attempt); i++) {
        struct bspline curve = bspline_copy(&attempt->curve);
        struct proof proof = {INFINITY, INFINITY, INFINITY};
        if (proof_print(&curve))
            proof_measure(&curve, s->track, RESOLUTION * o->tolerance, INFINITY, &proof);
        if (proof_keeps(&proof, o->tolerance, o->angle) && runs_on(&curve, s->target.other_leads)) {
            bspline_free(&s->curve);
            s->curve = curve;
            s->proof = proof;
            return true;
        }
        bspline_free(&curve);
        double over = fmax(fmax(proof.point, proof.other) / o->tolerance, proof.axis / o->angle);
        if (!(over < 2)) {
            s->coarse = true;
            return false;
        }
        s->coarse = s->coarse || over > COARSE;
        goal = fmin(goal, attempt->feet.worst) * (1 - MARGIN) / over;
    }
    return false;
}

/* Fits the attempt; takes it, whatever comes of it. */
static bool serves(struct search *s, struct attempt *attempt)
{
    bool done = prove(s, attempt);

    if (done)
        keep(&s->served, attempt);
    else if (s->failed.curve.poles != attempt->curve.poles ||
             attempt->feet.worst < s->failed.feet.worst)
        keep(&s->failed, attempt);
    attempt_free(attempt);
    return done;
}

/* A start from the knots s->knot. */
static bool serves_from(struct search *s, size_t poles, const double *u)
{
    struct attempt attempt = {0};
    struct bspline form = {.degree = s->options->degree, .poles = poles};

    if (attempt_start(&s->target, &form, s->knot, u, &attempt))
        return serves(s, &attempt);
    attempt_free(&attempt);
    return false;
}

/* The failed curve with a knot more where it is worst. */
static struct attempt one_more(struct search *s)
{
    struct attempt more = attempt_copy(&s->failed, &s->target);
    double u = more.feet.u[more.feet.where];

    size_t span = bspline_span(more.curve.degree, more.curve.poles, more.curve.knot, u);
    double from = more.curve.knot[span], width = more.curve.knot[span + 1] - from;
    u = fmin(fmax(u, from + 0.25 * width), from + 0.75 * width);
    bspline_insert(&more.curve, u);
    return more;
}

/* The starts that know nothing of other attempts. */
static bool serves_anew(struct search *s, size_t poles)
{
    int degree = s->options->degree;

    knotstart_uniform(&s->target, degree, poles, s->knot);
    if (serves_from(s, poles, s->target.at))
        return true;
    if (poles < (size_t)degree + 2 || !knotstart_spread(&s->target, degree, poles, s->knot))
        return false;
    if (serves_from(s, poles, s->target.at))
        return true;
    knotstart_spread(&s->target, degree, poles, s->knot);
    knotstart_mean(&s->target, degree, poles, s->knot);
    return serves_from(s, poles, s->target.at);
}

/* From the curve of `attempt` without its knot j. */
static bool serves_without(struct search *s, const struct attempt *attempt, size_t j)
{
    const double *knot = attempt->curve.knot;
    size_t knots = attempt->curve.poles + (size_t)s->options->degree + 1;
    double *u = mem_alloc(s->target.n, sizeof *u);

    memcpy(u, attempt->feet.u, s->target.n * sizeof *u);
    memcpy(s->knot, knot, j * sizeof *knot);
    memcpy(s->knot + j, knot + j + 1, (knots - j - 1) * sizeof *knot);
    bool done = serves_from(s, attempt->curve.poles - 1, u);
    free(u);
    return done;
}

/* With one knot less: up to `tries` of those that are missed least. */
static bool serves_with_one_less(struct search *s, const struct attempt *from, int tries)
{
    struct attempt attempt = attempt_copy(from, &s->target);
    size_t first = (size_t)s->options->degree + 1, poles = attempt.curve.poles;
    double *missed = mem_alloc(poles, sizeof *missed);
    bool done = false;

    for (size_t j = first; j < poles; j++)
        missed[j] = knotstart_missed(&attempt.curve, j);
    for (int i = 0; i < tries && !done; i++) {
        size_t least = first;
        for (size_t j = first; j < poles; j++)
            if (missed[j] < missed[least])
                least = j;
        if (poles <= first || !isfinite(missed[least]))
            break;
        missed[least] = INFINITY;
        done = serves_without(s, &attempt, least);
    }
    free(missed);
    attempt_free(&attempt);
    return done;
}

/* How many knots are worth a try to be left out. */
static int tries(const struct search *s)
{
    return s->curve.poles <= FEW ? LEFT_OUT : s->curve.poles <= MANY ? LEFT_OUT / 2 : 1;
}

/*
 * The best that failed, with a knot more where it is worst and then one less elsewhere, as long as
 * that makes it better.
 */
static bool serves_by_exchange(struct search *s)
{
    int most = s->curve.poles <= FEW ? EXCHANGES : s->curve.poles <= MANY ? 1 : 0;

    for (int i = 0; i < most; i++) {
        double before = s->failed.feet.worst;
        if (s->failed.curve.poles + 1 != s->curve.poles ||
            !(before < WORTH_IT * s->options->tolerance))
            break;
        struct attempt more = one_more(s);
        minimax_fit(&s->target, (1 - MARGIN) * s->options->tolerance, &more);
        bool done = serves_with_one_less(s, &more, tries(s));
        attempt_free(&more);
        if (done)
            return true;
        if (!(s->failed.feet.worst < 0.998 * before))
            break;
    }
    return false;
}

static size_t next_count(size_t poles)
{
    return poles < ONE_BY_ONE ? poles + 1 : poles + poles / 4;
}

/* More places when there are more poles. */
static void set_target(struct search *s, size_t poles)
{
    const struct freeknots_options *o = s->options;

    if (s->target.n > 0 && poles * PARTS_PER_POLE <= s->parts)
        return;
    while (poles * PARTS_PER_POLE > s->parts)
        s->parts *= 2;
    target_free(&s->target);
    attempt_free(&s->failed);
    s->target = target_new(s->track, s->parts, o->tolerance, o->angle);
    free(s->knot);
    s->knot = mem_alloc(2 * s->target.n + 32, sizeof *s->knot);
}

static bool serves_with_one_more(struct search *s)
{
    struct attempt more = one_more(s);
    return serves(s, &more);
}

/* Upwards until a count serves.  Returns the last one that did not. */
static size_t search_upwards(struct search *s, size_t least)
{
    size_t failed = least - 1;

    for (size_t n = least; n < s->track->n && s->curve.poles == 0; n = next_count(n)) {
        set_target(s, n);
        if (!(s->failed.curve.poles + 1 == n && serves_with_one_more(s)) && !serves_anew(s, n))
            failed = n;
    }
    return failed;
}

static void bisect(struct search *s, size_t failed)
{
    while (s->curve.poles > failed + 1) {
        size_t n = failed + (s->curve.poles - failed) / 2;
        if (!serves_anew(s, n))
            failed = n;
    }
}

static void search_counts(struct search *s)
{
    size_t least = (size_t)s->options->degree + 1;

    least = least < 3 ? 3 : least;
    size_t failed = search_upwards(s, least);
    if (s->curve.poles > ONE_BY_ONE)
        bisect(s, failed);
    while (s->curve.poles > least &&
           (serves_with_one_less(s, &s->served, tries(s)) || serves_by_exchange(s)))
        ;
}

static void search_free(struct search *s)
{
    attempt_free(&s->failed);
    attempt_free(&s->served);
    target_free(&s->target);
    free(s->knot);
}

bool freeknots_search(const struct track *track, const struct freeknots_options *options,
                      struct bspline *curve, struct proof *proof)
{
    *curve = (struct bspline){0};
    for (size_t parts = PARTS; parts <= PARTS_FINEST; parts *= 4) {
        struct search s = {.track = track, .options = options, .parts = parts};
        search_counts(&s);
        if (s.curve.poles > 0 && (curve->poles == 0 || s.curve.poles < curve->poles)) {
            bspline_free(curve);
            *curve = s.curve;
            *proof = s.proof;
        } else {
            bspline_free(&s.curve);
        }
        search_free(&s);
        if (!s.coarse || curve->poles > 0 || parts > track->n)
            break;
    }
    return curve->poles > 0;
}
