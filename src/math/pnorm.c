/* pnorm - see pnorm.h. */
#include "math/pnorm.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

struct pnorm pnorm_new(size_t points, bool twice, size_t unknowns)
{
    size_t pairs = points * (twice ? 2 : 1);
    struct pnorm s = {.points = points, .pairs = pairs, .unknowns = unknowns};

    s.off = mem_alloc(4 * pairs, sizeof *s.off);
    s.weighed = s.off + 2 * pairs;
    s.slopes = mem_alloc(2 * pairs * unknowns, sizeof *s.slopes);
    s.column = mem_alloc(unknowns, sizeof *s.column);
    for (size_t k = 0; k < unknowns; k++)
        s.column[k].slope = s.slopes + 2 * pairs * k;
    s.normal = band_new(unknowns, unknowns > 0 ? unknowns - 1 : 0);
    s.right = mem_alloc(unknowns, sizeof *s.right);
    return s;
}

void pnorm_free(struct pnorm *s)
{
    free(s->off);
    free(s->slopes);
    free(s->column);
    free(s->right);
    band_free(&s->normal);
}

static double power(double x, int n)
{
    double y = 1;
    while (n > 0) {
        y *= n % 2 ? x : 1;
        x *= x;
        n /= 2;
    }
    return y;
}

double pnorm_cost(const struct pnorm *s, const double *off, const double held[3], int half,
                  double scale)
{
    double sum = held[0] * held[0] + held[1] * held[1] + held[2] * held[2];
    for (size_t i = 0; i < s->pairs; i++) {
        double d2 = off[2 * i] * off[2 * i] + off[2 * i + 1] * off[2 * i + 1];
        sum += power(d2 / (scale * scale), half);
    }
    return sum;
}

/* Pair i of the distances and their slopes become those of (d / scale)^half. */
static void weigh_pair(struct pnorm *s, size_t i, int half, double scale)
{
    double x = s->off[2 * i], y = s->off[2 * i + 1], d = sqrt(x * x + y * y);
    double f = power(d / scale, half - 1) / scale;
    double ux = d > 0 ? x / d : 0, uy = d > 0 ? y / d : 0;
    s->weighed[2 * i] = f * x;
    s->weighed[2 * i + 1] = f * y;
    size_t point = i < s->points ? i : i - s->points;
    for (size_t k = 0; k < s->unknowns; k++) {
        struct pnorm_column *c = &s->column[k];
        if (point < c->from || point >= c->to)
            continue;
        double *slope = c->slope + 2 * i, along = (half - 1) * (ux * slope[0] + uy * slope[1]);
        slope[0] = f * (slope[0] + along * ux);
        slope[1] = f * (slope[1] + along * uy);
    }
}

static double dot(const double *a, const double *b, size_t from, size_t to)
{
    double even = 0, odd = 0;
    for (size_t i = 2 * from; i < 2 * to; i += 2) {
        even += a[i] * b[i];
        odd += a[i + 1] * b[i + 1];
    }
    return even + odd;
}

/* Sum over the points [from, to), both ends of the lever. */
static double sum_of_products(const struct pnorm *s, const double *a, const double *b, size_t from,
                              size_t to)
{
    size_t n = s->points;
    double sum = dot(a, b, from, to);
    return s->pairs > n ? sum + dot(a, b, n + from, n + to) : sum;
}

void pnorm_equations(struct pnorm *s, int half, double scale)
{
    for (size_t i = 0; i < s->pairs; i++)
        weigh_pair(s, i, half, scale);
    for (size_t k = 0; k < s->unknowns; k++) {
        const struct pnorm_column *c = &s->column[k];
        const double *h = c->held, *g = s->held;
        s->right[k] = -(h[0] * g[0] + h[1] * g[1] + h[2] * g[2]) -
                      sum_of_products(s, c->slope, s->weighed, c->from, c->to);
        for (size_t l = 0; l <= k; l++) {
            const struct pnorm_column *d = &s->column[l];
            size_t from = c->from > d->from ? c->from : d->from;
            size_t to = c->to < d->to ? c->to : d->to;
            g = d->held;
            *band_at(&s->normal, k, l) = h[0] * g[0] + h[1] * g[1] + h[2] * g[2] +
                                         sum_of_products(s, c->slope, d->slope, from, to);
        }
    }
}
