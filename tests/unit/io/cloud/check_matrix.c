/* matrix: files as registration programs write them, and files that are no matrix. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "io/cloud/matrix.h"

static char name[] = "/tmp/check_matrix.XXXXXX";

static int read_text(const char *text, struct transform *t, struct error *error)
{
    FILE *f = fopen(name, "w");
    ck_assert_ptr_nonnull(f);
    fputs(text, f);
    ck_assert_int_eq(fclose(f), 0);
    return matrix_read(name, t, error);
}

START_TEST(reads)
{
    static const char *const text[] = {
        "1 2 3 4\n0 5 6 7\n0 0 8 9\n0 0 0 1\n",
        "# from the registration\r\n1,2,3,4\r\n0,5,6,7 # second row\r\n0,0,8,9\r\n0,0,0,1\r\n",
        "1.0e0; 2; 3; 4; 0; 5; 6; 7; 0; 0; 8; 9; 0; 0; 0; 1",
        "\t1 2\n3 4\n\n0 5 6 7 0 0\n8 +9.000 -0 0 0 1.0",
    };
    static const double want[16] = {1, 2, 3, 4, 0, 5, 6, 7, 0, 0, 8, 9, 0, 0, 0, 1};
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        struct transform t;
        struct error error = {.text = ""};
        ck_assert_msg(read_text(text[i], &t, &error) == 0, "%s", error.text);
        for (int k = 0; k < 16; k++)
            ck_assert(t.m[k / 4][k % 4] == want[k]);
    }
}
END_TEST

static void refused(const char *text, const char *words)
{
    struct transform t;
    struct error error;
    ck_assert_int_eq(read_text(text, &t, &error), -1);
    ck_assert_msg(strstr(error.text, words) != NULL, "`%s` without `%s`", error.text, words);
    ck_assert_ptr_nonnull(strstr(error.text, name));
}

START_TEST(refuses)
{
    refused("", "found 0 numbers");
    refused("1 0 0 0 0 1 0 0 0 0 1 0", "found 12 numbers");
    refused("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n5\n", ":5: found more than 16");
    refused("1 0 0 0\n0 one 0 0\n", ":2: found `one 0 0`");
    refused("1 0 0 0\n0 1x 0 0\n", ":2: found `1x 0 0`");
    refused("1 0 0 0\n0 1e999 0 0\n", ":2:");
    refused("1 0 0 0\n0 nan 0 0\n", ":2:");
    refused("1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n", "last row");
    refused("1 0 0 0\n0 1 0 0\n1 1 0 0\n0 0 0 1\n", "flattens");
    refused("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 2\n", "last row");
    /* a determinant of less than 1e-9 of the lengths of the rows, whatever these are */
    refused("1 0 0 0\n0 1 0 0\n1 0 0.9e-9 0\n0 0 0 1\n", "flattens");
    refused("1e6 0 0 0\n0 1e6 0 0\n1e6 0 0.9e-3 0\n0 0 0 1\n", "flattens");
    struct transform t;
    struct error error;
    ck_assert_int_eq(read_text("1 0 0 0\n0 1 0 0\n1 0 1.1e-9 0\n0 0 0 1\n", &t, &error), 0);
    ck_assert_int_eq(read_text("-1e6 0 0 0\n0 1e6 0 0\n1e6 0 1.1e-3 0\n0 0 0 1\n", &t, &error), 0);
}
END_TEST

START_TEST(no_such_file)
{
    struct transform t;
    struct error error;
    ck_assert_int_eq(matrix_read("/nowhere/matrix.txt", &t, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "/nowhere/matrix.txt"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("matrix");
    TCase *tests = tcase_create("matrix");
    SRunner *runner = srunner_create(suite);
    int fd = mkstemp(name);
    if (fd < 0)
        return 1;
    close(fd);
    tcase_add_test(tests, reads);
    tcase_add_test(tests, refuses);
    tcase_add_test(tests, no_such_file);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    unlink(name);
    return failed > 0;
}
