/*
 * check_surfaces_told - which surfaces are refused, at the limit and beyond, and which have gaps in
 * their trimming.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/surfaces_told.h"

enum { N = 3 };

static struct patch patch[N];
static struct patches patches;
static struct sheet sheet[N];

static void setup(void)
{
    static char name[] = "part.igs";
    patches = (struct patches){.n = N, .item = patch};
    for (int i = 0; i < N; i++) {
        patch[i] = (struct patch){.file = name, .entity = 10 + i};
        sheet[i] = (struct sheet){0};
        *array_push(&sheet[i].face) = (struct face){{0, 1, 2}};
    }
}

static void teardown(void)
{
    for (int i = 0; i < N; i++)
        sheet_free(&sheet[i]);
}

START_TEST(at_the_limit_none_is_refused)
{
    struct error error = {.text = ""};
    sheet[0].off = sheet[2].off = 0.25;
    ck_assert_uint_eq(surfaces_tell_refused(&patches, sheet, 0.25, &error), 0);
    ck_assert_str_eq(error.text, "");
    ck_assert_uint_eq(surfaces_tell_refused(&patches, sheet, 0.25, NULL), 0);
    for (int i = 0; i < N; i++)
        ck_assert(!sheet[i].refused && sheet[i].face.n == 1);
}
END_TEST

START_TEST(the_first_that_is_refused_is_told)
{
    struct error error = {.text = ""};
    sheet[1].off = 0.2500001;
    sheet[2].unclear = 1;
    ck_assert_uint_ge(surfaces_tell_refused(&patches, sheet, 0.25, &error), 1);
    ck_assert_ptr_nonnull(strstr(error.text, "part.igs: surface 11: "));
    ck_assert_ptr_nonnull(strstr(error.text, "in space"));
    ck_assert(!sheet[1].refused);
    sheet[1].off = 0;
    ck_assert_uint_eq(surfaces_tell_refused(&patches, sheet, 0.25, &error), 1);
    ck_assert_ptr_nonnull(strstr(error.text, "surface 12: its trimming crosses itself, in 1 "));
}
END_TEST

START_TEST(without_an_error_each_is_left_out)
{
    sheet[0].off = 1;
    sheet[2].unclear = 2;
    ck_assert_uint_eq(surfaces_tell_refused(&patches, sheet, 0.25, NULL), 2);
    for (int i = 0; i < N; i++) {
        ck_assert(sheet[i].refused == (i != 1));
        ck_assert_uint_eq(sheet[i].face.n, i == 1);
    }
}
END_TEST

START_TEST(gaps_beyond_the_limit)
{
    ck_assert_uint_eq(surfaces_tell_gaps(&patches, sheet, 0.25), 0);
    sheet[0].gap = 0.25;
    sheet[1].gap = 0.2500001;
    sheet[2].gap = 7;
    ck_assert_uint_eq(surfaces_tell_gaps(&patches, sheet, 0.25), 2);
    sheet[2].refused = true; /* why has been told */
    ck_assert_uint_eq(surfaces_tell_gaps(&patches, sheet, 0.25), 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("surfaces_told");
    TCase *tests = tcase_create("surfaces_told");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, at_the_limit_none_is_refused);
    tcase_add_test(tests, the_first_that_is_refused_is_told);
    tcase_add_test(tests, without_an_error_each_is_left_out);
    tcase_add_test(tests, gaps_beyond_the_limit);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
