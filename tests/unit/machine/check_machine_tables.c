/* machine_tables: keys with a number in their name and tables of tools, each line with what it says
 * or with what is wrong in it. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine/machine_tables.h"
#include "scratch.h"

static int set(struct machine *m, const char *text, struct error *error)
{
    return machine_tables_set(m, text, "shop/own.txt", 7, error);
}

static const struct {
    const char *line;
    int number;
    double length; /* below zero: not said */
    const char *name;
} tool_line[] = {
    {"tool.1.length = 120.5", 1, 120.5, ""},
    {" tool.12.length=0", 12, 0, ""},
    {"tool.3.length = 10000 \t\r", 3, 10000, ""},
    {"tool.99999999.name = BALL R5", 99999999, -1, "BALL R5"},
    {"tool.0.name = A23456789012345678901234567890123456789", 0, -1,
     "A23456789012345678901234567890123456789"},
};

START_TEST(keys_of_tools)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(set(&m, tool_line[_i].line, &error), 0);
    ck_assert_uint_eq(m.tools, 1);
    const struct machine_tool *tool = machine_tool(&m, tool_line[_i].number);
    ck_assert_ptr_nonnull(tool);
    ck_assert_str_eq(tool->name, tool_line[_i].name);
    ck_assert(machine_has_lengths(&m) == (tool_line[_i].length >= 0));
    if (tool_line[_i].length >= 0)
        ck_assert_double_eq(tool->length, tool_line[_i].length);
    else
        ck_assert(isnan(tool->length));
    ck_assert_ptr_null(machine_tool(&m, tool_line[_i].number + 1));
}
END_TEST

/* Two keys of a tool are of one tool; offsets and auxiliary functions each at their number. */
START_TEST(keys_together)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(set(&m, "tool.5.name = DRILL", &error), 0);
    ck_assert_int_eq(set(&m, "tool.5.length = 80", &error), 0);
    ck_assert_int_eq(set(&m, "tool.5.length = 81", &error), 0);
    ck_assert_uint_eq(m.tools, 1);
    ck_assert_str_eq(m.tool[0].name, "DRILL");
    ck_assert_double_eq(m.tool[0].length, 81);
    ck_assert_int_eq(set(&m, "offset.1 = G55", &error), 0);
    ck_assert_int_eq(set(&m, "offset.20 = G54.1 P3", &error), 0);
    ck_assert_str_eq(m.tool_offset[0], "G55");
    ck_assert_str_eq(m.tool_offset[19], "G54.1 P3");
    ck_assert_int_eq(set(&m, "aux.88 = M88|G4 X1.", &error), 0);
    ck_assert_int_eq(set(&m, "aux.7 = M7", &error), 0);
    ck_assert_int_eq(set(&m, "aux.88 = M89", &error), 0);
    ck_assert_int_eq(m.aux[0].number, 88);
    ck_assert_str_eq(m.aux[0].blocks, "M89");
    ck_assert_int_eq(m.aux[1].number, 7);
    ck_assert_str_eq(m.aux[1].blocks, "M7");
    ck_assert_str_eq(m.aux[2].blocks, "");
}
END_TEST

/* Keys of the machine itself, and what is no setting, are left to others. */
START_TEST(other_keys)
{
    static const char *const line[] = {"x.max = 900",       "tool.1.length",
                                       "tool.1.length =  ", "tool.1.width = 3",
                                       "tool.x.name = B",   "offset.1x = G55",
                                       "aux.88y = M8",      "tooling.1.name = B",
                                       "digits = 3"};
    struct machine m = machine_default(), before = m;
    struct error error;
    for (size_t i = 0; i < sizeof line / sizeof *line; i++)
        ck_assert_msg(set(&m, line[i], &error) == 1, "%s", line[i]);
    ck_assert_uint_eq(m.tools, before.tools);
    ck_assert_mem_eq(m.tool_offset, before.tool_offset, sizeof m.tool_offset);
    ck_assert_mem_eq(m.aux, before.aux, sizeof m.aux);
}
END_TEST

static const struct {
    const char *line, *found;
} bad_key[] = {
    {"tool.1.length = -0.1", "found `-0.1` as a tool's length"},
    {"tool.1.length = 10000.1", "expected 0 to 10000"},
    {"tool.1.length = 12 mm", "found `12 mm`"},
    {"tool.1.name = a\"b", "quotes"},
    {"tool.1.name = (b)", "brackets"},
    {"tool.1.name = A234567890123456789012345678901234567890", "fewer than 40"},
    {"offset.0 = G55", "offset.0 = G55, expected offset.1 to offset.20"},
    {"offset.21 = G55", "offset.21"},
    {"offset.2 = G54.1 P30000000000000", "short word"},
    {"aux.1 = 0123456789012345678901234567890123456789012345678901234567890", "short blocks"},
    {"tools = no-such-table", "shop/no-such-table"},
};

START_TEST(refused_with_the_line)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    ck_assert_int_eq(set(&m, bad_key[_i].line, &error), -1);
    ck_assert_msg(strstr(error.text, bad_key[_i].found) != NULL, "%s", error.text);
    if (!strstr(bad_key[_i].line, "tools"))
        ck_assert_msg(strncmp(error.text, "shop/own.txt:7: ", 16) == 0, "%s", error.text);
}
END_TEST

/* All that there is room for, and one more. */
START_TEST(full)
{
    struct machine m = machine_default();
    struct error error;
    char line[40];
    for (int i = 1; i <= MACHINE_TOOLS; i++) {
        snprintf(line, sizeof line, "tool.%d.length = %d", i, i);
        ck_assert_int_eq(set(&m, line, &error), 0);
    }
    ck_assert_double_eq(machine_tool(&m, MACHINE_TOOLS)->length, MACHINE_TOOLS);
    ck_assert_int_eq(set(&m, "tool.101.length = 1", &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "more than 100 tools"));
    for (int i = 1; i <= MACHINE_AUX; i++) {
        snprintf(line, sizeof line, "aux.%d = M%d", i, i);
        ck_assert_int_eq(set(&m, line, &error), 0);
    }
    ck_assert_int_eq(set(&m, "aux.31 = M1", &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "aux.31"));
}
END_TEST

static int set_table(struct machine *m, const char *text, struct error *error)
{
    char line[1000];
    snprintf(line, sizeof line, "tools = %s", scratch_text(text));
    return machine_tables_set(m, line, scratch_name(), 7, error);
}

START_TEST(tables)
{
    struct machine m = machine_default();
    struct error error;
    ck_assert_int_eq(set_table(&m,
                               "; a table\n# of tools\n\n  1 120.5 BALL R5 \t\n2\t80\r\n"
                               "3 0 # no name\n4 10000 ; CUTTER\n"
                               "T5 P1 Z95.5 D10 ;a mill\nt6 z1\nT7 P3\n1 121\n",
                               &error),
                     0);
    static const struct machine_tool want[] = {{1, 121, "BALL R5"}, {2, 80, ""},
                                               {3, 0, ""},          {4, 10000, "CUTTER"},
                                               {5, 95.5, "a mill"}, {6, 1, ""}};
    ck_assert_uint_eq(m.tools, 7);
    for (size_t i = 0; i < 6; i++) {
        ck_assert_int_eq(m.tool[i].number, want[i].number);
        ck_assert_double_eq(m.tool[i].length, want[i].length);
        ck_assert_str_eq(m.tool[i].name, want[i].name);
    }
    ck_assert_int_eq(m.tool[6].number, 7);
    ck_assert(isnan(m.tool[6].length));
}
END_TEST

static const char *const bad_table[] = {"ok",
                                        "1",
                                        "1.5 80",
                                        "-1 80",
                                        "1 x",
                                        "1 -0.5",
                                        "1 10000.5",
                                        "P1 Z80",
                                        "T-1 Z80",
                                        "T1 Z",
                                        "T1 Z10001",
                                        "T1 Z-1",
                                        "T1 5",
                                        "1e10 80",
                                        "3000000000 80",
                                        "1000000000 80",
                                        "T1e30",
                                        "T3000000000 Z8",
                                        "T1.5 Z80",
                                        "1 80 A(B)",
                                        "1 80 A234567890123456789012345678901234567890"};

START_TEST(refused_tables)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    char text[200], place[200];
    snprintf(text, sizeof text, "; two good lines first\n9 1\n%s\n", bad_table[_i]);
    ck_assert_int_eq(set_table(&m, text, &error), -1);
    snprintf(place, sizeof place, "%s:3: found `", scratch_name());
    ck_assert_msg(strncmp(error.text, place, strlen(place)) == 0, "%s", error.text);
}
END_TEST

START_TEST(table_of_none)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    ck_assert_int_eq(set_table(&m, "; none yet\n", &error), -1);
    ck_assert_msg(strstr(error.text, ": found no tool, expected lines of number and length"), "%s",
                  error.text);
}
END_TEST

START_TEST(table_with_too_many)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    char text[2000] = "";
    for (int i = 0; i <= MACHINE_TOOLS; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%d 1\n", i);
    ck_assert_int_eq(set_table(&m, text, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, ":101: found more than 100 tools"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("machine_tables");
    TCase *tests = tcase_create("machine_tables");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, keys_of_tools, 0, (int)(sizeof tool_line / sizeof *tool_line));
    tcase_add_test(tests, keys_together);
    tcase_add_test(tests, other_keys);
    tcase_add_loop_test(tests, refused_with_the_line, 0, (int)(sizeof bad_key / sizeof *bad_key));
    tcase_add_test(tests, full);
    tcase_add_test(tests, tables);
    tcase_add_loop_test(tests, refused_tables, 0, (int)(sizeof bad_table / sizeof *bad_table));
    tcase_add_test(tests, table_of_none);
    tcase_add_test(tests, table_with_too_many);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
