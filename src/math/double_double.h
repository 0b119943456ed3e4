/*
 * double_double - the rounding errors of single operations, and numbers of twice the digits made of
 * them (Dekker 1971; Knuth, volume 2, 4.2.2).  Exact wherever nothing overflows or underflows, and
 * without fma, which some C libraries and machines lack.
 */
#ifndef CLOUDMILL_DOUBLE_DOUBLE_H
#define CLOUDMILL_DOUBLE_DOUBLE_H

/* The number high + low; low is at most half the last digit of high. */
struct pair {
    double high, low;
};

static inline struct pair two_sum(double a, double b)
{
    double s = a + b, part = s - a;

    return (struct pair){s, (a - (s - part)) + (b - part)};
}

/* As two_sum, where |a| >= |b| or a = 0. */
static inline struct pair quick_sum(double a, double b)
{
    double s = a + b;

    return (struct pair){s, b - (s - a)};
}

/* The upper 26 binary digits of a, and the rest in as many. */
static inline struct pair halves(double a)
{
    double c = 0x1p27 * a + a, high = c - (c - a);

    return (struct pair){high, a - high};
}

static inline struct pair two_product(double a, double b)
{
    struct pair x = halves(a), y = halves(b);
    double p = a * b;

    return (struct pair){p,
                         ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

/* a / b, of twice the digits: error at most a few 2^-104 of it. */
static inline struct pair pair_ratio(struct pair a, struct pair b)
{
    double q = a.high / b.high;
    struct pair p = two_product(q, b.high);

    return quick_sum(q, (((a.high - p.high) - p.low) + (a.low - q * b.low)) / b.high);
}

#endif
