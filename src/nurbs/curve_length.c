/* curve_length - see curve_length.h. */
#include "nurbs/curve_length.h"

#include <stdlib.h>

#include "base/array.h"

enum { PARTS = 32, STEPS = 60 }; /* of a span; of Newton's method */

/* The length between two places of one span. */
static double within_span(const struct nurbs_curve *c, double from, double to)
{
    static const double x[3] = {-0.7745966692414834, 0, 0.7745966692414834};
    static const double w[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += w[k] * (to - from) / 2 *
               vec_length(nurbs_curve_derivative(c, (from + to) / 2 + x[k] * (to - from) / 2));
    return sum;
}

struct curve_length curve_length(const struct nurbs_curve *c)
{
    struct doubles at = {0}, length = {0};
    double last = c->t.from, sum = 0;
    *array_push(&at) = last;
    *array_push(&length) = 0;
    for (size_t i = (size_t)c->t.degree; i < c->t.poles; i++)
        for (int p = 1; p <= PARTS; p++) {
            double end = c->t.knot[i] + (c->t.knot[i + 1] - c->t.knot[i]) * p / PARTS;
            end = fmin(end, c->t.to);
            if (!(end > last))
                continue;
            sum += within_span(c, last, end);
            *array_push(&at) = last = end;
            *array_push(&length) = sum;
        }
    return (struct curve_length){c, at.n - 1, at.item, length.item};
}

/* The part of the table that x is in. */
static size_t part_of(const double *value, size_t n, double x)
{
    size_t low = 0, high = n;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        *(value[middle] <= x ? &low : &high) = middle;
    }
    return low;
}

double curve_length_to(const struct curve_length *l, double t)
{
    t = fmin(fmax(t, l->at[0]), l->at[l->n]);
    size_t i = part_of(l->at, l->n, t);
    return l->length[i] + within_span(l->curve, l->at[i], t);
}

double curve_length_at(const struct curve_length *l, double length)
{
    if (!(length > 0))
        return l->at[0];
    if (length >= l->length[l->n])
        return l->at[l->n];
    size_t i = part_of(l->length, l->n, length);
    double low = l->at[i], high = l->at[i + 1], want = length - l->length[i];
    double t = low + (high - low) * want / (l->length[i + 1] - l->length[i]);
    for (int k = 0; k < STEPS && low < high; k++) {
        double off = within_span(l->curve, l->at[i], t) - want;
        *(off > 0 ? &high : &low) = t;
        double next = t - off / vec_length(nurbs_curve_derivative(l->curve, t));
        if (!(next > low && next < high))
            next = (low + high) / 2;
        if (!(fabs(next - t) > 1e-15 * (fabs(t) + l->at[l->n] - l->at[0])))
            break;
        t = next;
    }
    return t;
}

void curve_length_free(struct curve_length *l)
{
    free(l->at);
    free(l->length);
    *l = (struct curve_length){0};
}
