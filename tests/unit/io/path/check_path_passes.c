/*
 * path_passes: the list in the head is that of the passes, as short as their order lets it be, and
 * a path that has others than its head lists says so.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "scratch.h"

/* Reads a path of these passes (a blank before each) behind this head. */
static struct path path_of(const char *head, const char *passes)
{
    struct path path;
    struct error error = {.text = ""};
    char text[2000] = "";

    strcat(strcat(text, head), "GOTO/1,2,3\n");
    for (const char *p = passes; (p = strchr(p, ' ')); p++)
        sprintf(text + strlen(text), "$$-> PASS/%lu\nGOTO/1,2,3\n", strtoul(p, NULL, 10));
    strcat(text, "FINI\n");
    ck_assert_msg(path_read(scratch_text(text), &path, &error) == 0, "%s", error.text);
    return path;
}

/* The PASSES of a path that is written. */
static void listed(const struct path_passes *passes, char *text, size_t size)
{
    struct path path = {.head = {.passes = *passes}};
    const char *name = scratch_text("");
    struct out *out = out_open(name);
    char line[200];

    path_write_head(out, &path.head);
    out_close(out);
    FILE *file = fopen(name, "r");
    *text = '\0';
    while (fgets(line, sizeof line, file))
        if (strstr(line, "PASSES") && strlen(text) + strlen(line) < size)
            strcat(text, line);
    fclose(file);
}

START_TEST(as_short_as_they_can_be)
{
    static const struct {
        const char *passes, *list;
    } cases[] = {
        {"", ""},
        {" 7", "$$-> PASSES/7\n"},
        {" 1 2 1 3 4 5 7", "$$-> PASSES/1,THRU,2,1,3,THRU,5,7\n"},
        {" 1 3 4 5 9 8 7 6 5 5 5 6", "$$-> PASSES/1,3,THRU,5,9,THRU,5,5,5,THRU,6\n"},
        {" 0 1 0 1000000000 999999999", "$$-> PASSES/0,THRU,1,0,1000000000,THRU,999999999\n"},
        {" 1 5 9 13 17 21 25 29 33 37 41 45 49 53 57 61 65 69 73 77 81 85 89 93",
         "$$-> PASSES/1,5,9,13,17,21,25,29,33,37,41,45,49,53,57,61,65,69,73,77,81\n"
         "$$-> PASSES/85,89,93\n"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct path path = path_of("", cases[i].passes);
        struct path_passes passes = path_passes_of(&path);
        char text[400], head[500];
        listed(&passes, text, sizeof text);
        ck_assert_str_eq(text, cases[i].list);
        path_free(&path);
        snprintf(head, sizeof head, "$$-> CLOUDMILL/1\n%s", text);
        path = path_of(head, cases[i].passes);
        ck_assert_msg(path.head.unmet.n == 0, "%zu: %s", i, cases[i].passes);
        ck_assert_uint_eq(path.head.passes.n > 0, *text != '\0');
        path_free(&path);
        array_free(&passes);
    }
}
END_TEST

START_TEST(others_than_the_head_lists)
{
    static const struct {
        const char *head, *passes, *unmet; /* NULL: none */
    } cases[] = {
        {"$$-> PASSES/1,THRU,4\n", " 1 2 3 4", NULL},
        {"$$-> PASSES/1,2,3\n$$-> passes / 4\n", " 1 2 3 4", NULL},
        {"$$-> PASSES/3,2,THRU,4,4,THRU,4\n", " 3 2 3 4 4", NULL},
        {"", " 4 1 9", NULL},
        {"$$-> PASSES/1,THRU,4\n", " 1 2 4", "found pass 4 after pass 2, expected pass 3"},
        {"$$-> PASSES/1,THRU,4\n", " 1 3 2 4", "found pass 3 after pass 1, expected pass 2"},
        {"$$-> PASSES/1,THRU,4\n", " 2 3 4", "found pass 2, expected pass 1"},
        {"$$-> PASSES/1,THRU,4\n", " 1 2", "found the end after pass 2, expected pass 3"},
        {"$$-> PASSES/1,THRU,4\n", "", "found the end, expected pass 1"},
        {"$$-> PASSES/4,THRU,1\n", " 4 3 2 1 1", "found pass 1 after pass 1, expected the end"},
        {"$$-> LEDGER/biarcfit,0.1\n", " 1", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct path path = path_of(cases[i].head, cases[i].passes);
        ck_assert_uint_eq(path.head.unmet.n, cases[i].unmet != NULL);
        if (cases[i].unmet) {
            ck_assert_str_eq(path.head.unmet.item[0].stage, "path");
            ck_assert_msg(strstr(path.head.unmet.item[0].text, cases[i].unmet), "%zu: %s", i,
                          path.head.unmet.item[0].text);
        }
        path_free(&path);
    }
}
END_TEST

/* What a fitter spent in a pass, and no head: the part that has it is not there. */
START_TEST(without_the_head)
{
    for (int own = 0; own < 2; own++) {
        struct path path;
        struct error error;
        char text[200];
        snprintf(text, sizeof text, "%s$$-> PASS/3\nGOTO/1,2,3\n$$-> LEDGER/bsplfit,0.01\nFINI\n",
                 own ? "$$-> CLOUDMILL/1\n" : "");
        ck_assert_int_eq(path_read(scratch_text(text), &path, &error), 0);
        ck_assert_uint_eq(path.head.unmet.n, 1 - (size_t)own);
        if (!own)
            ck_assert_ptr_nonnull(
                strstr(path.head.unmet.item[0].text, "passes of bsplfit without"));
        path_free(&path);
    }
}
END_TEST

START_TEST(no_list)
{
    static const char *const wrong[] = {"",
                                        "/",
                                        "/x",
                                        "/1,THRU",
                                        "/1,THRU,x",
                                        "/THRU,3",
                                        "/-1",
                                        "/1.5",
                                        "/1,THRU,2000000000",
                                        "/1,2,THRU,THRU"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct path path;
        struct error error = {.text = ""};
        char text[200];
        snprintf(text, sizeof text, "$$-> PASSES%s\nGOTO/1,2,3\nFINI\n", wrong[i]);
        ck_assert_msg(path_read(scratch_text(text), &path, &error) < 0, "%s", wrong[i]);
        ck_assert_ptr_nonnull(strstr(error.text, ":1: "));
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_passes");
    TCase *tests = tcase_create("path_passes");
    tcase_add_test(tests, as_short_as_they_can_be);
    tcase_add_test(tests, others_than_the_head_lists);
    tcase_add_test(tests, without_the_head);
    tcase_add_test(tests, no_list);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
