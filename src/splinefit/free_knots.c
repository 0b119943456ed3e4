/* free_knots - see free_knots.h. */
#include "free_knots.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "knots_init.h"
#include "minimax.h"
#include "spline_bound.h"
#include "spline_lsq.h"

/* ---- tries: from knots to a proven curve */

/* What the tries on one reference share, and the best that they found. */
struct knots_tries {
    const struct reference *reference;
    const struct free_knots_options *options;
    struct deviation within;
    struct reference rough;  /* few places: most tries fail on them already */
    struct reference fine;   /* and more, to be nearly sure before a proof */
    struct candidate failed; /* the nearest with the last count that did not serve, on `rough` */
    struct candidate served; /* with the least count that did, before printing, on `rough` */
    struct bspline curve;    /* and as printed; no poles as long as none did */
    struct deviation proof;
    double *knot;  /* room for those of a start */
    size_t parts;  /* places of `rough`, about */
    bool coarse;   /* a curve that kept the tolerance at the places did not keep it between */
    int patience;  /* of minimax_fit */
    double effort; /* distances times steps that may still be spent */
};

enum { PROOFS = 6, ROUGH_PER_POLE = 8, FINER = 4, FEW_PER_POLE = 5, FEW_FINER = 2, FEW_LEAST = 64 };
static const double SLOWEST = 0.1; /* of the mean speed */
static const double NEAR = 0.1;    /* parts of the tolerance: feet to begin with */
static const double COARSE = 1.05; /* parts of the tolerance */

static void set_places(struct knots_tries *t, size_t parts, size_t finer)
{
    reference_free(&t->rough);
    reference_free(&t->fine);
    candidate_free(&t->failed);
    t->parts = parts;
    t->rough = reference_sample(t->reference, parts);
    t->fine = reference_sample(t->reference, finer * parts);
    free(t->knot);
    t->knot = mem_alloc(2 * t->rough.n + 32, sizeof *t->knot);
}

/* With at least `parts` places and enough of them for so many poles; all found so far is kept, but
 * `failed`. */
static void knots_try_on_places(struct knots_tries *t, size_t parts, size_t poles)
{
    if (t->rough.n > 0 && poles * ROUGH_PER_POLE <= t->parts)
        return;
    parts = t->parts > parts ? t->parts : parts;
    while (poles * ROUGH_PER_POLE > parts)
        parts *= 2;
    set_places(t, parts, FINER);
}

/* Before any try: as few places as tell for curves of at most so many poles. */
static void knots_try_on_few_places(struct knots_tries *t, size_t poles)
{
    size_t parts = FEW_PER_POLE * poles;

    set_places(t, parts > FEW_LEAST ? parts : FEW_LEAST, FEW_FINER);
}

/* Frees all but the curve. */
static void knots_tries_free(struct knots_tries *t)
{
    candidate_free(&t->failed);
    candidate_free(&t->served);
    reference_free(&t->rough);
    reference_free(&t->fine);
    free(t->knot);
}

static void replace_candidate(struct candidate *place, struct candidate *candidate)
{
    candidate_free(place);
    *place = *candidate;
    *candidate = (struct candidate){0};
}

/* Speed by the parameter of the point that moves more: the tracked one, or the other end of the
 * radius, which is nearly in proportion between the point and the head. */
static double speed_at(const struct bspline *curve, const struct reference *places, double u)
{
    struct vec3 point[2], head[2];

    bspline_derivatives(curve, curve->pole, u, 1, point);
    if (!places->other_leads)
        return vec_length(point[1]);
    bspline_derivatives(curve, curve->head, u, 1, head);
    return vec_length(vec_mix(point[1], head[1], places->offset / HEAD_LENGTH));
}

/* True if the parameter speed never falls near zero, which a control would have to brake for. */
static bool never_stops(const struct bspline *curve, const struct reference *places)
{
    enum { PARTS_OF_SPAN = 8 };
    double least = INFINITY, sum = 0, start = curve->knot[0];

    for (size_t i = (size_t)curve->degree; i < curve->poles; i++)
        for (int k = 0; k <= PARTS_OF_SPAN; k++) {
            double width = curve->knot[i + 1] - curve->knot[i];
            double speed = speed_at(curve, places, curve->knot[i] + width * k / PARTS_OF_SPAN);
            least = fmin(least, speed);
            sum += speed * width / (PARTS_OF_SPAN + 1);
        }
    return least > SLOWEST * sum / (curve->knot[curve->poles] - start);
}

/* True when the candidate, which is on `fine`, keeps the tolerance on its printed digits. */
static bool prove_printed(struct knots_tries *t, struct candidate *candidate)
{
    const struct free_knots_options *o = t->options;
    double goal = (1 - SPLINE_MARGIN) * o->tolerance;

    for (int i = 0; i < PROOFS && minimax_fit(&t->fine, goal, t->patience, candidate, &t->effort);
         i++) {
        struct bspline curve = bspline_copy(&candidate->curve);
        struct deviation proof = {INFINITY, INFINITY, INFINITY};
        if (bspline_has_short_span(&curve, o->least)) {
            bspline_free(&curve);
            return false;
        }
        t->effort -= (double)t->reference->n;
        if (spline_bound_print(&curve, t->reference))
            spline_bound_measure(&curve, t->reference, SPLINE_RESOLUTION_FREE * o->tolerance,
                                 INFINITY, &proof);
        if (deviation_within(&proof, &t->within) && never_stops(&curve, &t->fine)) {
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
        goal = fmin(goal, candidate->feet.worst) * (1 - SPLINE_MARGIN) / over;
    }
    return false;
}

/* The candidate on `fine`, and back again. */
static bool prove_fine(struct knots_tries *t, struct candidate *candidate)
{
    struct candidate fine = candidate_onto(candidate, &t->rough, &t->fine);
    bool done = prove_printed(t, &fine);

    candidate_free(candidate);
    *candidate = candidate_onto(&fine, &t->fine, &t->rough);
    candidate_free(&fine);
    return done;
}

/*
 * Fits the candidate, on `rough` and then on `fine`, and proves it on the printed digits; if need
 * be it is moved on, to a smaller distance.  True when it serves; `served`, `curve` and `proof` are
 * its then.  Takes the candidate, whatever comes of it.
 */
static bool knots_try_serves(struct knots_tries *t, struct candidate *candidate)
{
    double goal = (1 - SPLINE_MARGIN) * t->options->tolerance;
    bool done = minimax_fit(&t->rough, goal, t->patience, candidate, &t->effort) &&
                prove_fine(t, candidate);

    if (done)
        replace_candidate(&t->served, candidate);
    else if (t->failed.curve.poles != candidate->curve.poles ||
             candidate->feet.worst < t->failed.feet.worst)
        replace_candidate(&t->failed, candidate);
    candidate_free(candidate);
    return done;
}

/* The same from the knots t->knot, by least squares with the places of `rough` at u. */
static bool knots_try_from_knots(struct knots_tries *t, size_t poles, const double *u)
{
    struct candidate candidate = {0};
    struct bspline form = {.degree = t->options->degree, .poles = poles};

    if (t->effort > 0 && candidate_new(&t->rough, &t->within, &form, t->knot, u, &candidate))
        return knots_try_serves(t, &candidate);
    candidate_free(&candidate);
    return false;
}

/* The same from a curve that was fitted to nearly the same data. */
static bool knots_try_from_curve(struct knots_tries *t, const struct bspline *before)
{
    const struct reference *places = &t->rough;
    struct candidate candidate = {bspline_copy(before), footpoints_new(places, &t->within)};
    struct reference data = *t->reference;
    size_t last = before->poles - 1, end = data.n - 1;

    candidate.curve.pole[0] = data.point[0];
    candidate.curve.pole[last] = data.point[end];
    if (before->head != NULL) {
        candidate.curve.head[0] = spline_head(&data, 0);
        candidate.curve.head[last] = spline_head(&data, end);
    }
    data.n = places->n;
    data.point = places->point;
    bool done =
        spline_bound_feet(&candidate.curve, &data, NEAR * t->options->tolerance, candidate.feet.u);
    if (done && before->head != NULL)
        memcpy(candidate.feet.v, candidate.feet.u, places->n * sizeof *candidate.feet.u);
    if (done)
        return knots_try_serves(t, &candidate);
    candidate_free(&candidate);
    return false;
}

/* A copy with a knot more where it is worst; the curve is the same. */
static struct candidate knots_try_one_more(const struct knots_tries *t,
                                           const struct candidate *from)
{
    struct candidate more = candidate_copy(from, &t->rough);
    double u = more.feet.u[more.feet.where];

    size_t span = bspline_span(more.curve.degree, more.curve.poles, more.curve.knot, u);
    double start = more.curve.knot[span], width = more.curve.knot[span + 1] - start;
    u = fmin(fmax(u, start + 0.25 * width), start + 0.75 * width);
    bspline_insert(&more.curve, u);
    return more;
}

/* The same for the curve of `from` without its knot j. */
static bool knots_try_without(struct knots_tries *t, const struct candidate *from, size_t j)
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

/* ---- counts of poles */

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
static bool serves_spread(struct knots_tries *t, size_t poles)
{
    return knots_init_spread(&t->rough, t->options->degree, poles, t->knot) &&
           knots_try_from_knots(t, poles, t->rough.length);
}

/* From knots that depend on no earlier candidate. */
static bool serves_from_scratch(struct knots_tries *t, size_t poles)
{
    int degree = t->options->degree;

    knots_init_uniform(&t->rough, degree, poles, t->knot);
    if (knots_try_from_knots(t, poles, t->rough.length))
        return true;
    if (poles < (size_t)degree + 2 || !knots_init_spread(&t->rough, degree, poles, t->knot))
        return false;
    if (knots_try_from_knots(t, poles, t->rough.length))
        return true;
    knots_init_spread(&t->rough, degree, poles, t->knot);
    knots_init_mean(&t->rough, degree, poles, t->knot);
    return knots_try_from_knots(t, poles, t->rough.length);
}

/* With one knot less: up to `tries` of those that are missed least. */
static bool serves_with_one_less(struct knots_tries *t, const struct candidate *from, int tries)
{
    struct candidate candidate = candidate_copy(from, &t->rough);
    size_t first = (size_t)t->options->degree + 1, poles = candidate.curve.poles;
    double *missed = mem_alloc(poles, sizeof *missed);
    bool done = false;

    knots_init_missed(&candidate.curve, missed + first);
    for (int i = 0; i < tries && !done; i++) {
        size_t least = first;
        for (size_t j = first; j < poles; j++)
            if (missed[j] < missed[least])
                least = j;
        if (poles <= first || !isfinite(missed[least]))
            break;
        missed[least] = INFINITY;
        done = knots_try_without(t, &candidate, least);
    }
    free(missed);
    candidate_free(&candidate);
    return done;
}

/* How many knots are worth a try to be left out. */
static int left_out_tries(const struct knots_tries *t)
{
    return t->curve.poles <= FEW ? LEFT_OUT : t->curve.poles <= MANY ? LEFT_OUT / 2 : 1;
}

/*
 * The best that failed, with a knot more where it is worst and then one less elsewhere, as long as
 * that makes it better.
 */
static bool serves_by_exchange(struct knots_tries *t)
{
    int most = t->curve.poles <= FEW ? EXCHANGES : t->curve.poles <= MANY ? 1 : 0;

    for (int i = 0; i < most && t->effort > 0; i++) {
        double before = t->failed.feet.worst;
        if (t->failed.curve.poles + 1 != t->curve.poles ||
            !(before < WORTH_IT * t->options->tolerance))
            break;
        struct candidate more = knots_try_one_more(t, &t->failed);
        minimax_fit(&t->rough, t->options->tolerance, 1, &more, &t->effort);
        bool done = serves_with_one_less(t, &more, left_out_tries(t));
        candidate_free(&more);
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

static bool serves_with_one_more(struct knots_tries *t)
{
    struct candidate more = knots_try_one_more(t, &t->failed);
    return knots_try_serves(t, &more);
}

/* A pole for every few points and still to do: the curve would follow the noise of the data. */
static bool is_rough(const struct knots_tries *t, size_t poles, size_t points)
{
    return poles > FEW && poles * points > t->reference->n;
}

static double work_share(const struct free_knots_options *options)
{
    return options->work > 0 ? options->work : 1;
}

static double uneven_effort(const struct free_knots_options *options)
{
    return EFFORT_UNEVEN * work_share(options);
}

/* Upwards until a count serves.  Returns the last one that did not. */
static size_t search_upwards(struct knots_tries *t, size_t parts, size_t least)
{
    size_t failed = least - 1;

    for (size_t n = least; n < (t->options->known ? t->options->known : t->reference->n) &&
                           t->curve.poles == 0 && t->effort > 0 && !is_rough(t, n, ROUGH_POINTS);
         n = next_count(n)) {
        if (is_rough(t, n, UNEVEN_POINTS))
            t->effort = fmin(t->effort, uneven_effort(t->options) * (double)t->reference->n);
        knots_try_on_places(t, parts, n);
        if (!(t->failed.curve.poles + 1 == n && serves_with_one_more(t)) &&
            !serves_from_scratch(t, n))
            failed = n;
    }
    return failed;
}

static void bisect(struct knots_tries *t, size_t failed)
{
    while (t->curve.poles > failed + 1 && t->effort > 0) {
        size_t n = failed + (t->curve.poles - failed) / 2;
        if (!serves_from_scratch(t, n))
            failed = n;
    }
}

/* The nearest candidate that failed, with more steps. */
static bool serves_by_patience(struct knots_tries *t)
{
    bool done = false;

    if (t->failed.curve.poles + 1 == t->curve.poles &&
        t->failed.feet.worst < NEARLY * t->options->tolerance) {
        struct candidate again = candidate_copy(&t->failed, &t->rough);
        t->patience = PATIENCE;
        done = knots_try_serves(t, &again);
        t->patience = 1;
    }
    return done;
}

/*
 * Of uneven data, where a curve that serves is found soon, but one that does not is long in
 * failing: down from the count that is known, and none gets much of the effort.  Only knots
 * spread_knots by the data are a start that comes near.
 */
static void search_uneven(struct knots_tries *t, size_t least)
{
    size_t serves = t->options->known, failed = least - 1;
    double most =
        uneven_effort(t->options) * fmax((double)t->reference->n, PLACES * (double)serves);
    double left = fmin(t->effort, most), each = left / TRIALS;

    knots_try_on_few_places(t, serves);
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

static void search_counts(struct knots_tries *t, size_t parts)
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
           (serves_with_one_less(t, &t->served, left_out_tries(t)) || serves_by_patience(t) ||
            serves_by_exchange(t)))
        ;
}

static struct knots_tries knots_tries_new(const struct reference *reference,
                                          const struct free_knots_options *options, double effort)
{
    return (struct knots_tries){.reference = reference,
                                .options = options,
                                .within = {options->tolerance, options->tolerance, options->angle},
                                .effort = effort,
                                .patience = 1};
}

struct free_knots_result free_knots_search(const struct reference *reference,
                                           const struct free_knots_options *options)
{
    struct free_knots_result best = {.cut = false};
    double effort = (EFFORT + EFFORT_PER_POINT * (double)reference->n) * work_share(options);

    for (size_t parts = PARTS; parts <= PARTS_FINEST; parts *= 4) {
        struct knots_tries t = knots_tries_new(reference, options, effort);
        search_counts(&t, parts);
        if (t.curve.poles > 0 && (best.curve.poles == 0 || t.curve.poles < best.curve.poles)) {
            bspline_free(&best.curve);
            best.curve = t.curve;
            best.proof = t.proof;
        } else {
            bspline_free(&t.curve);
        }
        effort = t.effort;
        bool coarse = t.coarse;
        knots_tries_free(&t);
        if (!coarse || best.curve.poles > 0 || parts > reference->n)
            break;
    }
    best.cut = effort <= 0;
    return best;
}

struct free_knots_result free_knots_again(const struct reference *reference,
                                          const struct free_knots_options *options,
                                          const struct bspline *before)
{
    struct free_knots_result found = {.cut = false};
    double effort = uneven_effort(options) * (double)reference->n;
    struct knots_tries t = knots_tries_new(reference, options, effort);
    size_t most = before->poles + before->poles / MORE_AGAIN + 2;

    if (reference->turns != (before->head != NULL))
        return found;
    knots_try_on_few_places(&t, most);
    bool done = knots_try_from_curve(&t, before);
    while (!done && t.failed.curve.poles > 0 && t.failed.curve.poles < most && t.effort > 0)
        done = serves_with_one_more(&t);
    if (done) {
        found.curve = t.curve;
        found.proof = t.proof;
    }
    knots_tries_free(&t);
    return found;
}
