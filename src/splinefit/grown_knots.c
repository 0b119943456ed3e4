/* grown_knots - see grown_knots.h. */
#include "grown_knots.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "grown_fit.h"
#include "knots_init.h"
#include "spline_bound.h"
#include "spline_lsq.h"
#include "splinefit/splinefit.h"

enum {
    POINTS_PER_SPAN = 32, /* to begin with */
    ROUNDS = 32,          /* of divisions, at most */
    PASSES = 40,          /* of knots taken out, at most */
    PROOFS = 4,
    PLACES = 4,  /* for a point, where the points alone do not do, ... */
    MORE = 6,    /* ... and where these do not either */
    APART = 4,   /* knots between two that are taken out at once */
    BESIDE = 8,  /* knots from where the data has moved to those that it has nothing to do with */
    SETTLE = 3,  /* times that some of those are put back */
    QUARTER = 4, /* parts that a span far off is divided into */
};

static const double FAR_OFF = 16;    /* tolerances: halves would not do (degree 3) */
static const double GOAL = 0.975;    /* of the tolerance, at the points and between them */
static const double CLOSER = 0.98;   /* of that, when the proof finds more */
static const double HOPELESS = 4;    /* times the tolerance, by the proof */
static const double SHORTEST = 1.05; /* of the least length, for a span before it is printed */
/* mm of the reference: no span is made shorter, if there is a least length; 0.02 are left of that
 * on a curve that cuts corners. */
static const double FLOOR = 0.023;
static const double LOWER = 0.7; /* of that length, each time that it does not do */

struct inner_knot {
    double u;
    bool stays, out; /* it was missed when it was taken out; it is out now */
    bool kept;       /* it was missed in the curve before, and nothing has moved near it */
};

struct inner_knots {
    size_t n, cap;
    struct inner_knot *item;
};

struct growth {
    const struct reference *whole;     /* what the curve is proven by */
    const struct reference *reference; /* what it is fitted to: the same, or places on it */
    const struct free_knots_options *options;
    struct vec3 *head; /* of the points; NULL: the axis is fixed */
    struct inner_knots inner;
    struct doubles in;    /* those that are not out */
    struct grown_fit fit; /* with these */
    double goal;          /* for how far it is off */
};

/* Fits the curve and measures its spans, beyond `enough` no more than that they are; the largest
 * figure, or infinite without a curve. */
static double fit_curve(struct growth *g, double enough)
{
    g->in.n = 0;
    for (size_t i = 0; i < g->inner.n; i++)
        if (!g->inner.item[i].out)
            *array_push(&g->in) = g->inner.item[i].u;
    return grown_fit_knots(&g->fit, g->in.item, g->in.n, enough);
}

/* ---- more knots */

static void add_knot(struct inner_knots *knots, double u)
{
    *array_push(knots) = (struct inner_knot){.u = u};
}

/* Parts for a span that holds so many points; none shorter than `floor`. */
static size_t parts_of(const struct growth *g, double floor, double worst, double length,
                       size_t points)
{
    size_t parts = worst <= g->goal ? 1 : worst > FAR_OFF ? QUARTER : 2;

    parts = parts > points ? points : parts;
    while (parts > 2 && length < (double)parts * SHORTEST * g->options->least)
        parts--;
    if (length < (double)parts * floor)
        parts = 1;
    return parts > 1 ? parts : 1;
}

/* Divides the spans that are too far off, none shorter than `floor` on a mean of its parts, which
 * have as many points, and none of these shorter than is bearable; false if there is
 * none that can be. */
static bool divide_spans(struct growth *g, double floor)
{
    const struct reference *t = g->reference;
    size_t degree = (size_t)g->options->degree, spans = g->fit.curve.poles - degree, k = 0;
    double least = g->options->least > 0 ? FLOOR : 0;
    struct inner_knots more = {0};

    for (size_t s = 0; s < spans; s++) {
        double from = g->fit.curve.knot[degree + s], to = g->fit.curve.knot[degree + s + 1];
        double last = from;
        size_t first = k;
        while (k < t->n && t->length[k] < to)
            k++;
        size_t parts = parts_of(g, floor, g->fit.off[s], to - from, k - first);
        for (size_t i = 1; i < parts; i++) {
            size_t at = first + i * (k - first) / parts;
            double u = at > first ? (t->length[at - 1] + t->length[at]) / 2 : from;
            if (least > 0 && to - last >= 2 * least) /* points may lie anywhere in it */
                u = fmin(fmax(u, last + least), to - least);
            if (u > last && (least == 0 || fmin(u - last, to - u) >= 0.999 * least)) {
                add_knot(&more, u);
                last = u;
            }
        }
        if (s + 1 < spans) {
            bool kept = g->inner.item[s].kept;
            *array_push(&more) = (struct inner_knot){.u = to, .stays = kept, .kept = kept};
        }
    }
    bool done = more.n > g->inner.n;
    array_free(&g->inner);
    g->inner = more;
    return done;
}

/* The spans beside those that are too far off are so, too. */
static void spread_worst(struct growth *g)
{
    size_t spans = g->fit.curve.poles - (size_t)g->options->degree;
    double before = 0;

    for (size_t s = 0; s < spans; s++) {
        double here = g->fit.off[s], after = s + 1 < spans ? g->fit.off[s + 1] : 0;
        g->fit.off[s] = fmax(here, fmax(before, after));
        before = here;
    }
}

/* The same with spans as long as asked for if that does; else shorter, at last as short as is
 * bearable. */
static bool divide_spans_soon(struct growth *g)
{
    double floor = SHORTEST * g->options->least;

    for (; floor > FLOOR; floor *= LOWER)
        if (divide_spans(g, floor))
            return true;
    return divide_spans(g, g->options->least > 0 ? FLOOR : 0);
}

/* A curve with so many inner knots has fewer poles than there are points. */
static bool has_room(const struct growth *g, size_t inner)
{
    return inner + (size_t)g->options->degree + 1 < g->whole->n;
}

/* Until the curve is near enough everywhere. */
static bool grow(struct growth *g)
{
    for (int i = 0; i < ROUNDS && has_room(g, g->inner.n); i++) {
        double worst = fit_curve(g, INFINITY);
        if (worst <= g->goal)
            return true;
        if (!isfinite(worst))
            return false;
        if (divide_spans_soon(g))
            continue;
        spread_worst(g);
        if (!divide_spans_soon(g))
            return false;
    }
    return false;
}

/* ---- fewer knots */

struct weight {
    double missed;
    size_t knot;
};

static int by_weight(const void *a, const void *b)
{
    const struct weight *v = a, *w = b;

    if (v->missed != w->missed)
        return v->missed < w->missed ? -1 : 1;
    return v->knot < w->knot ? -1 : v->knot > w->knot;
}

/* Takes out knots that are missed least, none near to another; returns how many. */
static size_t take_out(struct growth *g)
{
    size_t n = g->inner.n, first = (size_t)g->options->degree + 1, taken = 0;
    struct weight *weight = mem_alloc(n + 1, sizeof *weight);
    double *missed = mem_alloc(n + 1, sizeof *missed);

    knots_init_missed(&g->fit.curve, missed);
    for (size_t i = 0; i < n; i++) {
        const double *knot = &g->fit.curve.knot[first + i];
        bool close = fmin(knot[0] - knot[-1], knot[1] - knot[0]) < SHORTEST * g->options->least;
        weight[i] = (struct weight){close ? 0 : missed[i], i};
    }
    qsort(weight, n, sizeof *weight, by_weight);
    for (size_t w = 0; w < n; w++) {
        size_t i = weight[w].knot, from = i > APART ? i - APART : 0;
        bool apart = !g->inner.item[i].stays;
        for (size_t k = from; k < n && k <= i + APART; k++)
            apart = apart && !g->inner.item[k].out;
        if (apart) {
            g->inner.item[i].out = true;
            taken++;
        }
    }
    free(weight);
    free(missed);
    return taken;
}

/* Puts a knot back for good where the curve is too far off beside it; returns how many.  `all`:
 * every one that is out. */
static size_t put_back(struct growth *g, bool all)
{
    size_t degree = (size_t)g->options->degree, spans = g->fit.curve.poles - degree, span = 0,
           n = 0;

    for (size_t i = 0; i < g->inner.n; i++) {
        struct inner_knot *knot = &g->inner.item[i];
        while (span + 1 < spans && g->fit.curve.knot[degree + span + 1] <= knot->u)
            span++;
        if (!knot->out)
            continue;
        double worst = g->fit.off[span];
        for (size_t s = span > 1 ? span - 2 : 0; s < spans && s <= span + 2; s++)
            worst = fmax(worst, g->fit.off[s]);
        if (all || worst > g->goal) {
            knot->out = false;
            knot->stays = true;
            n++;
        }
    }
    return n;
}

static void forget_out(struct growth *g)
{
    size_t n = 0;

    for (size_t i = 0; i < g->inner.n; i++)
        if (!g->inner.item[i].out)
            g->inner.item[n++] = g->inner.item[i];
    g->inner.n = n;
}

/* As long as the curve can do without some of them. */
static void thin_out(struct growth *g)
{
    for (int pass = 0; pass < PASSES && take_out(g) > 0; pass++) {
        double worst = fit_curve(g, g->goal);
        for (int i = 0; i < SETTLE && worst > g->goal && put_back(g, false) > 0; i++)
            worst = fit_curve(g, g->goal);
        if (worst > g->goal) {
            put_back(g, true);
            fit_curve(g, g->goal);
        }
        forget_out(g);
    }
}

/* ---- proven */

/* The curve on its printed digits; how much of the tolerance it takes, infinite: it does not serve
 * at all. */
static double prove(const struct growth *g, struct free_knots_result *found)
{
    const struct free_knots_options *o = g->options;
    double tolerance = o->tolerance;

    found->curve = bspline_copy(&g->fit.curve);
    if (!spline_bound_print(&found->curve, g->whole))
        return INFINITY;
    spline_bound_measure(&found->curve, g->whole, SPLINE_RESOLUTION_GROWN * tolerance,
                         HOPELESS * tolerance, &found->proof);
    const struct deviation *p = &found->proof;
    return fmax(fmax(p->point, p->other) / tolerance, p->axis / o->angle);
}

/* Keeps the knots of the curve before but for those near to what has moved. */
static void keep_knots(struct growth *g, const struct doubles *moved)
{
    size_t n = g->inner.n, done = 0;
    double length = g->reference->length[g->reference->n - 1];

    for (size_t i = 0; i < n; i++)
        g->inner.item[i].stays = g->inner.item[i].kept = true;
    for (size_t k = 0; k + 1 < moved->n; k += 2) {
        double from = moved->item[k] * length, to = moved->item[k + 1] * length;
        while (done < n && g->inner.item[done].u < from)
            done++;
        size_t first = done > BESIDE ? done - BESIDE : 0, last = done;
        while (last < n && g->inner.item[last].u <= to)
            last++;
        for (size_t i = first; i < n && i < last + BESIDE; i++)
            g->inner.item[i].stays = g->inner.item[i].kept = false;
    }
}

/* Begins with the knots of the curve before. */
static void begin_again(struct growth *g, const struct bspline *before)
{
    const struct reference *t = g->reference;
    double length = t->length[t->n - 1], last = 0;

    for (size_t j = (size_t)before->degree + 1; j < before->poles; j++) {
        double u = before->knot[j] * length / before->knot[before->poles];
        if (u > last && u < length)
            add_knot(&g->inner, u);
        last = u;
    }
    if (g->options->moved)
        keep_knots(g, g->options->moved);
}

/* Begins with knots evenly among the points. */
static void begin_evenly(struct growth *g)
{
    const struct reference *t = g->reference;
    double last = 0;

    for (size_t k = POINTS_PER_SPAN; k + POINTS_PER_SPAN / 2 < t->n; k += POINTS_PER_SPAN)
        if ((t->length[k] + t->length[k - 1]) / 2 >= SHORTEST * g->options->least + last) {
            last = (t->length[k] + t->length[k - 1]) / 2;
            add_knot(&g->inner, last);
        }
}

/* Begins with those of a growth that came no further, where these leave room for more. */
static void begin_where_stuck(struct growth *g, const struct inner_knots *stuck)
{
    if (!has_room(g, stuck->n)) {
        begin_evenly(g);
        return;
    }
    double length = g->reference->length[g->reference->n - 1];
    double scale = length / g->whole->length[g->whole->n - 1];

    for (size_t i = 0; i < stuck->n; i++)
        add_knot(&g->inner, scale * stuck->item[i].u);
}

/* What growths on other places have in common: as in struct growth. */
struct growth_start {
    const struct reference *whole;
    const struct free_knots_options *options;
    bool between;
};

static struct growth growth_new(const struct growth_start *start, const struct reference *places)
{
    const struct free_knots_options *o = start->options;
    struct growth g = {.whole = start->whole, .reference = places, .options = o, .goal = GOAL};

    g.head = places->turns ? spline_heads(places) : NULL;
    g.fit = grown_fit_new(places, g.head, o->degree);
    g.fit.tolerance = o->tolerance;
    g.fit.angle = o->angle;
    g.fit.between = start->between;
    return g;
}

static void growth_free(struct growth *g)
{
    free(g->head);
    grown_fit_free(&g->fit);
    array_free(&g->in);
    array_free(&g->inner);
}

/* The curve of a growth that has begun; without one *found is empty. */
static void grow_and_prove(struct growth *g, struct free_knots_result *found)
{
    *found = (struct free_knots_result){.cut = true};
    for (int i = 0; i < PROOFS && grow(g); i++) {
        thin_out(g);
        double taken = prove(g, found);
        if (taken <= 1)
            return;
        bspline_free(&found->curve);
        if (!(taken < HOPELESS))
            return;
        g->goal *= CLOSER / taken;
    }
}

/*
 * Fits `places` of the whole, the points themselves or places between them, too.  Begins with the
 * knots of the curve before; else with those that a growth came to no further, *stuck; else evenly.
 * False: it finds nothing; *stuck, where it had none, is what it came to.
 */
static bool fit_places(const struct growth_start *start, const struct reference *places,
                       const struct bspline *before, struct inner_knots *stuck,
                       struct free_knots_result *found)
{
    struct growth g = growth_new(start, places);

    if (before)
        begin_again(&g, before);
    else if (stuck->item)
        begin_where_stuck(&g, stuck);
    else
        begin_evenly(&g);
    grow_and_prove(&g, found);
    if (!stuck->item) {
        *stuck = g.inner;
        g.inner = (struct inner_knots){0};
    }
    growth_free(&g);
    return found->curve.poles > 0;
}

/* The points alone first, looked at between them; then more places than points, for knots may be
 * closer there: so close to each other that nobody need look between them, as a rule, for the proof
 * does. */
struct free_knots_result grown_knots_fit(const struct reference *reference,
                                         const struct free_knots_options *options,
                                         const struct bspline *before)
{
    struct growth_start start = {reference, options, true};
    struct inner_knots stuck = {0};
    struct free_knots_result found;

    bool done = fit_places(&start, reference, before, &stuck, &found);
    if (!done) {
        struct reference places = reference_sample(reference, PLACES * reference->n);
        start.between = false;
        done = (before && fit_places(&start, &places, before, &stuck, &found)) ||
               fit_places(&start, &places, NULL, &stuck, &found);
        reference_free(&places);
    }
    if (!done) {
        struct reference places = reference_sample(reference, MORE * reference->n);
        start.between = true;
        fit_places(&start, &places, NULL, &stuck, &found);
        reference_free(&places);
    }
    array_free(&stuck);
    return found;
}
