/*
 * post_writer: numbers as printf and a rule of this file write them, modal words, block numbers,
 * comments.
 */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chains.h"
#include "post/post_writer.h"

static const struct nc_format_options plain = {
    .open = "; ", .close = "", .comment_width = 80, .number = "N"};

/* What the writer has put into its block so far. */
static const char *text_of(struct nc_writer *w)
{
    static char text[NC_LINE_MAX + 1];
    memcpy(text, w->line, w->n);
    text[w->n] = '\0';
    return text;
}

/* By printf, and then without zeros at the end and -0. */
static void by_printf(char *to, double value, int digits, bool point, bool sign)
{
    char text[60];
    snprintf(text, sizeof text, "%.*f", digits, value);
    if (strchr(text, '.')) {
        size_t n = strlen(text);
        while (text[n - 1] == '0')
            text[--n] = '\0';
        if (text[n - 1] == '.' && !point)
            text[n - 1] = '\0';
    } else if (point) {
        strcat(text, ".");
    }
    const char *number = strtod(text, NULL) == 0 && *text == '-' ? text + 1 : text;
    sprintf(to, "%s%s", sign && *number != '-' ? "+" : "", number);
}

START_TEST(numbers)
{
    seed = 700;
    for (int i = 0; i < 20000; i++) {
        struct nc_writer w;
        struct nc_format_options style = plain;
        char want[80] = "X";
        int digits = 1 + i % 7;
        double value = (2 * chance() - 1) * pow(10, 9 * chance() - 5);
        style.point = i % 2;
        style.sign = i % 3 == 0;
        nc_writer_begin(&w, NULL, style, 0, 99999);
        nc_number(&w, "X", value, digits);
        by_printf(want + 1, value, digits, style.point, style.sign);
        ck_assert_str_eq(text_of(&w), want);
    }
}
END_TEST

static const struct {
    double value;
    int digits;
    const char *want;
} exact[] = {{0.5, 0, "1"},      {-0.5, 0, "-1"},           {2.5, 0, "3"},
             {0.125, 2, "0.13"}, {-0.0004, 3, "0"},         {-0.0, 3, "0"},
             {1e-9, 3, "0"},     {123456.7, 1, "123456.7"}, {-12.25, 1, "-12.3"},
             {100, 3, "100"},    {0.1 + 0.2, 3, "0.3"},     {1e6, 0, "1000000"}};

/* Half is rounded away from zero; no -0, no exponent. */
START_TEST(ties)
{
    struct nc_writer w;
    char want[40];
    nc_writer_begin(&w, NULL, plain, 0, 99999);
    nc_number(&w, "Z", exact[_i].value, exact[_i].digits);
    snprintf(want, sizeof want, "Z%s", exact[_i].want);
    ck_assert_str_eq(text_of(&w), want);
}
END_TEST

/* A word is there where its value, as printed, is another than the last one, and there alone. */
START_TEST(modal)
{
    struct nc_writer w;
    double said = NAN;
    int left_out = 0;
    seed = 710;
    nc_writer_begin(&w, NULL, plain, 0, 99999);
    for (int i = 0; i < 5000; i++) {
        double value = chance() < 0.5 ? 0.01 * chance() : -0.002 * chance();
        double printed = round(fabs(value) * 1000) / 1000 * (value < 0 ? -1 : 1);
        bool forgotten = i % 50 == 0, changed = forgotten || !(printed == said);
        if (forgotten)
            nc_forget(&w, NC_X, NC_Z);
        ck_assert_int_eq(nc_modal(&w, NC_Y, "Y", value, 3), changed);
        if (changed)
            ck_assert_double_eq(strtod(text_of(&w) + 1, NULL), printed);
        else
            ck_assert_uint_eq(w.n, 0);
        nc_end(&w);
        said = printed;
        left_out += !changed;
    }
    ck_assert_int_gt(left_out, 200);
    ck_assert(nc_motion(&w, "G1") && !nc_motion(&w, "G1") && nc_motion(&w, "G0"));
    nc_remember(&w, NC_Y, 7);
    ck_assert(!nc_modal(&w, NC_Y, "Y", 7.0004, 3) && nc_modal(&w, NC_Y, "Y", 7.0006, 3));
}
END_TEST

/* By steps up to the largest, then from the first again; a dropped block has none. */
START_TEST(block_numbers)
{
    struct nc_writer w;
    nc_writer_begin(&w, NULL, plain, 10, 55);
    for (int i = 0; i < 12; i++) {
        char want[40];
        nc_code(&w, "G1");
        nc_drop(&w);
        nc_code(&w, "G0");
        snprintf(want, sizeof want, "N%d G0", 10 * (i % 5 + 1));
        ck_assert_str_eq(text_of(&w), want);
        nc_end(&w);
        nc_end(&w); /* a block without words is none */
        ck_assert_uint_eq(w.blocks, (size_t)i + 1);
    }
    nc_line(&w, "%");
    ck_assert_uint_eq(w.blocks, 13);
    struct nc_format_options all = plain;
    all.count_all = true;
    *all.number = '\0';
    nc_writer_begin(&w, NULL, all, 10, 9999);
    for (int i = 0; i < 3; i++) {
        char want[40];
        nc_code(&w, "L");
        snprintf(want, sizeof want, "%d L", i);
        ck_assert_str_eq(text_of(&w), want);
        nc_end(&w);
    }
}
END_TEST

/* In capitals and without brackets for a control that wants it so, without blanks at the end; never
 * longer than 80. */
START_TEST(comments)
{
    struct nc_format_options brackets = {
        .open = "(", .close = ")", .capitals = true, .comment_width = 80};
    struct nc_writer w;
    nc_writer_begin(&w, NULL, brackets, 0, 99999);
    nc_comment(&w, "Tool (%s) 50%% \t\xc3\xa9", "ball");
    ck_assert_int_eq(strncmp(w.own, "(TOOL -BALL- 50-)\n", 18), 0);
    char many[300];
    memset(many, 'x', sizeof many - 1);
    many[sizeof many - 1] = '\0';
    nc_comment(&w, "%s", many);
    ck_assert_uint_eq(strcspn(w.own, "\n"), brackets.comment_width);
    ck_assert_int_eq(w.own[brackets.comment_width - 1], ')');
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_writer");
    TCase *tests = tcase_create("blocks");

    tcase_add_test(tests, numbers);
    tcase_add_loop_test(tests, ties, 0, sizeof exact / sizeof *exact);
    tcase_add_test(tests, modal);
    tcase_add_test(tests, block_numbers);
    tcase_add_test(tests, comments);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
