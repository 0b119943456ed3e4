/*
 * elementary_angle - sin, cos, tan and their inverses; see elementary.h.
 *
 * sin and cos: Cody and Waite's reduction to |r| <= pi/4, in two doubles; beyond 2^20 that of Payne
 * and Hanek; then polynomials through the Chebyshev nodes.  atan2: the ratio minus the nearest
 * k/16, by the tangent of a difference, and Taylor's series for what is left.
 */
#include "math/elementary.h"

#include <stdbool.h>
#include <stdint.h>

#include "double_double.h"

/* ---- an angle as quarter turns and what is left */

struct reduced {
    unsigned quarter;
    struct pair rest;
};

/* pi/2 in parts of 33 binary digits, so that up to 2^20 times a part is exact, and the rest
 * of it. */
static const double QUARTER[4] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69,
                                  0x1.b839a252049c1p-104};
#define QUARTER_HIGH 0x1.921fb54442d18p0
#define QUARTER_LOW 0x1.1a62633145c07p-54
static const double PER_QUARTER = 0x1.45f306dc9c883p-1; /* 2/pi */

static const double BIG = 0x1p20; /* from here on the parts are not enough */

static struct reduced reduce_small(double x)
{
    const double whole = 0x1.8p52; /* a number added to it is rounded to a whole one */
    double n = (x * PER_QUARTER + whole) - whole;
    double first = x - n * QUARTER[0];
    struct pair a = two_sum(first, -n * QUARTER[1]);
    struct pair b = two_sum(a.low, -n * QUARTER[2]);
    struct pair high = two_sum(a.high, b.high);

    return (struct reduced){(unsigned)(int)n & 3,
                            quick_sum(high.high, high.low + (b.low - n * QUARTER[3]))};
}

/* The binary digits of 2/pi after the point. */
static const uint32_t TWO_BY_PI[] = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

enum { WINDOW = 6 }; /* words of 32 digits that matter for one number */

/* The 32 digits of 2/pi behind the first `from`; zeros before the point. */
static uint32_t digits_behind(int from)
{
    int word = from >= 0 ? from / 32 : -((31 - from) / 32), shift = from - 32 * word;
    uint32_t a = word >= 0 ? TWO_BY_PI[word] : 0, b = word >= -1 ? TWO_BY_PI[word + 1] : 0;

    return shift == 0 ? a : a << shift | b >> (32 - shift);
}

/* |x| = m 2^e with m of 53 digits: the digits of 2/pi that make whole turns of it are left out, and
 * m times the next 192 are a fraction of a turn. */
static struct reduced reduce_big(double x)
{
    int e;
    uint64_t m = (uint64_t)ldexp(frexp(fabs(x), &e), 53);
    uint32_t factor[2] = {(uint32_t)m, (uint32_t)(m >> 32)};
    uint32_t turn[WINDOW + 2] = {0}; /* the last word first; all beyond WINDOW are whole turns */

    e -= 53;
    for (int i = 0; i < WINDOW; i++) {
        uint64_t digits = digits_behind(e - 2 + 32 * (WINDOW - 1 - i)), carry = 0;
        for (int j = 0; j < 2; j++) {
            uint64_t sum = digits * factor[j] + turn[i + j] + carry;
            turn[i + j] = (uint32_t)sum;
            carry = sum >> 32;
        }
        turn[i + 2] = (uint32_t)carry;
    }
    unsigned quarter = turn[WINDOW - 1] >> 30;
    bool up = turn[WINDOW - 1] >> 29 & 1; /* nearer to the next */
    double part[WINDOW];
    for (int i = 0; i < WINDOW; i++) {
        uint32_t word = i == WINDOW - 1 ? turn[i] & 0x3fffffff : turn[i];
        part[i] = ldexp((double)word, 32 * (i - WINDOW) + 2);
    }
    struct pair f = two_sum(part[WINDOW - 1] - up, part[WINDOW - 2]);
    for (int i = WINDOW - 3; i >= 0; i--) {
        struct pair s = two_sum(f.high, part[i]);
        f = quick_sum(s.high, s.low + f.low);
    }
    struct pair p = two_product(f.high, QUARTER_HIGH);
    struct pair r = quick_sum(p.high, p.low + (f.high * QUARTER_LOW + f.low * QUARTER_HIGH));
    quarter = quarter + up;
    if (x < 0)
        return (struct reduced){(4 - quarter) & 3, {-r.high, -r.low}};
    return (struct reduced){quarter & 3, r};
}

#define EIGHTH 0x1.921fb54442d18p-1 /* of a turn: pi/4 */

static struct reduced reduce(double x)
{
    if (fabs(x) <= EIGHTH)
        return (struct reduced){0, {x, 0}};
    return fabs(x) < BIG ? reduce_small(x) : reduce_big(x);
}

/* ---- sin, cos, tan */

/* sin r = r + low + the rest, which is of the order of r^3. */
static double sin_rest(struct pair r)
{
    double z = r.high * r.high;
    double s = -0x1.5555555555555p-3 +
               z * (0x1.111111111111p-7 +
                    z * (-0x1.a01a01a019937p-13 +
                         z * (0x1.71de3a54607a5p-19 +
                              z * (-0x1.ae64541295cdfp-26 +
                                   z * (0x1.61217ee5cca1bp-33 + z * (-0x1.ab17bdcbd33b3p-41))))));

    return r.high * z * s + (r.low - 0.5 * z * r.low);
}

/* cos r = 1 - half + the rest. */
static double cos_rest(struct pair r, double z, double half)
{
    double c = 0x1.5555555555555p-5 +
               z * (-0x1.6c16c16c16c16p-10 +
                    z * (0x1.a01a01a019d0ap-16 +
                         z * (-0x1.27e4fb7712ca2p-22 +
                              z * (0x1.1eed8deb82809p-29 +
                                   z * (-0x1.9394b9eb4d56dp-37 + z * (0x1.ab78473be5981p-45))))));
    double w = 1 - half;

    return ((1 - w) - half) + (z * z * c - r.high * r.low);
}

static double sin_kernel(struct pair r)
{
    return r.high + sin_rest(r);
}

static double cos_kernel(struct pair r)
{
    double z = r.high * r.high, half = 0.5 * z;

    return (1 - half) + cos_rest(r, z, half);
}

double elementary_sin(double x)
{
    if (!isfinite(x))
        return x - x;
    if (fabs(x) < 0x1p-27)
        return x;
    if (fabs(x) <= EIGHTH)
        return sin_kernel((struct pair){x, 0});
    struct reduced a = reduce(x);
    double value = a.quarter & 1 ? cos_kernel(a.rest) : sin_kernel(a.rest);
    return a.quarter & 2 ? -value : value;
}

double elementary_cos(double x)
{
    if (!isfinite(x))
        return x - x;
    struct reduced a = reduce(x);
    double value = a.quarter & 1 ? sin_kernel(a.rest) : cos_kernel(a.rest);
    return a.quarter == 1 || a.quarter == 2 ? -value : value;
}

struct sine_cosine elementary_sine_cosine(double x)
{
    if (!isfinite(x))
        return (struct sine_cosine){x - x, x - x};
    struct reduced a = reduce(x);
    double s = sin_kernel(a.rest), c = cos_kernel(a.rest);
    struct sine_cosine value =
        a.quarter & 1 ? (struct sine_cosine){c, s} : (struct sine_cosine){s, c};

    if (fabs(x) < 0x1p-27)
        value.sine = x;
    value.sine = a.quarter & 2 ? -value.sine : value.sine;
    value.cosine = a.quarter == 1 || a.quarter == 2 ? -value.cosine : value.cosine;
    return value;
}

double elementary_tan(double x)
{
    if (!isfinite(x))
        return x - x;
    if (fabs(x) < 0x1p-27)
        return x;
    struct reduced a = reduce(x);
    struct pair z = two_product(a.rest.high, a.rest.high);
    struct pair s = quick_sum(a.rest.high, sin_rest(a.rest));
    struct pair c = quick_sum(1, -0.5 * z.high);
    c = quick_sum(c.high, c.low - 0.5 * z.low + (cos_rest(a.rest, z.high, 0.5 * z.high) - c.low));
    struct pair t = a.quarter & 1 ? pair_ratio(c, s) : pair_ratio(s, c);
    return a.quarter & 1 ? -(t.high + t.low) : t.high + t.low;
}

/* ---- the inverses */

/* The arcs whose tangents are k/16, in two doubles. */
static const struct pair ARC[17] = {{0, 0},
                                    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                    {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
                                    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

/* The angle of the ratio q + low, which is small: q^3 (1/3 - ...) less. */
static double arc_rest(double q)
{
    double y = q * q;
    return q * y * (-1.0 / 3 + y * (1.0 / 5 + y * (-1.0 / 7 + y * (1.0 / 9 + y * (-1.0 / 11)))));
}

/* The angle of (most, least) in [0, pi/4], of lengths that neither overflow nor underflow: that of
 * k/16, and of z = (least - most k/16) / (most + least k/16).  Where k is 0 much of it is, too. */
static struct pair arc_of_ratio(double least, double most)
{
    int k = (int)(16 * ((float)least / (float)most) + 0.5F);
    if (k == 0) {
        double q = least / most;
        struct pair p = two_product(q, most);
        return quick_sum(q, ((least - p.high) - p.low) * (1 / most) + arc_rest(q));
    }
    double c = k / 16.0, product = c * most;
    struct pair m = halves(most), d = two_sum(most, c * least);
    struct pair n = two_sum(least, -product);
    double inverse = 1 / d.high, q = n.high / d.high;
    struct pair p = two_product(q, d.high);

    n.low -= (c * m.high - product) + c * m.low;
    double low = (((n.high - p.high) - p.low) + (n.low - q * d.low)) * inverse;
    struct pair a = quick_sum(ARC[k].high, q);
    return quick_sum(a.high, a.low + (low + (ARC[k].low + arc_rest(q))));
}

/* The angle of (x, |y|), from the axis that is nearest; lengths as above. */
static struct pair angle_of(double y, double x)
{
    static const struct {
        double sign;
        struct pair axis;
    } FROM[4] = {{1, {0, 0}},
                 {-1, {QUARTER_HIGH, QUARTER_LOW}},
                 {-1, {2 * QUARTER_HIGH, 2 * QUARTER_LOW}},
                 {1, {QUARTER_HIGH, QUARTER_LOW}}};
    double ax = fabs(x), ay = fabs(y);
    int steep = ay > ax, i = steep + 2 * (x < 0);
    struct pair a = arc_of_ratio(steep ? ax : ay, steep ? ay : ax);
    struct pair s = quick_sum(FROM[i].axis.high, FROM[i].sign * a.high);

    return quick_sum(s.high, s.low + (FROM[i].axis.low + FROM[i].sign * a.low));
}

/* Where one of them is zero, infinite or NaN, or their ratio is out of bounds. */
static double atan2_special(double y, double x)
{
    if (isnan(x) || isnan(y))
        return x + y;
    if (isinf(x)) /* as seen from far away */
        return elementary_atan2(copysign(isinf(y) ? 1 : 0, y), copysign(1, x));
    if (isinf(y))
        return copysign(QUARTER_HIGH, y);
    if (fabs(y) <= 0) /* also -0 */
        return signbit(x) ? copysign(2 * QUARTER_HIGH, y) : y;
    if (fabs(x) <= 0)
        return copysign(QUARTER_HIGH, y);
    int ex, ey;
    frexp(x, &ex);
    frexp(y, &ey);
    if (ey - ex > 60)
        return copysign(QUARTER_HIGH, y);
    if (ex - ey > 60)
        return x < 0 ? copysign(2 * QUARTER_HIGH, y) : y / x;
    return elementary_atan2(ldexp(y, -ey), ldexp(x, -ey));
}

double elementary_atan2(double y, double x)
{
    const double least = 0x1p-100, most = 0x1p100; /* squares of them are within a float, too */
    double ax = fabs(x), ay = fabs(y);

    if (!(ax > least && ax < most && ay > least && ay < most))
        return atan2_special(y, x);
    struct pair a = angle_of(y, x);
    return copysign(a.high + a.low, y);
}

/* The other side of the triangle: sqrt(1 - x^2), of |x| < 1.  On the unit circle an error of it
 * turns the angle by that times x. */
static struct pair other_side(double x)
{
    struct pair less = two_sum(1, -x), more = two_sum(1, x);
    struct pair p = two_product(less.high, more.high);
    double low = p.low + (less.high * more.low + less.low * more.high);
    double root = sqrt(p.high);
    struct pair square = two_product(root, root);

    return quick_sum(root, ((p.high - square.high) - square.low + low) / (2 * root));
}

double elementary_asin(double x)
{
    if (!(fabs(x) <= 1))
        return (x - x) / (x - x);
    if (fabs(x) < 0x1p-27)
        return x;
    if (fabs(x) >= 1)
        return copysign(QUARTER_HIGH, x);
    struct pair side = other_side(x), a = angle_of(x, side.high);
    return copysign(a.high + (a.low - fabs(x) * side.low), x);
}

double elementary_acos(double x)
{
    if (!(fabs(x) <= 1))
        return (x - x) / (x - x);
    if (fabs(x) >= 1)
        return x > 0 ? 0 : 2 * QUARTER_HIGH;
    struct pair side = other_side(x), a = angle_of(side.high, x);
    return a.high + (a.low + x * side.low);
}
