/*
 * elementary_power - exp, log, pow and what is made of them; see elementary.h.
 *
 * log: x = 2^k z, 1/z nearly one of 64 short numbers c, so that r = c z - 1 is exact in two
 * doubles, and Taylor's series of log(1 + r); exp: the nearest multiple of log 2 / 32, and Taylor's
 * series (after Tang, ACM TOMS 15 and 16).  The sums are kept in two doubles, for pow.
 */
#include "math/elementary.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "double_double.h"

/* ---- log, exp */

/* c of 10 digits, -log c in a part whose sum with k log 2 is exact, and the rest of it. */
static const struct near_reciprocal {
    double c, high, low;
} RECIPROCAL[64] = {{0x1.68p0, -0x1.5d1bdbf58p-2, -0x1.394a11b1c1ee4p-43},
                    {0x1.64p0, -0x1.51aad872ep-2, 0x1.f4bd8db0a7cc1p-44},
                    {0x1.608p0, -0x1.478cd5959cp-2, 0x1.84dd903cdcbdap-43},
                    {0x1.5c8p0, -0x1.3bdd24eb14p-2, -0x1.6d425b478c893p-43},
                    {0x1.59p0, -0x1.31871c9544p-2, -0x1.84fab94cecfd9p-46},
                    {0x1.558p0, -0x1.27161913f8p-2, -0x1.4f4f1f61564b4p-44},
                    {0x1.52p0, -0x1.1c898c169ap-2, 0x1.81410e5c62affp-44},
                    {0x1.4e8p0, -0x1.11e0e2dadap-2, 0x1.a47f88fcce5bap-45},
                    {0x1.4bp0, -0x1.071b85fcd6p-2, 0x1.bcb8ba3e01a11p-44},
                    {0x1.478p0, -0x1.f871b28954p-3, -0x1.045014ad6c881p-43},
                    {0x1.448p0, -0x1.e598ed5a88p-3, 0x1.d134bcf1e98a1p-47},
                    {0x1.41p0, -0x1.cf6354e09cp-3, -0x1.771239a07d55bp-45},
                    {0x1.3ep0, -0x1.bc286742d8p-3, -0x1.9ac53f39d121cp-44},
                    {0x1.3bp0, -0x1.a8becfc884p-3, 0x1.0e73d186f2318p-43},
                    {0x1.38p0, -0x1.9525a9cf44p-3, -0x1.6b47641307539p-43},
                    {0x1.35p0, -0x1.815c0a1434p-3, -0x1.7ead6836ff18cp-43},
                    {0x1.32p0, -0x1.6d60fe719cp-3, -0x1.21c8d54765c4dp-43},
                    {0x1.2f8p0, -0x1.5c94007598p-3, 0x1.a8d948cd23322p-44},
                    {0x1.2c8p0, -0x1.483bccce7p-3, 0x1.c22b5b1b81393p-43},
                    {0x1.2ap0, -0x1.371fc201e8p-3, -0x1.ee8779b2d8abcp-44},
                    {0x1.27p0, -0x1.2266f190a4p-3, -0x1.acb7d51efc602p-43},
                    {0x1.248p0, -0x1.10f8e42254p-3, 0x1.93b3843396307p-45},
                    {0x1.22p0, -0x1.fec9131dcp-4, 0x1.54555d1ae6607p-44},
                    {0x1.1f8p0, -0x1.db5270188p-4, 0x1.36c43d4a8f3fp-43},
                    {0x1.1dp0, -0x1.b78c82bb1p-4, 0x1.25ef7bc3987e7p-44},
                    {0x1.1a8p0, -0x1.9375e55598p-4, 0x1.0911e463f9e4ep-43},
                    {0x1.18p0, -0x1.6f0d28ae58p-4, 0x1.4b4641b664613p-44},
                    {0x1.158p0, -0x1.4a50d3aa18p-4, -0x1.82007b3dda307p-43},
                    {0x1.138p0, -0x1.2cb0283f6p-4, 0x1.0f08e9acd47efp-43},
                    {0x1.11p0, -0x1.075983599p-4, 0x1.b8ecfe4b59987p-44},
                    {0x1.0fp0, -0x1.d276b8adbp-5, -0x1.6a423c78a64bp-46},
                    {0x1.0c8p0, -0x1.868a83084p-5, 0x1.2623a134ac693p-46},
                    {0x1.0a8p0, -0x1.494acc34ep-5, 0x1.bb8e1d6a40b6ep-43},
                    {0x1.08p0, -0x1.f829b0e78p-6, -0x1.980267c7e09e4p-45},
                    {0x1.06p0, -0x1.7b91b07d6p-6, 0x1.3b955b602ace4p-44},
                    {0x1.04p0, -0x1.fc0a8b0fcp-7, -0x1.f1e7cf6d3a69cp-50},
                    {0x1.02p0, -0x1.fe02a6b1p-8, -0x1.9e23f0dda40e4p-46},
                    {1, 0, 0},
                    {0x1.f8p-1, 0x1.020565894p-6, -0x1.4f716c1b8bdf5p-43},
                    {0x1.f08p-1, 0x1.f7a9b1678p-6, 0x1.42ad9271be7d7p-45},
                    {0x1.e9p-1, 0x1.788595a35p-5, 0x1.dee9e5ef898b6p-43},
                    {0x1.e2p-1, 0x1.eea31c007p-5, -0x1.1e113e4fc93b8p-43},
                    {0x1.dbp-1, 0x1.333d7f818p-4, 0x1.fa5b5255f91dfp-43},
                    {0x1.d4p-1, 0x1.700d30aebp-4, -0x1.f8f85c959884bp-43},
                    {0x1.cd8p-1, 0x1.a956d3ecbp-4, -0x1.0ce4359fe9da8p-43},
                    {0x1.c7p-1, 0x1.e3707ee308p-4, -0x1.bc25ec6626551p-43},
                    {0x1.c1p-1, 0x1.0ce7ecdcccp-3, 0x1.4652dabff5447p-46},
                    {0x1.bbp-1, 0x1.28753bc11cp-3, -0x1.45b58e5367e8dp-43},
                    {0x1.b5p-1, 0x1.4462b9dc9cp-3, -0x1.84858a711b062p-44},
                    {0x1.afp-1, 0x1.60b3100b08p-3, 0x1.475d49b3b83f6p-43},
                    {0x1.a98p-1, 0x1.7b00916514p-3, 0x1.28c501a7cc0d4p-43},
                    {0x1.a4p-1, 0x1.95a5adcf7p-3, 0x1.7f22858a0ff6fp-47},
                    {0x1.9e8p-1, 0x1.b0a4b48fcp-3, 0x1.b4634a8f199c5p-43},
                    {0x1.998p-1, 0x1.c97f8079d4p-3, 0x1.3b161a8c6e6c5p-45},
                    {0x1.948p-1, 0x1.e2a877a6b4p-3, -0x1.3ee3f443c7bf3p-43},
                    {0x1.8f8p-1, 0x1.fc218be62p-3, 0x1.4bba46f1cf6ap-44},
                    {0x1.8a8p-1, 0x1.0af660eb9ep-2, 0x1.3c7c3f528d80ap-45},
                    {0x1.86p-1, 0x1.16b5ccbadp-2, -0x1.23299042d74bfp-44},
                    {0x1.818p-1, 0x1.22981fbef8p-2, -0x1.a1421609580dap-44},
                    {0x1.7dp-1, 0x1.2e9e2bce12p-2, 0x1.4300c128d1dc2p-45},
                    {0x1.788p-1, 0x1.3ac8ca38e6p-2, -0x1.d0befbc02be4ap-45},
                    {0x1.748p-1, 0x1.45b8c0a17ep-2, -0x1.d9120e7d0a853p-47},
                    {0x1.7p-1, 0x1.522ae0738ap-2, 0x1.ebe708164c759p-45},
                    {0x1.6cp-1, 0x1.5d5bddf596p-2, -0x1.a0b2a08a465dcp-47}};

static const struct pair LOG_2 = {0x1.62e42fefa4p-1, -0x1.8432a1b0e2634p-43};
static const struct pair LOG10_E = {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/* Of a finite x > 0. */
static struct pair log_pair(double x)
{
    const uint64_t root_half = 0x3fe6a09e667f3bcd; /* z is in [sqrt(1/2), sqrt(2)) */
    int k = 0;
    uint64_t bits;
    double z;

    if (x < 0x1p-1000) {
        x *= 0x1p100;
        k = -100;
    }
    memcpy(&bits, &x, sizeof bits);
    uint64_t above = bits - root_half;
    int binary = (int)(above >> 52);
    k += binary >= 2048 ? binary - 4096 : binary;
    bits -= above & (uint64_t)0xfff << 52;
    memcpy(&z, &bits, sizeof z);
    struct near_reciprocal near = RECIPROCAL[above >> 46 & 63];
    struct pair part = halves(z);
    struct pair r = two_sum(part.high * near.c - 1, part.low * near.c);
    struct pair square = two_product(r.high, r.high);
    double y = r.high;
    double rest =
        y * square.high *
        (1.0 / 3 +
         y * (-1.0 / 4 +
              y * (1.0 / 5 + y * (-1.0 / 6 + y * (1.0 / 7 + y * (-1.0 / 8 + y * (1.0 / 9)))))));
    struct pair a = two_sum(k * LOG_2.high + near.high, r.high);
    struct pair b = two_sum(a.high, -0.5 * square.high);
    double low = (k * LOG_2.low + near.low) + (r.low - r.high * r.low) - 0.5 * square.low;
    return quick_sum(b.high, b.low + (a.low + (low + rest)));
}

/* 2^(j/32), in two doubles. */
static const struct pair POWER[32] = {{1, 0},
                                      {0x1.059b0d3158574p0, 0x1.d73e2a475b465p-55},
                                      {0x1.0b5586cf9890fp0, 0x1.8a62e4adc610bp-54},
                                      {0x1.11301d0125b51p0, -0x1.6c51039449b3ap-54},
                                      {0x1.172b83c7d517bp0, -0x1.19041b9d78a76p-55},
                                      {0x1.1d4873168b9aap0, 0x1.e016e00a2643cp-54},
                                      {0x1.2387a6e756238p0, 0x1.9b07eb6c70573p-54},
                                      {0x1.29e9df51fdee1p0, 0x1.612e8afad1255p-55},
                                      {0x1.306fe0a31b715p0, 0x1.6f46ad23182e4p-55},
                                      {0x1.371a7373aa9cbp0, -0x1.63aeabf42eae2p-54},
                                      {0x1.3dea64c123422p0, 0x1.ada0911f09ebcp-55},
                                      {0x1.44e086061892dp0, 0x1.89b7a04ef80dp-59},
                                      {0x1.4bfdad5362a27p0, 0x1.d4397afec42e2p-56},
                                      {0x1.5342b569d4f82p0, -0x1.07abe1db13cadp-55},
                                      {0x1.5ab07dd485429p0, 0x1.6324c054647adp-54},
                                      {0x1.6247eb03a5585p0, -0x1.383c17e40b497p-54},
                                      {0x1.6a09e667f3bcdp0, -0x1.bdd3413b26456p-54},
                                      {0x1.71f75e8ec5f74p0, -0x1.16e4786887a99p-55},
                                      {0x1.7a11473eb0187p0, -0x1.41577ee04992fp-55},
                                      {0x1.82589994cce13p0, -0x1.d4c1dd41532d8p-54},
                                      {0x1.8ace5422aa0dbp0, 0x1.6e9f156864b27p-54},
                                      {0x1.93737b0cdc5e5p0, -0x1.75fc781b57ebcp-57},
                                      {0x1.9c49182a3f09p0, 0x1.c7c46b071f2bep-56},
                                      {0x1.a5503b23e255dp0, -0x1.d2f6edb8d41e1p-54},
                                      {0x1.ae89f995ad3adp0, 0x1.7a1cd345dcc81p-54},
                                      {0x1.b7f76f2fb5e47p0, -0x1.5584f7e54ac3bp-56},
                                      {0x1.c199bdd85529cp0, 0x1.11065895048ddp-55},
                                      {0x1.cb720dcef9069p0, 0x1.503cbd1e949dbp-56},
                                      {0x1.d5818dcfba487p0, 0x1.2ed02d75b3707p-55},
                                      {0x1.dfc97337b9b5fp0, -0x1.1a5cd4f184b5cp-54},
                                      {0x1.ea4afa2a490dap0, -0x1.e9c23179c2893p-54},
                                      {0x1.f50765b6e454p0, 0x1.9d3e12dd8a18bp-54}};

static const struct pair STEP = {0x1.62e42fefap-6, 0x1.cf79abc9e3b3ap-45}; /* log 2 / 32 */
static const double PER_STEP = 0x1.71547652b82fep5;

/* e^(x + low), a small low. */
static double exp_pair(double x, double low)
{
    const double whole = 0x1.8p52;

    if (x > 710)
        return HUGE_VAL;
    if (x < -746)
        return 0;
    double n = (x * PER_STEP + whole) - whole;
    int k = (int)n, j = k & 31;
    struct pair r = two_sum(x - n * STEP.high, low - n * STEP.low);
    double y = r.high;
    double rest =
        r.low + y * y *
                    (1.0 / 2 +
                     y * (1.0 / 6 + y * (1.0 / 24 + y * (1.0 / 120 + y * (1.0 / 720 + y / 5040)))));
    double value = POWER[j].high + (POWER[j].high * y + (POWER[j].low + POWER[j].high * rest));
    int binary = (k - j) / 32;
    if (binary < -1000 || binary > 1000)
        return ldexp(value, binary);
    uint64_t bits = (uint64_t)(1023 + binary) << 52;
    double scale;
    memcpy(&scale, &bits, sizeof scale);
    return value * scale;
}

double elementary_exp(double x)
{
    return isnan(x) ? x : exp_pair(x, 0);
}

/* log of what has none or an infinite one: x is NaN, infinite, or not above zero. */
static double log_special(double x)
{
    if (isnan(x) || x > 0)
        return x;
    return x < 0 ? (x - x) / 0.0 : -HUGE_VAL;
}

static bool has_log(double x)
{
    return x > 0 && x <= 0x1.fffffffffffffp1023;
}

double elementary_log(double x)
{
    if (!has_log(x))
        return log_special(x);
    struct pair l = log_pair(x);
    return l.high + l.low;
}

double elementary_log10(double x)
{
    if (!has_log(x))
        return log_special(x);
    struct pair l = log_pair(x), p = two_product(l.high, LOG10_E.high);
    return p.high + (p.low + (l.high * LOG10_E.low + l.low * LOG10_E.high));
}

double elementary_log1p(double x)
{
    if (!(x > -1) || isinf(x))
        return x < -1 || isnan(x) ? log_special(x) : log_special(1 + x);
    if (fabs(x) < 0x1p-54)
        return x;
    struct pair s = two_sum(1, x), l = log_pair(s.high);
    return l.high + (l.low + s.low / s.high);
}

/* ---- pow */

static bool is_whole(double y)
{
    return fabs(y) >= 0x1p52 || floor(y) - y >= 0;
}

static bool is_odd(double y)
{
    return fabs(y) < 0x1p53 && is_whole(y) && fabs(fmod(y, 2)) > 0.5;
}

/* |x|^y for a finite x that is not 0 and a finite y. */
static double pow_of_size(double x, double y)
{
    struct pair l = log_pair(fabs(x));
    if (fabs(y) * fabs(l.high) > 1000)
        return (y > 0) == (l.high > 0) ? HUGE_VAL : 0;
    struct pair p = two_product(y, l.high);
    return exp_pair(p.high, p.low + y * l.low);
}

double elementary_pow(double x, double y)
{
    double size = fabs(x);

    if (fabs(y) <= 0 || (x >= 1 && x <= 1))
        return 1;
    if (isnan(x) || isnan(y))
        return x + y;
    if (isinf(y))
        return size >= 1 && size <= 1 ? 1 : (size > 1) == (y > 0) ? HUGE_VAL : 0;
    bool negative = signbit(x) && is_odd(y);
    if (size <= 0 || isinf(x)) {
        double value = (size > 0) == (y > 0) ? HUGE_VAL : 0;
        return negative ? -value : value;
    }
    if (x < 0 && !is_whole(y))
        return (x - x) / (x - x);
    double value = pow_of_size(x, y);
    return negative ? -value : value;
}

/* ---- hyperbolic */

double elementary_sinh(double x)
{
    double size = fabs(x), y = x * x;

    if (size < 1) {
        double term = 0; /* Taylor's series, from its last term that counts */
        for (int n = 20; n >= 2; n -= 2)
            term = (1 + term) * y / (n * (n + 1));
        return x + x * term;
    }
    double e = size > 700 ? elementary_exp(size / 2) : elementary_exp(size);
    double value = size > 700 ? 0.5 * e * e : 0.5 * (e - 1 / e);
    return copysign(value, x);
}

double elementary_cosh(double x)
{
    double size = fabs(x);
    double e = size > 700 ? elementary_exp(size / 2) : elementary_exp(size);

    return size > 700 ? 0.5 * e * e : 0.5 * (e + 1 / e);
}

double elementary_asinh(double x)
{
    double size = fabs(x);
    double value = size > 0x1p28
                       ? elementary_log(size) + elementary_log(2)
                       : elementary_log1p(size + size * size / (1 + sqrt(1 + size * size)));

    return isnan(x) ? x : copysign(value, x);
}
