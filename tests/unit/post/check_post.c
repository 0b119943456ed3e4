/* post: what may be asked for, what a report says of a path whose lengths are known, and what
 * is refused. */
#include "programs.h"

#include "base/cli.h"

/* 20 down, 10 along, 20 up; 11.18 over at rapid; 21 down, 10 and 2 along, 21 up at rapid. */
static const char two[] = "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nLOADTL/3\nSPINDL/RPM,5000,CLW\n"
                          "$$-> PASS/1\nRAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\n"
                          "GOTO/0,0,0,0,0,1\nGOTO/10,0,0,0,0,1\nGOTO/10,0,20,0,0,1\n$$-> PASS/2\n"
                          "RAPID\nGOTO/0,5,20,0,0,1\nGOTO/0,5,-1,0,0,1\nGOTO/10,5,-1,0,0,1\n"
                          "COOLNT/ON\nGOTO/12,5,-1,0,0,1\nRAPID\nGOTO/12,5,20,0,0,1\nFINI\n";

START_TEST(limits)
{
    static const struct {
        const char *text;
        size_t blocks, bytes;
    } good[] = {{"20000", 20000, 0},
                {"1", 1, 0},
                {"500k", 0, 500000},
                {"2M", 0, 2000000},
                {"1.5k", 0, 1500}};
    static const char *const bad[] = {"", "0", "-3", "x", "5G", "5kk", "1e13", "5 k", "0.5"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct post_extract extract = {0};
        ck_assert_int_eq(post_limit_read(good[i].text, &extract, &error), 0);
        ck_assert_uint_eq(extract.blocks, good[i].blocks);
        ck_assert_uint_eq(extract.bytes, good[i].bytes);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct post_extract extract = {0};
        ck_assert_msg(post_limit_read(bad[i], &extract, &error) == -1, "%s", bad[i]);
        ck_assert_ptr_nonnull(strstr(error.text, "option --split"));
        ck_assert_uint_eq(extract.blocks + extract.bytes, 0);
    }
}
END_TEST

START_TEST(what_a_control_knows)
{
    struct post_options options = {.axis = POST_AXIS_VECTORS};
    struct machine own = {.vectors = true, .text.title = "Own"};
    ck_assert_int_eq(post_check(CONTROL_siemens, &own, &options, &error), 0);
    ck_assert_int_eq(post_check(CONTROL_linuxcnc, &own, &options, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "--vectors"));
    own.vectors = false;
    ck_assert_int_eq(post_check(CONTROL_fanuc, &own, &options, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "Own"));
    options.axis = POST_AXIS_ROTARY;
    ck_assert_int_eq(post_check(CONTROL_fanuc, &own, &options, &error), 0);
    options = (struct post_options){.plane = true};
    ck_assert_int_eq(post_check(CONTROL_heidenhain, &own, &options, &error), 0);
    ck_assert_int_eq(post_check(CONTROL_linuxcnc, &own, &options, &error), -1);
    options = (struct post_options){.name = "1234"};
    ck_assert_int_eq(post_check(CONTROL_fanuc, &own, &options, &error), 0);
    options.name = "a name/with it";
    ck_assert_int_eq(post_check(CONTROL_fanuc, &own, &options, &error), -1);
}
END_TEST

/* In mm also where the program is in inches. */
START_TEST(lengths_and_counts)
{
    for (int inch = 0; inch < 2; inch++) {
        struct post_options options = programs_begin(CONTROL_fanuc, two);
        options.inch = inch;
        path_spend(&path, "before", 0.0125);
        ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), 0);
        struct post_report r = post_report(post);
        double printed = inch ? 1e-3 : 1e-9; /* four digits of an inch, along nine motions */
        ck_assert_double_eq_tol(r.cut, 20 + 10 + 20 + 21 + 10 + 2, printed);
        ck_assert_double_eq_tol(r.rapid, sqrt(125) + 21, printed);
        ck_assert_uint_eq(r.passes, 2);
        ck_assert_uint_eq(r.lines, 6);
        ck_assert_uint_eq(r.rapids, 3);
        ck_assert_uint_eq(r.arcs + r.splines + r.chorded + r.turns + r.fast + r.peaks, 0);
        ck_assert(!r.feed_assumed && !r.approach_made && !r.retract_made && !r.no_spindle_on);
        ck_assert(!r.no_tool && !r.no_coolant && !r.no_vectors && !r.cutcom_off);
        ck_assert_double_le(r.point, inch ? 2.2e-3 : 1e-9); /* half a unit of each last digit */
        ck_assert_double_eq_tol(r.ledger, 0.0125 + r.point, 1e-12);
        /* at 600 mm/min: no less than all of it at that, no more than half as much again */
        ck_assert_double_gt(r.minutes, 83.0 / 600);
        ck_assert_double_lt(r.minutes, 1.5 * 83.0 / 600);
        programs_end();
    }
}
END_TEST

/* Without a feed, a rapid before or after, a speed and a tool: each is told. */
START_TEST(what_is_missing)
{
    struct post_options options = programs_begin(CONTROL_fanuc, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\n"
                                                                "GOTO/0,0,0,0,0,1\nCOOLNT/THRU\n"
                                                                "GOTO/10,0,0,0,0,1\nFINI\n");
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), 0);
    struct post_report r = post_report(post);
    ck_assert(r.feed_assumed && r.approach_made && r.retract_made);
    ck_assert(r.no_spindle_on && r.no_tool && r.no_coolant);
    ck_assert_uint_eq(r.passes, 0);
    ck_assert_double_eq_tol(r.cut, machine.retract + 10, 1e-9);
    programs_end();
    options = programs_begin(CONTROL_fanuc, two);
    options.no_spindle = true;
    path.head.tool = 0;
    path.head.spindle = 0;
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), 0);
    r = post_report(post);
    ck_assert(!r.no_spindle_on && !r.no_tool);
    programs_end();
}
END_TEST

START_TEST(inserts_are_refused)
{
    struct post_options options =
        programs_begin(CONTROL_fanuc, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nRAPID\nGOTO/0,0,9,0,0,1\n"
                                      "INSERT G4 X1\nGOTO/0,0,0,0,0,1\nFINI\n");
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), 0);
    post_free(post);
    options.insert = POST_INSERT_REFUSE;
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), EXIT_FAILED);
    ck_assert_ptr_nonnull(strstr(error.text, ":6: found `INSERT G4 X1`"));
    programs_end();
}
END_TEST

/* A tilted plane where the axis stays in the cut, and where the machine turns to it. */
START_TEST(planes)
{
    static const char tilted[] = "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nRAPID\nGOTO/0,0,20,0.6,0,0.8\n"
                                 "FEDRAT/600,MMPM\nGOTO/0,0,0,0.6,0,0.8\nGOTO/0,9,0,%s\nFINI\n";
    char text[400];
    for (int turns = 0; turns < 2; turns++) {
        snprintf(text, sizeof text, tilted, turns ? "0.8,0,0.6" : "0.6,0,0.8");
        struct post_options options = programs_begin(CONTROL_siemens, text);
        options.plane = true;
        ck_assert_int_eq(programs_plan(CONTROL_siemens, &options), turns ? EXIT_FAILED : 0);
        if (turns)
            ck_assert_ptr_nonnull(strstr(error.text, "tool axis that turns in the cut"));
        programs_end();
        options = programs_begin(CONTROL_siemens, text);
        options.plane = true;
        strcpy(machine.blocks.plane_on, "none");
        ck_assert_int_eq(programs_plan(CONTROL_siemens, &options), EXIT_USAGE);
        programs_end();
    }
}
END_TEST

/* Beyond the travel of an axis there is no program. */
START_TEST(out_of_travel)
{
    struct post_options options =
        programs_begin(CONTROL_fanuc, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nFEDRAT/600,MMPM\n"
                                      "GOTO/0,0,0,0,0,1\nGOTO/9,0,0,0,0.6,-0.8\nFINI\n");
    ck_assert_int_eq(programs_plan(CONTROL_fanuc, &options), EXIT_FAILED);
    ck_assert_ptr_null(post);
    programs_end();
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post");
    TCase *tests = tcase_create("post");
    tcase_add_test(tests, limits);
    tcase_add_test(tests, what_a_control_knows);
    tcase_add_test(tests, lengths_and_counts);
    tcase_add_test(tests, what_is_missing);
    tcase_add_test(tests, inserts_are_refused);
    tcase_add_test(tests, planes);
    tcase_add_test(tests, out_of_travel);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
