/* check_control - the table of controls: names lead to rows, and what is no name to none. */
#include <check.h>
#include <string.h>

#include "machine/control.h"

START_TEST(each_name_finds_its_row)
{
    static const char *const name[] = {"fanuc", "siemens", "heidenhain", "linuxcnc"};
    ck_assert_int_eq(CONTROLS, 4);
    for (int i = 0; i < CONTROLS; i++) {
        ck_assert_int_eq(control_find(name[i]), i);
        ck_assert_str_eq(control_row((enum control_id)i)->name, name[i]);
    }
}
END_TEST

START_TEST(no_part_of_a_name_and_no_other_letters)
{
    static const char *const none[] = {"", "fanu", "fanucs", "Fanuc", "fanuc ", "haas"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        ck_assert_msg(control_find(none[i]) == CONTROLS, "%s", none[i]);
}
END_TEST

/* Of the controls' manuals: C=DC() is Siemens' word; LinuxCNC's kinematics are of its machine. */
START_TEST(what_each_can_do)
{
    for (int i = 0; i < CONTROLS; i++) {
        const struct control *row = control_row((enum control_id)i);
        ck_assert(row->dc == (i == CONTROL_siemens));
        ck_assert(row->tcp_of_machine == (i == CONTROL_linuxcnc));
    }
    ck_assert_str_eq(control_row(CONTROL_linuxcnc)->title, "LinuxCNC");
}
END_TEST

START_TEST(the_names_as_a_choice)
{
    ck_assert_str_eq(control_names(), "fanuc|siemens|heidenhain|linuxcnc");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("control");
    TCase *tests = tcase_create("control");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, each_name_finds_its_row);
    tcase_add_test(tests, no_part_of_a_name_and_no_other_letters);
    tcase_add_test(tests, what_each_can_do);
    tcase_add_test(tests, the_names_as_a_choice);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
