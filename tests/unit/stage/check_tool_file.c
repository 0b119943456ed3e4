/* tool_file: the tool above its ball, part by part from the ball's centre upward, by hand; what
 * makes no tool. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scratch.h"
#include "stage/tool_file.h"

static struct error error;

static const struct {
    struct tool_file tool;
    double flute; /* of the cylinder, from the ball's centre */
    int n;
    struct holder_part part[4];
} body[] = {
    {{0}, 20, 0, {{0, 0, 0}}}, /* nothing said: four radii */
    {{.flute = 12}, 7, 0, {{0, 0, 0}}},
    {{.flute = 3}, 0, 0, {{0, 0, 0}}}, /* within the ball */
    {{.flute = 12, .length = 60}, 7, 1, {{5, 5, 7}}},
    {{.flute = 12, .length = 60, .shank = 4}, 7, 2, {{5, 5, 7}, {4, 4, 48}}},
    {{.flute = 80, .length = 60, .shank = 4}, 75, 1, {{5, 5, 55}}},
    {{.length = 60, .shank = 4}, 20, 1, {{4, 4, 55}}},
    {{.flute = 12, .stickout = 40, .holder = "17:19+17:31.5:26"},
     7,
     4,
     {{5, 5, 7}, {5, 5, 28}, {17, 17, 19}, {17, 31.5, 26}}},
    {{.flute = 12, .shank = 3, .length = 90, .stickout = 40, .holder = "17:19"},
     7,
     3,
     {{5, 5, 7}, {3, 3, 28}, {17, 17, 19}}},
    {{.flute = 50, .shank = 3, .stickout = 40, .holder = "17:19"},
     45,
     2,
     {{5, 5, 35}, {17, 17, 19}}},
};

START_TEST(bodies)
{
    struct tool_body b;
    ck_assert_int_eq(tool_file_body(&body[_i].tool, 5, &b, &error), 0);
    ck_assert(!b.ball_only);
    ck_assert_double_eq(b.flute, body[_i].flute);
    ck_assert_int_eq(b.above.n, body[_i].n);
    for (int i = 0; i < body[_i].n; i++) {
        ck_assert_double_eq(b.above.part[i].low, body[_i].part[i].low);
        ck_assert_double_eq(b.above.part[i].high, body[_i].part[i].high);
        ck_assert_double_eq(b.above.part[i].length, body[_i].part[i].length);
    }
}
END_TEST

START_TEST(no_bodies)
{
    struct tool_file tool = {.holder = "17:19"};
    struct tool_body b;
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a stickout of 0, expected one above the radius 5"));
    tool.stickout = 5;
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), -1);
    tool.stickout = 5.001;
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), 0);
    strcpy(tool.holder, "17:x");
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "tool: holder: "));
    *tool.holder = '\0';
    for (int i = 0; i < HOLDER_PARTS - 2; i++)
        strcat(tool.holder, i ? "+9:2" : "9:2");
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), 0);
    strcat(tool.holder, "+9:2");
    ck_assert_int_eq(tool_file_body(&tool, 5, &b, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a holder of 15 cones, expected fewer"));
    const struct tool_file endless = {.flute = 12, .shank = 4};
    ck_assert_int_eq(tool_file_body(&endless, 5, &b, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a shank of 4 that ends nowhere"));
}
END_TEST

/* Each key; a later file overrules an earlier one, key by key. */
START_TEST(files)
{
    struct tool_file tool = {0};
    char name[200];
    ck_assert_int_eq(tool_file_read(&tool,
                                    scratch_text("# a cutter\n radius = 4 \nflute=12\nshank = 3.5\n"
                                                 "length = 80\nname = BALL 4 # mm\n\n"),
                                    &error),
                     0);
    ck_assert_int_eq(tool_file_read(&tool,
                                    scratch_text("stickout = 45\nholder = 9:2+9:3:4\nflute = 13"),
                                    &error),
                     0);
    ck_assert_double_eq(tool.radius, 4);
    ck_assert_double_eq(tool.flute, 13);
    ck_assert_double_eq(tool.shank, 3.5);
    ck_assert_double_eq(tool.length, 80);
    ck_assert_double_eq(tool.stickout, 45);
    ck_assert_str_eq(tool.name, "BALL 4");
    ck_assert_str_eq(tool.holder, "9:2+9:3:4");
    static const char *const bad[] = {"radius = 0", "flute = 10001",          "shank = x",
                                      "wide = 3",   "radius = 3\nradius = 4", "flute"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        ck_assert_int_eq(tool_file_read(&tool, scratch_text(bad[i]), &error), -1);
        snprintf(name, sizeof name, "%s:%d: ", scratch_name(), i == 4 ? 2 : 1);
        ck_assert_msg(strncmp(error.text, name, strlen(name)) == 0, "%s", error.text);
    }
    ck_assert_int_eq(tool_file_read(&tool, scratch_text("vi = 1\n"), &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found `vi`, expected a key of a tool"));
    ck_assert_int_eq(tool_file_read(&tool, "no/such/tool", &error), -1);
    ck_assert_int_eq(tool_file_read(&tool, scratch_text("# nothing\n\n"), &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, ": found no key, expected lines key = value"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("tool_file");
    TCase *tests = tcase_create("tool_file");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, bodies, 0, (int)(sizeof body / sizeof *body));
    tcase_add_test(tests, no_bodies);
    tcase_add_test(tests, files);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
