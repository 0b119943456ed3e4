/* ncpoly - see ncpoly.h. */
#include "post/ncpoly.h"

#include <stdlib.h>
#include <string.h>

#include "base/num.h"

enum { SAMPLES = 8, FACTORS = NC_POLY_DEGREE - 1 };
static const double cubic_most = 20; /* PL above this would cost digits of the factors */
static const double other_most = 1;  /* with powers up to the fifth this would */

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

static void take_factors(const struct bspline *b, const struct vec3 *pole, double u, double scale,
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
    take_factors(b, b->pole, u, (end - u) / s.h, s.digits, s.factor);
    s.end = vec_round(bspline_at(b, b->pole, end), digits);
    if (b->head) {
        take_factors(b, b->head, u, (end - u) / s.h, s.digits, s.head_factor);
        s.head_end = vec_round(bspline_at(b, b->head, end), digits);
    }
    return s;
}

bool nc_poly_words(struct nc_spans *spans, const struct bspline *b, int digits)
{
    for (size_t i = (size_t)b->degree; i < b->poles; i++)
        if (b->knot[i + 1] > b->knot[i]) {
            struct nc_span s = span_words(b, i, digits);
            if (s.h <= 0)
                return false;
            *array_push(spans) = s;
        }
    return true;
}

/* PO[XH]=(end,a2,...) and the blank before it, for X, Y and Z. */
static size_t width(struct vec3 end, const struct vec3 *factor, int n, int end_digits, int digits)
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
        size_t n = width(s->end, s->factor, factors, digits, s->digits);
        if (turns)
            n += width(s->head_end, s->head_factor, factors, digits, s->digits);
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
