/*
 * bytes - numbers as binary files hold them, the low byte first, whatever the machine.
 */
#ifndef CLOUDMILL_BYTES_H
#define CLOUDMILL_BYTES_H

#include <stdint.h>
#include <string.h>

/* The whole number without a sign in the n bytes at p, n <= 8. */
static inline uint64_t bytes_whole(const char *p, int n)
{
    uint64_t value = 0;
    while (n-- > 0)
        value = value << 8 | (unsigned char)p[n];
    return value;
}

/* IEEE numbers of four and eight bytes. */
static inline double bytes_float(const char *p)
{
    uint32_t bits = (uint32_t)bytes_whole(p, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

static inline double bytes_double(const char *p)
{
    uint64_t bits = bytes_whole(p, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

#endif
