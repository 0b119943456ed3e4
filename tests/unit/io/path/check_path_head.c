/* path_head: what the tool is above its ball, and what is refused of it. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "scratch.h"

START_TEST(the_tool_above_its_ball)
{
    static const struct {
        const char *word;
        int parts;
        const char *wrong;
    } cases[] = {{"", 1, NULL},
                 {"$$-> TOOL/BALL-ONLY\n", 0, NULL},
                 {"$$-> TOOL/FLUTE,0\n", 0, NULL},
                 {"$$-> tool / flute,0,holder,3:40 + 9:9\n", 0, "found `3:40 + 9:9`"},
                 {"$$-> TOOL/FLUTE,5,HOLDER,3:40\n", 2, NULL},
                 {"$$-> TOOL/FLUTE,-5\n", 0, "found a flute of -5"},
                 {"$$-> TOOL/FLUTE\n", 0, "found `$$-> TOOL/FLUTE`"},
                 {"$$-> NOISE/0\n", 1, NULL},
                 {"$$-> NOISE/-0.1\n", 0, "found NOISE/-0.1, expected no less than 0"},
                 {"$$-> NOISE/\n", 0, "mm"},
                 {"$$-> TOOL/BALL-ONLY,5\n", 0, "expected TOOL/BALL-ONLY or"},
                 {"$$-> TOOL/FLUTE,5,HOLDER\n", 0, "expected TOOL/BALL-ONLY or"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct path path;
        struct error error = {.text = ""};
        char text[400];
        snprintf(text, sizeof text, "CUTTER/16,8\n%sGOTO/1,2,3\nFINI\n", cases[i].word);
        int result = path_read(scratch_text(text), &path, &error);
        ck_assert_msg((result < 0) == (cases[i].wrong != NULL), "%zu: %s", i, error.text);
        if (cases[i].wrong) {
            ck_assert_msg(strstr(error.text, cases[i].wrong), "%zu: %s", i, error.text);
            continue;
        }
        ck_assert_int_eq(path_holder(&path).n, cases[i].parts);
        path_free(&path);
    }
}
END_TEST

/* Of two regions nobody knows which part of the path is whose. */
START_TEST(a_region)
{
#define BOX "$$-> REGION/BORDER,1\n$$-> REGION/BOX,0,0,0,5,5,5\n"
    static const struct {
        const char *before, *after;
        bool given;
        const char *wrong;
    } cases[] = {{"", "", false, NULL},
                 {BOX, "", true, NULL},
                 {BOX, BOX, false, NULL},
                 {"", BOX, false, NULL},
                 {BOX, "$$-> REGION/BORDER,2\n$$-> REGION/POLYGON,0,0,1,0,1,1\n", false, NULL},
                 {"$$-> REGION/BORDER,1\n$$-> REGION/POLYGON,0,0,1,0\n"
                  "$$-> REGION/CORNERS,1,1\n",
                  "", true, NULL},
                 {"$$-> REGION/CORNERS,1,1\n", "", false, "expected REGION/POLYGON,x,y"},
                 {"$$-> REGION/POLYGON,1,1,2\n", "", false, "expected REGION/POLYGON,x,y"},
                 {"$$-> REGION/BOX,1,1,2\n", "", false, "x, y, z of two corners"},
                 {"$$-> REGION/BALL,1,1,2\n", "", false, "expected REGION/BORDER, BOX"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct path path;
        struct error error = {.text = ""};
        char text[400];
        snprintf(text, sizeof text, "CUTTER/16,8\n%sGOTO/1,2,3\n%sGOTO/1,2,4\nFINI\n",
                 cases[i].before, cases[i].after);
        int result = path_read(scratch_text(text), &path, &error);
        ck_assert_msg((result < 0) == (cases[i].wrong != NULL), "%zu: %s", i, error.text);
        if (cases[i].wrong) {
            ck_assert_msg(strstr(error.text, cases[i].wrong), "%zu: %s", i, error.text);
            continue;
        }
        ck_assert(region_given(&path.head.region) == cases[i].given);
        path_free(&path);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_head");
    TCase *tests = tcase_create("path_head");
    tcase_add_test(tests, the_tool_above_its_ball);
    tcase_add_test(tests, a_region);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
