/*
 * floor - what the floors of reading share: decimals by a hand parser, and a cloud's rows out of
 * large blocks.  No checks: plain rows alone.
 */
#ifndef CLOUDMILL_BENCH_FLOOR_H
#define CLOUDMILL_BENCH_FLOOR_H

#include <string.h>
#include <unistd.h>

enum { FLOOR_CHUNK = 1 << 16 };

/* A sign, digits and a point, at most nine digits after it; where it ends. */
static inline const char *floor_number(const char *p, double *value)
{
    static const double ten[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    while (*p == ' ')
        p++;
    int negative = *p == '-';
    p += negative;
    long mantissa = 0, decimals = 0;
    for (; *p >= '0' && *p <= '9'; p++)
        mantissa = mantissa * 10 + (*p - '0');
    if (*p == '.')
        for (p++; *p >= '0' && *p <= '9'; p++, decimals++)
            mantissa = mantissa * 10 + (*p - '0');
    *value = (double)(negative ? -mantissa : mantissa) / ten[decimals];
    return p;
}

/* Hands each row `x y z` to take(), in the order of the file. */
static inline void floor_rows(int fd, void (*take)(double x, double y, double z))
{
    static char buffer[2 * FLOOR_CHUNK + 1];
    size_t have = 0;
    for (ssize_t n; (n = read(fd, buffer + have, FLOOR_CHUNK)) > 0;) {
        const char *p = buffer, *end = buffer + have + (size_t)n, *last = end;
        while (last > p && last[-1] != '\n')
            last--;
        while (p < last) {
            double x, y, z;
            p = floor_number(floor_number(floor_number(p, &x), &y), &z) + 1;
            take(x, y, z);
        }
        have = (size_t)(end - last);
        memmove(buffer, last, have);
    }
}

#endif
