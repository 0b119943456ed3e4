/*
 * pair - two numbers in one register, for sums over millions of points: each is reckoned as it
 * would be alone, to the bit.
 */
#ifndef CLOUDMILL_PAIR_H
#define CLOUDMILL_PAIR_H

#include <string.h>

typedef double pair __attribute__((vector_size(16)));

/* Both the same. */
static inline pair pair_both(double x)
{
    return (pair){x, x};
}

/* The other way round. */
static inline pair pair_swap(pair p)
{
    return (pair){p[1], p[0]};
}

/* Two numbers that follow each other. */
static inline pair pair_at(const double *x)
{
    pair p;
    memcpy(&p, x, sizeof p);
    return p;
}

static inline void pair_put(double *x, pair p)
{
    memcpy(x, &p, sizeof p);
}

/* The lesser, and the greater, of each; of two equals, or beside a NaN, the second. */
static inline pair pair_lesser(pair a, pair b)
{
    return (pair){a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1]};
}

static inline pair pair_greater(pair a, pair b)
{
    return (pair){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}

#endif
