/* elementary - hypot and cbrt; see elementary.h. */
#include "math/elementary.h"

#include "double_double.h"

/* C. Borges, An improved algorithm for hypot(x, y), 2019: the root, and what its square lacks,
 * without a product of more than 53 digits. */
static double hypot_within(double x, double y)
{
    double h = sqrt(x * x + y * y), lacks;

    if (h <= 2 * y) {
        double d = h - y;
        lacks = x * (2 * d - x) + (d - 2 * (x - y)) * d;
    } else {
        double d = h - x;
        lacks = 2 * d * (x - 2 * y) + ((4 * d - y) * y + d * d);
    }
    return h - lacks / (2 * h);
}

double elementary_hypot(double x, double y)
{
    double a = fabs(x), b = fabs(y);

    if (isinf(a) || isinf(b))
        return HUGE_VAL;
    if (isnan(a) || isnan(b))
        return a + b;
    double most = elementary_fmax(a, b), least = elementary_fmin(a, b);
    if (least <= most * 0x1p-54)
        return a + b;
    if (most > 0x1p500)
        return 0x1p600 * hypot_within(0x1p-600 * most, 0x1p-600 * least);
    if (least < 0x1p-450)
        return 0x1p-600 * hypot_within(0x1p600 * most, 0x1p600 * least);
    return hypot_within(most, least);
}

double elementary_cbrt(double x)
{
    int e;

    if (!isfinite(x) || fabs(x) <= 0)
        return x;
    double m = frexp(fabs(x), &e); /* |x| = m 2^e, e a multiple of 3: m in [1/8, 1) */
    int over = ((e % 3) + 3) % 3;
    if (over > 0) {
        m = ldexp(m, over - 3);
        e += 3 - over;
    }
    double r = 0.45 + m * (0.95 - 0.4 * m);
    for (int i = 0; i < 4; i++) /* Halley: three times the digits in each step */
        r *= (r * r * r + 2 * m) / (2 * (r * r * r) + m);
    struct pair square = two_product(r, r), cube = two_product(r, square.high);
    r -= ((cube.high - m) + (cube.low + r * square.low)) / (3 * square.high);
    return copysign(ldexp(r, e / 3), x);
}
