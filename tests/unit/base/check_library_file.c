/* library_file, program_dir, error: where a named file is found, which comes first, and what is
 * said when none is there. */
#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/library_file.h"
#include "base/program_dir.h"

static const struct library library = {"machine", "machines", "CHECK_LIBRARY"};
static char root[64], file[LIBRARY_FILE];
static struct error error;

/* Folders own, job and here; the process stands in here. */
static void setup(void)
{
    strcpy(root, "/tmp/check_libraryXXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(root));
    ck_assert_int_eq(chdir(root), 0);
    ck_assert(mkdir("own", 0700) == 0 && mkdir("job", 0700) == 0 && mkdir("here", 0700) == 0);
    ck_assert_int_eq(chdir("here"), 0);
    unsetenv(library.variable);
}

static void put(const char *name)
{
    FILE *f = fopen(name, "w");
    ck_assert_ptr_nonnull(f);
    fclose(f);
}

static void teardown(void)
{
    static const char *const made[] = {
        "/own/mill.txt", "/job/mill.txt", "/here/mill.txt", "/own", "/job", "/here", ""};
    char name[100];
    ck_assert_int_eq(chdir("/"), 0);
    for (size_t i = 0; i < sizeof made / sizeof *made; i++) {
        snprintf(name, sizeof name, "%s%s", root, made[i]);
        remove(name);
    }
}

static void found(const char *name, const char *beside, const char *where)
{
    ck_assert_msg(library_file_find(&library, name, beside, file, &error) == 0, "%s", error.text);
    ck_assert_str_eq(file, where);
}

START_TEST(which_comes_first)
{
    char own[100], job[100], beside[100];
    snprintf(own, sizeof own, "%s/own", root);
    snprintf(beside, sizeof beside, "%s/job/a.txt", root);
    setenv(library.variable, own, 1);
    ck_assert_int_eq(library_file_find(&library, "mill", beside, file, &error), -1);
    ck_assert(error.file);
    ck_assert_ptr_nonnull(strstr(error.text, "machine mill: not found in this folder, in "
                                             "$CHECK_LIBRARY or in /"));
    ck_assert_ptr_nonnull(strstr(error.text, "share/cloudmill/machines"));
    put("../own/mill.txt");
    snprintf(job, sizeof job, "%s/own/mill.txt", root);
    found("mill", beside, job);
    found("mill", NULL, job);
    put("mill.txt");
    found("mill", beside, "./mill.txt");
    put("../job/mill.txt");
    snprintf(job, sizeof job, "%s/job/mill.txt", root);
    found("mill", beside, job);
    found("mill", "a.txt", "mill.txt");
    found("mill", NULL, "mill.txt");
    setenv(library.variable, "", 1); /* as if it were not there */
    found("mill", NULL, "mill.txt");
}
END_TEST

/* With a slash or an ending it is a file's name, whether it is there or not. */
START_TEST(names_of_files)
{
    char name[LIBRARY_FILE + 1];
    found("mill.txt", NULL, "mill.txt");
    found("mill.txt", "job.txt", "mill.txt");
    found("mill.txt", "../job/a.txt", "../job/mill.txt");
    found("b/mill", "../job/a.txt", "../job/b/mill");
    found("/b/mill", "../job/a.txt", "/b/mill");
    memset(name, 'x', LIBRARY_FILE);
    name[0] = '/';
    name[LIBRARY_FILE - 1] = '\0';
    found(name, NULL, name);
    name[LIBRARY_FILE - 1] = 'x';
    name[LIBRARY_FILE] = '\0';
    ck_assert_int_eq(library_file_find(&library, name, NULL, file, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "file name too long"));
}
END_TEST

/* The tests lie among what is built, beside whose sources the machines are. */
START_TEST(with_the_program)
{
    char folder[PATH_MAX], self[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
    if (n > 0) {
        self[n] = '\0';
        program_dir(folder, sizeof folder);
        ck_assert_uint_eq(strlen(folder), (size_t)(strrchr(self, '/') - self));
        ck_assert_int_eq(strncmp(folder, self, strlen(folder)), 0);
    }
}
END_TEST

START_TEST(errors)
{
    char far[300];
    memset(far, 'f', sizeof far);
    far[299] = '\0';
    error.file = error.system = true;
    ck_assert_int_eq(error_set(&error, "%d found, expected %s", 3, "two"), -1);
    ck_assert_str_eq(error.text, "3 found, expected two");
    ck_assert(!error.file && !error.system);
    error.system = true;
    ck_assert_int_eq(error_at(&error, "a.xyz", 7, "%d found", 3), -1);
    ck_assert_str_eq(error.text, "a.xyz:7: 3 found");
    ck_assert(error.file && !error.system);
    ck_assert_int_eq(error_at(&error, "a.xyz", 0, "empty"), -1);
    ck_assert_str_eq(error.text, "a.xyz: empty");
    /* a long name leaves room for what was found, a long text ends with its room */
    error_at(&error, far, 7, "found");
    ck_assert_str_eq(error.text + 200, ":7: found");
    error_at(&error, far, 7, "%s%s", far, far);
    ck_assert_uint_eq(strlen(error.text), sizeof error.text - 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("library_file");
    TCase *tests = tcase_create("library_file");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, which_comes_first);
    tcase_add_test(tests, names_of_files);
    tcase_add_test(tests, with_the_program);
    tcase_add_test(tests, errors);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
