/*
 * check_num_exact - the nearest double to a decimal, against strtod and, where a number is half way
 * between two doubles, against the rule: the even one, and one digit more or less decides.
 */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num_exact.h"

enum { ROOM = 2000 };

static double exact(const char *text)
{
    return num_exact(text, text + strlen(text));
}

static void same(const char *text, double truth)
{
    double value = exact(text);
    ck_assert_msg(memcmp(&value, &truth, sizeof value) == 0, "%.60s: %.17g, not %.17g", text, value,
                  truth);
}

/* Powers of ten with digits around every border between the ways it is found: 19 digits, 5^27, the
 * least and the largest double. */
START_TEST(as_strtod_at_the_borders)
{
    static const char *const digits[] = {"1",
                                         "9",
                                         "999999999999999999",
                                         "1000000000000000001",
                                         "9999999999999999999",
                                         "18446744073709551615",
                                         "18446744073709551616",
                                         "10000000000000000000000000000000000000001",
                                         "4503599627370497",
                                         "9007199254740991"};
    static const int around[] = {-345, -324, -310, -308, -30, -28, -27, -26, -1,
                                 0,    1,    26,   27,   28,  29,  289, 300, 309};
    char text[ROOM];
    for (size_t i = 0; i < sizeof digits / sizeof *digits; i++)
        for (size_t k = 0; k < sizeof around / sizeof *around; k++) {
            snprintf(text, sizeof text, "%se%d", digits[i], around[k]);
            same(text, strtod(text, NULL));
            snprintf(text, sizeof text, "-.%se%d", digits[i], around[k]);
            same(text, strtod(text, NULL));
        }
}
END_TEST

/* Half way between x and the next double: 767 digits say it whole for the smallest; printf does. */
static void half_way(char *text, double x)
{
    double next = nextafter(x, HUGE_VAL);
    ck_assert_double_lt(x, 1); /* exact in long double below */
    long double half = ((long double)x + (long double)next) / 2;
    snprintf(text, ROOM, "%.1090Lf", half);
    size_t n = strlen(text);
    while (text[n - 1] == '0')
        text[--n] = '\0';
}

START_TEST(half_way_to_the_even_one)
{
#if __LDBL_MANT_DIG__ < 64
    return;
#endif
    static const double at[] = {0.1, 0.3, 1e-5, 1e-200, 2.2250738585072014e-308, 3e-308};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        char text[ROOM], more[ROOM + 2];
        double next = nextafter(at[i], HUGE_VAL);
        unsigned long long bits;
        memcpy(&bits, &at[i], sizeof bits);
        half_way(text, at[i]);
        same(text, bits % 2 == 0 ? at[i] : next);
        snprintf(more, sizeof more, "%s1", text);
        same(more, next);
        /* its last digit is 5: one less */
        text[strlen(text) - 1] = '4';
        same(text, at[i]);
    }
}
END_TEST

/* What stands beyond 772 digits decides too. */
START_TEST(the_last_of_very_many_digits)
{
    char text[ROOM];
    /* 2^53 + 1, half way between 2^53 and 2^53 + 2 */
    int n = snprintf(text, sizeof text, "9007199254740993.");
    memset(text + n, '0', 1500);
    text[n + 1500] = '\0';
    same(text, 9007199254740992.0);
    text[n + 1499] = '1';
    same(text, 9007199254740994.0);
    /* zeros in front count for nothing */
    memset(text, '0', 1500);
    strcpy(text + 1500, "9007199254740993e0");
    same(text, 9007199254740992.0);
    strcpy(text + 1500, "1e-2");
    same(text, 0.01);
}
END_TEST

/* The whole of a long number moves with its exponent. */
START_TEST(digits_and_exponent_together)
{
    for (int zeros = 0; zeros < 1200; zeros += 37) {
        char text[ROOM];
        text[0] = '7';
        memset(text + 1, '0', (size_t)zeros);
        snprintf(text + 1 + zeros, ROOM - 1 - (size_t)zeros, "e%d", -zeros);
        same(text, 7);
        snprintf(text + 1 + zeros, ROOM - 1 - (size_t)zeros, "3D+%d", -zeros < -1 ? 0 : 1);
        if (zeros == 0)
            same(text, 730);
    }
}
END_TEST

START_TEST(ends_of_the_range)
{
    static const struct {
        const char *text;
        double value;
    } at[] = {{"1.7976931348623157e308", 1.7976931348623157e308},
              {"1.7976931348623158e308", 1.7976931348623157e308},
              {"179769313486231580794e288", HUGE_VAL}, /* from half way to 2^1024 on */
              {"179769313486231580793e288", 1.7976931348623157e308},
              {"1e309", HUGE_VAL},
              {"1e310", HUGE_VAL},
              {"1e311", HUGE_VAL},
              {"-1e400", -HUGE_VAL},
              {"1e999999999999", HUGE_VAL},
              {"0e999999999999", 0},
              {"4.9406564584124654e-324", 0x1p-1074},
              {"2.4703282292062328e-324", 0x1p-1074},
              {"2.4703282292062327e-324", 0},
              {"7.4109846876186981e-324", 0x1p-1074},
              {"7.4109846876186982e-324", 0x1p-1073},
              {"1e-330", 0},
              {"1e-331", 0},
              {"-1e-999999999999", -0.0},
              {"2.2250738585072011e-308", 0x1p-1022 - 0x1p-1074},
              {"2.2250738585072014e-308", 0x1p-1022}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        same(at[i].text, at[i].value);
}
END_TEST

START_TEST(spelled_with_signs_and_letters)
{
    same("+5", 5);
    same("-5", -5);
    same("-0", -0.0);
    same("5.", 5);
    same(".25", 0.25);
    same("1E2", 100);
    same("1d+2", 100);
    same("100e-2", 1);
    same("0.000", 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("num_exact");
    TCase *tests = tcase_create("num_exact");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, as_strtod_at_the_borders);
    tcase_add_test(tests, half_way_to_the_even_one);
    tcase_add_test(tests, the_last_of_very_many_digits);
    tcase_add_test(tests, digits_and_exponent_together);
    tcase_add_test(tests, ends_of_the_range);
    tcase_add_test(tests, spelled_with_signs_and_letters);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
