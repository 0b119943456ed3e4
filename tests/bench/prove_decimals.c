/*
 * prove_decimals - num_read against strtod on so many hard decimal numbers (tests/lib/decimals.h),
 * and num_write of it, and of the half of a last digit before it, against printf; exit 1 where one
 * is not the same.
 *
 *     prove_decimals MILLIONS
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "decimals.h"

/* A tie, which printf rounds to the even digit and num_write away from zero. */
static int is_tie(double x, int digits)
{
    char text[400];
    int n = snprintf(text, sizeof text, "%.60f", x);
    const char *rest = n < (int)sizeof text ? strchr(text, '.') + 1 + digits : "";

    return rest[0] == '5' && strspn(rest + 1, "0") == strlen(rest + 1);
}

/* A coordinate that is a half of the last digit, as nearly as a double is, or as it was read. */
static int is_written(double value, uint64_t i)
{
    char text[NUM_MAX], truth[NUM_MAX];
    int digits = (int)(i % 7);
    double x = i % 2 ? value : (floor(value * num_ten[digits]) + 0.5) / num_ten[digits];

    if (!(fabs(x) < 1e9))
        return 1;
    num_write(text, x, digits);
    snprintf(truth, sizeof truth, "%.*f", digits,
             is_tie(x, digits) ? nextafter(x, x < 0 ? -HUGE_VAL : HUGE_VAL) : x);
    if (strcmp(text, truth) == 0 || strtod(truth, NULL) == 0) /* it writes no -0 */
        return 1;
    printf("%.17g: written as %s, expected %s\n", x, text, truth);
    return 0;
}

int main(int argc, char **argv)
{
    uint64_t state = 88172645463325252u, n = argc > 1 ? strtoull(argv[1], NULL, 10) * 1000000 : 0;
    char text[DECIMAL_MAX];

    for (uint64_t i = 0; i < n; i++) {
        decimal_hard(&state, i, text);
        const char *p = text;
        double value = 0, truth = strtod(text, NULL);
        if (!num_read(&p, &value) || *p || memcmp(&value, &truth, sizeof value) != 0) {
            printf("%s: read as %.17g, expected %.17g\n", text, value, truth);
            return 1;
        }
        if (!is_written(value, i))
            return 1;
    }
    printf("%llu million numbers read as strtod reads them, written as printf does\n",
           (unsigned long long)n / 1000000);
    return 0;
}
