/*
 * num_exact - see num_exact.h.
 *
 * The number is D 10^e with an integer D.  Without its powers of two, which only move the exponent,
 * it is D 5^e or D / 5^-e: a quotient of integers, whose first 64 bits and whether any are left
 * over tell how it is rounded.  Where D has at most 19 digits and 5^|e| is below 2^63 the quotient
 * is one of 128 bits; else it is found bit by bit, in integers as long as needed.
 */
#include "num_exact.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum {
    DIGITS = 772, /* half way between two doubles a number has 767 at most */
    SHORT = 19,   /* so many digits are below 2^64 */
    FIVES = 27,   /* 5^27 is below 2^63 */
    LIMBS = 120,  /* 10^773, or 5^1110 and 64 bits more */
    BITS = 53
};

struct decimal {
    int n; /* digits, the first and the last not 0 */
    unsigned char digit[DIGITS + 1];
    int exponent; /* of ten, after the last digit */
    bool negative;
};

static void push_digit(struct decimal *d, int digit, bool *more)
{
    if (d->n == 0 && digit == 0)
        return;
    if (d->n < DIGITS) {
        d->digit[d->n++] = (unsigned char)digit;
        return;
    }
    *more = *more || digit != 0;
    d->exponent++;
}

/* The exponent at p, after its letter; beyond 10^6 it does not matter any more. */
static int exponent_at(const char *p, const char *to)
{
    bool negative = p < to && *p == '-';
    int value = 0;

    for (p += p < to && (*p == '-' || *p == '+'); p < to; p++)
        value = value < 1000000 ? value * 10 + (*p - '0') : value;
    return negative ? -value : value;
}

static struct decimal decimal_of(const char *from, const char *to)
{
    struct decimal d = {.negative = *from == '-'};
    bool more = false, point = false;
    long decimals = 0;
    const char *p = from + (*from == '-' || *from == '+');

    for (; p < to && (*p == '.' || (*p >= '0' && *p <= '9')); p++) {
        if (*p == '.') {
            point = true;
            continue;
        }
        push_digit(&d, *p - '0', &more);
        decimals += point;
    }
    const long far = 1000000000;
    long exponent = d.exponent - decimals + (p < to ? exponent_at(p + 1, to) : 0);
    d.exponent = (int)(exponent < -far ? -far : exponent > far ? far : exponent);
    if (more) { /* what is left over is seen as one more digit */
        d.digit[d.n++] = 1;
        d.exponent--;
    }
    for (; d.n > 0 && d.digit[d.n - 1] == 0; d.n--)
        d.exponent++;
    return d;
}

/* bits 2^exponent, and something more below its last bit, as the nearest double. */
static double round_bits(uint64_t bits, bool more, int exponent)
{
    int length = 64 - __builtin_clzll(bits), first = exponent + length - 1;
    int kept = first >= -1022 ? BITS : BITS - (-1022 - first), lost = length - kept;

    if (kept < 0)
        return 0;
    if (lost <= 0)
        return ldexp((double)bits, exponent);
    uint64_t half = (uint64_t)1 << (lost - 1), whole = lost < 64 ? bits >> lost : 0;
    uint64_t rest = lost < 64 ? bits & (2 * half - 1) : bits;
    if (rest > half || (rest == half && (more || whole % 2 == 1)))
        whole++;
    return ldexp((double)whole, exponent + lost);
}

/* ---- short numbers */

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 uint128;

static double round_long(uint128 n, bool more, int exponent)
{
    uint64_t high = (uint64_t)(n >> 64);
    if (high == 0)
        return round_bits((uint64_t)n, more, exponent);
    int lost = 64 - __builtin_clzll(high);
    uint128 low = n & (((uint128)1 << lost) - 1);
    return round_bits((uint64_t)(n >> lost), more || low != 0, exponent + lost);
}

static bool is_short(const struct decimal *d)
{
    return d->n <= SHORT && d->exponent >= -FIVES && d->exponent <= FIVES;
}

static double short_value(const struct decimal *d)
{
    uint64_t n = 0, five = 1;

    for (int i = 0; i < d->n; i++)
        n = n * 10 + d->digit[i];
    for (int i = d->exponent < 0 ? -d->exponent : d->exponent; i > 0; i--)
        five *= 5;
    if (d->exponent >= 0)
        return round_long((uint128)n * five, false, d->exponent);
    int shift = 64 + __builtin_clzll(n);
    uint128 large = (uint128)n << shift, quotient = large / five;
    return round_long(quotient, quotient * five != large, d->exponent - shift);
}
#else
static bool is_short(const struct decimal *d)
{
    (void)d;
    return false;
}

static double short_value(const struct decimal *d)
{
    (void)d;
    return 0;
}
#endif

/* ---- long ones */

/* An integer, its lowest limb first, no zeros on top. */
struct integer {
    int n;
    uint32_t limb[LIMBS];
};

/* a = a factor + term */
static void multiply_add(struct integer *a, uint32_t factor, uint32_t term)
{
    uint64_t carry = term;

    for (int i = 0; i < a->n; i++) {
        carry += (uint64_t)a->limb[i] * factor;
        a->limb[i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry)
        a->limb[a->n++] = (uint32_t)carry;
}

static void multiply_fives(struct integer *a, int power)
{
    const uint32_t most = 1220703125; /* 5^13 */

    for (; power >= 13; power -= 13)
        multiply_add(a, most, 0);
    for (; power > 0; power--)
        multiply_add(a, 5, 0);
}

static int bit_length(const struct integer *a)
{
    return 32 * a->n - __builtin_clz(a->limb[a->n - 1]);
}

static void shift_left(struct integer *a, int bits)
{
    int limbs = bits / 32;

    if (bits % 32)
        multiply_add(a, (uint32_t)1 << bits % 32, 0);
    memmove(a->limb + limbs, a->limb, (size_t)a->n * sizeof *a->limb);
    memset(a->limb, 0, (size_t)limbs * sizeof *a->limb);
    a->n += limbs;
}

static bool is_less(const struct integer *a, const struct integer *b)
{
    if (a->n != b->n)
        return a->n < b->n;
    for (int i = a->n; i-- > 0;)
        if (a->limb[i] != b->limb[i])
            return a->limb[i] < b->limb[i];
    return false;
}

/* a = a - b, which is not larger */
static void subtract(struct integer *a, const struct integer *b)
{
    uint64_t borrow = 0;

    for (int i = 0; i < a->n; i++) {
        uint64_t difference = (uint64_t)a->limb[i] - (i < b->n ? b->limb[i] : 0) - borrow;
        a->limb[i] = (uint32_t)difference;
        borrow = difference >> 63;
    }
    while (a->n > 0 && a->limb[a->n - 1] == 0)
        a->n--;
}

static double long_value(const struct decimal *d)
{
    struct integer over = {.n = 0}, under = {1, {1}};

    for (int i = 0; i < d->n; i++)
        multiply_add(&over, 10, d->digit[i]);
    multiply_fives(d->exponent < 0 ? &under : &over, d->exponent < 0 ? -d->exponent : d->exponent);
    /* a quotient of 62 or 63 bits */
    int shift = bit_length(&under) + 62 - bit_length(&over);
    if (shift > 0)
        shift_left(&over, shift);
    shift_left(&under, 63 + (shift < 0 ? -shift : 0));
    uint64_t quotient = 0;
    for (int i = 0; i < 64; i++) {
        bool one = !is_less(&over, &under);
        if (one)
            subtract(&over, &under);
        quotient = 2 * quotient + one;
        if (i < 63)
            multiply_add(&over, 2, 0);
    }
    return round_bits(quotient, over.n > 0, d->exponent - shift);
}

double num_exact(const char *from, const char *to)
{
    struct decimal d = decimal_of(from, to);
    double value;

    if (d.n == 0 || d.n + d.exponent < -330)
        value = 0;
    else if (d.n + d.exponent > 310)
        value = HUGE_VAL;
    else
        value = is_short(&d) ? short_value(&d) : long_value(&d);
    return d.negative ? -value : value;
}
