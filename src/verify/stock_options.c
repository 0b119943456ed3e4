/* stock_options - see stock_options.h. */
#include "verify/stock_options.h"

#include <string.h>

#include "base/num.h"

#define MOST 1e5 /* mm */

/* Up to 6 numbers between commas; how many, -1: something else. */
static int numbers(const char *s, double value[6])
{
    for (int n = 0; n < 6; s++) {
        if (!num_read(&s, &value[n]) || !(fabs(value[n]) <= MOST))
            return -1;
        n++;
        if (!*s)
            return n;
        if (*s != ',')
            return -1;
    }
    return -1;
}

int stock_options_read(const char *text, struct stock_options *spec, struct error *error)
{
    bool box = strncmp(text, "box", 3) == 0;
    const char *rest = text + (box ? 3 : strncmp(text, "offset", 6) == 0 ? 6 : 0);
    double v[6];
    int n = rest == text ? -1 : !*rest ? 0 : strchr(",:", *rest) ? numbers(rest + 1, v) : -1;
    *spec = (struct stock_options){.kind = box ? STOCK_AROUND : STOCK_OFFSET};
    if (box && n == 6) {
        spec->kind = STOCK_BETWEEN;
        spec->low = vec(v[0], v[1], v[2]);
        spec->high = vec(v[3], v[4], v[5]);
        if (v[0] < v[3] && v[1] < v[4] && v[2] < v[5])
            return 0;
        return error_set(error, "found `%.80s`, expected the lower corner first", text);
    }
    if (n == 1 && (v[0] > 0 || (box && v[0] == 0)))
        spec->allowance = v[0];
    else if (!(box && n == 0))
        return error_set(
            error, "found `%.80s`, expected box, box,MM, box:X0,Y0,Z0,X1,Y1,Z1 or offset,MM", text);
    return 0;
}
