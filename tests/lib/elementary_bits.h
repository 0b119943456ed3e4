/* elementary_bits - the bits of 320,000 results of math/elementary.h, added up: one number that
 * tells whether a compiler or a machine computes them otherwise. */
#ifndef CLOUDMILL_TESTS_ELEMENTARY_BITS_H
#define CLOUDMILL_TESTS_ELEMENTARY_BITS_H

#include <stdbool.h>
#include <stdint.h>

#include "math/elementary.h"

static inline double elementary_bits_uniform(uint64_t *state, double from, double to)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * ((double)(*state >> 11) * 0x1p-53);
}

/* One of either sign, of any size from 2^-30 to 2^30. */
static inline double elementary_bits_any(uint64_t *state)
{
    int e = (int)floor(elementary_bits_uniform(state, -30, 30));
    double size = ldexp(1, e) * elementary_bits_uniform(state, 1, 2);
    return elementary_bits_uniform(state, 0, 1) < 0.5 ? -size : size;
}

static inline unsigned long long elementary_bits(void)
{
    uint64_t sum = 0, state = 1;
    for (int i = 0; i < 20000; i++) {
        double x = elementary_bits_any(&state), y = elementary_bits_uniform(&state, -8, 8),
               z = elementary_bits_uniform(&state, -1, 1);
        double f[] = {
            elementary_sin(x),         elementary_cos(y),       elementary_tan(y),
            elementary_atan2(x, y),    elementary_asin(z),      elementary_acos(z),
            elementary_exp(y),         elementary_log(fabs(x)), elementary_pow(fabs(x), y),
            elementary_hypot(x, y),    elementary_cbrt(x),      elementary_log10(fabs(x)),
            elementary_log1p(fabs(x)), elementary_sinh(y),      elementary_cosh(y),
            elementary_asinh(x)};
        for (size_t k = 0; k < sizeof f / sizeof *f; k++) {
            union {
                double number;
                uint64_t bits;
            } u = {.number = f[k]};
            sum = sum * 31 + u.bits;
        }
    }
    return sum;
}

#endif
