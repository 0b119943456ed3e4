/* apt: statements of CL text as they are split, by hand; and what is no text. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/apt.h"
#include "scratch.h"

static struct error error;
static struct reader r;
static struct apt apt;

static void put(const char *text)
{
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
}

static void teardown(void)
{
    apt_free(&apt);
    reader_close(&r);
}

static const struct {
    const char *text, *word, *raw;
    bool comment, slash;
    size_t n;
    const char *argument[4];
} one[] = {
    {"goto/1, -2.5e1 ,x\n", "GOTO", "goto/1, -2.5e1 ,x", false, true, 3, {"1", "-2.5E1", "X"}},
    {"  SPINDL / RPM , 400 $$ quick\n",
     "SPINDL",
     "SPINDL / RPM , 400",
     false,
     true,
     2,
     {"RPM", "400"}},
    {"FINI\n", "FINI", "FINI", false, false, 0, {0}},
    {"\n \t\nEND\n", "END", "END", false, false, 0, {0}},
    {"  TLON , GOFWD /1\n", "TLON,GOFWD", "TLON , GOFWD /1", false, true, 1, {"1"}},
    {"RAPID/\n", "RAPID", "RAPID/", false, true, 0, {0}},
    {"GOTO/1,2, $ rest of it\n  3\n", "GOTO", "GOTO/1,2, 3", false, true, 3, {"1", "2", "3"}},
    {"GOTO/ $\n$\n1 $\n,2\n", "GOTO", "GOTO/ 1 ,2", false, true, 2, {"1", "2"}},
    {"$$ a comment / 1,2\n", "", "$$ a comment / 1,2", true, false, 0, {0}},
    {"$$-> pass / 3\n", "PASS", "$$-> pass / 3", true, true, 1, {"3"}},
    {"$$-> pass / $\n3\n", "PASS", "$$-> pass / 3", true, true, 1, {"3"}},
    {"$$ costs 3 $$\n", "", "$$ costs 3 $$", true, false, 0, {0}},
    {"partno 8/9 $ 5,6\n", "PARTNO", "partno 8/9 $ 5,6", false, false, 0, {0}},
    {"PPRINT/x $$ y\n", "PPRINT", "PPRINT/x $$ y", false, false, 0, {0}},
    {"PPRINTX/1\n", "PPRINTX", "PPRINTX/1", false, true, 1, {"1"}},
    {"N30 ,GOTO/4\n", "GOTO", "GOTO/4", false, true, 1, {"4"}},
    {"n30,GOTO/4\n", "GOTO", "GOTO/4", false, true, 1, {"4"}},
    {"100) GOTO/4\n", "GOTO", "GOTO/4", false, true, 1, {"4"}},
    {"N30 GOTO/4\n", "N30 GOTO", "N30 GOTO/4", false, true, 1, {"4"}},
    {"30 ,GOTO/4\n", "30,GOTO", "30 ,GOTO/4", false, true, 1, {"4"}},
    {"1.5, -2, 3E1\n", "", "1.5, -2, 3E1", false, false, 3, {"1.5", "-2", "3E1"}},
    {"A,1\n", "A,1", "A,1", false, false, 0, {0}},
};

START_TEST(statements)
{
    put(one[_i].text);
    ck_assert_msg(apt_read(&r, &apt, &error) == 1, "%s", error.text);
    ck_assert_str_eq(apt.word, one[_i].word);
    ck_assert_str_eq(apt.raw, one[_i].raw);
    ck_assert(apt.comment == one[_i].comment);
    ck_assert(apt.slash == one[_i].slash);
    ck_assert_uint_eq(apt.argument.n, one[_i].n);
    for (size_t i = 0; i < one[_i].n; i++) {
        char *end;
        double truth = strtod(one[_i].argument[i], &end);
        ck_assert_str_eq(apt.argument.item[i].text, one[_i].argument[i]);
        ck_assert(apt_is(&apt, i, one[_i].argument[i]));
        ck_assert(apt.argument.item[i].is_number == (*end == '\0'));
        if (!*end)
            ck_assert_double_eq(apt.argument.item[i].number, truth);
    }
    ck_assert(!apt_is(&apt, one[_i].n, "1"));
    ck_assert_int_eq(apt_read(&r, &apt, &error), 0);
}
END_TEST

/* A statement is where its first line is. */
START_TEST(lines)
{
    put("$$ a\n\nGOTO/1, $\n2\nFINI\n");
    static const unsigned line[] = {1, 3, 5};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(apt_read(&r, &apt, &error), 1);
        ck_assert_uint_eq(apt.line, line[i]);
    }
    ck_assert_uint_eq(apt.argument.n, 0); /* none of the one before */
}
END_TEST

START_TEST(numbers)
{
    double v[3] = {7, 7, 7};
    put("GOTO/1,2,X,4\n");
    apt_read(&r, &apt, &error);
    ck_assert_int_eq(apt_numbers(&apt, "a.cl", 0, 2, v, "x, y", &error), 0);
    ck_assert(v[0] == 1 && v[1] == 2 && v[2] == 7);
    ck_assert_int_eq(apt_numbers(&apt, "a.cl", 3, 1, v, "z", &error), 0);
    ck_assert(v[0] == 4 && v[1] == 2);
    ck_assert_int_eq(apt_numbers(&apt, "a.cl", 1, 2, v, "y, z", &error), -1);
    ck_assert_str_eq(error.text, "a.cl:1: found `X` in GOTO, expected a finite number (y, z)");
    ck_assert_int_eq(apt_numbers(&apt, "a.cl", 3, 2, v, "u, v", &error), -1);
    ck_assert_str_eq(error.text, "a.cl:1: found 1 numbers in GOTO, expected 2 (u, v)");
}
END_TEST

START_TEST(no_text)
{
    static const struct {
        const char *text, *found;
    } k[] = {{"GOTO/1\nGOTO/\001\n", "a binary character (code 1), expected APT text"},
             {"GOTO/1\n\177\n", "code 127"},
             {"GOTO/1\nGOTO/1, $\n", "in a statement continued by $, expected the rest"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        put(k[i].text);
        ck_assert_int_eq(apt_read(&r, &apt, &error), 1);
        ck_assert_int_eq(apt_read(&r, &apt, &error), -1);
        ck_assert_msg(strstr(error.text, k[i].found) != NULL, "%s", error.text);
        ck_assert_ptr_nonnull(strstr(error.text, ":2: "));
        reader_close(&r);
    }
    put("GOTO/1\t,2\f\n"); /* these are blanks of a printer */
    ck_assert_int_eq(apt_read(&r, &apt, &error), 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("apt");
    TCase *tests = tcase_create("apt");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_loop_test(tests, statements, 0, (int)(sizeof one / sizeof *one));
    tcase_add_test(tests, lines);
    tcase_add_test(tests, numbers);
    tcase_add_test(tests, no_text);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
