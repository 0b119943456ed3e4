/*
 * check_tool_options - the tool that options give: its size at the edge of what is taken, and what
 * overrules what.
 */
#include <check.h>
#include <string.h>

#include "scratch.h"
#include "stage/tool_options.h"

static struct error error;
static struct tool_body body;

static int read_with(struct tool_options options, double radius)
{
    error.text[0] = '\0';
    return tool_options_read(&options, radius, &body, &error);
}

static int read_holder(const char *holder, double radius)
{
    return read_with((struct tool_options){.holder = holder}, radius);
}

START_TEST(nothing_said_is_four_radii_of_flute)
{
    ck_assert_int_eq(read_with((struct tool_options){0}, 3), 0);
    ck_assert_double_eq(body.flute, 12);
    ck_assert(!body.ball_only && body.above.n == 0);
}
END_TEST

START_TEST(a_flute_that_is_given)
{
    struct tool_options options = {.flute_given = true, .flute = 0};
    ck_assert_int_eq(read_with(options, 3), 0);
    ck_assert_double_eq(body.flute, 0);
    ck_assert(body.ball_only); /* nothing is above the ball */
    options.holder = "5:60";
    ck_assert_int_eq(read_with(options, 3), 0);
    ck_assert_double_eq(body.flute, 0);
    ck_assert(!body.ball_only);
    options.holder = NULL;
    options.flute = 7;
    ck_assert_int_eq(read_with(options, 3), 0);
    ck_assert_double_eq(body.flute, 7);
    options.flute_given = false;
    ck_assert_int_eq(read_with(options, 3), 0);
    ck_assert_double_eq(body.flute, 12);
}
END_TEST

START_TEST(the_ball_only)
{
    struct tool_options options = {.ball_only = true, .flute = 5};
    ck_assert_int_eq(read_with(options, 3), 0);
    ck_assert(body.ball_only && body.above.n == 0);
    options.flute_given = true;
    ck_assert_int_eq(read_with(options, 3), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "--flute"));
    options.flute_given = false;
    options.holder = "3:10";
    ck_assert_int_eq(read_with(options, 3), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "--holder"));
}
END_TEST

/* Up to a metre, or a hundred radii of a larger ball: lengths together, radii, flute. */
START_TEST(the_largest_tool)
{
    static const struct {
        const char *holder;
        double flute, radius;
        bool good;
    } at[] = {{"3:1000", 0, 1, true},       {"3:1000.001", 0, 1, false},
              {"3:400+4:600", 0, 1, true},  {"3:400+4:600.001", 0, 1, false},
              {"1000:1:5", 0, 1, true},     {"1000.001:1:5", 0, 1, false},
              {"1:1000:5", 0, 1, true},     {"1:1000.001:5", 0, 1, false},
              {"3:10", 1000, 1, true},      {"3:10", 1000.001, 1, false},
              {"3:1000.001", 0, 10, false}, {"3:2000", 0, 20, true},
              {"3:2000.001", 0, 20, false}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct tool_options options = {
            .holder = at[i].holder, .flute = at[i].flute, .flute_given = true};
        int got = read_with(options, at[i].radius);
        ck_assert_msg((got == 0) == at[i].good, "%s, flute %g, R %g: %s", at[i].holder, at[i].flute,
                      at[i].radius, error.text);
        if (got != 0)
            ck_assert_ptr_nonnull(strstr(error.text, "expected at most"));
    }
}
END_TEST

START_TEST(a_holder_that_is_none)
{
    ck_assert_int_eq(read_holder("3", 1), -1);
    ck_assert_int_eq(strncmp(error.text, "option --holder: ", 17), 0);
    ck_assert_int_eq(read_holder("3:10+4:5:6", 1), 0);
    ck_assert_int_eq(body.above.n, 2);
}
END_TEST

/* One radius, from -r or from the file; two that are the same are one. */
START_TEST(the_radius_of_a_file)
{
    const char *name[1] = {scratch_text("radius = 4\n")};
    struct tool_options options = {.files = {.n = 1, .item = name}};
    double radius = 0;
    ck_assert_msg(tool_options_files(&options, &radius, &error) == 0, "%s", error.text);
    ck_assert_double_eq(radius, 4);
    options.file = (struct tool_file){0};
    radius = 4 + 9e-10;
    ck_assert_int_eq(tool_options_files(&options, &radius, &error), 0);
    options.file = (struct tool_file){0};
    radius = 4 + 2e-9;
    ck_assert_int_eq(tool_options_files(&options, &radius, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "expected one radius"));
    options.file = (struct tool_file){0};
    radius = 0;
    name[0] = scratch_text("flute = 9\n");
    ck_assert_int_eq(tool_options_files(&options, &radius, &error), 0);
    ck_assert_double_eq(radius, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("tool_options");
    TCase *tests = tcase_create("tool_options");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, nothing_said_is_four_radii_of_flute);
    tcase_add_test(tests, a_flute_that_is_given);
    tcase_add_test(tests, the_ball_only);
    tcase_add_test(tests, the_largest_tool);
    tcase_add_test(tests, a_holder_that_is_none);
    tcase_add_test(tests, the_radius_of_a_file);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
