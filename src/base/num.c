/*
 * num - see num.h.
 *
 * Reading: up to 19 digits are gathered in an integer.  When it is below 2^53 and the power of
 * ten within 10^22, both are exact doubles and one multiplication or division rounds once, which
 * is the nearest double (Clinger 1990).  All else goes to num_exact.
 *
 * Writing: x * 10^digits is rounded to an integer, half away from zero, and its digits are set
 * down; beyond 2^53, where a double has no decimals to round, printf writes it.
 */
#include "base/num.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "num_exact.h"

const double num_ten[23] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                            1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The value of an exponent at p (`e-3`, `D+05`), and its end; 0 and p if there is none. */
static int read_exponent(const char *p, const char **end)
{
    *end = p;
    if (*p != 'e' && *p != 'E' && *p != 'd' && *p != 'D')
        return 0;
    p++;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+')
        p++;
    if (!is_digit(*p))
        return 0;
    int value = 0;
    for (; is_digit(*p); p++)
        if (value < 100000)
            value = value * 10 + (*p - '0');
    *end = p;
    return negative ? -value : value;
}

bool num_read(const char **s, double *value)
{
    const char *p = *s;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+')
        p++;

    uint64_t mantissa = 0;
    int digits = 0, decimals = 0;
    const char *first = p;
    for (; is_digit(*p); p++, digits++)
        mantissa = mantissa * 10 + (uint64_t)(*p - '0');
    if (*p == '.') {
        const char *point = ++p;
        for (; is_digit(*p); p++)
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
        decimals = p - point < 400 ? (int)(p - point) : 400;
        digits = p - first > 400 ? 400 : digits + decimals;
    }
    if (digits == 0)
        return false;

    const char *end = p;
    int exponent = read_exponent(p, &end) - decimals;
    if (digits <= 19 && mantissa <= (UINT64_C(1) << 53) && exponent >= -22 && exponent <= 22) {
        double m = (double)mantissa;
        m = exponent < 0 ? m / num_ten[-exponent] : m * num_ten[exponent];
        *value = negative ? -m : m;
    } else {
        *value = num_exact(*s, end);
    }
    *s = end;
    return true;
}

bool num_not_finite(const char **s)
{
    static const char *const word[] = {"nan",     "infinity", "inf",   "1.#qnan",
                                       "1.#snan", "1.#ind",   "1.#inf"};
    const char *p = *s;
    if (*p == '-' || *p == '+')
        p++;
    for (size_t i = 0; i < sizeof word / sizeof *word; i++) {
        size_t n = strlen(word[i]);
        if (strncasecmp(p, word[i], n) != 0)
            continue;
        p += n;
        if (*p == '(' && p[strcspn(p, ") \t,;")] == ')')
            p += strcspn(p, ")") + 1;
        while (is_digit(*p)) /* 1.#INF00 */
            p++;
        *s = p;
        return true;
    }
    return false;
}

bool num_whole(const char *text, double *value)
{
    while (*text == ' ' || *text == '\t')
        text++;
    if (!num_read(&text, value) || !isfinite(*value))
        return false;
    while (*text == ' ' || *text == '\t')
        text++;
    return *text == '\0';
}

enum { DIGITS_MAX = 16 }; /* of an integer below 2^53 */

/* The digits of n up to `end`, no fewer than `least`; returns where they start. */
static inline char *put_digits(char *end, uint64_t n, int least)
{
    static const char pair[] = "00010203040506070809101112131415161718192021222324"
                               "25262728293031323334353637383940414243444546474849"
                               "50515253545556575859606162636465666768697071727374"
                               "75767778798081828384858687888990919293949596979899";
    char *p = end;
    for (; n >= 10; n /= 100)
        memcpy(p -= 2, pair + 2 * (n % 100), 2);
    if (n || p == end)
        *--p = (char)('0' + n);
    while (end - p < least)
        *--p = '0';
    return p;
}

size_t num_put(char *buf, int64_t integer, bool negative, int digits)
{
    char text[2 * DIGITS_MAX],
        *end = text + DIGITS_MAX; /* at the end, so that copies have one length */
    const char *p = put_digits(end, (uint64_t)integer, digits + 1);
    char *to = buf;
    *to = '-';
    to += negative && integer != 0;
    memcpy(to, p, DIGITS_MAX);
    to += end - p;
    if (digits) {
        to -= digits;
        memcpy(to + 1, end - digits, DIGITS_MAX);
        *to = '.';
        to += 1 + digits;
    }
    *to = '\0';
    return (size_t)(to - buf);
}

/* What a product p = a * b of doubles was rounded by: their halves of 26 bits (Veltkamp) have exact
 * products (Dekker 1971).  Far from the largest doubles. */
static double product_rest(double a, double b, double p)
{
    const double split = 134217729; /* 2^27 + 1 */
    double ca = split * a, cb = split * b;
    double ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;

    return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

bool num_units_doubtful(double x, int digits, double s, double *whole)
{
    if (!(fabs(s) < 9007199254740992.0))
        return false;
    double below = trunc(fabs(s)), part = fabs(s) - below;
    bool half = part == 0.5 && product_rest(fabs(x), num_ten[digits], fabs(s)) >= 0;

    *whole = below + (part > 0.5 || half);
    if (x < 0 && *whole > 0)
        *whole = -*whole;
    return true;
}

size_t num_write(char *buf, double x, int digits)
{
    int64_t integer;
    if (!num_scaled(x, digits, &integer))
        return (size_t)snprintf(buf, NUM_MAX, "%.*f", digits, x);
    return num_put(buf, integer, x < 0, digits);
}

size_t num_shorten(char *buf, size_t n, int digits, bool point)
{
    if (!digits) {
        if (point)
            buf[n++] = '.';
    } else {
        while (buf[n - 1] == '0')
            n--;
        if (buf[n - 1] == '.' && !point)
            n--;
    }
    buf[n] = '\0';
    return n;
}

size_t num_write_short(char *buf, double x, int digits, bool point)
{
    return num_shorten(buf, num_write(buf, x, digits), digits, point);
}

/* Below 1 with eight decimals, as the components of directions are: 0.57735027 */
static size_t put_fraction(char *buf, uint32_t integer, bool negative)
{
    uint64_t digit = num_eight_digits(integer);
    size_t left = 8 - (size_t)__builtin_clzll(digit) / 8;
    char *to = buf;
    *to = '-';
    to += negative;
    memcpy(to, "0.", 2);
    num_put_eight(to + 2, digit + UINT64_C(0x3030303030303030));
    to += 2 + left;
    return (size_t)(to - buf);
}

size_t num_put_long(char *buf, int64_t integer, bool negative, int digits, bool point)
{
    if (digits == 8 && integer > 0 && integer < 100000000)
        return put_fraction(buf, (uint32_t)integer, negative);
    return num_shorten(buf, num_put(buf, integer, negative, digits), digits, point);
}
