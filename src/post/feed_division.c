/* feed_division - see feed_division.h. */
#include "feed_division.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"

static const double SHARE = 0.1;      /* of the time, saved at least */
static const double LEAST = 0.2 / 60; /* the same for a place, minutes */

enum { GROUPS = 256 };

/* What the spans from each on take together, at one rate; n + 1 of them. */
static double *minutes_after(const struct feed_spans *spans)
{
    double *after = mem_alloc(spans->n + 1, sizeof *after), length = 0, rate = 0;

    after[spans->n] = 0;
    for (size_t i = spans->n; i-- > 0;) {
        length += spans->item[i].length;
        rate = fmax(rate, spans->item[i].rate);
        after[i] = length * rate;
    }
    return after;
}

/* One place; 1: it saves too little. */
static double at_one_place(const struct feed_spans *spans, const double *after)
{
    double length = 0, rate = 0, minutes = after[0], best = 1;

    for (size_t i = 0; i + 1 < spans->n; i++) {
        length += spans->item[i].length;
        rate = fmax(rate, spans->item[i].rate);
        if (length * rate + after[i + 1] < minutes) {
            minutes = length * rate + after[i + 1];
            best = spans->item[i].s;
        }
    }
    return after[0] - minutes > fmax(SHARE * after[0], LEAST) ? best : 1;
}

/* The first of two. */
static double at_two_places(const struct feed_spans *spans, const double *after)
{
    double length = 0, rate = 0, minutes = after[0], best = 1;

    for (size_t i = 0; i + 2 < spans->n; i++) {
        double between = 0, slowest = 0;
        length += spans->item[i].length;
        rate = fmax(rate, spans->item[i].rate);
        for (size_t k = i + 1; k + 1 < spans->n; k++) {
            between += spans->item[k].length;
            slowest = fmax(slowest, spans->item[k].rate);
            double sum = length * rate + between * slowest + after[k + 1];
            if (sum < minutes) {
                minutes = sum;
                best = spans->item[i].s;
            }
        }
    }
    return after[0] - minutes > fmax(SHARE * after[0], 2 * LEAST) ? best : 1;
}

/* The spans in even groups, each at its slowest. */
static struct feed_spans group(const struct feed_spans *spans)
{
    struct feed_spans groups = {0};
    size_t each = (spans->n + GROUPS - 1) / GROUPS;

    for (size_t i = 0; i < spans->n; i += each) {
        struct feed_span sum = {0};
        for (size_t k = i; k < i + each && k < spans->n; k++) {
            sum.s = spans->item[k].s;
            sum.length += spans->item[k].length;
            sum.rate = fmax(sum.rate, spans->item[k].rate);
        }
        *array_push(&groups) = sum;
    }
    return groups;
}

double feed_division(const struct feed_spans *spans)
{
    double *after = minutes_after(spans), best = at_one_place(spans, after);

    if (best == 1 && after[0] > 2 * LEAST) {
        struct feed_spans groups = group(spans);
        double *of_groups = minutes_after(&groups);
        best = at_two_places(&groups, of_groups);
        free(of_groups);
        array_free(&groups);
    }
    free(after);
    return best;
}
