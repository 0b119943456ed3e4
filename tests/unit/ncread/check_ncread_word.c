/* ncread_word: numbers and words as strictly as the controls read them. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "ncread/ncread_word.h"

static struct ncread_words words;
static struct error error;

static void teardown(void)
{
    array_free(&words);
}

static const struct {
    const char *text;
    double value;
    bool pointed;
    size_t taken;
} number[] = {{"12X", 12, false, 2},      {"-1.5", -1.5, true, 4},
              {"+0.25 Y", 0.25, true, 5}, {"7.", 7, true, 2},
              {".5", 0.5, true, 2},       {"123456789.123456789", 123456789.123456789, true, 19},
              {"3EDGE", 3, false, 1},     {"0", 0, false, 1},
              {"0.1.2", 0.1, true, 3},    {"+0", 0, false, 2}};

START_TEST(numbers)
{
    const char *s = number[_i].text;
    double value;
    bool pointed;
    ck_assert_int_eq(ncread_word_number(&s, &value, &pointed, &error), 0);
    ck_assert_double_eq(value, number[_i].value);
    ck_assert(pointed == number[_i].pointed);
    ck_assert_uint_eq((size_t)(s - number[_i].text), number[_i].taken);
}
END_TEST

static const struct {
    const char *text, *found;
} bad_number[] = {{"", "expected a number"},
                  {"-", "expected a number"},
                  {".", "expected a number"},
                  {"X", "expected a number"},
                  {"1234567890", "too many digits"},
                  {"1.1234567890", "too many digits"},
                  {"1e3", "exponent"},
                  {"1D+3", "exponent"},
                  {"2.E-1", "exponent"},
                  {"-0", "minus zero"},
                  {"-0.000", "minus zero"}};

START_TEST(bad_numbers)
{
    const char *s = bad_number[_i].text;
    double value;
    bool pointed;
    ck_assert_int_eq(ncread_word_number(&s, &value, &pointed, &error), -1);
    ck_assert_msg(strstr(error.text, bad_number[_i].found) != NULL, "%s", error.text);
}
END_TEST

/* The words as a text: each its name, AC IC DC, its numbers, a point where they have one. */
static const char *told(void)
{
    static const char *const kind[] = {"a", "s", "n", "c"};
    static char text[400];
    *text = '\0';
    for (size_t i = 0; i < words.n; i++) {
        const struct ncread_word *w = &words.item[i];
        char *to = text + strlen(text);
        sprintf(to, "%s%s:%s%s%s%s%s", i ? " " : "", kind[w->kind], w->name, w->absolute ? "@" : "",
                w->by ? "+" : "", w->shortest ? "~" : "", w->pointed ? "." : "");
        for (int k = 0; k < w->values; k++)
            sprintf(to + strlen(to), ",%g", w->value[k]);
    }
    return text;
}

static const struct {
    bool siemens;
    const char *line, *want;
} block[] = {
    {false, "", ""},
    {false, "N10 G1X1.5 Y-2(NOTE) Z 3. ; X9", "a:N,10 a:G,1 a:X.,1.5 a:Y,-2 a:Z.,3"},
    {false, "/g43.4\th1", "a:G.,43.4 a:H,1"},
    {false, "(ALL A NOTE)", ""},
    {true, "", ""},
    {true, "N10 G1X1.5 Y-2 ;X9", "a:N,10 a:G,1 a:X.,1.5 a:Y,-2"},
    {true, "A3=0.5 I1=AC(2) PO[X]=(1,2,-3) T=\"BALL 1\" PL=1",
     "s:A3.,0.5 s:I1@,2 s:PO[X],1,2,-3 s:T s:PL,1"},
    {true, "C=DC(90) X=IC(-1)", "s:C~,90 s:X+,-1"},
    {true, "TRAORI CYCLE832(0.01,11,0.1) CIP", "n:TRAORI c:CYCLE832 n:CIP"},
    {true, "PO[Y]=(1,2,3,4,5,6)", "s:PO[Y],1,2,3,4,5,6"},
};

START_TEST(blocks)
{
    int got = block[_i].siemens ? ncread_word_siemens(block[_i].line, &words, &error)
                                : ncread_word_fanuc(block[_i].line, &words, &error);
    ck_assert_msg(got == 0, "%s", error.text);
    ck_assert_str_eq(told(), block[_i].want);
}
END_TEST

static const struct {
    bool siemens;
    const char *line, *found;
} bad_block[] = {
    {false, "X", "expected a number"},
    {false, "X1 (A (B))", "inside another"},
    {false, "(NO END", "does not end"},
    {false, "#1=3", "a variable or macro"},
    {false, "X#1", "a variable"},
    {false, "X[1+2]", "a variable"},
    {false, "X1 =3", "expected a word"},
    {true, "x1", "expected a word"},
    {true, "T=\"BALL", "a text that does"},
    {true, "PO[X]=(1,2,3,4,5,6,7)", "more than 6 numbers"},
    {true, "I1=AC(2", "expected `)`"},
    {true, "CYCLE832(0.01", "does not end"},
    {true, "X1.5=", "after a word"},
    {true, "A3=", "expected a number"},
    {true, "PO[X]=()", "expected a number"},
};

START_TEST(bad_blocks)
{
    int got = bad_block[_i].siemens ? ncread_word_siemens(bad_block[_i].line, &words, &error)
                                    : ncread_word_fanuc(bad_block[_i].line, &words, &error);
    ck_assert_int_eq(got, -1);
    ck_assert_msg(strstr(error.text, bad_block[_i].found) != NULL, "%s", error.text);
}
END_TEST

/* Names that are too long are cut; words are found by their whole names, the first of them. */
START_TEST(names)
{
    char line[100];
    memset(line, 'A', 60);
    strcpy(line + 60, " X=1 XY=2 X=3");
    ck_assert_int_eq(ncread_word_siemens(line, &words, &error), 0);
    ck_assert_uint_eq(words.n, 4);
    ck_assert_uint_eq(strlen(words.item[0].name), WORD_TEXT - 1);
    ck_assert_ptr_eq(ncread_word_find(&words, "X"), &words.item[1]);
    ck_assert_ptr_eq(ncread_word_find(&words, "XY"), &words.item[2]);
    ck_assert_ptr_null(ncread_word_find(&words, "Y"));
    ck_assert_int_eq(ncread_word_siemens("", &words, &error), 0);
    ck_assert_ptr_null(ncread_word_find(&words, "X"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_word");
    TCase *tests = tcase_create("ncread_word");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_loop_test(tests, numbers, 0, (int)(sizeof number / sizeof *number));
    tcase_add_loop_test(tests, bad_numbers, 0, (int)(sizeof bad_number / sizeof *bad_number));
    tcase_add_loop_test(tests, blocks, 0, (int)(sizeof block / sizeof *block));
    tcase_add_loop_test(tests, bad_blocks, 0, (int)(sizeof bad_block / sizeof *bad_block));
    tcase_add_test(tests, names);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
