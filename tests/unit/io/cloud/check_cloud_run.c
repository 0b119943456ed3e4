/* cloud_run: the fast reader of plain rows against strtod, and against the careful one. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "clouds.h"

/* Many rows in one style: each number must be strtod's, whatever the path it took. */
START_TEST(random_rows_are_exact)
{
    enum { ROWS = 4000 };
    static char text[ROWS * 120];
    static double want[ROWS][3];
    static const char *const parting[] = {" ", "\t", ",", ", ", ";", "  "};
    for (int style = 0; style < 6; style++) {
        char *p = text;
        for (int i = 0; i < ROWS; i++) {
            for (int k = 0; k < 3; k++) {
                char *from = p;
                p += clouds_number(p);
                want[i][k] = strtod(from, NULL);
                p += sprintf(p, "%s", k < 2 ? parting[style] : "");
            }
            if (clouds_below(3) == 0)
                p += sprintf(p, "%s%u", parting[style], clouds_below(100));
            p += sprintf(p, clouds_below(20) ? "\n" : "\r\n");
        }
        clouds_expect(text, ROWS, (const double(*)[3])want);
    }
}
END_TEST

/*
 * The same text with LF, which may go through the fast reader, and with CR, which never does, must
 * give the same points, counts and message, whatever damage is in it.
 */
START_TEST(fast_is_as_careful)
{
    static const char dirt[] = " ,;.-+0123456789eEdD#/nai\txyz";
    static char text[5000];
    for (int round = 0; round < 4000; round++) {
        size_t n = 0;
        const char *parting = round % 4 == 0 ? "," : round % 4 == 1 ? ";" : " ";
        for (unsigned rows = 3 + clouds_below(20); rows; rows--) {
            for (int k = 0; k < 3; k++) {
                n += clouds_number(text + n);
                n += (size_t)sprintf(text + n, "%s", k < 2 ? parting : "");
            }
            n += (size_t)sprintf(text + n, "%s\n", clouds_below(3) ? "" : " 7 8");
        }
        for (unsigned changes = clouds_below(4); changes; changes--) {
            size_t at = clouds_below((unsigned)n - 1);
            if (text[at] != '\n')
                text[at] = dirt[clouds_below(sizeof dirt - 1)];
        }
        int status = clouds_bytes(text, n);
        struct vec3s fast = clouds.points;
        struct cloud_count fast_count = clouds.count;
        struct error fast_error = clouds.error;
        clouds.points = (struct vec3s){0};

        for (size_t i = 0; i < n; i++)
            if (text[i] == '\n')
                text[i] = '\r';
        ck_assert_int_eq(clouds_bytes(text, n), status);
        if (status < 0) {
            ck_assert_str_eq(clouds.error.text, fast_error.text);
        } else {
            ck_assert_uint_eq(clouds.points.n, fast.n);
            ck_assert_mem_eq(clouds.points.item, fast.item, fast.n * sizeof *fast.item);
            ck_assert_uint_eq(clouds.count.comments, fast_count.comments);
            ck_assert_uint_eq(clouds.count.heads, fast_count.heads);
            ck_assert_uint_eq(clouds.count.not_finite, fast_count.not_finite);
        }
        array_free(&fast);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_run");
    TCase *tests = tcase_create("cloud_run");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clouds_clear, clouds_clear);
    tcase_add_test(tests, random_rows_are_exact);
    tcase_add_test(tests, fast_is_as_careful);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
