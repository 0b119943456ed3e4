/* elementary against long double, which has 11 digits more (64 in all, or 113), on millions of
 * arguments; and against values known exactly. */
#include <check.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "math/elementary.h"

#include "elementary_bits.h"
#include "seed.h"

enum { CASES = 200000 };

static uint64_t state;

static double uniform(double from, double to)
{
    state = state * 6364136223846793005u + seed_step();
    return from + (to - from) * ((double)(state >> 11) * 0x1p-53);
}

/* Of any size from 2^low to 2^high, either sign if asked. */
static double of_any_size(double low, double high, bool either)
{
    double size = ldexp(1, (int)floor(uniform(low, high))) * uniform(1, 2);
    return either && uniform(0, 1) < 0.5 ? -size : size;
}

/* |value - truth| in units of truth's last place as a double. */
static double ulps(double value, long double truth)
{
    int e;
    frexpl(truth, &e);
    if (e < -1021)
        e = -1021;
    return (double)(fabsl((long double)value - truth) / ldexpl(1, e - 53));
}

static double worst, worst_at;

static void compare(double x, double value, long double truth)
{
    double off = ulps(value, truth);
    if (!(off <= worst)) {
        worst = off;
        worst_at = x;
    }
}

static void expect_below(const char *name, double bound)
{
    if (getenv("ELEMENTARY_SHOW"))
        printf("%-8s %.4f ulp, at %a\n", name, worst, worst_at);
    ck_assert_msg(worst <= bound, "%s: %g ulp at %a", name, worst, worst_at);
    worst = 0;
}

static bool has_long_double(void)
{
    return LDBL_MANT_DIG >= 64;
}

static void begin(void)
{
    state = 1;
    worst = 0;
}

START_TEST(angles_against_long_double)
{
    static const double range[] = {0.8, 7, 700, 1e6, 1e9};
    for (size_t k = 0; k < sizeof range / sizeof *range; k++) {
        for (int i = 0; i < CASES; i++) {
            double x = uniform(-range[k], range[k]);
            compare(x, elementary_sin(x), sinl((long double)x));
            compare(x, elementary_cos(x), cosl((long double)x));
        }
        expect_below("sin, cos", 0.85);
        for (int i = 0; i < CASES / 4; i++) {
            double x = uniform(-range[k], range[k]);
            compare(x, elementary_tan(x), tanl((long double)x));
        }
        expect_below("tan", 0.95);
    }
    for (int i = 0; i < CASES; i++) {
        double x = of_any_size(-60, 900, true);
        compare(x, elementary_sin(x), sinl((long double)x));
        compare(x, elementary_cos(x), cosl((long double)x));
    }
    expect_below("sin, cos", 0.85);
}
END_TEST

START_TEST(beside_multiples_of_a_quarter_turn)
{
    for (int n = 1; n < 200000; n++) {
        double x = (double)(n * (acosl(-1) / 2));
        compare(x, elementary_sin(x), sinl((long double)x));
        compare(x, elementary_cos(x), cosl((long double)x));
    }
    expect_below("sin, cos", 0.85);
}
END_TEST

START_TEST(inverses_against_long_double)
{
    for (int i = 0; i < 4 * CASES; i++) {
        double x = of_any_size(-20, 20, true), y = of_any_size(-20, 20, true);
        compare(y, elementary_atan2(y, x), atan2l((long double)y, (long double)x));
        x = uniform(-1, 1), y = uniform(-1, 1);
        compare(y, elementary_atan2(y, x), atan2l((long double)y, (long double)x));
    }
    expect_below("atan2", 0.53);
    for (int i = 0; i < CASES; i++) {
        double x = of_any_size(-1000, 1000, true), y = of_any_size(-1000, 1000, true);
        compare(y, elementary_atan2(y, x), atan2l((long double)y, (long double)x));
    }
    expect_below("atan2", 0.6);
    for (int i = 0; i < 2 * CASES; i++) {
        double x = i % 2 ? uniform(-1, 1) : 1 - of_any_size(-50, 0, false);
        compare(x, elementary_asin(x), asinl((long double)x));
        compare(x, elementary_acos(x), acosl((long double)x));
    }
    expect_below("asin, acos", 0.53);
}
END_TEST

START_TEST(exponentials_against_long_double)
{
    for (int i = 0; i < CASES; i++) {
        double x = i % 2 ? uniform(-700, 700) : of_any_size(-50, 8, true);
        compare(x, elementary_exp(x), expl((long double)x));
    }
    expect_below("exp", 0.53);
    for (int i = 0; i < CASES; i++) {
        double x = i % 2 ? of_any_size(-1074, 1023, false) : uniform(0.5, 2);
        compare(x, elementary_log(x), logl((long double)x));
        compare(x, elementary_log10(x), log10l((long double)x));
    }
    expect_below("log, log10", 0.53);
    for (int i = 0; i < CASES; i++) {
        double x = i % 2 ? of_any_size(-60, 20, false) : uniform(-0.99, 1);
        compare(x, elementary_log1p(x), log1pl((long double)x));
    }
    expect_below("log1p", 1);
    for (int i = 0; i < 2 * CASES; i++) {
        double x = of_any_size(i % 2 ? -2 : -30, i % 2 ? 2 : 30, false);
        double y = uniform(-1, 1) * (i % 2 ? 300 : 20);
        compare(x, elementary_pow(x, y), powl((long double)x, (long double)y));
    }
    expect_below("pow", 0.53);
}
END_TEST

START_TEST(hyperbolics_against_long_double)
{
    for (int i = 0; i < CASES; i++) {
        double x = i % 2 ? uniform(-20, 20) : of_any_size(-30, 3, true);
        compare(x, elementary_sinh(x), sinhl((long double)x));
        compare(x, elementary_cosh(x), coshl((long double)x));
        compare(x, elementary_asinh(x), asinhl((long double)x));
    }
    expect_below("sinh, cosh, asinh", 2.5);
}
END_TEST

START_TEST(roots_against_long_double)
{
    for (int i = 0; i < 4 * CASES; i++) {
        double x = of_any_size(-20, 20, true), y = of_any_size(-20, 20, true);
        compare(x, elementary_hypot(x, y), sqrtl((long double)x * x + (long double)y * y));
    }
    expect_below("hypot", 0.6);
    for (int i = 0; i < CASES; i++) {
        double x = of_any_size(-1000, 1000, true);
        compare(x, elementary_cbrt(x), cbrtl((long double)x));
    }
    expect_below("cbrt", 0.6);
}
END_TEST

static void same(double a, double b)
{
    ck_assert_msg((isnan(a) && isnan(b)) || (a <= b && a >= b && signbit(a) == signbit(b)),
                  "%a instead of %a", a, b);
}

/* What C11, annex F says, for every pair of special arguments: as the C library has it. */
START_TEST(special_values)
{
    static const double x[] = {0.0,    -0.0,       1,        -1,        0.5,    -0.5,   2,
                               -2,     3,          -3,       1e300,     -1e300, 5e-324, -5e-324,
                               0x1p53, 0x1p53 + 2, INFINITY, -INFINITY, NAN};
    enum { N = sizeof x / sizeof *x };
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < N; k++) {
            same(elementary_atan2(x[i], x[k]), (atan2)(x[i], x[k]));
            same(elementary_pow(x[i], x[k]), (pow)(x[i], x[k]));
            same(elementary_hypot(x[i], x[k]), (hypot)(x[i], x[k]));
            if (!(isnan(x[i]) && isnan(x[k])) && !(fabs(x[i]) <= 0 && fabs(x[k]) <= 0)) {
                same(elementary_fmax(x[i], x[k]), (fmax)(x[i], x[k]));
                same(elementary_fmin(x[i], x[k]), (fmin)(x[i], x[k]));
            }
        }
        if (fabs(x[i]) > 1e-300 && fabs(x[i]) < 1e300 && !(fabs(x[i]) >= 1 && fabs(x[i]) <= 1))
            continue;
        if (fabs(x[i]) < 1 || !isfinite(x[i])) {
            same(elementary_sin(x[i]), (sin)(x[i]));
            same(elementary_cos(x[i]), (cos)(x[i]));
            same(elementary_tan(x[i]), (tan)(x[i]));
            same(elementary_sinh(x[i]), (sinh)(x[i]));
            same(elementary_cosh(x[i]), (cosh)(x[i]));
            same(elementary_asinh(x[i]), (asinh)(x[i]));
        }
        same(elementary_asin(x[i]), (asin)(x[i]));
        same(elementary_acos(x[i]), (acos)(x[i]));
        same(elementary_exp(x[i]), (exp)(x[i]));
        same(elementary_log(x[i]), (log)(x[i]));
        same(elementary_log10(x[i]), (log10)(x[i]));
        same(elementary_log1p(x[i]), (log1p)(x[i]));
        if (fabs(x[i]) > 1e-300 || fabs(x[i]) <= 0 || isnan(x[i]))
            same(elementary_cbrt(x[i]), (cbrt)(x[i]));
    }
}
END_TEST

START_TEST(what_is_exact)
{
    for (int n = 0; n <= 22; n++) {
        double power = elementary_pow(10, n);
        same(power, strtod((char[8]){'1', 'e', (char)('0' + n / 10), (char)('0' + n % 10)}, NULL));
        same(elementary_log10(power), n);
        same(elementary_pow(10, -n), 1 / power);
    }
    for (int a = 1; a < 200; a++) {
        same(elementary_cbrt(a * a * a), a);
        same(elementary_pow(a, 3), a * a * a);
        same(elementary_hypot(3 * a, -4 * a), 5 * a);
        same(elementary_atan2(a, a), 0x1.921fb54442d18p-1);
        same(elementary_atan2(a, -a), 0x1.2d97c7f3321d2p1);
    }
    same(elementary_acos(0.5), 0x1.0c152382d7366p0); /* pi/3 */
    same(elementary_sin(0x1.921fb54442d18p1), 0x1.1a62633145c07p-53);
    same(elementary_sin(1e22), -0.8522008497671888); /* Ng, 1992 */
}
END_TEST

/* To the bit as each of them alone, of angles of any size, beside quarter turns, of what is
 * none. */
START_TEST(sine_and_cosine_at_once)
{
    const double odd[] = {0, -0.0, 1e-320, 0x1p-27, 1e300, HUGE_VAL, NAN};
    enum { ODD = sizeof odd / sizeof *odd };
    for (int i = 0; i < 300000; i++) {
        double x = i % 3 == 0   ? uniform(-8, 8)
                   : i % 3 == 1 ? of_any_size(-40, 60, true)
                                : i % 99 * 0x1.921fb54442d18p-1 * (1 + uniform(-1, 1) * 1e-15);
        x = i % 100 ? x : odd[i / 100 % ODD];
        struct sine_cosine both = elementary_sine_cosine(x);
        same(both.sine, elementary_sin(x));
        same(both.cosine, elementary_cos(x));
    }
}
END_TEST

/* As hypot itself is compared, also with limits that are hypot to the last digit or beside it, of
 * any size, and with what is no number. */
START_TEST(hypot_compared)
{
    const double odd[] = {0, -0.0, 1e-320, 1e300, HUGE_VAL, -HUGE_VAL, NAN};
    enum { ODD = sizeof odd / sizeof *odd };
    for (int i = 0; i < 200000; i++) {
        int low = i % 3 ? -3 : -1000, high = i % 3 ? 3 : 1000;
        double x = i % 50 ? of_any_size(low, high, true) : odd[i / 50 % ODD];
        double y = i % 70 ? of_any_size(low, high, true) : odd[i / 70 % ODD];
        double h = elementary_hypot(x, y);
        const double limit[] = {h, nextafter(h, 0), nextafter(h, HUGE_VAL), h * uniform(-1, 2),
                                odd[i % ODD]};
        for (size_t k = 0; k < sizeof limit / sizeof *limit; k++)
            ck_assert_int_eq(hypot_compare(x, y, limit[k]), (h > limit[k]) - (h < limit[k]));
    }
}
END_TEST

/* The bits of 320,000 results, added up: the same on every machine. */
START_TEST(the_same_bits_everywhere)
{
    unsigned long long sum = elementary_bits();
    ck_assert_msg(sum == 0xa132187ce1e5c51e, "%#llx", sum);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("elementary");
    TCase *precise = tcase_create("against long double"), *t = tcase_create("values");
    tcase_add_checked_fixture(precise, begin, NULL);
    tcase_set_timeout(precise, 60);
    tcase_add_test(precise, angles_against_long_double);
    tcase_add_test(precise, beside_multiples_of_a_quarter_turn);
    tcase_add_test(precise, inverses_against_long_double);
    tcase_add_test(precise, exponentials_against_long_double);
    tcase_add_test(precise, hyperbolics_against_long_double);
    tcase_add_test(precise, roots_against_long_double);
    tcase_add_test(t, special_values);
    tcase_add_test(t, what_is_exact);
    tcase_add_test(t, sine_and_cosine_at_once);
    tcase_add_test(t, hypot_compared);
    tcase_add_test(t, the_same_bits_everywhere);
    if (has_long_double())
        suite_add_tcase(s, precise);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
