/* machine_options, control: which control and machine the options make, in which order keys count,
 * and what each error ends with. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "machine/machine_options.h"
#include "scratch.h"

static struct machine_options options;
static struct machine machine;
static struct error error;
static char a[200], b[200];

static void setup(void)
{
    options = (struct machine_options){0};
    error = (struct error){.text = ""};
}

static void teardown(void)
{
    machine_options_free(&options);
}

static int read_all(void)
{
    return machine_options_read(&options, &machine, &error);
}

START_TEST(nothing_said)
{
    ck_assert_int_eq(read_all(), 0);
    ck_assert_int_eq(machine.text.dialect, CONTROLS);
    ck_assert_int_eq(machine.letter[0], MACHINE_C);
}
END_TEST

/* -c before the machine's own control, --set before the machine's keys, the last --set first. */
START_TEST(what_counts)
{
    strcpy(a, scratch_text("control = heidenhain\nfeed.max = 4321\n"));
    options.name = a;
    ck_assert_msg(read_all() == 0, "%s", error.text);
    ck_assert_int_eq(machine.text.dialect, CONTROL_heidenhain);
    ck_assert_double_eq(machine.feed_max, 4321);
    options.control = "siemens";
    ck_assert_int_eq(read_all(), 0);
    ck_assert_int_eq(machine.text.dialect, CONTROL_siemens);
    options.control = NULL;
    *array_push(&options.set) = "control=fanuc";
    *array_push(&options.set) = "feed.max=100";
    *array_push(&options.set) = "feed.max=200";
    ck_assert_msg(read_all() == 0, "%s", error.text);
    ck_assert_int_eq(machine.text.dialect, CONTROL_fanuc);
    ck_assert_double_eq(machine.feed_max, 200);
}
END_TEST

START_TEST(errors)
{
    options.name = "no-such-machine";
    ck_assert_int_eq(read_all(), EXIT_FAILED);
    ck_assert_ptr_nonnull(strstr(error.text, "no-such-machine: not found"));
    options.control = "fanuc";
    ck_assert_int_eq(read_all(), EXIT_FAILED);
    options.name = NULL;
    options.control = "fanucc";
    ck_assert_int_eq(read_all(), EXIT_USAGE);
    options.control = "fanuc";
    *array_push(&options.set) = "no.key=1";
    ck_assert_int_eq(read_all(), EXIT_USAGE);
    ck_assert_ptr_nonnull(strstr(error.text, "no.key"));
    options.control = NULL;
    ck_assert_int_eq(read_all(), EXIT_USAGE);
    strcpy(a, scratch_text("control = fanuc\nfeed.max = x\n"));
    options.set.n = 0;
    options.name = a;
    ck_assert_int_eq(read_all(), EXIT_FAILED);
    ck_assert_ptr_nonnull(strstr(error.text, ":2: "));
}
END_TEST

/* Names in capitals, as a program's head has them. */
START_TEST(adopted)
{
    const char *missing = "";
    strcpy(a, "SIEMENS");
    ck_assert(machine_options_adopt(&options, a, b, &missing));
    ck_assert_ptr_null(missing);
    ck_assert_str_eq(options.control, "siemens");
    ck_assert_ptr_null(options.name);
    strcpy(b, "NO-SUCH"); /* the control that was chosen stays */
    char other[] = "FANUC";
    ck_assert(!machine_options_adopt(&options, other, b, &missing));
    ck_assert_str_eq(missing, "no-such");
    ck_assert_str_eq(options.control, "siemens");
    options.name = "mine";
    ck_assert(machine_options_adopt(&options, a, b, &missing));
    ck_assert_str_eq(options.name, "mine");
    options.control = NULL;
    strcpy(a, "NONE");
    ck_assert(!machine_options_adopt(&options, a, b, &missing));
    ck_assert_str_eq(missing, "none");
    ck_assert_ptr_null(options.control);
}
END_TEST

START_TEST(controls)
{
    ck_assert_str_eq(control_names(), "fanuc|siemens|heidenhain|linuxcnc");
    for (int i = 0; i < CONTROLS; i++)
        ck_assert_int_eq(control_find(control_row((enum control_id)i)->name), i);
    ck_assert_int_eq(control_find("fanu"), CONTROLS);
    ck_assert_int_eq(control_find(""), CONTROLS);
    ck_assert(control_row(CONTROL_siemens)->dc && !control_row(CONTROL_fanuc)->dc);
    ck_assert(control_row(CONTROL_linuxcnc)->tcp_of_machine);
    /* rows of options point to their values */
    ck_assert_ptr_eq(machine_option_name(&options).value, &options.name);
    ck_assert_ptr_eq(machine_option_set(&options).value, &options.set);
    ck_assert_ptr_eq(machine_option_control(&options, "help").value, &options.control);
    ck_assert_str_eq(machine_option_control(&options, "help").help, "help");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("machine_options");
    TCase *tests = tcase_create("machine_options");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, nothing_said);
    tcase_add_test(tests, what_counts);
    tcase_add_test(tests, errors);
    tcase_add_test(tests, adopted);
    tcase_add_test(tests, controls);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
