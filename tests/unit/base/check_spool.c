/* spool: a file in the folder that TMPDIR names, or elsewhere, which no folder shows. */
#include <check.h>
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/spool.h"

static char folder[] = "/tmp/check_spool.XXXXXX";

static int files_in(const char *name)
{
    DIR *dir = opendir(name);
    int n = 0;
    ck_assert_ptr_nonnull(dir);
    for (struct dirent *entry; (entry = readdir(dir));)
        n += entry->d_name[0] != '.';
    closedir(dir);
    return n;
}

/* What is written is read again, and no folder shows it; the device that it is on. */
static dev_t used(void)
{
    char text[8] = "";
    struct stat st;
    FILE *file = spool_open();
    ck_assert_ptr_nonnull(file);
    ck_assert_int_eq(files_in(folder), 0);
    ck_assert(fputs("points", file) >= 0 && fseek(file, 0, SEEK_SET) == 0);
    ck_assert_ptr_nonnull(fgets(text, sizeof text, file));
    ck_assert_str_eq(text, "points");
    ck_assert_int_eq(fstat(fileno(file), &st), 0);
    ck_assert_uint_eq(st.st_nlink, 0);
    ck_assert_int_eq(fclose(file), 0);
    return st.st_dev;
}

START_TEST(in_a_folder)
{
    struct stat st;
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(setenv("TMPDIR", folder, 1), 0);
    ck_assert_int_eq(stat(folder, &st), 0);
    ck_assert_uint_eq(used(), st.st_dev);
    ck_assert_int_eq(setenv("TMPDIR", "/nowhere/at/all", 1), 0);
    used();
    ck_assert_int_eq(setenv("TMPDIR", "", 1), 0);
    used();
    ck_assert_int_eq(unsetenv("TMPDIR"), 0);
    used();
    ck_assert_int_eq(rmdir(folder), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("spool");
    TCase *tests = tcase_create("spool");
    tcase_add_test(tests, in_a_folder);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
