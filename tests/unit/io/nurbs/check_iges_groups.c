/* iges_groups: entities know the group (402) that they are directly in, of several the first; other
 * forms are no groups; a pointer to nothing is an error. */
#include "iges_files.h"

#include "io/nurbs/iges_groups.h"

static int *group;

static void setup(void)
{
    iges_file_begin();
}

static void teardown(void)
{
    iges_file_end();
    free(group);
    group = NULL;
}

START_TEST(groups)
{
    int a = iges_file_add(128, 0, 0, false, "128,0;"),
        b = iges_file_add(128, 0, 0, false, "128,0;");
    int c = iges_file_add(128, 0, 0, false, "128,0;"),
        d = iges_file_add(128, 0, 0, false, "128,0;");
    iges_file_format(402, 7, 0, false, "402,2,%d,%d;", a, b);
    iges_file_format(402, 9, 0, false, "402,2,%d,%d;", a, d); /* a parent and its parts */
    iges_file_format(402, 1, 0, false, "402,2,%d,%d;", b, c); /* b is in the first already */
    iges_file_format(402, 15, 0, false, "402,9,%d;", 9);      /* of a group, and says too many */
    iges_file_read();
    group = iges_groups(&iges, &error);
    const int want[] = {1, 1, 2, 0, 3, 0, 0, 0};
    ck_assert_ptr_nonnull(group);
    ck_assert_uint_eq(iges.entity.n, sizeof want / sizeof *want);
    for (size_t i = 0; i < iges.entity.n; i++)
        ck_assert_int_eq(group[i], want[i]);
}
END_TEST

START_TEST(no_entity)
{
    iges_file_add(128, 0, 0, false, "128,0;");
    iges_file_add(402, 7, 0, false, "402,1,77;");
    iges_file_read();
    group = iges_groups(&iges, &error);
    ck_assert_ptr_null(group);
    ck_assert_ptr_nonnull(strstr(error.text, "77"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_groups");
    TCase *tests = tcase_create("iges_groups");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, groups);
    tcase_add_test(tests, no_entity);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
