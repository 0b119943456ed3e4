/* cloud_text: every way of writing three points in rows, and every row that is refused. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "clouds.h"

START_TEST(partings)
{
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    clouds_three("1.5\t-2.25\t3000\n0.5\t0.25\t-4\n7\t8\t9\n");
    clouds_three("  1.5    -2.25  3000 \n0.5 0.25\t -4\t\n\t7 8 9\n");
    clouds_three("1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    clouds_three(" 1.5 , -2.25,\t3000 ,\n0.5,0.25, -4,\n7, 8, 9\n");
    clouds_three("1.5;-2.25;3000\n0.5 ; 0.25;-4;\n7;8;9\n");
}
END_TEST

START_TEST(numbers)
{
    clouds_three("+1.5 -2.25e0 3e3\n.5 2.5E-1 -4.\n70d-1 0.8D+01 09\n");
    clouds_three("15E-1 -225.0e-2 3000.000000000000000000000\n0000000000000000000000.5 .25 -4e+0\n"
                 "7.00000000000000000000 8 9\n");
    static const double exact[][3] = {
        {0.1, 123456789.123456789, 4649776.2345},
        {1.7976931348623157e-300, 5e-324, 9007199254740993e-3},
    };
    clouds_expect("0.1 123456789.123456789 4649776.2345\n"
                  "1.7976931348623157e-300 5e-324 9007199254740.993\n",
                  2, exact);
}
END_TEST

START_TEST(decimal_commas)
{
    clouds_three("1,5;-2,25;3000\n0,5;0,25;-4\n7;8;9\n");
    clouds_three("1,5 -2,25 3000\n0,5 0,25 -4\n7 8 9\n");
    clouds_three("1,5\t-2,25\t3000\n,5\t0,25\t-4,0\n7\t8\t9\n");
    static const double late[][3] = {{0, 0, 0}, {1, 2, 3}, {0.5, 1.5, 2.5}};
    clouds_expect("0;0;0\n1;2;3\n0,5;1,5;2,5\n", 3, late);
    clouds_expect("0 0 0\n1 2 3\n0,5 1,5 2,5\n", 3, late);
    clouds_refused("1.5 2 3\n1,5 2 3\n", ":2: '1,5'");
    clouds_refused("1,5;2;3\n1.5;2;3\n", ":2: '1.5'");
    clouds_refused("0 0 0\n1 2 3\n0.5 1 2\n0,5 1 2\n", ":4: '0,5'");
    clouds_refused("0 0 0\n1.5 2,5 3\n", ":2: '2,5'");
    clouds_refused("0 0 0\n1,500.5 2 3\n", ":2: '1,500.5'");
    clouds_refused("1,5,2,5,3,5 1\n2,5,2,5,3,5 1\n,\n", ":3: ");
}
END_TEST

START_TEST(line_ends)
{
    clouds_three("1.5 -2.25 3000\r\n0.5 0.25 -4\r\n7 8 9\r\n");
    clouds_three("1.5 -2.25 3000\r0.5 0.25 -4\r7 8 9\r");
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4\r7 8 9");
    clouds_three("\xEF\xBB\xBF"
                 "1.5 -2.25 3000\n\n  \n0.5 0.25 -4\n\r\n7 8 9\n\n\t\n");
}
END_TEST

START_TEST(comments)
{
    clouds_three("# made\n#1 2 3\n1.5 -2.25 3000 # first\n// x y z\n0.5 0.25 -4 // second\n"
                 "; 5 5 5\n7 8 9 ; third\n# end\n");
    ck_assert_uint_eq(clouds.count.comments, 5);
    ck_assert_uint_eq(clouds.count.heads, 0);
    ck_assert_uint_eq(clouds.count.columns, 3);
    clouds_three("#x;y;z\n1.5;-2.25;3000\n0.5;0.25;-4;#last\n7;8;9\n");
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4;no\n7 8 9#9\n");
    clouds_refused("1 2 3\n4 5 # 6\n7 8 9\n", ":2: 2 columns");
    clouds_refused("1 2 3\n4 5 ; 6\n7 8 9\n", ":2: 2 columns");
}
END_TEST

START_TEST(headings)
{
    clouds_three("X Y Z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.heads, 1);
    clouds_three("\"x [mm]\",\"y [mm]\",\"z [mm]\"\n1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    clouds_three("Scan of panel 7, 12.3.2019, 600 points\nOperator: H. M.\n\nx y z\n"
                 "1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.heads, 3);
    clouds_three("600 points\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    clouds_three("12 3 2019 scan of a panel\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.heads, 1);
    clouds_three("12 3 2019 scan, of, a panel\n1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    clouds_three("M\xFCller\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
}
END_TEST

START_TEST(further_columns)
{
    clouds_three("1.5 -2.25 3000 12\n0.5 0.25 -4 13\n7 8 9 14\n");
    ck_assert_uint_eq(clouds.count.columns, 4);
    clouds_three("1.5 -2.25 3000 1 2 nan\n0.5 0.25 -4 1 2 3\n7 8 9 1 2 3");
    ck_assert_uint_eq(clouds.count.columns, 6);
    clouds_three("x,y,z,class\n1.5,-2.25,3000,ground\n0.5,0.25,-4,high wall\n7,8,9,1\n");
    clouds_three("1.5 -2.25 3000 a\n0.5 0.25 -4 b,c\n7 8 9\n");
}
END_TEST

/* A heading that names as many columns as there are says where x, y and z stand. */
START_TEST(named_columns)
{
    clouds_three("id,x,y,z\nP1,1.5,-2.25,3000\nP2,0.5,0.25,-4\nP3,7,8,9\n");
    clouds_three("Z;Y (mm);time;X_mm\n3000;-2,25;0;1,5\n-4;0,25;1;0,5\n9;8;2;7\n");
    clouds_three("nx ny nz x y z\n0 0 1 1.5 -2.25 3000\n0 0 1 0.5 0.25 -4\n0 0 1 7 8 9\n");
    clouds_three("my x y z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n"); /* four names, three columns */
    clouds_three("x y x\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    clouds_refused("id,x,y,z\nP1,1.5,-2.25,3000\nP2,0.5,0.25\n", ":3: 3 columns");
}
END_TEST

START_TEST(not_finite_is_counted)
{
    clouds_three(
        "1.5 -2.25 3000\nnan nan nan\n0.5 0.25 -4\n12.0 NaN 3.0\n-nan(ind) 1 2\n1 -Infinity 2\n"
        "1 2 1e999\n1.#IND 1 2\n1 -1.#INF00 2\n1 1e31 2\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.not_finite, 8);
    ck_assert_uint_eq(clouds.count.first_not_finite, 2);
    clouds_three("nan nan nan\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.not_finite, 1);
    clouds_three("nan;nan;nan\n1,5;-2,25;3000\n0,5;0,25;-4\n7;8;9\n");
    clouds_refused("nan nan nan\ninf 1 2\n", "no points (2 rows");
    clouds_refused("1 2 3\n1 nano 3\n", ":2: 'nano'");
    clouds_refused("1 2 3\n1 inf2x 3\n", ":2: 'inf2x'");
}
END_TEST

START_TEST(broken_rows)
{
    clouds_refused("1 2 3\n4 oops 6\n7 8 9\n", ":2: 'oops' is no number");
    clouds_refused("1 2 3\n4 5.6.7 6\n7 8 9\n", ":2: '5.6.7'");
    clouds_refused("1 2 3\n4 5\n7 8 9\n", ":2: 2 columns");
    clouds_refused("1 2 3\nx y z\n7 8 9\n", ":2: 'x'");
    clouds_refused("1 2 3\n4 5 6abc\n7 8 9\n", ":2: '6abc'");
    clouds_refused("1 2 3\n4 5 0x10\n7 8 9\n", ":2: '0x10'");
    clouds_refused("1 2 3\n4 5 --6\n7 8 9\n", ":2: '--6'");
    clouds_refused("1 2 3\n4 5 6e\n7 8 9\n", ":2: '6e'");
    clouds_refused("1,2,3\n4,,6\n7,8,9\n", ":2: ''");
    clouds_refused("1,2,3\n4,5 6\n7,8,9\n", ":2: '5 6'");
    clouds_refused("1,2,3\n4 5 6\n7,8,9\n", ":2: '4 5 6'");
    clouds_refused("1 2 3\n4,5,6\n7 8 9\n", ":2: '4,5,6'");
    clouds_refused("1 2\n3 4\n", ":1: 2 columns");
    clouds_refused("1 2\n3 4 5\n", ":1: 2 columns");
    clouds_refused("12.5 7.5 oops\n3 4 5\n", ":1: 'oops'");
    clouds_refused("5.5\n3 4 5\n", ":1: 1 column in");
    clouds_refused("1\n2\n3\n4\n", ":3: ");
}
END_TEST

START_TEST(cut_short)
{
    clouds_refused("1 2 3\n4 5 6\n7 8", ":3: 2 columns in the last row");
    clouds_refused("1 2 3\n4 5 6\n7", ":3: 1 columns in the last row");
    clouds_refused("1 2 3 100\n4 5 6 100\n7 8 9", ":3: 3 columns in the last row, expected 4");
    ck_assert_int_eq(clouds_text("1 2 3 100\n4 5 6 100\n7 8 9\n"), 0);
}
END_TEST

START_TEST(counts)
{
    clouds_three("3\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.heads, 1);
    clouds_three("# PTS\n2\n1.5 -2.25 3000 -100 1 2 3\n0.5 0.25 -4 5 1 2 3\n1\n7 8 9 5 1 2 3\n");
    clouds_three("7\nx y z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n"); /* no count of what follows */
    clouds_refused("4\n1 2 3\n4 5 6\n7 8 9\n", "3 rows, expected the 4 of line 1");
    clouds_refused("2\n1 2 3\n4 5 6\n7 8 9\n", ":4: a row more than the 2 of line 1");
    clouds_refused("2\n1 2 3\n4 5 6\n2\n7 8 9\n", "1 rows, expected the 2 of line 4");
    clouds_refused("3\n1 2 3\n4 5 6\n2\n7 8 9\n", ":4: 1 column in the row");
    clouds_refused("99999999999999999999\n1 2 3\n", ":1: ");
    clouds_refused("-3\n1 2 3\n", ":1: ");
    clouds_refused("3.5\n1 2 3\n", ":1: ");
    clouds_refused("3\n", "0 rows, expected the 3");
}
END_TEST

START_TEST(long_lines)
{
    size_t n = 300000;
    char *text = malloc(n + 100);
    memset(text, 'x', n);
    text[0] = '#';
    strcpy(text + n, "\n1 2 3\n");
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert_uint_eq(clouds.points.n, 1);
    memset(text, '1', n);
    strcpy(text + n, " 2 3\n4 5 6\n");
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert_uint_eq(clouds.points.n, 1);
    ck_assert_uint_eq(clouds.count.not_finite, 1);
    memset(text, '0', n);
    strcpy(text + n, "1 2 3\n4 5 6\n");
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert_uint_eq(clouds.points.n, 2);
    ck_assert_double_eq(clouds.points.item[0].x, 1);
    for (size_t i = 0; i < n; i += 2)
        memcpy(text + i, "4 ", 2);
    strcpy(text + n, "\n");
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert_uint_eq(clouds.count.columns, n / 2);
    free(text);
}
END_TEST

/* The fast reader of plain rows against strtod, and against the careful one. */
/* Many rows in one style: each number must be strtod's, whatever the path it took. */
START_TEST(random_rows_are_exact)
{
    enum { ROWS = 4000 };
    static char text[ROWS * 120];
    static double want[ROWS][3];
    static const char *const delimiter[] = {" ", "\t", ",", ", ", ";", "  "};
    for (int style = 0; style < 6; style++) {
        char *p = text;
        for (int i = 0; i < ROWS; i++) {
            for (int k = 0; k < 3; k++) {
                char *from = p;
                p += clouds_number(p);
                want[i][k] = strtod(from, NULL);
                p += sprintf(p, "%s", k < 2 ? delimiter[style] : "");
            }
            if (clouds_below(3) == 0)
                p += sprintf(p, "%s%u", delimiter[style], clouds_below(100));
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
        const char *delimiter = round % 4 == 0 ? "," : round % 4 == 1 ? ";" : " ";
        for (unsigned rows = 3 + clouds_below(20); rows; rows--) {
            for (int k = 0; k < 3; k++) {
                n += clouds_number(text + n);
                n += (size_t)sprintf(text + n, "%s", k < 2 ? delimiter : "");
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

/* Much text is read at two places at once: rows keep their order, and a line that is no plain row
 * is found wherever it stands. */
START_TEST(much_text)
{
    enum { ROWS = 6000, SPECIAL = 97 };
    static const char *const odd[] = {"# no row\n", "\n", "1e0 2 3 4\n", "1 2 x\n"};
    char *text = malloc(ROWS * 40 + 100), part[80];
    for (int at = 0; at < ROWS; at += SPECIAL) {
        const char *line = odd[at / SPECIAL % 4];
        bool bad = strchr(line, 'x') != NULL && at > 0;
        size_t n = 0, extra = line[0] == '1' && at > 0;
        for (int i = 0; i < ROWS; i++) {
            if (i == at && at > 0)
                n += (size_t)sprintf(text + n, "%s", line);
            n += (size_t)sprintf(text + n, "%d %d.%d %d\n", i, i * 7 % 1013, i % 10, -i);
        }
        if (bad) {
            sprintf(part, ":%d: ", at + 1);
            clouds_refused(text, part);
            continue;
        }
        ck_assert_int_eq(clouds_bytes(text, n), 0);
        ck_assert_uint_eq(clouds.points.n, ROWS + extra);
        for (int i = 0; i < ROWS; i++) {
            struct vec3 p = clouds.points.item[i + (i >= at ? (int)extra : 0)];
            ck_assert_double_eq(p.x, i);
            ck_assert_double_eq(p.z, -i);
        }
    }
    free(text);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_text");
    TCase *tests = tcase_create("cloud_text");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clouds_clear, clouds_clear);
    tcase_add_test(tests, partings);
    tcase_add_test(tests, numbers);
    tcase_add_test(tests, decimal_commas);
    tcase_add_test(tests, line_ends);
    tcase_add_test(tests, comments);
    tcase_add_test(tests, headings);
    tcase_add_test(tests, further_columns);
    tcase_add_test(tests, named_columns);
    tcase_add_test(tests, not_finite_is_counted);
    tcase_add_test(tests, broken_rows);
    tcase_add_test(tests, cut_short);
    tcase_add_test(tests, counts);
    tcase_add_test(tests, long_lines);
    tcase_add_test(tests, random_rows_are_exact);
    tcase_add_test(tests, fast_is_as_careful);
    tcase_add_test(tests, much_text);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
