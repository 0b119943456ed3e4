/* unmet: lines are kept under their stage, one line each, and carried as they are. */
#include "base/unmet.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"

START_TEST(lines_are_kept)
{
    struct unmets a = {0}, b = {0};

    ck_assert_int_eq(unmets_status(&a), EXIT_DONE);
    unmets_add(&a, "meshnorm", "two\nlines\tand \x7f");
    unmet_say(&a, "off by %.3f mm", 0.5);
    unmet_say(NULL, "accepted");
    ck_assert_int_eq(unmets_status(&a), EXIT_UNMET);
    unmets_add_all(&b, &a);
    unmets_add_all(&b, &a);
    unmets_free(&a);
    ck_assert_uint_eq(b.n, 4);
    ck_assert_str_eq(b.item[0].stage, "meshnorm");
    ck_assert_str_eq(b.item[0].text, "two?lines?and ?");
    ck_assert_str_eq(b.item[3].text, "off by 0.500 mm");
    unmets_free(&b);
    ck_assert_int_eq(unmets_status(&b), EXIT_DONE);
}
END_TEST

START_TEST(a_line_has_a_bound)
{
    struct unmets a = {0};
    char longer[2000];

    memset(longer, 'x', sizeof longer);
    longer[sizeof longer - 1] = '\0';
    unmet_say(&a, "%s", longer);
    ck_assert_uint_lt(strlen(a.item[0].text), 400);
    unmets_free(&a);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("unmet");
    TCase *tests = tcase_create("unmet");
    tcase_add_test(tests, lines_are_kept);
    tcase_add_test(tests, a_line_has_a_bound);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
