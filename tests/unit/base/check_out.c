/* out: bytes through its buffer, numbers, and a file that is the older one until it is complete. */
#include <check.h>
#include <float.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/out.h"
#include "scratch.h"

static char *written(size_t *n)
{
    return scratch_read(n);
}

static void is(const char *want)
{
    size_t n;
    char *text = written(&n);
    ck_assert_str_eq(text, want);
    free(text);
}

static struct out *abandoned; /* as by a process that ends: nothing is given back */

START_TEST(older_until_complete)
{
    const char *name = scratch_text("older\n");
    struct stat before, after;
    ck_assert_int_eq(chmod(name, 0640), 0);
    ck_assert_int_eq(stat(name, &before), 0);
    struct out *out = out_open(name);
    out_text(out, "newer\n");
    is("older\n");
    out_close(out);
    is("newer\n");
    ck_assert_int_eq(stat(name, &after), 0);
    ck_assert_uint_eq(after.st_mode & 07777, 0640);
    ck_assert_uint_ne(before.st_ino, after.st_ino);
    abandoned = out_open(name);
    out_text(abandoned, "never\n");
    out_abandon();
    is("newer\n");
}
END_TEST

START_TEST(through_a_link)
{
    char link[200];
    const char *name = scratch_text("older\n");
    struct stat st;
    snprintf(link, sizeof link, "%s.link", name);
    ck_assert_int_eq(symlink(name, link), 0);
    struct out *out = out_open(link);
    out_text(out, "newer\n");
    out_close(out);
    is("newer\n");
    ck_assert_int_eq(lstat(link, &st), 0);
    ck_assert(S_ISLNK(st.st_mode));
    unlink(link);
}
END_TEST

static int fill(const char *name)
{
    struct out *out = out_open(name);
    out_text(out, "newer\n");
    out_close(out);
    return access(name, F_OK);
}

/* Links in two folders, one by the name from the root, lead to a file that is not there yet. */
START_TEST(through_links_to_what_is_not_there)
{
    char folder[] = "/tmp/check_outXXXXXX", link[2][100], file[100];
    struct stat st;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(link[0], sizeof link[0], "%s/first", folder);
    snprintf(link[1], sizeof link[1], "%s/inner", folder);
    ck_assert_int_eq(mkdir(link[1], 0700), 0);
    snprintf(link[1], sizeof link[1], "%s/inner/second", folder);
    snprintf(file, sizeof file, "%s/inner/file", folder);
    ck_assert_int_eq(symlink(link[1], link[0]), 0);
    ck_assert_int_eq(symlink("file", link[1]), 0);
    ck_assert_int_eq(fill(link[0]), 0);
    for (int i = 0; i < 2; i++)
        ck_assert(lstat(link[i], &st) == 0 && S_ISLNK(st.st_mode));
    ck_assert(lstat(file, &st) == 0 && S_ISREG(st.st_mode) && st.st_size == 6);
    ck_assert(unlink(link[0]) == 0 && unlink(link[1]) == 0 && unlink(file) == 0);
    snprintf(link[1], sizeof link[1], "%s/inner", folder);
    ck_assert(rmdir(link[1]) == 0 && rmdir(folder) == 0); /* and nothing else is left */
}
END_TEST

/* A name of 255 bytes, beside which the unfinished file has one of its own. */
START_TEST(the_longest_name)
{
    char name[5 + 255 + 1] = "/tmp/";
    memset(name + 5, 'n', 255);
    ck_assert_int_eq(fill(name), 0);
    unlink(name);
}
END_TEST

/* Started without standard input, the file gets its number. */
START_TEST(in_place_of_standard_input)
{
    const char *name = scratch_text("older\n");
    int kept = dup(STDIN_FILENO);
    close(STDIN_FILENO);
    struct out *out = out_open(name);
    ck_assert_int_ge(dup(STDIN_FILENO), 0); /* it is open */
    out_text(out, "newer\n");
    is("older\n");
    out_close(out);
    is("newer\n");
    dup2(kept, STDIN_FILENO);
    out = out_open(name); /* one that is abandoned leaves nothing behind */
    out_abandon();
}
END_TEST

/* Pieces of all lengths around the buffer's, by each way in. */
START_TEST(all_bytes_in_order)
{
    enum { SIZE = 1000000 };
    char *want = malloc(SIZE);
    size_t at = 0, n;
    struct out *out = out_open(scratch_text(""));
    for (size_t i = 0; i < SIZE; i++)
        want[i] = (char)('a' + i * 7919 % 26);
    for (size_t piece = 1; at < SIZE; piece = piece * 3 % 140009) {
        size_t take = piece < SIZE - at ? piece : SIZE - at;
        if (take <= 4096) {
            memcpy(out_room(out, take), want + at, take);
            out_take(out, take);
        } else if (take < 9000) {
            out_printf(out, "%.*s", (int)take, want + at);
        } else {
            out_bytes(out, want + at, take);
        }
        at += take;
    }
    out_close(out);
    char *got = written(&n);
    ck_assert_uint_eq(n, SIZE);
    ck_assert_mem_eq(got, want, SIZE);
    free(got);
    free(want);
}
END_TEST

START_TEST(numbers_read_back)
{
    static const double exact[] = {0,       -0.0,        0.1,     1.0 / 3,        500000.123456789,
                                   DBL_MAX, DBL_EPSILON, DBL_MIN, 5400000.000001, -1e-300};
    enum { N = sizeof exact / sizeof *exact };
    struct out *out = out_open(scratch_text(""));
    for (int i = 0; i < N; i++) {
        out_exact(out, exact[i]);
        out_text(out, "\n");
    }
    out_int(out, LLONG_MIN);
    out_text(out, " ");
    out_int(out, LLONG_MAX);
    out_text(out, " ");
    out_int(out, 0);
    out_text(out, " ");
    out_num(out, 5400000.1234564, 6);
    out_close(out);
    size_t n;
    char *text = written(&n), *p = text;
    for (int i = 0; i < N; i++) {
        double got = strtod(p, &p);
        ck_assert(!(got < exact[i]) && !(got > exact[i]));
    }
    ck_assert_str_eq(p, "\n-9223372036854775808 9223372036854775807 0 5400000.123456");
    free(text);
}
END_TEST

/* What is put into memory, less and more than a buffer holds, comes where it is joined. */
START_TEST(joined_from_memory)
{
    enum { ROWS = 30000 };
    struct out *out = out_open(scratch_name()), *memory[2] = {out_memory(), out_memory()};
    out_text(out, "before ");
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < (round ? 3 : ROWS); i++) {
            out_int(memory[1], 2 * i + 1);
            out_text(memory[1], " ");
            out_num(memory[0], 2 * i, 6);
            memcpy(out_room(memory[0], 1), " ", 1);
            out_take(memory[0], 1);
        }
        out_join(out, memory[0]);
        out_text(out, "| ");
        out_join(out, memory[1]);
        out_join(out, memory[1]); /* empty */
        out_text(out, "| ");
    }
    out_close(memory[0]);
    out_close(memory[1]);
    out_close(out);
    size_t n;
    char *text = written(&n), *p = text;
    ck_assert_int_eq(strncmp(p, "before ", 7), 0);
    p += 7;
    for (int part = 0; part < 4; part++) {
        for (long i = 0; i < (part < 2 ? ROWS : 3); i++)
            ck_assert(strtod(p, &p) == (double)(2 * i + part % 2));
        ck_assert_int_eq(strncmp(p, " | ", 3), 0);
        p += 2;
    }
    ck_assert_str_eq(p, " ");
    free(text);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("out");
    TCase *tests = tcase_create("out");
    SRunner *runner = srunner_create(suite);

    tcase_add_test(tests, older_until_complete);
    tcase_add_test(tests, through_a_link);
    tcase_add_test(tests, through_links_to_what_is_not_there);
    tcase_add_test(tests, the_longest_name);
    tcase_add_test(tests, in_place_of_standard_input);
    tcase_add_test(tests, all_bytes_in_order);
    tcase_add_test(tests, numbers_read_back);
    tcase_add_test(tests, joined_from_memory);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
