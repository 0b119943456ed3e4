/* post_program: moves of every kind as the blocks they become, with tools, planes and drilling
 * cycles changed on the way; what is modal is said once, and anew after a change. */
#include "programs.h"

#include "post/post_program.h"

static char name[300];

static void teardown(void)
{
    remove(name);
    programs_end();
}

/* The blocks of a path, from the first that has this in it. */
static const char *blocks(enum control_id control, const char *text, const char *from)
{
    static const struct post_extract whole = {.from = -1, .explain = -1};
    struct post_options options = programs_begin(control, text);
    size_t files;
    snprintf(name, sizeof name, "%s.nc", scratch_name());
    ck_assert_msg(programs_plan(control, &options) == 0, "%s", error.text);
    ck_assert_int_eq(post_write(post, whole, name, &files, &error), 0);
    const char *found = strstr(programs_text(name), from);
    ck_assert_msg(found != NULL, "%s", programs_text(name));
    return found;
}

#define HEAD "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\nLOADTL/3\nSPINDL/RPM,5000,CLW\n"

/* A statement, a dwell and an arc among the lines. */
START_TEST(moves)
{
    ck_assert_str_eq(
        blocks(CONTROL_fanuc,
               HEAD "RAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\nGOTO/0,0,0,0,0,1\nDELAY/1.5\n"
                    "CIRCLE/10,0,0,0,0,-1,10\nGOTO/10,10,0,0,0,1\nSTOP\nGOTO/12,10,0,0,0,1\n"
                    "RAPID\nGOTO/12,10,20,0,0,1\nFINI\n",
               "N100"),
        "N100 Z20.\nN110 G1 Z0. F600.\nN120 G4 X1.5\nN130 G2 X10. Y10. I10. J0.\nN140 M0\n"
        "N150 G1 X12.\nN160 G0 Z20.\nN170 G49 G91 G28 Z0.\nN180 G90\nN190 G0 A0. C0.\nN200 "
        "M9\nN210 M5\n"
        "N220 M30\n");
}
END_TEST

/* Home, the other tool with its speed, and back: all places are said anew, though as before. */
START_TEST(another_tool)
{
    const char *text =
        blocks(CONTROL_fanuc,
               HEAD "RAPID\nGOTO/5,6,20,0,0,1\nFEDRAT/600,MMPM\nGOTO/5,6,0,0,0,1\nRAPID\n"
                    "GOTO/5,6,20,0,0,1\nLOADTL/7\nSPINDL/RPM,900,CCLW\nRAPID\nGOTO/5,6,20,0,0,1\n"
                    "GOTO/5,6,-3,0,0,1\nRAPID\nGOTO/5,6,20,0,0,1\nFINI\n",
               "T7 M6");
    const char *home = strstr(programs_text(name), "G28 Z0.");
    ck_assert_ptr_nonnull(home);
    ck_assert_ptr_nonnull(strstr(home + 1, "G28 Z0.")); /* before the first and before the second */
    ck_assert(strstr(home + 1, "G28 Z0.") < strstr(home, "T7 M6"));
    const char *const want[] = {"S900 M4", "H7", "X5. Y6.", "Z20.", "Z-3. F600.", "Z20.", "M30"};
    for (size_t k = 0; k < sizeof want / sizeof *want; k++) {
        ck_assert_msg((text = strstr(text, want[k])) != NULL, "%s", want[k]);
        text += strlen(want[k]);
    }
}
END_TEST

/* A cycle is said once, each further hole with its place alone, and it is ended before what comes
 * after it. */
START_TEST(holes)
{
    const char *text =
        blocks(CONTROL_fanuc,
               HEAD "RAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/300,MMPM\nCYCLE/DRILL,12,MMPM,300,2\n"
                    "GOTO/1,2,0,0,0,1\nGOTO/11,2,0,0,0,1\nGOTO/11,9,0,0,0,1\nCYCLE/OFF\nRAPID\n"
                    "GOTO/0,0,20,0,0,1\nFINI\n",
               "G81");
    size_t n = 0;
    for (const char *at = programs_text(name); (at = strstr(at, "G81")) != NULL; at++)
        n++;
    ck_assert_uint_eq(n, 1);
    ck_assert_ptr_nonnull(strstr(text, "X1. Y2."));
    const char *off = strstr(text, "G80"), *second = strstr(text, "X11."),
               *third = strstr(text, "Y9.");
    ck_assert(off && second && third && second < third && third < off);
    ck_assert(strstr(off, "X0. Y0.") != NULL);
}
END_TEST

/* Passes are comments alone. */
START_TEST(passes)
{
    blocks(CONTROL_fanuc,
           HEAD "$$-> PASS/1\nRAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\n$$-> PASS/12\n"
                "GOTO/0,0,0,0,0,1\nRAPID\nGOTO/0,0,20,0,0,1\nFINI\n",
           "Z0.");
    char line[200];
    size_t first = 0, twelfth = 0, at = 0;
    FILE *f = fopen(name, "r");
    ck_assert_ptr_nonnull(f);
    while (fgets(line, sizeof line, f)) {
        at++;
        if (strcmp(line, "(PASS 1)\n") == 0)
            first = at;
        if (strcmp(line, "(PASS 12)\n") == 0)
            twelfth = at;
    }
    fclose(f);
    ck_assert(0 < first && first < twelfth);
}
END_TEST

/* Siemens and Heidenhain say the same in words of their own. */
START_TEST(other_controls)
{
    static const char path_text[] =
        HEAD "RAPID\nGOTO/0,0,20,0,0,1\nFEDRAT/600,MMPM\nGOTO/0,0,0,0,0,1\nGOTO/10,0,0,0,0,1\n"
             "RAPID\nGOTO/10,0,20,0,0,1\nFINI\n";
    const char *text = blocks(CONTROL_siemens, path_text, "G1 Z0");
    ck_assert_ptr_nonnull(strstr(text, "F600"));
    ck_assert_ptr_nonnull(strstr(text, "X10"));
    ck_assert(strstr(text, "G0 Z20") > strstr(text, "X10"));
    programs_end();
    text = blocks(CONTROL_heidenhain, path_text, "L Z+0 ");
    ck_assert_ptr_nonnull(strstr(text, "F600"));
    ck_assert(strstr(text, "L Z+20 FMAX") > strstr(text, "L X+10"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_program");
    TCase *tests = tcase_create("post_program");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, moves);
    tcase_add_test(tests, another_tool);
    tcase_add_test(tests, holes);
    tcase_add_test(tests, passes);
    tcase_add_test(tests, other_controls);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
