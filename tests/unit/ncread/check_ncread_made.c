/*
 * ncread_made: keys of --set out of a head, the work offset that they, the machine and its control
 * give, and when two offsets are the same.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "machine/machine_options.h"
#include "ncread/ncread_made.h"

static const struct {
    const char *a, *b;
    bool same;
} pairs[] = {
    {"G54", "G54", true},
    {"G54", "G054", true},
    {"G54", "G55", false},
    {"G54", "", false},
    {"", "", true},
    {"G54.1 P3", "G54.1P03", true},
    {"G54.1 P3", "G54.1 P4", false},
    {"G15 H1", "G15 H2", false},
    {"G15 H1", "G15", false},
    {"CYCL DEF 247 Q339=+1", "CYCL DEF 247 Q339=1", true},
    {"CYCL DEF 247 Q339=+1", "CYCL DEF 247 Q339=+2", false},
};

START_TEST(the_same_offset)
{
    ck_assert_int_eq(ncread_made_same(pairs[_i].a, pairs[_i].b), pairs[_i].same);
    ck_assert_int_eq(ncread_made_same(pairs[_i].b, pairs[_i].a), pairs[_i].same);
}
END_TEST

static const struct {
    const char *control, *said, *set, *own; /* read for it; the head's; --set of both */
    const char *work;                       /* NULL: not known */
} offsets[] = {
    {"fanuc", "FANUC", "", NULL, "G54"},
    {"fanuc", "siemens", "", NULL, NULL},
    {"fanuc", "", "", NULL, NULL},
    {"fanuc", "", "", "offset=G56", "G56"},
    {"fanuc", "FANUC", "OFFSET=G55", NULL, "G55"},
    {"fanuc", "FANUC", "X.MAX=900 OFFSET = G54.1 P3 CENTRE.A=0 0 -120", NULL, "G54.1 P3"},
    {"fanuc", "FANUC", "OFFSET=G55", "offset=G56", "G56"},
    {"fanuc", "FANUC", "OFFSET=G55", "x.max=900", "G55"},
    {"fanuc", "FANUC", "OFFSET=G55 OFFSET.1=G57", NULL, "G57"},
    {"fanuc", "FANUC", "OFFSET.2=G57", NULL, "G54"},
    {"siemens", "siemens", "offset=G505", NULL, "G505"},
    {"siemens", "siemens", "offset=TRANS X1", NULL, NULL}, /* no word that a reader knows */
    {"heidenhain", "heidenhain", "", NULL, ""},
    {"heidenhain", "heidenhain", "offset=CYCL DEF 247 Q339=+2 a.max=30", NULL,
     "CYCL DEF 247 Q339=+2"},
    {"okuma", "OKUMA", "", NULL, "G15 H1"},
};

START_TEST(the_offset_that_was_meant)
{
    struct ncread_head head = {.numbered = true};
    struct machine_options options = {.name = "table-ac", .control = offsets[_i].control};
    struct machine machine;
    struct error error;
    char work[NCREAD_MADE_TEXT];
    snprintf(head.control_file, sizeof head.control_file, "%s", offsets[_i].said);
    snprintf(head.machine_file, sizeof head.machine_file, "TABLE-AC");
    snprintf(head.set, sizeof head.set, "%s", offsets[_i].set);
    if (offsets[_i].own)
        *array_push(&options.set) = offsets[_i].own;
    ck_assert_msg(machine_options_read(&options, &machine, &error) == 0, "%s", error.text);
    ncread_made_set(&machine, &head, &options.set);
    bool known = ncread_made_work(&machine, &head, &options.set, work);
    ck_assert_int_eq(known, offsets[_i].work != NULL);
    if (known)
        ck_assert_str_eq(work, offsets[_i].work);
    machine_options_free(&options);
}
END_TEST

START_TEST(words_of_coolant)
{
    struct ncread_head head = {.set = "COOLANT.ON=M51 COOLANT.OFF=M52|G4 X1. COOLANT.AIR=none"};
    struct machine machine = machine_default();
    struct cli_list own = {0};
    *array_push(&own) = "coolant.off = M59";
    ncread_made_set(&machine, &head, &own);
    ck_assert_str_eq(machine.blocks.coolant_on, "M51");
    ck_assert_str_eq(machine.blocks.coolant_off, "");
    ck_assert_str_eq(machine.blocks.coolant_air, "none");
    array_free(&own);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_made");
    TCase *tests = tcase_create("ncread_made");
    tcase_add_loop_test(tests, the_same_offset, 0, sizeof pairs / sizeof *pairs);
    tcase_add_loop_test(tests, the_offset_that_was_meant, 0, sizeof offsets / sizeof *offsets);
    tcase_add_test(tests, words_of_coolant);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
