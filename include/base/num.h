/*
 * num - numbers as text, the same in every locale and on every platform.
 */
#ifndef CLOUDMILL_NUM_H
#define CLOUDMILL_NUM_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* 10^0 to 10^22, all exact. */
extern const double num_ten[23];

/*
 * Reads one decimal number at *s: sign, digits with or without a point (`5`, `5.`, `.5`),
 * exponent by e, E, d or D.  The value is the nearest double, as strtod's would be.  True if there
 * is one; *s is then advanced to its end; false leaves *s.  The text must end in '\0' or any
 * other character that cannot be part of a number.  nan, inf and hexadecimal are no numbers;
 * a number too large for a double gives +-HUGE_VAL: check with isfinite where it matters.
 */
bool num_read(const char **s, double *value);

/* What a character is as a digit, 10 or more: it is none. */
static inline unsigned num_digit(char c)
{
    return (unsigned)(unsigned char)c - '0';
}

/* The first eight characters, the first one lowest, on any processor. */
static inline uint64_t num_eight(const char *p)
{
    const unsigned char *u = (const unsigned char *)p;
    return (uint64_t)u[0] | (uint64_t)u[1] << 8 | (uint64_t)u[2] << 16 | (uint64_t)u[3] << 24 |
           (uint64_t)u[4] << 32 | (uint64_t)u[5] << 40 | (uint64_t)u[6] << 48 |
           (uint64_t)u[7] << 56;
}

/* The number of eight digits, a byte each, the first one lowest. */
static inline uint64_t num_of_eight(uint64_t digit)
{
    digit = (digit * 10 + (digit >> 8)) & 0x00ff00ff00ff00ff;
    digit = (digit * 100 + (digit >> 16)) & 0x0000ffff0000ffff;
    return (digit * 10000 + (digit >> 32)) & 0xffffffff;
}

/* The number of leading digits among them, and their value, 0 if there are none. */
static inline int num_digits(uint64_t eight, uint64_t *value)
{
    static const uint64_t each = 0x0101010101010101;
    uint64_t digit = eight ^ (0x30 * each);
    uint64_t other = ((digit + 0x76 * each) | digit) & (0x80 * each);
    int bits = other ? __builtin_ctzll(other) & 56 : 64;
    *value = num_of_eight(bits ? digit << (64 - bits) : 0); /* leading zeros */
    return bits / 8;
}

/* Are the first n of them, 1 to 8, digits?  And their value. */
static inline bool num_so_many_digits(uint64_t eight, int n, uint64_t *value)
{
    static const uint64_t each = 0x0101010101010101;
    uint64_t digit = eight ^ (0x30 * each);
    uint64_t other = ((digit + 0x76 * each) | digit) & (0x80 * each);
    *value = num_of_eight(digit << (64 - 8 * n));
    return other << (64 - 8 * n) == 0;
}

/* The number of leading digits alone. */
static inline int num_leading(uint64_t eight)
{
    static const uint64_t each = 0x0101010101010101;
    uint64_t digit = eight ^ (0x30 * each);
    uint64_t other = ((digit + 0x76 * each) | digit) & (0x80 * each);
    return other ? __builtin_ctzll(other) / 8 : 8;
}

/* The number of at most 15 digits, so many of them behind the point: both are exact, so that one
 * division rounds once, to the nearest double. */
static inline double num_of_digits(bool negative, uint64_t mantissa, size_t decimals)
{
    double magnitude = (double)(int64_t)mantissa / num_ten[decimals];
    return negative ? -magnitude : magnitude;
}

/* 10^0 to 10^8. */
static const uint64_t num_scale[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/* num_plain of any length. */
static inline const char *num_long(const char *p, double *value)
{
    bool negative = *p == '-';
    p += negative;
    uint64_t mantissa, more; /* eight digits at a time: how many there are is not guessed */
    size_t decimals = 0;
    const char *first = p;
    p += num_digits(num_eight(p), &mantissa);
    for (; p - first >= 8 && *p >= '0' && *p <= '9' && p - first < 16; p++)
        mantissa = mantissa * 10 + (uint64_t)(*p - '0');
    size_t digits = (size_t)(p - first);
    if (*p == '.') {
        first = ++p;
        int n = num_digits(num_eight(p), &more);
        mantissa = mantissa * num_scale[n] + more;
        p += n;
        for (; n == 8 && *p >= '0' && *p <= '9' && p - first < 16; p++)
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
        decimals = (size_t)(p - first);
        digits += decimals;
    }
    if (digits - 1 >= 15 || *p >= 'A') /* none or too many; an exponent */
        return NULL;
    *value = num_of_digits(negative, mantissa, decimals);
    return p;
}

/*
 * A faster num_read for plain numbers, at most 15 digits without an exponent, of which files have
 * millions.  Returns the end of the number, or NULL if it is not plain.  It reads eight digits at a
 * time, and so up to eight characters after the number; most numbers have no more, those before and
 * behind the point together.
 */
static inline const char *num_plain(const char *p, double *value)
{
    bool negative = *p == '-';
    const char *q = p + negative;
    int before = num_leading(num_eight(q));
    if (before < 8 && q[before] == '.') {
        const uint64_t first = ((uint64_t)1 << 8 * before) - 1; /* those before the point */
        uint64_t mantissa;
        int digits = num_digits((num_eight(q) & first) | (num_eight(q + 1) & ~first), &mantissa);
        q += digits + 1;
        if (digits > 0 && (unsigned char)*q < '0') { /* neither a further digit nor an exponent */
            *value = num_of_digits(negative, mantissa, (size_t)(digits - before));
            return q;
        }
    }
    return num_long(p, value);
}

/*
 * num_plain of a number that has as many digits before and behind the point as the one read before
 * it, as columns of one program nearly always have: a sixth less time there, for the processor
 * guesses where it ends; half as much again where that varies.
 */
static inline const char *num_even(const char *p, double *value)
{
    bool negative = *p == '-';
    const char *first = p += negative;
    uint64_t mantissa = 0;
    size_t digits, decimals = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        mantissa = mantissa * 10 + (uint64_t)(*p - '0');
    digits = (size_t)(p - first);
    if (*p == '.') {
        for (first = ++p; *p >= '0' && *p <= '9'; p++)
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
        decimals = (size_t)(p - first);
        digits += decimals;
    }
    if (digits - 1 >= 15 || *p >= 'A') /* as in num_long */
        return NULL;
    *value = num_of_digits(negative, mantissa, decimals);
    return p;
}

/*
 * num_even of a number in a column whose numbers mostly have as many digits behind the point:
 * *behind, 0 before the first one, is how many of them are read at once.  Like num_plain it reads
 * up to eight characters after the number.
 */
static inline const char *num_in_column(const char *p, double *value, int *behind)
{
    bool negative = *p == '-';
    const char *first = p += negative;
    uint64_t mantissa = 0, more;
    size_t digits, decimals = 0;
    for (unsigned digit; (digit = num_digit(*p)) < 10; p++)
        mantissa = mantissa * 10 + digit;
    digits = (size_t)(p - first);
    if (*p == '.') {
        first = ++p;
        if (*behind > 0 && num_so_many_digits(num_eight(p), *behind, &more)) {
            mantissa = mantissa * num_scale[*behind] + more;
            p += *behind;
        }
        for (unsigned digit; (digit = num_digit(*p)) < 10; p++)
            mantissa = mantissa * 10 + digit;
        decimals = (size_t)(p - first);
        digits += decimals;
        if (decimals != (size_t)*behind)
            *behind = decimals < 8 ? (int)decimals : 8;
    }
    if (digits - 1 >= 15 || *p >= 'A') /* as in num_long */
        return NULL;
    *value = num_of_digits(negative, mantissa, decimals);
    return p;
}

/*
 * Skips a word that programs print for a value that is not finite: nan, inf and infinity in any
 * case, with a sign and followed by brackets (`-nan(ind)`), 1.#IND, 1.#QNAN, -1.#INF.  False leaves
 * *s.
 */
bool num_not_finite(const char **s);

/* True if the whole text is one finite number, with or without blanks around it. */
bool num_whole(const char *text, double *value);

enum { NUM_MAX = 352 }; /* room for any number that num_write writes, and its '\0' */

/*
 * Writes x with `digits` decimals (0 to 9) at buf, rounded half away from zero, with a decimal
 * point (none at digits 0), never an exponent, never -0; ends in '\0'; returns the length.
 */
size_t num_write(char *buf, double x, int digits);

/* num_write of a number that num_scaled has made whole. */
size_t num_put(char *buf, int64_t integer, bool negative, int digits);

/* Removes the trailing zeros from the n characters that num_write wrote; returns the length that is
 * left.  A whole number keeps its point if `point` is set: 12. */
size_t num_shorten(char *buf, size_t n, int digits, bool point);

/* num_write without trailing zeros; a whole number keeps its point if `point` is set: 12. 0.5 */
size_t num_write_short(char *buf, double x, int digits, bool point);

/*
 * The eight digits of n, below 10^8, a byte each, the first one lowest.  n is split into fours,
 * pairs and single digits by multiplication with 1 / 100 and 1 / 10, accurate enough to truncate.
 */
static inline uint64_t num_eight_digits(uint32_t n)
{
    uint64_t fours = n / 10000 | (uint64_t)(n % 10000) << 32;
    uint64_t hundreds = ((fours * 10486) >> 20) & 0x0000007f0000007f;
    uint64_t pairs = hundreds | (fours - 100 * hundreds) << 16;
    uint64_t tens = ((pairs * 103) >> 10) & 0x000f000f000f000f;
    return tens | (pairs - 10 * tens) << 8;
}

/* Stores eight bytes, the lowest first, on any processor. */
static inline void num_put_eight(char *to, uint64_t bytes)
{
    const char text[] = {(char)bytes,         (char)(bytes >> 8),  (char)(bytes >> 16),
                         (char)(bytes >> 24), (char)(bytes >> 32), (char)(bytes >> 40),
                         (char)(bytes >> 48), (char)(bytes >> 56)};
    memcpy(to, text, sizeof text);
}

/* num_put and num_shorten at once, without '\0'. */
size_t num_put_long(char *buf, int64_t integer, bool negative, int digits, bool point);

/* The same, but faster; up to NUM_MAX characters may be overwritten. */
static inline size_t num_put_short(char *buf, int64_t integer, bool negative, int digits,
                                   bool point)
{
    static const uint64_t character = 0x3030303030303030;
    if (integer >= 100000000 || digits > 7)
        return num_put_long(buf, integer, negative, digits, point);
    uint64_t digit = num_eight_digits((uint32_t)integer);
    unsigned ones = 8 * (7 - (unsigned)digits); /* bits before the last digit before the point */
    unsigned first = (unsigned)__builtin_ctzll(digit | UINT64_C(1) << ones) & 56;
    unsigned zeros = (unsigned)__builtin_clzll(digit | 1) / 8; /* at the end */
    char *to = buf;
    *to = '-';
    to += negative && integer != 0;
    num_put_eight(to, (digit + character) >> first);
    to += (ones - first) / 8 + 1;
    *to = '.';
    if (zeros < (unsigned)digits) {
        num_put_eight(to + 1, (digit + character) >> (ones + 8));
        to += 1 + (unsigned)digits - zeros;
    } else {
        to += point;
    }
    return (size_t)(to - buf);
}

/* num_units where the product, s, may be half a unit or was rounded to it, or is large. */
bool num_units_doubtful(double x, int digits, double s, double *whole);

/*
 * x * 10^digits rounded half away from zero, by the double that x is, where that is below 2^53, and
 * never -0; else false.  Below 2^51 a sum with 1.5 * 2^52 has no room for parts of one: it is
 * rounded to the nearest whole number, which tells all but halves.
 */
static inline bool num_units(double x, int digits, double *whole)
{
    const double no_parts = 6755399441055744.0, most = 2251799813685248.0;
    double s = x * num_ten[digits];
    *whole = (s + no_parts) - no_parts;
    if (__builtin_expect(fabs(s - *whole) < 0.5 && fabs(s) < most, 1))
        return true;
    return num_units_doubtful(x, digits, s, whole);
}

/* The same of |x|, as an integer.  Signed, for that is what processors convert at once. */
static inline bool num_scaled(double x, int digits, int64_t *integer)
{
    double whole;
    if (!num_units(fabs(x), digits, &whole))
        return false;
    *integer = (int64_t)whole;
    return true;
}

/* The value that num_write(x, digits) reads back as. */
static inline double num_round(double x, int digits)
{
    double whole;
    return num_units(x, digits, &whole) ? whole / num_ten[digits] : x;
}

#endif
