/* post_spline - see post_spline.h. */
#include "post_spline.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"
#include "curve/cubic_form.h"
#include "machine/rotary_spline.h"

/* ---- a B-spline as polynomials */

enum { SAMPLES = 8, FACTORS = NC_POLY_DEGREE - 1 };
static const double cubic_most = 20; /* PL above this would cost digits of the factors */
static const double other_most = 1;  /* with powers up to the fifth this would */
static const double factor_most = 1e9;

/* The polynomial's value at p, its factor of p taken from both ends. */
static struct vec3 span_at(struct vec3 start, struct vec3 end, const struct vec3 factor[FACTORS],
                           double h, double p)
{
    double most = h, power = p;
    struct vec3 slope = vec_sub(end, start), at = start;
    for (int i = 0; i < FACTORS; i++) {
        most *= h;
        power *= p;
        slope = vec_along(slope, -most, factor[i]);
        at = vec_along(at, power, factor[i]);
    }
    return vec_along(at, p / h, slope);
}

static void taylor_factors(const struct bspline *b, const struct vec3 *pole, double u, double scale,
                           int digits, struct vec3 factor[FACTORS])
{
    struct vec3 d[NC_POLY_DEGREE + 1];
    double share = scale;
    bspline_derivatives(b, pole, u, NC_POLY_DEGREE, d);
    for (int i = 0; i < FACTORS; i++) {
        share *= scale / (i + 2);
        factor[i] = vec_round(vec_scale(share, d[i + 2]), digits);
    }
}

static struct nc_span span_words(const struct bspline *b, size_t i, int digits)
{
    double u = b->knot[i], end = b->knot[i + 1];
    double most = b->degree > 3 ? other_most : cubic_most;
    struct nc_span s = {.h = num_round(fmin(end - u, most), 6)};
    s.digits = b->degree > 3 ? 7 : s.h > 10 ? 9 : s.h > 1 ? 8 : 6;
    if (s.h <= 0)
        return s;
    taylor_factors(b, b->pole, u, (end - u) / s.h, s.digits, s.factor);
    s.end = vec_round(bspline_at(b, b->pole, end), digits);
    if (b->head) {
        taylor_factors(b, b->head, u, (end - u) / s.h, s.digits, s.head_factor);
        s.head_end = vec_round(bspline_at(b, b->head, end), digits);
    }
    return s;
}

/* On a span as short as its printed digits, factors have more digits than a control reads. */
static bool is_readable(const struct nc_span *s)
{
    for (int i = 0; i < FACTORS; i++)
        if (!(vec_length(s->factor[i]) < factor_most &&
              vec_length(s->head_factor[i]) < factor_most))
            return false;
    return s->h > 0;
}

bool nc_poly_words(struct nc_spans *spans, const struct bspline *b, int digits)
{
    for (size_t i = (size_t)b->degree; i < b->poles; i++)
        if (b->knot[i + 1] > b->knot[i]) {
            struct nc_span s = span_words(b, i, digits);
            if (!is_readable(&s))
                return false;
            *array_push(spans) = s;
        }
    return true;
}

/* PO[XH]=(end,a2,...) and the blank before it, for X, Y and Z. */
static size_t words_width(struct vec3 end, const struct vec3 *factor, int n, int end_digits,
                          int digits)
{
    char word[NUM_MAX];
    size_t sum = 3 * strlen(" PO[XH]=()");
    const double to[] = {end.x, end.y, end.z};
    for (int k = 0; k < 3; k++) {
        sum += num_write_short(word, to[k], end_digits, false);
        for (int i = 0; i < n; i++) {
            const double f[] = {factor[i].x, factor[i].y, factor[i].z};
            sum += 1 + num_write_short(word, f[k], digits, false);
        }
    }
    return sum;
}

size_t nc_poly_width(const struct nc_spans *spans, int degree, bool turns, int digits)
{
    size_t most = 0;
    int factors = nc_poly_factors(degree);
    for (size_t i = 0; i < spans->n; i++) {
        const struct nc_span *s = &spans->item[i];
        size_t n = words_width(s->end, s->factor, factors, digits, s->digits);
        if (turns)
            n += words_width(s->head_end, s->head_factor, factors, digits, s->digits);
        most = n > most ? n : most;
    }
    return most;
}

struct pose_deviation nc_poly_deviation(const struct nc_spans *spans, const struct bspline *b,
                                        const struct interpolation *f, struct vec3 start,
                                        struct vec3 head, const struct motion *motion,
                                        struct pose_deviation allowed, struct doubles *more)
{
    struct pose_deviation worst = {0, 0};
    double from = b->knot[0], range = b->knot[b->poles] - from;
    size_t knot = (size_t)b->degree;
    for (size_t i = 0; i < spans->n; i++, knot++) {
        const struct nc_span *n = &spans->item[i];
        struct pose_deviation d[SAMPLES + 1];
        while (b->knot[knot + 1] <= b->knot[knot])
            knot++;
        double u = b->knot[knot], h = b->knot[knot + 1] - u;
        for (int k = 0; k <= SAMPLES; k++) {
            double p = n->h * k / SAMPLES;
            struct pose wanted = motion_at(motion, (u + h * k / SAMPLES - from) / range);
            struct pose at = {span_at(start, n->end, n->factor, n->h, p), wanted.a};
            if (b->head)
                at.a = vec_unit(vec_sub(span_at(head, n->head_end, n->head_factor, n->h, p), at.p));
            d[k] = interpolation_difference(f, at, wanted);
        }
        struct pose_deviation here = interpolation_peak(d, SAMPLES + 1);
        if (!pose_deviation_within(here, allowed))
            *array_push(more) = u + h / 2;
        worst = pose_deviation_worst(worst, here);
        start = n->end;
        head = n->head_end;
    }
    return worst;
}

/* ---- a B-spline as the words of its blocks */

enum { ROUNDS_MAX = 6, CUBIC = 3 };
static const double WOBBLE = 0.5; /* degrees that an axis may go to and fro on a curve */

void nc_spline_free(struct nc_spline *spline)
{
    bspline_free(&spline->curve);
    for (int i = 0; i < ROTARY_MAX; i++)
        free(spline->angle[i]);
    array_free(&spline->span);
    *spline = (struct nc_spline){0};
}

/* ---- the curve as the control can be given it ---- */

/* The knots of a cubic beside a curve of higher degree, half a span at a time. */
struct beside {
    struct bspline curve; /* the curve itself where its degree will do */
    bool lowered;
    struct doubles knots; /* more than its own */
};

static struct beside curve_beside(const struct bspline *b, int degree)
{
    struct beside c = {.lowered = b->degree > degree};
    c.curve = c.lowered ? cubic_form(b, NULL, 0) : bspline_copy(b);
    return c;
}

static void beside_free(struct beside *c)
{
    bspline_free(&c->curve);
    array_free(&c->knots);
}

/* Knots more; the curve itself stays as it is. */
static void beside_refine(struct beside *c, const struct bspline *b, const struct doubles *more)
{
    for (size_t i = 0; i < more->n; i++)
        if (c->lowered)
            *array_push(&c->knots) = more->item[i];
        else
            bspline_insert(&c->curve, more->item[i]);
    if (!c->lowered)
        return;
    bspline_free(&c->curve);
    c->curve = cubic_form(b, c->knots.item, c->knots.n);
}

/* ---- polynomials ---- */

/* By polynomials of such a degree at most. */
static struct pose_deviation poly_words(struct nc_spline *spline, int degree, int digits,
                                        const struct interpolation *f,
                                        const struct block_pose *from, const struct motion *motion,
                                        struct pose_deviation allowed)
{
    const struct bspline *b = motion->curve;
    struct beside c = curve_beside(b, degree);
    struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
    spline->form = NC_POLY;
    for (int round = 0; round < ROUNDS_MAX; round++) {
        struct doubles more = {0};
        spline->span.n = 0;
        spline->degree = c.curve.degree;
        if (!nc_poly_words(&spline->span, &c.curve, digits) ||
            nc_poly_width(&spline->span, c.curve.degree, spline->turns, digits) > NC_POLY_WIDTH) {
            d = (struct pose_deviation){HUGE_VAL, HUGE_VAL};
            break;
        }
        d = nc_poly_deviation(&spline->span, &c.curve, f, from->p, spline->head_start, motion,
                              allowed, &more);
        bool enough = more.n == 0 || !c.lowered;
        if (!enough)
            beside_refine(&c, b, &more);
        array_free(&more);
        if (enough)
            break;
    }
    beside_free(&c);
    return d;
}

/* ---- poles ---- */

/* Poles as printed; the first one is where the tool is, in the very digits that brought it there.
 */
static void round_poles(struct bspline *b, int digits, const struct block_pose *from)
{
    for (size_t i = 0; i < b->poles; i++) {
        b->pole[i] = vec_round(b->pole[i], digits);
        if (b->head)
            b->head[i] = vec_round(b->head[i], digits);
    }
    b->pole[0] = from->p;
}

/* A uniform clamped cubic by its poles alone: the control takes spans of length 1. */
static struct pose_deviation bspline_words(struct nc_spline *spline, int digits,
                                           const struct interpolation *f,
                                           const struct block_pose *from,
                                           const struct motion *motion)
{
    struct pose_deviation worst = {0, 0};
    spline->form = NC_BSPLINE;
    spline->curve = bspline_copy(motion->curve);
    struct bspline *b = &spline->curve;
    size_t p = (size_t)b->degree;
    round_poles(b, digits, from);
    for (size_t i = 0; i < b->poles + p + 1; i++)
        b->knot[i] = i < p ? 0 : i > b->poles ? (double)(b->poles - p) : (double)(i - p);
    struct motion printed = motion_spline(motion->from, motion->to, b);
    for (size_t span = 0; span < b->poles - p; span++) {
        struct pose_deviation d[SAMPLES + 1];
        for (int k = 0; k <= SAMPLES; k++) {
            double s = (double)(span * SAMPLES + (size_t)k) / (double)((b->poles - p) * SAMPLES);
            d[k] = interpolation_difference(f, motion_at(&printed, s), motion_at(motion, s));
        }
        worst = pose_deviation_worst(worst, interpolation_peak(d, SAMPLES + 1));
    }
    return worst;
}

/* ---- NURBS with rotary words ---- */

/* Knots so that the shortest span is 1 or more, rounded. */
static void scale_knots(struct bspline *b, int digits)
{
    double from = b->knot[0], least = b->knot[b->poles] - from;
    size_t knots = b->poles + (size_t)b->degree + 1;
    for (size_t i = (size_t)b->degree; i < b->poles; i++)
        if (b->knot[i + 1] > b->knot[i])
            least = fmin(least, b->knot[i + 1] - b->knot[i]);
    double scale = fmax(1, 1 / least);
    for (size_t i = 0; i < knots; i++)
        b->knot[i] = num_round(scale * (b->knot[i] - from), digits);
}

static struct vec3 angles_at(const struct bspline *b, double *const angle[], size_t span,
                             const double *basis)
{
    double q[3] = {0, 0, 0};
    for (int k = 0; k < ROTARY_MAX; k++)
        for (int i = 0; i <= b->degree; i++)
            q[k] += basis[i] * RADIANS(angle[k][span - (size_t)b->degree + (size_t)i]);
    return vec(q[0], q[1], q[2]);
}

/*
 * The printed NURBS against the motion; `exact` has the knots not yet scaled and rounded.  Each
 * span that is beyond `allowed` adds its middle to `more`.
 */
static struct pose_deviation nurbs_deviation(const struct nc_spline *spline,
                                             const struct interpolation *f,
                                             const struct bspline *exact,
                                             const struct motion *motion,
                                             struct pose_deviation allowed, struct doubles *more)
{
    const struct bspline *b = &spline->curve;
    struct pose_deviation worst = {0, 0};
    double start = exact->knot[0], range = exact->knot[exact->poles] - start;
    for (size_t span = (size_t)b->degree; span < b->poles; span++) {
        struct pose_deviation d[SAMPLES + 1] = {{0, 0}};
        double u = exact->knot[span], h = exact->knot[span + 1] - u;
        double v = b->knot[span], g = b->knot[span + 1] - v;
        for (int k = 0; h > 0 && k <= SAMPLES; k++) {
            double basis[BSPLINE_DEGREE_MAX + 1];
            bspline_basis(b->degree, b->knot, span, v + g * k / SAMPLES, basis);
            struct pose wanted = motion_at(motion, (u + h * k / SAMPLES - start) / range),
                        at = wanted;
            at.p = vec(0, 0, 0);
            for (int i = 0; i <= b->degree; i++)
                at.p = vec_along(at.p, basis[i], b->pole[span - (size_t)b->degree + (size_t)i]);
            struct vec3 q = angles_at(b, spline->angle, span, basis);
            at.a = chain_axis(f->chain, (const double[]){q.x, q.y});
            d[k] = interpolation_difference(f, at, wanted);
        }
        struct pose_deviation here = interpolation_peak(d, SAMPLES + 1);
        if (!pose_deviation_within(here, allowed))
            *array_push(more) = u + h / 2;
        worst = pose_deviation_worst(worst, here);
    }
    return worst;
}

/* One round: angles fitted on the knots of `exact`, everything rounded as printed. */
static int nurbs_round(struct nc_spline *spline, struct nc_spline_digits digits,
                       const struct interpolation *f, const struct block_pose *from,
                       const struct bspline *exact, const struct motion *motion)
{
    struct motion same = motion_spline(motion->from, motion->to, exact);
    int over;
    nc_spline_free(spline);
    spline->form = NC_NURBS;
    spline->turns = exact->head != NULL;
    spline->curve = bspline_copy(exact);
    for (int k = 0; k < ROTARY_MAX; k++)
        spline->angle[k] = mem_alloc(exact->poles, sizeof(double));
    if (rotary_spline_fit(f->chain, &same, from->q, spline->angle, &over) != 0)
        return -1;
    for (int k = 0; k < ROTARY_MAX; k++)
        for (size_t i = 0; i < exact->poles; i++)
            spline->angle[k][i] = num_round(DEGREES(spline->angle[k][i]), digits.angle);
    round_poles(&spline->curve, digits.linear, from);
    scale_knots(&spline->curve, digits.knot);
    return 0;
}

/* Is an axis that is at `at` at even steps within its travel, between them too?  Its farthest place
 * is that of a parabola through the steps about it. */
static bool is_in_travel(const double *at, int n, const struct rotary *axis)
{
    const double printed = RADIANS(0.0005);
    for (int k = 0; k < n; k++) {
        double most = at[k], least = at[k];
        if (k > 0 && k + 1 < n) {
            double slope = (at[k + 1] - at[k - 1]) / 2, bend = at[k + 1] - 2 * at[k] + at[k - 1];
            double peak =
                fabs(slope) <= fabs(bend) && bend != 0 ? at[k] - slope * slope / bend / 2 : at[k];
            most = fmax(most, peak);
            least = fmin(least, peak);
        }
        if (least < axis->min - printed || most > axis->max + printed)
            return false;
    }
    return true;
}

/* Do the rotary axes stay within their travel between the ends, too?  Beside the pole their poles
 * may be far from the curve, and that from both its ends. */
static bool nurbs_in_travel(const struct nc_spline *spline, const struct kinematic_chain *chain)
{
    enum { PLACES = 16 }; /* in a span */
    const struct bspline *b = &spline->curve;
    for (size_t span = (size_t)b->degree; span < b->poles; span++) {
        double u = b->knot[span], h = b->knot[span + 1] - u, q[2][PLACES + 1];
        for (int k = 0; k <= PLACES; k++) {
            double basis[BSPLINE_DEGREE_MAX + 1];
            bspline_basis(b->degree, b->knot, span, u + h * k / PLACES, basis);
            struct vec3 at = angles_at(b, spline->angle, span, basis);
            q[0][k] = at.x;
            q[1][k] = at.y;
        }
        for (int i = 0; h > 0 && i < chain->n && i < 2; i++)
            if (!is_in_travel(q[i], PLACES + 1, &chain->rotary[i]))
                return false;
    }
    return true;
}

/* How much further an axis goes by its poles than from the first to the last of them. */
static double wobble_of(const double *angle, size_t poles)
{
    double way = 0;
    for (size_t i = 1; i < poles; i++)
        way += fabs(angle[i] - angle[i - 1]);
    return way - fabs(angle[poles - 1] - angle[0]);
}

/* The poles of an angle that is linear on the knots of the curve. */
static void set_linear(const struct bspline *b, int digits, double *angle)
{
    size_t p = (size_t)b->degree, last = b->poles - 1;
    double from = angle[0], turn = angle[last] - from, range = b->knot[b->poles] - b->knot[0];
    for (size_t i = 1; i < last; i++) {
        double place = 0;
        for (size_t k = 1; k <= p; k++)
            place += (b->knot[i + k] - b->knot[0]) / (double)p;
        angle[i] = num_round(from + turn * place / range, digits);
    }
}

/* Axes that go to and fro beside the pole, where their turn hardly tells in the tool axis, go
 * straight from end to end if that keeps what is `allowed`. */
static void calm_angles(struct nc_spline *spline, int digits, const struct interpolation *f,
                        const struct bspline *exact, const struct motion *motion,
                        struct pose_deviation allowed, struct pose_deviation *d)
{
    size_t poles = spline->curve.poles;
    struct doubles more = {0};
    for (int k = 0; k < ROTARY_MAX; k++) {
        if (wobble_of(spline->angle[k], poles) < WOBBLE)
            continue;
        double *was = spline->angle[k];
        spline->angle[k] = mem_alloc(poles, sizeof *was);
        memcpy(spline->angle[k], was, poles * sizeof *was);
        set_linear(&spline->curve, digits, spline->angle[k]);
        struct pose_deviation calm = nurbs_deviation(spline, f, exact, motion, allowed, &more);
        bool good = pose_deviation_within(calm, allowed);
        if (good)
            *d = calm;
        free(good ? was : spline->angle[k]);
        spline->angle[k] = good ? spline->angle[k] : was;
    }
    array_free(&more);
}

static struct pose_deviation nurbs_words(struct nc_spline *spline, struct nc_spline_digits digits,
                                         const struct interpolation *f,
                                         const struct block_pose *from, const struct motion *motion,
                                         struct pose_deviation allowed)
{
    struct beside c = curve_beside(motion->curve, CUBIC);
    struct pose_deviation d = {HUGE_VAL, HUGE_VAL};
    for (int round = 0; round < ROUNDS_MAX; round++) {
        struct doubles more = {0};
        if (nurbs_round(spline, digits, f, from, &c.curve, motion) != 0) {
            d = (struct pose_deviation){HUGE_VAL, HUGE_VAL};
            break;
        }
        d = nurbs_deviation(spline, f, &c.curve, motion, allowed, &more);
        bool enough = more.n == 0 || c.curve.poles > 4 * motion->curve->poles + 20;
        if (enough && pose_deviation_within(d, allowed))
            calm_angles(spline, digits.angle, f, &c.curve, motion, allowed, &d);
        if (!enough)
            beside_refine(&c, motion->curve, &more);
        array_free(&more);
        if (enough)
            break;
    }
    beside_free(&c);
    if (pose_deviation_within(d, allowed) && !nurbs_in_travel(spline, f->chain))
        d = (struct pose_deviation){HUGE_VAL, HUGE_VAL};
    return d;
}

static struct block_pose end_pose(const struct nc_spline *spline, const struct motion *motion)
{
    struct block_pose to = {.p = spline->form == NC_POLY
                                     ? spline->span.item[spline->span.n - 1].end
                                     : spline->curve.pole[spline->curve.poles - 1],
                            .a = motion_at(motion, 1).a};
    for (int k = 0; spline->form == NC_NURBS && k < ROTARY_MAX; k++)
        to.q[k] = RADIANS(spline->angle[k][spline->curve.poles - 1]);
    return to;
}

bool nc_spline_words(struct nc_spline *spline, enum nc_splines kind, struct nc_spline_digits digits,
                     const struct interpolation *f, const struct block_pose *from,
                     const struct motion *motion, struct pose_deviation allowed,
                     struct block_pose *to, struct pose_deviation *d)
{
    const struct bspline *b = motion->curve;
    *spline = (struct nc_spline){0};
    if (kind == NC_SPLINES_NONE || b->degree < 2)
        return false;
    if (!b->head && vec_angle(motion->from.a, motion->to.a) > 1e-8)
        return false;
    *d = (struct pose_deviation){HUGE_VAL, HUGE_VAL};
    if (kind == NC_SPLINES_ROTARY) {
        *d = nurbs_words(spline, digits, f, from, motion, allowed);
    } else {
        spline->turns = b->head != NULL;
        if (b->head)
            spline->head_start = vec_round(b->head[0], digits.linear);
        if (b->degree == 3 && bspline_uniform(b))
            *d = bspline_words(spline, digits.linear, f, from, motion);
        if (!pose_deviation_within(*d, allowed)) {
            bspline_free(&spline->curve);
            *d = poly_words(spline, NC_POLY_DEGREE, digits.linear, f, from, motion, allowed);
        }
        if (!pose_deviation_within(*d, allowed) && b->degree > CUBIC)
            *d = poly_words(spline, CUBIC, digits.linear, f, from, motion, allowed);
    }
    if (!pose_deviation_within(*d, allowed)) {
        nc_spline_free(spline);
        return false;
    }
    *to = end_pose(spline, motion);
    return true;
}

/* ---- the curve as it will be read */

static struct pose poly_at(const struct nc_spline *spline, struct vec3 start, double s)
{
    size_t n = spline->span.n, i = (size_t)fmin(fmax(0, s * (double)n + 1e-9), (double)(n - 1));
    const struct nc_span *span = &spline->span.item[i];
    double p = span->h * fmax(0, s * (double)n - (double)i);
    struct vec3 head = i > 0 ? span[-1].head_end : spline->head_start;
    struct vec3 tip = span_at(i > 0 ? span[-1].end : start, span->end, span->factor, span->h, p);
    head = span_at(head, span->head_end, span->head_factor, span->h, p);
    return (struct pose){tip, vec_unit(vec_sub(head, tip))};
}

struct pose nc_spline_at(const struct nc_spline *spline, struct vec3 start, double s)
{
    const struct bspline *b = &spline->curve;
    if (spline->form == NC_POLY)
        return poly_at(spline, start, s);
    double from = b->knot[b->degree], u = from + s * (b->knot[b->poles] - from);
    struct vec3 tip = bspline_at(b, b->pole, u);
    return (struct pose){tip, vec_unit(vec_sub(bspline_at(b, b->head, u), tip))};
}

double nc_spline_next(const struct nc_spline *spline, double s)
{
    double n = (double)spline->span.n;
    if (spline->form == NC_POLY)
        return fmin(1, (floor(s * n + 1e-6) + 1) / n);
    const struct motion printed = motion_spline((struct pose){0}, (struct pose){0}, &spline->curve);
    return motion_next_knot(&printed, s);
}
