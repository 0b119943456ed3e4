/* grown_fit - see grown_fit.h. */
#include "grown_fit.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/band.h"
#include "spline_lsq.h"

static const double NEAR = 1e-5; /* of the tolerance: poles that have moved no farther stay */

/* ---- what is kept of a span: products of its basis functions, lower half, their products with
 * the places, its poles, and what it is off */

static size_t products_of(const struct bspline *curve)
{
    size_t order = (size_t)curve->degree + 1;

    return order * (order + 1) / 2;
}

static size_t columns_of(const struct bspline *curve)
{
    return curve->head ? 6 : 3;
}

static size_t vectors_of(const struct bspline *curve)
{
    return ((size_t)curve->degree + 1) * columns_of(curve);
}

static size_t size_of(const struct bspline *curve)
{
    return products_of(curve) + 2 * vectors_of(curve) + 1;
}

static double *poles_of(const struct bspline *curve, double *item)
{
    return item + products_of(curve) + vectors_of(curve);
}

static double *off_of(const struct bspline *curve, double *item)
{
    return item + size_of(curve) - 1;
}

static struct grown_spans spans_new(size_t spans, size_t size)
{
    return (struct grown_spans){0, mem_alloc(spans, sizeof(size_t)),
                                mem_alloc(spans * size, sizeof(double))};
}

static void spans_free(struct grown_spans *spans)
{
    free(spans->end);
    free(spans->item);
}

struct grown_fit grown_fit_new(const struct reference *reference, const struct vec3 *head,
                               int degree)
{
    struct bspline like = {.degree = degree, .head = head ? &(struct vec3){0, 0, 0} : NULL};
    size_t n = reference->n;

    return (struct grown_fit){.reference = reference,
                              .head = head,
                              .curve = {.degree = degree},
                              .off = mem_alloc(n + 1, sizeof(double)),
                              .known = spans_new(n + 1, size_of(&like)),
                              .next = spans_new(n + 1, size_of(&like)),
                              .basis = mem_alloc(2 * n * ((size_t)degree + 1), sizeof(double))};
}

void grown_fit_free(struct grown_fit *fit)
{
    bspline_free(&fit->curve);
    spans_free(&fit->known);
    spans_free(&fit->next);
    free(fit->off);
    free(fit->basis);
}

/* ---- items: even ones are places, odd ones the middles behind them */

static double place_of(const struct grown_fit *fit, size_t item)
{
    const double *length = &fit->reference->length[item / 2];

    return item % 2 ? (length[0] + length[1]) / 2 : length[0];
}

/* Behind the last item before the end of the span. */
static size_t end_of_span(const struct grown_fit *fit, size_t span, size_t from)
{
    size_t all = 2 * (fit->reference->n - 1), i = from;

    if (span + 1 == fit->curve.poles)
        return all;
    while (i < all && place_of(fit, i) < fit->curve.knot[span + 1])
        i++;
    return i;
}

static void set_basis(struct grown_fit *fit, size_t span, size_t from, size_t to)
{
    const struct bspline *curve = &fit->curve;
    size_t step = fit->between ? 1 : 2;

    for (size_t i = fit->between ? from : from + from % 2; i < to; i += step)
        bspline_basis(curve->degree, curve->knot, span, place_of(fit, i),
                      fit->basis + i * ((size_t)curve->degree + 1));
}

/* ---- sums of a span */

static void add_vector(const double *value, size_t order, size_t columns, struct vec3 p, double *at)
{
    for (size_t i = 0; i < order; i++) {
        at[i * columns] += value[i] * p.x;
        at[i * columns + 1] += value[i] * p.y;
        at[i * columns + 2] += value[i] * p.z;
    }
}

/* Of the places among the items, without the first and the last one: on these are the end poles. */
static void set_sums(const struct grown_fit *fit, size_t from, size_t to, double *item)
{
    const struct reference *t = fit->reference;
    size_t order = (size_t)fit->curve.degree + 1, columns = columns_of(&fit->curve);
    double *right = item + products_of(&fit->curve);

    memset(item, 0, size_of(&fit->curve) * sizeof *item);
    for (size_t k = from > 1 ? (from + 1) / 2 : 1; 2 * k < to; k++) {
        const double *value = fit->basis + 2 * k * order;
        double *at = item;
        for (size_t i = 0; i < order; i++)
            for (size_t j = 0; j <= i; j++)
                *at++ += value[i] * value[j];
        add_vector(value, order, columns, t->point[k], right);
        if (fit->head)
            add_vector(value, order, columns, fit->head[k], right + 3);
    }
    *off_of(&fit->curve, item) = INFINITY;
}

/* The span of the curve before that had the same knots about it, searched from number *at on;
 * NULL: none. */
static const double *same_span(const struct grown_fit *fit, const struct bspline *before,
                               size_t span, size_t *at)
{
    size_t degree = (size_t)fit->curve.degree;
    const double *knot = &fit->curve.knot[span + 1 - degree];

    while (*at < fit->known.n && before->knot[degree + *at] < fit->curve.knot[span])
        ++*at;
    if (*at >= fit->known.n || memcmp(&before->knot[*at + 1], knot, 2 * degree * sizeof *knot) != 0)
        return NULL;
    return fit->known.item + *at * size_of(&fit->curve);
}

/* The sums of all spans, those of the curve before where they are the same. */
static void set_spans(struct grown_fit *fit, const struct bspline *before)
{
    size_t degree = (size_t)fit->curve.degree, size = size_of(&fit->curve), at = 0, from = 0;

    for (size_t span = degree; span < fit->curve.poles; span++) {
        double *item = fit->next.item + (span - degree) * size;
        const double *same = same_span(fit, before, span, &at);
        size_t to = same ? fit->known.end[at] : end_of_span(fit, span, from);
        if (same) {
            memcpy(item, same, size * sizeof *item);
        } else {
            set_basis(fit, span, from, to);
            set_sums(fit, from, to, item);
        }
        fit->next.end[span - degree] = to;
        from = to;
    }
    fit->next.n = fit->curve.poles - degree;
    struct grown_spans known = fit->known;
    fit->known = fit->next;
    fit->next = known;
}

/* ---- the curve */

/* Adds a span to the equations of the inner poles; what the end poles give is known. */
static void add_span(const struct bspline *curve, size_t first, const double *item,
                     struct band *matrix, double *right)
{
    size_t order = (size_t)curve->degree + 1, columns = columns_of(curve), last = curve->poles - 1;
    const double *at = item, *sum = item + products_of(curve);

    for (size_t i = 0; i < order; i++)
        for (size_t j = 0; j <= i; j++, at++) {
            bool end = first + i == last, start = first + j == 0;
            if (!end && !start)
                *band_at(matrix, first + i - 1, first + j - 1) += *at;
            else if (end != start)
                for (size_t c = 0; c < columns; c++) {
                    const struct vec3 *known = c < 3 ? curve->pole : curve->head;
                    struct vec3 p = known[end ? last : 0];
                    double x = vec_coordinate(p, (int)(c % 3));
                    size_t row = end ? first + j : first + i;
                    if (row != 0 && row != last)
                        right[(row - 1) * columns + c] -= *at * x;
                }
        }
    for (size_t i = 0; i < order; i++)
        for (size_t c = 0; c < columns && first + i != 0 && first + i != last; c++)
            right[(first + i - 1) * columns + c] += sum[i * columns + c];
}

static void take_poles(const double *x, size_t columns, size_t inner, struct vec3 *pole)
{
    for (size_t i = 0; i < inner; i++)
        pole[i + 1] = vec(x[i * columns], x[i * columns + 1], x[i * columns + 2]);
}

/* False: the places do not determine the poles. */
static bool solve(struct grown_fit *fit)
{
    struct bspline *curve = &fit->curve;
    size_t inner = curve->poles - 2, degree = (size_t)curve->degree, columns = columns_of(curve);
    struct band matrix = band_new(inner, degree);
    double *right = mem_alloc(columns * inner + 1, sizeof *right);

    for (size_t s = 0; s + degree < curve->poles; s++)
        add_span(curve, s, fit->known.item + s * size_of(curve), &matrix, right);
    bool determined = band_factor(&matrix);
    if (determined) {
        band_solve(&matrix, right, columns);
        take_poles(right, columns, inner, curve->pole);
        if (curve->head)
            take_poles(right + 3, columns, inner, curve->head);
    }
    band_free(&matrix);
    free(right);
    return determined;
}

static void set_curve(struct grown_fit *fit, const double *inner, size_t n)
{
    const struct reference *t = fit->reference;
    size_t degree = (size_t)fit->curve.degree, last = t->n - 1;
    struct bspline curve = spline_new(t, fit->curve.degree, degree + 1 + n);

    for (size_t i = 0; i <= degree; i++) {
        curve.knot[i] = 0;
        curve.knot[curve.poles + i] = t->length[last];
    }
    for (size_t i = 0; i < n; i++)
        curve.knot[degree + 1 + i] = inner[i];
    curve.pole[0] = t->point[0];
    curve.pole[curve.poles - 1] = t->point[last];
    if (curve.head) {
        curve.head[0] = fit->head[0];
        curve.head[curve.poles - 1] = fit->head[last];
    }
    fit->curve = curve;
}

/* ---- how far off it is */

/* The largest squares of how far a span is off; one root is enough for all of them. */
struct off2 {
    double point, other, axis;
};

/* How far q is from the data beside interval k: from it, or from the one before; squared.  No more
 * than it is from the place there: where that is no farther than `most` nobody need know. */
static double off2_polyline(const struct vec3 *data, size_t k, bool between, struct vec3 q,
                            double most)
{
    struct vec3 place = between ? vec_mix(data[k], data[k + 1], 0.5) : data[k];
    struct vec3 there = vec_sub(q, place);

    if (vec_dot(there, there) <= most)
        return most;
    struct vec3 after = vec_sub(q, vec_segment_nearest(data[k], data[k + 1], q));
    if (k == 0 || between)
        return vec_dot(after, after);
    struct vec3 before = vec_sub(q, vec_segment_nearest(data[k - 1], data[k], q));
    return fmin(vec_dot(after, after), vec_dot(before, before));
}

static struct vec3 mix(const double *value, size_t order, const struct vec3 *pole)
{
    struct vec3 p = {0, 0, 0};

    for (size_t i = 0; i < order; i++)
        p = vec_along(p, value[i], pole[i]);
    return p;
}

/* At an item of the span whose first pole is `first`. */
static void measure_item(const struct grown_fit *fit, size_t first, size_t item, struct off2 *most)
{
    const struct reference *t = fit->reference;
    size_t order = (size_t)fit->curve.degree + 1, k = item / 2;
    const double *value = fit->basis + item * order;
    bool between = item % 2;
    struct vec3 p = mix(value, order, fit->curve.pole + first);

    most->point = fmax(most->point, off2_polyline(t->point, k, between, p, most->point));
    if (!fit->head)
        return;
    struct vec3 axis = vec_unit(vec_sub(mix(value, order, fit->curve.head + first), p));
    struct vec3 other = vec_along(p, t->offset, axis);
    struct vec3 turned = vec_sub(vec_mix(t->axis[k], t->axis[k + 1], between ? 0.5 : 0), axis);
    most->other = fmax(most->other, off2_polyline(t->other, k, between, other, most->other));
    most->axis = fmax(most->axis, vec_dot(turned, turned));
}

/* In parts of the tolerance. */
static double measure_span(const struct grown_fit *fit, size_t first, size_t from, size_t to,
                           double enough)
{
    size_t step = fit->between ? 1 : 2;
    struct off2 most = {0};

    double surely = enough * (1 + 1e-9), far = surely * fit->tolerance,
           turned = surely * fit->angle;

    far *= far;
    turned *= turned;
    for (size_t i = fit->between ? from : from + from % 2; i < to; i += step) {
        measure_item(fit, first, i, &most);
        if (most.point > far || most.other > far || most.axis > turned)
            break;
    }
    double off = sqrt(fmax(most.point, most.other)) / fit->tolerance;
    return fmax(off, sqrt(most.axis) / fit->angle);
}

/* Takes down where the poles of the span are; false: as they were when it was measured. */
static bool poles_moved(const struct grown_fit *fit, size_t first, double *was)
{
    const struct bspline *curve = &fit->curve;
    double most = NEAR * fit->tolerance;
    bool moved = false;

    for (size_t i = 0; i <= (size_t)curve->degree; i++)
        for (int kind = 0; kind < (curve->head ? 2 : 1); kind++, was += 3) {
            struct vec3 p = kind ? curve->head[first + i] : curve->pole[first + i];
            moved = moved || !(fabs(p.x - was[0]) <= most && fabs(p.y - was[1]) <= most &&
                               fabs(p.z - was[2]) <= most);
        }
    return moved;
}

static void keep_poles(const struct grown_fit *fit, size_t first, double *at)
{
    const struct bspline *curve = &fit->curve;

    for (size_t i = 0; i <= (size_t)curve->degree; i++)
        for (int kind = 0; kind < (curve->head ? 2 : 1); kind++, at += 3) {
            struct vec3 p = kind ? curve->head[first + i] : curve->pole[first + i];
            at[0] = p.x;
            at[1] = p.y;
            at[2] = p.z;
        }
}

static double measure(struct grown_fit *fit, double enough)
{
    const struct bspline *curve = &fit->curve;
    size_t from = 0;
    double worst = 0;

    for (size_t s = 0; s + (size_t)curve->degree < curve->poles; s++) {
        double *item = fit->known.item + s * size_of(curve), *off = off_of(curve, item);
        if (!isfinite(*off) || poles_moved(fit, s, poles_of(curve, item))) {
            *off = measure_span(fit, s, from, fit->known.end[s], enough);
            keep_poles(fit, s, poles_of(curve, item));
        }
        from = fit->known.end[s];
        fit->off[s] = *off;
        worst = fmax(worst, *off);
        if (*off > enough)
            *off = INFINITY; /* how much it is nobody knows */
    }
    return worst;
}

double grown_fit_knots(struct grown_fit *fit, const double *inner, size_t n, double enough)
{
    struct bspline before = fit->curve;

    set_curve(fit, inner, n);
    bool few = fit->curve.poles <= fit->reference->n;
    if (few)
        set_spans(fit, &before);
    else
        fit->known.n = 0;
    bspline_free(&before);
    return few && solve(fit) ? measure(fit, enough) : INFINITY;
}
