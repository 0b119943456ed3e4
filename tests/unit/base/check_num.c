/* check_num - numbers as text: reading equals strtod's, writing rounds half away from zero. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "decimals.h"
#include "seed.h"

static uint64_t state = 88172645463325252u;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

START_TEST(reading_gives_the_nearest_double)
{
    for (uint64_t i = 0; i < 100000; i++) {
        char text[DECIMAL_MAX];
        decimal_hard(&state, i, text);
        const char *p = text;
        double value, truth = strtod(text, NULL);
        if (!num_read(&p, &value) || memcmp(&value, &truth, sizeof value) != 0 || *p != '\0')
            ck_abort_msg("%s: %.17g", text, value);
    }
}
END_TEST

/* Numbers of all lengths before and behind the point, with what may follow them in a row: the same
 * double and the same end as strtod's, or none; and none that strtod reads on from. */
START_TEST(plain_numbers_as_strtod)
{
    static const char *const follow[] = {" ", "\n", ",1", "\t", ";", "\r\n", ".", "e5", "E-3", "x"};
    for (int i = 0; i < 400000; i++) {
        char text[64] = {0}, *to = text;
        int before = i % 10, behind = i / 10 % 10, point = i / 100 % 3;
        if (i & 1024)
            *to++ = '-';
        for (int k = 0; k < before; k++)
            *to++ = (char)('0' + next_random() % 10 * (next_random() % 4 > 0));
        if (point)
            *to++ = '.';
        for (int k = 0; k < behind && point; k++)
            *to++ = (char)('0' + next_random() % 10 * (next_random() % 4 > 0));
        int kind = (int)(next_random() % (sizeof follow / sizeof *follow));
        strcpy(to, follow[kind]);
        char *end;
        double truth = strtod(text, &end);
        bool number = before + (point ? behind : 0) > 0, exponent = end != text && end > to;
        int as_many = behind < 8 ? behind : 8, other = (int)(next_random() % 9);
        for (int way = 0; way < 4; way++) {
            double value;
            const char *p = way == 0   ? num_plain(text, &value)
                            : way == 1 ? num_even(text, &value)
                                       : num_in_column(text, &value, way == 2 ? &as_many : &other);
            if (p ? p != end || memcmp(&value, &truth, sizeof value) != 0
                  : number && !exponent && before + behind < 15 && kind < 6)
                ck_abort_msg("%s: %.17g", text, value);
        }
        ck_assert(!point || other == (behind < 8 ? behind : 8));
    }
}
END_TEST

static const struct {
    const char *text;
    bool good;
    double value;
} spellings[] = {
    {"5", true, 5},
    {"5.", true, 5},
    {".5", true, .5},
    {"-.5", true, -.5},
    {"+3", true, 3},
    {"1e3", true, 1000},
    {"1D+03", true, 1000},
    {"1d-2", true, .01},
    {" 7 ", true, 7},
    {"", false, 0},
    {".", false, 0},
    {"-", false, 0},
    {"nan", false, 0},
    {"inf", false, 0},
    {"0x10", false, 0},
    {"1e999", false, 0},
    {"8x", false, 0},
    {"1e", false, 0},
    {"1,5", false, 0},
    {"--1", false, 0},
    {"0.000000000000000000000000000001", true, 1e-30},
    {"123456789012345678901234567890", true, 123456789012345678901234567890.0},
    {"9007199254740993", true, 9007199254740992.0}, /* half way: to even */
    {"9007199254740993.00000000000000000000000000000000001", true, 9007199254740994.0},
    {"4.9406564584124654e-324", true, 4.9406564584124654e-324},
    {"2.4703282292062327e-324", true, 0},
    {"1.7976931348623157e308", true, 1.7976931348623157e308},
    {"1e-99999999999", true, 0},
};

START_TEST(spellings_of_a_number)
{
    double value = 0;
    ck_assert_msg(num_whole(spellings[_i].text, &value) == spellings[_i].good, "%s",
                  spellings[_i].text);
    if (spellings[_i].good)
        ck_assert_msg(value == spellings[_i].value, "%s", spellings[_i].text);
}
END_TEST

static const struct {
    double x;
    int digits;
    const char *fixed, *brief, *pointed;
} writings[] = {
    {12, 3, "12.000", "12", "12."},
    {0.5, 3, "0.500", "0.5", "0.5"},
    {-0.0004, 3, "0.000", "0", "0."},
    {-0.0, 6, "0.000000", "0", "0."},
    {-3.25, 1, "-3.3", "-3.3", "-3.3"},
    {2.5, 0, "3", "3", "3."},
    {1234.5678, 2, "1234.57", "1234.57", "1234.57"},
    {100, 0, "100", "100", "100."},
    {0.001, 3, "0.001", "0.001", "0.001"},
    {-2840.9995, 3, "-2840.999", "-2840.999", "-2840.999"}, /* the double is below the half */
    {0.0015, 3, "0.002", "0.002", "0.002"},                 /* above it */
    {0.0125, 3, "0.013", "0.013", "0.013"},                 /* above it, too */
    {0.49999999999999994, 0, "0", "0", "0."},
    {99.9996, 3, "100.000", "100", "100."},
};

START_TEST(writings_of_a_number)
{
    char text[NUM_MAX];
    ck_assert_uint_eq(num_write(text, writings[_i].x, writings[_i].digits),
                      strlen(writings[_i].fixed));
    ck_assert_str_eq(text, writings[_i].fixed);
    num_write_short(text, writings[_i].x, writings[_i].digits, false);
    ck_assert_str_eq(text, writings[_i].brief);
    num_write_short(text, writings[_i].x, writings[_i].digits, true);
    ck_assert_str_eq(text, writings[_i].pointed);
}
END_TEST

/* Beside halves of the last digit it is what printf writes, which rounds by the double itself; but
 * for a tie, where both are as near. */
START_TEST(halves_are_rounded_by_the_double)
{
    for (int i = 0; i < 200000; i++) {
        char text[NUM_MAX], truth[NUM_MAX], decimal[NUM_MAX];
        int digits = (int)(next_random() % 7);
        snprintf(decimal, sizeof decimal, "%d.%0*d5", (int)(next_random() % 100000), digits,
                 digits > 0 ? (int)(next_random() % (uint64_t)num_ten[digits]) : 0);
        double x = strtod(digits > 0 ? decimal : strcat(strtok(decimal, "."), ".5"), NULL);
        bool tie = ldexp(x, 8) == floor(ldexp(x, 8)); /* only so are these exact */
        num_write(text, x, digits);
        snprintf(truth, sizeof truth, "%.*f", digits, tie ? nextafter(x, HUGE_VAL) : x);
        ck_assert_str_eq(text, truth);
    }
}
END_TEST

START_TEST(what_is_written_reads_back_as_rounded)
{
    for (int i = 0; i < 100000; i++) {
        char text[NUM_MAX];
        double x =
            (double)(int64_t)next_random() / (double)(UINT64_C(1) << (20 + next_random() % 40));
        int digits = (int)(next_random() % 10);
        num_write(text, x, digits);
        const char *p = text;
        double value;
        if (!num_read(&p, &value) || value != num_round(x, digits) ||
            !(fabs(value - x) <= 0.5000001 * pow(10, -digits) + 1e-15 * fabs(x)))
            ck_abort_msg("%.17g with %d digits: %s", x, digits, text);
    }
}
END_TEST

/* The quick way writes what the plain one does: all lengths, noughts at either end. */
START_TEST(short_numbers_alike)
{
    for (int i = 0; i < 400000; i++) {
        char text[NUM_MAX], brief[NUM_MAX];
        int64_t integer = (int64_t)(next_random() >> (11 + next_random() % 53));
        int digits = (int)(next_random() % 10);
        for (uint64_t k = next_random() % 4; k > 0 && i % 3 == 0; k--)
            integer = integer < INT64_C(100000000000) ? integer * 10 : integer;
        bool negative = i & 1, point = i & 2;
        size_t n = num_put(text, integer, negative, digits);
        n = num_shorten(text, n, digits, point);
        memset(brief, '#', sizeof brief);
        if (num_put_short(brief, integer, negative, digits, point) != n ||
            memcmp(text, brief, n) != 0)
            ck_abort_msg("%s", text);
    }
}
END_TEST

int main(void)
{
    state = seed_begin(state);
    Suite *suite = suite_create("num");
    TCase *tests = tcase_create("num");
    tcase_add_test(tests, reading_gives_the_nearest_double);
    tcase_add_test(tests, plain_numbers_as_strtod);
    tcase_add_loop_test(tests, spellings_of_a_number, 0,
                        (int)(sizeof spellings / sizeof *spellings));
    tcase_add_loop_test(tests, writings_of_a_number, 0, (int)(sizeof writings / sizeof *writings));
    tcase_add_test(tests, what_is_written_reads_back_as_rounded);
    tcase_add_test(tests, halves_are_rounded_by_the_double);
    tcase_add_test(tests, short_numbers_alike);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
