/* check_surfaces_scan - the scan in the head of a file of surfaces: what is written reads back. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "io/nurbs/surfaces_scan.h"

/* All lines of a text into a scan; false: one of them is another. */
static bool read_lines(char *text, struct scan_sources *scan)
{
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"))
        if (!surfaces_scan_line(line, scan))
            return false;
    return true;
}

START_TEST(no_scan_no_line)
{
    struct scan_sources none = {0};
    none.placed = true; /* of nothing */
    char *text = surfaces_scan_text(&none);
    ck_assert_str_eq(text, "");
    free(text);
}
END_TEST

START_TEST(the_line_of_a_file)
{
    struct scan_sources scan = {0};
    scan_sources_add_known(&scan, "part 1.xyz", 26493, 0x0123456789abcdefu);
    char *text = surfaces_scan_text(&scan);
    ck_assert_str_eq(text, "cloudmill scan 26493 0123456789abcdef part 1.xyz\n");
    free(text);
    scan_sources_free(&scan);
}
END_TEST

START_TEST(files_and_place_read_back)
{
    struct scan_sources scan = {0}, back = {0};
    scan_sources_add_known(&scan, "a.xyz", 0, 0);
    scan_sources_add_known(&scan, "-", (size_t)1 << 40, ~(uint64_t)0);
    scan.placed = true;
    for (int i = 0; i < 16; i++)
        scan.place.m[i / 4][i % 4] = (i % 2 ? -1 : 1) / (3.0 + i) * (i == 5 ? 1e-300 : 1e6);
    char *text = surfaces_scan_text(&scan);
    ck_assert(read_lines(text, &back));
    ck_assert_uint_eq(back.n, 2);
    for (size_t i = 0; i < back.n; i++) {
        ck_assert_str_eq(back.item[i].name, scan.item[i].name);
        ck_assert(back.item[i].points == scan.item[i].points);
        ck_assert(back.item[i].hash == scan.item[i].hash);
    }
    ck_assert(back.placed);
    ck_assert_mem_eq(back.place.m, scan.place.m, sizeof scan.place.m);
    free(text);
    scan_sources_free(&scan);
    scan_sources_free(&back);
}
END_TEST

/* A name with a line's end in it must not begin a line; other bytes stay. */
START_TEST(a_name_stays_on_its_line)
{
    struct scan_sources scan = {0};
    scan_sources_add_known(&scan, "a\nb\tc\x1f d\xc3\xa9", 1, 2);
    char *text = surfaces_scan_text(&scan);
    ck_assert_str_eq(text, "cloudmill scan 1 0000000000000002 a?b?c? d\xc3\xa9\n");
    free(text);
    scan_sources_free(&scan);
}
END_TEST

START_TEST(other_lines_are_left)
{
    static const char *const other[] = {"",
                                        "cloudmill",
                                        "cloudmill scan",
                                        "cloudmill scan ",
                                        "cloudmill scan x 0 a",
                                        "Cloudmill scan 1 0000000000000002 a",
                                        " cloudmill scan 1 0000000000000002 a",
                                        "cloudmill place ",
                                        "cloudmill place 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0",
                                        "cloudmill place 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 x",
                                        "cloudmill place 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 inf"};
    struct scan_sources scan = {0};
    for (size_t i = 0; i < sizeof other / sizeof *other; i++)
        ck_assert_msg(!surfaces_scan_line(other[i], &scan), "%s", other[i]);
    ck_assert(scan.n == 0 && !scan.placed);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("surfaces_scan");
    TCase *tests = tcase_create("surfaces_scan");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, no_scan_no_line);
    tcase_add_test(tests, the_line_of_a_file);
    tcase_add_test(tests, files_and_place_read_back);
    tcase_add_test(tests, a_name_stays_on_its_line);
    tcase_add_test(tests, other_lines_are_left);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
