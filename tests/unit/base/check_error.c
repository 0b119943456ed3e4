/* check_error - the line of an error: its place, its end where there is no more room. */
#include <check.h>
#include <string.h>

#include "base/error.h"

enum { ROOM = sizeof((struct error *)0)->text };

START_TEST(set_says_no_file)
{
    struct error e = {.file = true, .system = true};
    ck_assert_int_eq(error_set(&e, "found %d, expected %s", 3, "4"), -1);
    ck_assert_str_eq(e.text, "found 3, expected 4");
    ck_assert(!e.file && !e.system);
}
END_TEST

START_TEST(at_says_the_place)
{
    struct error e = {.system = true};
    ck_assert_int_eq(error_at(&e, "a.xyz", 1, "found %c", 'x'), -1);
    ck_assert_str_eq(e.text, "a.xyz:1: found x");
    ck_assert(e.file && !e.system);
    error_at(&e, "a.xyz", 0, "is empty");
    ck_assert_str_eq(e.text, "a.xyz: is empty");
    error_at(&e, "a", (size_t)-1, "x");
    ck_assert_str_eq(e.text, "a:18446744073709551615: x");
}
END_TEST

/* Of a name 200 characters are told, and the text still has its room. */
START_TEST(long_names_and_texts_are_cut)
{
    struct error e;
    char name[1000], text[1000];
    memset(name, 'n', sizeof name - 1);
    memset(text, 't', sizeof text - 1);
    name[sizeof name - 1] = text[sizeof text - 1] = '\0';

    error_at(&e, name, 7, "%s", text);
    ck_assert_uint_eq(strlen(e.text), ROOM - 1);
    ck_assert_uint_eq(strspn(e.text, "n"), 200);
    ck_assert_int_eq(strncmp(e.text + 200, ":7: t", 5), 0);
    ck_assert_uint_eq(strspn(e.text + 204, "t"), ROOM - 1 - 204);
    error_set(&e, "%s", text);
    ck_assert_uint_eq(strspn(e.text, "t"), ROOM - 1);
}
END_TEST

START_TEST(what_is_added_stands_after_it)
{
    struct error e;
    error_at(&e, "f", 2, "a");
    error_add(&e, ", %s", "b");
    ck_assert_str_eq(e.text, "f:2: a, b");
    ck_assert(e.file);
}
END_TEST

START_TEST(what_has_no_room_is_not_added)
{
    struct error e;
    char text[ROOM];
    for (size_t n = ROOM - 4; n < ROOM; n++) {
        memset(text, 't', n);
        text[n] = '\0';
        error_set(&e, "%s", text);
        error_add(&e, "abc");
        ck_assert_uint_eq(strlen(e.text), n + 3 < ROOM ? n + 3 : ROOM - 1);
        ck_assert_int_eq(strncmp(e.text + n, "abc", ROOM - 1 - n), 0);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("error");
    TCase *tests = tcase_create("error");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, set_says_no_file);
    tcase_add_test(tests, at_says_the_place);
    tcase_add_test(tests, long_names_and_texts_are_cut);
    tcase_add_test(tests, what_is_added_stands_after_it);
    tcase_add_test(tests, what_has_no_room_is_not_added);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
