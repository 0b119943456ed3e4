/*
 * prove_decimals - num_read against strtod on so many hard decimal numbers (tests/lib/decimals.h);
 * exit 1 where one is not the same double.
 *
 *     prove_decimals MILLIONS
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "decimals.h"

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
    }
    printf("%llu million numbers read as strtod reads them\n", (unsigned long long)n / 1000000);
    return 0;
}
