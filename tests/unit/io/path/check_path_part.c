/*
 * path_part: the parts of a path have every item once and in order, begin with passes, and are
 * about as long as each other.
 */
#include <check.h>
#include <string.h>

#include "io/path/path_part.h"

/* 40 passes of 1 ... 40 points, and one point before the first. */
static struct path passes(void)
{
    struct path path = {.name = "test"};
    struct pose at = {{0, 0, 0}, {0, 0, 1}};

    path_add_point(&path, at, true);
    for (size_t pass = 1; pass <= 40; pass++) {
        path_add_pass(&path, pass);
        for (size_t i = 0; i < pass; i++)
            path_add_point(&path, at, false);
    }
    return path;
}

START_TEST(every_item_once)
{
    struct path path = passes();

    for (long n = 1; n <= 100; n++) {
        size_t done = 0, from, to;
        for (long k = 1; k <= n; k++) {
            path_part_items((struct path_part){k, n}, &path, &from, &to);
            ck_assert_uint_eq(from, done);
            ck_assert(to >= from);
            ck_assert(from == 0 || from == path.item.n || path.item.item[from].kind == PATH_PASS);
            if (n <= 8)
                ck_assert_uint_lt(to - from, path.item.n / (size_t)n + 82); /* a pass at each end */
            done = to;
        }
        ck_assert_uint_eq(done, path.item.n);
    }
    path_free(&path);
}
END_TEST

START_TEST(the_whole)
{
    struct path path = passes();
    size_t from, to;

    path_part_items((struct path_part){0, 0}, &path, &from, &to);
    ck_assert(from == 0 && to == path.item.n);
    ck_assert(path_part_first((struct path_part){0, 0}));
    ck_assert(path_part_last((struct path_part){0, 0}));
    path_free(&path);
}
END_TEST

START_TEST(large_numbers)
{
    size_t from, to, most = (size_t)-1;

    path_part_share((struct path_part){PATH_PART_MOST, PATH_PART_MOST}, most, &from, &to);
    ck_assert_uint_eq(to, most);
    ck_assert(from > most / PATH_PART_MOST * (PATH_PART_MOST - 2) && from < most);
}
END_TEST

START_TEST(text)
{
    static const char *const bad[] = {"",    "1",    "1/",    "/2",   "0/2",     "3/2",  "-1/2",
                                      "1/x", "1/2x", "1/2/3", "+1/2", "1/10001", " 1/2", "1/-2"};
    struct path_part part;
    struct error error;

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert_msg(path_part_read(bad[i], &part, &error) < 0, "%s", bad[i]);
    ck_assert_int_eq(path_part_read("3/17", &part, &error), 0);
    ck_assert(part.k == 3 && part.n == 17);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("path_part");
    TCase *t = tcase_create("path_part");

    tcase_add_test(t, every_item_once);
    tcase_add_test(t, the_whole);
    tcase_add_test(t, large_numbers);
    tcase_add_test(t, text);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_ENV);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
