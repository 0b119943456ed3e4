/* bits - prints the bits of 320,000 results of math/elementary.h, added up as by
 * check_elementary.c, for compilers that have no Check; portability.t. */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "math/elementary.h"

static uint64_t state;

static double uniform(double from, double to)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * ((double)(state >> 11) * 0x1p-53);
}

/* Of any size from 2^low to 2^high, either sign if asked. */
static double of_any_size(double low, double high, bool either)
{
    double size = ldexp(1, (int)floor(uniform(low, high))) * uniform(1, 2);
    return either && uniform(0, 1) < 0.5 ? -size : size;
}

int main(void)
{
    uint64_t sum = 0;
    state = 1;
    for (int i = 0; i < 20000; i++) {
        double x = of_any_size(-30, 30, true), y = uniform(-8, 8), z = uniform(-1, 1);
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
    printf("0x%llx\n", (unsigned long long)sum);
    return 0;
}
