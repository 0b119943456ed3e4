/*
 * splinefit - counts of poles tried upwards, six combinations each.
 */
#include "splinefit/splinefit.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "free_knots.h"
#include "grown_knots.h"
#include "interpolate.h"
#include "spline_bound.h"
#include "spline_lsq.h"
#include "thin_lines.h"

enum { PARAMS = 3, KNOTS = 2, START = 5, STEP = 5, WIDER = 40 };

static const double HURRIED = 0.5; /* of the usual work: searches would take minutes */

static const double LINE = 0.021;     /* mm: the next block is read before a shorter one is over */
static const double LINE_ROOM = 0.75; /* of the tolerance: for the points left out for it */

/* Points of data that no number of even knots serves: of more, free ones would not serve either,
 * and take long to tell. */
enum { VAIN = 64 };

/* More poles than EVEN_MOST with fewer points for each than EVEN_POINTS follow noise. */
enum { EVEN_MOST = 24, EVEN_POINTS = 12 };

struct search {
    const struct reference *reference;
    const struct splinefit_options *options;
    struct deviation within;
    bool paper;
    struct vec3 *head; /* of the points; NULL: the axis is fixed */
    double *u[PARAMS]; /* the points' parameters, 0 to 1 */
    double *scaled;    /* the same in the range of a curve's knots */
};

static struct search search_new(const struct reference *reference,
                                const struct splinefit_options *options, bool paper)
{
    struct search s = {.reference = reference,
                       .options = options,
                       .within = {options->tolerance, options->tolerance, options->angle},
                       .paper = paper,
                       .head = reference->turns ? spline_heads(reference) : NULL};

    for (int i = 0; i < PARAMS; i++) {
        s.u[i] = mem_alloc(reference->n, sizeof(double));
        params_fill((enum params_method)i, reference->chord, reference->n, s.u[i]);
    }
    s.scaled = mem_alloc(reference->n, sizeof(double));
    return s;
}

static void search_free(struct search *s)
{
    for (int i = 0; i < PARAMS; i++)
        free(s->u[i]);
    free(s->scaled);
    free(s->head);
}

void splinefit_free(struct splinefit *fit)
{
    bspline_free(&fit->curve);
}

/* The parameters in the range of the printed knots. */
static void scale_params(const struct search *s, const double *u, const struct bspline *curve)
{
    double range = curve->knot[curve->poles];

    for (size_t k = 0; k < s->reference->n; k++)
        s->scaled[k] = fmin(u[k] * range, range);
}

/* Eq 7 at the other point. */
static double c1_other(const struct search *s, const struct bspline *curve)
{
    const struct reference *t = s->reference;
    double worst = 0;

    for (size_t k = 0; curve->head != NULL && k < t->n; k++) {
        struct vec3 p = bspline_at(curve, curve->pole, s->scaled[k]);
        struct vec3 h = bspline_at(curve, curve->head, s->scaled[k]);
        struct vec3 other = vec_along(p, t->offset, vec_unit(vec_sub(h, p)));
        worst = fmax(worst, vec_distance(other, t->other[k]));
    }
    return worst;
}

static bool is_accepted_by_paper(const struct search *s, const struct bspline *curve)
{
    const struct reference *t = s->reference;

    for (size_t k = 0; k < t->n; k++) {
        struct vec3 p = bspline_at(curve, curve->pole, s->scaled[k]);
        if (!(vec_distance(p, t->point[k]) <= s->options->tolerance))
            return false;
    }
    return c1_other(s, curve) <= s->options->tolerance;
}

static bool is_accepted(const struct search *s, const struct bspline *curve,
                        struct deviation *proof)
{
    const struct splinefit_options *o = s->options;

    if (s->paper) {
        if (!is_accepted_by_paper(s, curve))
            return false;
        spline_bound_measure(curve, s->reference, o->tolerance * SPLINE_RESOLUTION, INFINITY,
                             proof);
        return isfinite(proof->axis); /* not so where the head passes near the point */
    }
    if (spline_bound_hopeless(curve, s->reference, s->scaled, o->tolerance))
        return false;
    spline_bound_measure(curve, s->reference, o->tolerance * SPLINE_RESOLUTION, o->tolerance,
                         proof);
    return deviation_within(proof, &s->within);
}

/* One combination; on success *fit holds it in the place of what it held before. */
static bool try_combination(const struct search *s, size_t poles, int params, int knots,
                            struct splinefit *fit)
{
    const struct reference *t = s->reference;
    struct bspline curve = spline_new(t, s->options->degree, poles);
    struct deviation proof = {0};
    const double *u = s->u[params];

    knots_fill((enum knots_method)knots, u, t->n, curve.degree, poles, curve.knot);
    if (lsq_fit(&curve, u, t->point, s->head, t->n) && spline_bound_print(&curve, t)) {
        scale_params(s, u, &curve);
        if (is_accepted(s, &curve, &proof) && !bspline_has_short_span(&curve, s->options->least)) {
            bspline_free(&fit->curve);
            *fit = (struct splinefit){.curve = curve,
                                      .kind = SPLINEFIT_FITTED,
                                      .params = (enum params_method)params,
                                      .knots = (enum knots_method)knots,
                                      .proof = proof,
                                      .within = true};
            return true;
        }
    }
    bspline_free(&curve);
    return false;
}

/* The first combination that is accepted, in the paper's order. */
static bool try_count(const struct search *s, size_t poles, struct splinefit *fit)
{
    const struct splinefit_options *o = s->options;

    for (int i = 0; i < PARAMS; i++)
        for (int j = 0; j < KNOTS; j++)
            if ((o->params < 0 || o->params == i) && (o->knots < 0 || o->knots == j) &&
                try_combination(s, poles, i, j, fit))
                return true;
    return false;
}

static size_t next_count(const struct search *s, size_t poles)
{
    return s->paper || poles < WIDER ? poles + STEP : poles + poles / 4;
}

/* Upwards until a count serves; *failed is the last one that did not.  0: none. */
static size_t search_upwards(const struct search *s, size_t *failed, struct splinefit *fit)
{
    size_t least = (size_t)s->options->degree + 1;

    *failed = least - 1;
    for (size_t n = START < least ? least : START; n <= s->reference->n; n = next_count(s, n)) {
        if (try_count(s, n, fit))
            return n;
        *failed = n;
    }
    return 0;
}

static void bisect_count(const struct search *s, size_t failed, size_t served,
                         struct splinefit *fit)
{
    while (served - failed > 1) {
        size_t n = failed + (served - failed) / 2;
        if (try_count(s, n, fit))
            served = n;
        else
            failed = n;
    }
}

static bool try_straight(const struct search *s, struct splinefit *fit)
{
    const struct splinefit_options *o = s->options;

    *fit = (struct splinefit){.curve = spline_straight(s->reference), .kind = SPLINEFIT_STRAIGHT};
    if (spline_bound_print(&fit->curve, s->reference)) {
        spline_bound_measure(&fit->curve, s->reference, o->tolerance * SPLINE_RESOLUTION,
                             o->tolerance, &fit->proof);
        fit->within = deviation_within(&fit->proof, &s->within);
    }
    if (!fit->within)
        splinefit_free(fit);
    return fit->within;
}

/* What always serves: the data's own polyline, less what would be lines below LINE mm.  Between two
 * points the ball goes as it does on the path, where a straight way of the tip swings it off its
 * own: no deviation of the curve's. */
static void set_polyline(const struct search *s, struct splinefit *fit)
{
    const struct deviation room = {LINE_ROOM * s->within.point, LINE_ROOM * s->within.other,
                                   LINE_ROOM * s->within.axis};
    struct deviation made, off;
    struct reference t =
        thin_lines(s->reference, &room, s->options->least > 0 && !s->paper ? LINE : 0, &off);

    *fit = (struct splinefit){.curve = spline_polyline(&t), .kind = SPLINEFIT_POLYLINE};
    spline_bound_print(&fit->curve, s->reference);
    spline_bound_polyline(&fit->curve, &t, &fit->proof);
    fit->proof = deviation_worst(fit->proof, off);
    made = (struct deviation){fit->proof.point, 0, fit->proof.axis};
    fit->within = deviation_within(&made, &s->within);
    reference_free(&t);
}

/* False: nothing was found. */
static bool take_found(struct free_knots_result found, struct splinefit *fit)
{
    fit->curve = found.curve;
    fit->proof = found.proof;
    fit->cut = found.cut;
    return found.curve.poles > 0;
}

/* With all combinations open, the knots may as well be free.  `before`: a curve for nearly the same
 * data, or NULL. */
static bool fit_free_knots(const struct search *s, size_t known, const struct bspline *before,
                           struct splinefit *fit)
{
    const struct splinefit_options *o = s->options;
    struct free_knots_options options = {o->degree, o->tolerance, o->angle, known,
                                         o->work,   o->least,     NULL};

    *fit = (struct splinefit){.kind = SPLINEFIT_FREE, .within = true};
    if (o->params >= 0 || o->knots >= 0 || (before && before->degree != o->degree))
        return false;
    struct free_knots_result found = before ? free_knots_again(s->reference, &options, before)
                                            : free_knots_search(s->reference, &options);
    return take_found(found, fit);
}

/* Knots and parameters are not prescribed: the knots may as well be free. */
static bool is_open(const struct splinefit_options *options)
{
    return options->params < 0 && options->knots < 0;
}

static bool is_hurried(const struct splinefit_options *options)
{
    return options->work > 0 && options->work < HURRIED && is_open(options);
}

/* The curve follows the noise of its data: a search would end by its bound, with more poles. */
static bool is_uneven(const struct search *s, const struct splinefit *fit)
{
    size_t poles = fit->curve.poles;

    return poles > EVEN_MOST && poles * EVEN_POINTS > s->reference->n;
}

/* In a time that is linear in the data: knots where it asks for them.  False: it finds nothing.
 * `before` as above. */
static bool fit_grown_knots(const struct search *s, const struct bspline *before,
                            struct splinefit *fit)
{
    const struct splinefit_options *o = s->options;
    struct free_knots_options options = {o->degree, o->tolerance, o->angle, 0,
                                         o->work,   o->least,     o->moved};
    bool alike = before && before->degree == o->degree && before->poles < s->reference->n;

    *fit = (struct splinefit){.kind = SPLINEFIT_GROWN, .within = true};
    bool found = take_found(grown_knots_fit(s->reference, &options, alike ? before : NULL), fit);
    fit->cut = true;
    return found;
}

/* The same where there is no time for more: if need be the data's own polyline. */
static void fit_hurried(const struct search *s, const struct bspline *before, struct splinefit *fit)
{
    if (!fit_grown_knots(s, before, fit))
        set_polyline(s, fit);
    fit->cut = true;
}

static void fit_by_least_squares(const struct search *s, struct splinefit *fit)
{
    size_t failed, served = search_upwards(s, &failed, fit);

    if (served == 0)
        set_polyline(s, fit);
    else
        bisect_count(s, failed, served, fit);
}

/* The one with fewer poles into *fit. */
static void keep_fewer(struct splinefit *fit, struct splinefit *other)
{
    if (other->curve.poles < fit->curve.poles) {
        struct splinefit more = *fit;
        *fit = *other;
        *other = more;
    }
    splinefit_free(other);
}

/* The paper's measures of the curve that was chosen. */
static void set_paper_error(struct search *s, struct splinefit *fit)
{
    const struct reference *t = s->reference;

    if (fit->kind == SPLINEFIT_POLYLINE && fit->curve.poles == t->n)
        memcpy(s->scaled, fit->curve.knot + 1, t->n * sizeof *s->scaled);
    else if (fit->kind == SPLINEFIT_FREE || fit->kind == SPLINEFIT_POLYLINE)
        spline_bound_feet(&fit->curve, t, s->options->tolerance * SPLINE_RESOLUTION, s->scaled);
    else if (fit->kind == SPLINEFIT_STRAIGHT || fit->kind == SPLINEFIT_GROWN)
        scale_params(s, s->u[PARAMS_CHORD], &fit->curve);
    else
        scale_params(s, s->u[fit->params], &fit->curve);
    fit->deviation = fit_error_of(&fit->curve, fit->curve.pole, t->point, s->scaled, t->n);
}

void splinefit_paper(const struct reference *reference, const struct splinefit_options *options,
                     struct splinefit *fit)
{
    struct search s = search_new(reference, options, true);
    size_t failed;

    *fit = (struct splinefit){0};
    if (search_upwards(&s, &failed, fit) == 0)
        set_polyline(&s, fit);
    fit->within = true;
    set_paper_error(&s, fit);
    search_free(&s);
}

/* `grown`: knots were found where they were asked for. */
static void search_with(const struct reference *reference, const struct splinefit_options *options,
                        bool grown, struct splinefit *fit)
{
    struct search s = search_new(reference, options, false);
    struct splinefit squares = {0};
    bool many = !grown && reference->n > VAIN && is_open(options);
    bool first = reference->turns || many; /* the search is long: it is good to know before */

    if (first)
        fit_by_least_squares(&s, &squares);
    bool vain = first && squares.kind == SPLINEFIT_POLYLINE && reference->n > VAIN;
    size_t known = reference->turns && squares.within ? squares.curve.poles : 0;
    bool found = !vain && fit_free_knots(&s, known, NULL, fit), cut = !vain && fit->cut;
    if (!first && (!found || cut))
        fit_by_least_squares(&s, &squares);
    if (!found)
        *fit = squares;
    else if (first || cut)
        keep_fewer(fit, &squares);
    fit->cut = cut;
    set_paper_error(&s, fit);
    search_free(&s);
}

/* With knot spans of any length first: as a rule none of them is too short. */
static void search_spans(const struct reference *reference, const struct splinefit_options *options,
                         bool grown, struct splinefit *fit)
{
    struct splinefit_options any = *options;
    struct splinefit longer;

    any.least = 0;
    search_with(reference, &any, grown, fit);
    if (fit->kind == SPLINEFIT_POLYLINE || !bspline_has_short_span(&fit->curve, options->least))
        return;
    search_with(reference, options, grown, &longer);
    if (longer.kind == SPLINEFIT_POLYLINE) { /* the tolerance forbids it */
        splinefit_free(&longer);
        return;
    }
    splinefit_free(fit);
    *fit = longer;
}

/* What is found in little time; *done: more time would be spent in vain, or there is none. */
static void search_soon(const struct reference *reference, const struct splinefit_options *options,
                        struct splinefit *fit, bool *done)
{
    struct search s = search_new(reference, options, false);

    *fit = (struct splinefit){0};
    *done = try_straight(&s, fit);
    if (!*done && is_hurried(options)) {
        fit_hurried(&s, NULL, fit);
        *done = true;
    } else if (!*done && is_open(options) && fit_grown_knots(&s, NULL, fit)) {
        *done = is_uneven(&s, fit);
    }
    if (fit->curve.poles > 0)
        set_paper_error(&s, fit);
    search_free(&s);
}

void splinefit_search(const struct reference *reference, const struct splinefit_options *options,
                      struct splinefit *fit)
{
    struct splinefit soon;
    bool done;

    search_soon(reference, options, &soon, &done);
    if (done) {
        *fit = soon;
        return;
    }
    bool grown = soon.curve.poles > 0;
    search_spans(reference, options, grown, fit);
    if (grown)
        keep_fewer(fit, &soon);
}

void splinefit_again(const struct reference *reference, const struct splinefit_options *options,
                     const struct splinefit *before, struct splinefit *fit)
{
    struct search s = search_new(reference, options, false);

    bool found = true;

    if (is_hurried(options))
        fit_hurried(&s, &before->curve, fit);
    else if (before->kind == SPLINEFIT_GROWN)
        found = fit_grown_knots(&s, &before->curve, fit);
    else
        found = fit_free_knots(&s, 0, &before->curve, fit);
    if (found)
        set_paper_error(&s, fit);
    else
        splinefit_search(reference, options, fit);
    search_free(&s);
}

void splinefit_through(const struct reference *reference, const struct reference *whole,
                       const struct splinefit_options *options, enum spline_ends ends,
                       struct splinefit *fit)
{
    const struct deviation within = {options->tolerance, options->tolerance, options->angle};

    *fit = (struct splinefit){.curve = spline_through(reference, ends), .kind = SPLINEFIT_THROUGH};
    bool printed = spline_bound_print(&fit->curve, whole);
    spline_bound_measure(&fit->curve, whole, options->tolerance * SPLINE_RESOLUTION, INFINITY,
                         &fit->proof);
    fit->within = printed && deviation_within(&fit->proof, &within);
    fit->deviation = fit_error_of(&fit->curve, fit->curve.pole, reference->point,
                                  fit->curve.knot + 3, reference->n);
}
