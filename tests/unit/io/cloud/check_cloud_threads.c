/* cloud: a text that several threads parse gives the points, the counts and the errors of one, with
 * the line that is at fault; whatever stands in it, and where. */
#include "io/cloud/cloud.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "scratch.h"

enum { ROWS = 120000, LONG = 700000 };

/* A text under construction. */
static struct {
    char *item;
    size_t n, cap;
} text;

static void put(const char *bytes, size_t n)
{
    array_reserve(&text, text.n + n);
    memcpy(text.item + text.n, bytes, n);
    text.n += n;
}

static void put_text(const char *s)
{
    put(s, strlen(s));
}

/* Rows `from` to before `to`; no two are the same. */
static void put_rows(int from, int to, const char *end)
{
    char row[100];
    for (int i = from; i < to; i++)
        put(row, (size_t)sprintf(row, "%d.%03d %.2f -%d.5%s", i, i % 1000, i / 100.0, i % 7, end));
}

struct outcome {
    int status;
    struct vec3s points;
    struct cloud_count count;
    struct error error;
};

static struct outcome read_by(const char *file, int threads)
{
    struct outcome o = {0};
    o.status = cloud_read(file, threads, &o.points, &o.count, &o.error);
    return o;
}

static void same_outcome(const struct outcome *a, const struct outcome *b)
{
    ck_assert_int_eq(a->status, b->status);
    ck_assert_uint_eq(a->points.n, b->points.n);
    ck_assert(a->points.n == 0 ||
              memcmp(a->points.item, b->points.item, a->points.n * sizeof *a->points.item) == 0);
    ck_assert_uint_eq(a->count.points, b->count.points);
    ck_assert_uint_eq(a->count.comments, b->count.comments);
    ck_assert_uint_eq(a->count.heads, b->count.heads);
    ck_assert_uint_eq(a->count.not_finite, b->count.not_finite);
    ck_assert_uint_eq(a->count.first_not_finite, b->count.first_not_finite);
    ck_assert_uint_eq(a->count.columns, b->count.columns);
    ck_assert_uint_eq(a->count.open_end, b->count.open_end);
    ck_assert_int_eq(a->count.indexed, b->count.indexed);
    if (a->status != 0)
        ck_assert_str_eq(a->error.text, b->error.text);
}

/* By one thread, and the same by others, of the text under construction, which is then empty. */
static struct outcome read_text(void)
{
    static const int threads[] = {2, 3, 7, 0};
    const char *file = scratch_bytes(text.item, text.n);
    struct outcome one = read_by(file, 1);
    for (size_t k = 0; k < sizeof threads / sizeof *threads; k++) {
        struct outcome other = read_by(file, threads[k]);
        same_outcome(&one, &other);
        array_free(&other.points);
    }
    text.n = 0;
    return one;
}

static void expect_points(size_t n)
{
    struct outcome o = read_text();
    ck_assert_msg(o.status == 0, "%s", o.error.text);
    ck_assert_uint_eq(o.points.n, n);
    for (size_t i = 0; i < n; i++) /* each row is there, in its order */
        ck_assert(o.points.item[i].x == (double)(i * 1000 + i % 1000) / 1000);
    array_free(&o.points);
}

static void expect_error(const char *says)
{
    struct outcome o = read_text();
    ck_assert_int_eq(o.status, -1);
    ck_assert_msg(strstr(o.error.text, says) != NULL, "%s\n  lacks: %s", o.error.text, says);
    array_free(&o.points);
}

START_TEST(plain_rows)
{
    put_rows(0, ROWS, "\n");
    expect_points(ROWS);
    put_rows(0, ROWS, "\r\n");
    expect_points(ROWS);
    put_rows(0, ROWS, " 12 13\n");
    expect_points(ROWS);
    for (int rows = 1; rows < 6; rows++) {
        put_rows(0, rows, "\n");
        expect_points((size_t)rows);
    }
}
END_TEST

START_TEST(no_line_end)
{
    put_rows(0, ROWS, "\n");
    put_text("120000 1 2");
    struct outcome o = read_text();
    ck_assert_int_eq(o.status, 0);
    ck_assert_uint_eq(o.count.open_end, ROWS + 1);
    ck_assert_uint_eq(o.points.n, ROWS + 1);
    array_free(&o.points);
    put_rows(0, ROWS, "\r"); /* line ends as of old, none of which is ours to cut at */
    expect_points(ROWS);
}
END_TEST

/* The first line at fault is named, wherever it is, and whatever is at fault behind it. */
START_TEST(bad_lines)
{
    static const int at[] = {700, 40000, 61234, 90001, ROWS - 1};
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        char says[60];
        sprintf(says, ":%d: 'wrong' is no number", at[k] + 1);
        put_rows(0, at[k], "\n");
        put_text("wrong 1 2\n");
        put_rows(at[k], ROWS, "\n");
        put_text("wronger 1 2\n");
        expect_error(says);
    }
    put_rows(0, 70000, "\n");
    put_text("1 2\n");
    put_rows(70000, ROWS, "\n");
    expect_error(":70001: 2 columns in the row");
    put_rows(0, 70000, "\n");
    put("1 2\0 3\n", 7);
    put_rows(70000, ROWS, "\n");
    expect_error(":70001: a NUL byte");
}
END_TEST

/* Lines that are no rows, one by one, many after each other, and longer than a thread's part. */
START_TEST(other_lines)
{
    put_text("# a scan\nx y z\n");
    put_rows(0, 30000, "\n");
    for (int i = 0; i < 40000; i++)
        put_text("# nothing to be seen here, nor there\n");
    put_rows(30000, 60000, "\n");
    put_text("# ");
    for (int i = 0; i < LONG; i++)
        put_text("#");
    put_text("\n\n");
    put_rows(60000, ROWS, "\n# between\n");
    expect_points(ROWS);

    put_rows(0, 60000, "\n");
    put_text("60000.000 1 2");
    for (int i = 0; i < LONG; i++)
        put_text(" 3");
    put_text("\n");
    put_rows(60001, ROWS, "\n");
    expect_points(ROWS);

    put_rows(0, 61000, "\n");
    put_text("nan 1 2\n");
    put_rows(61000, 100000, "\n");
    put_text("inf 1 2\n");
    put_rows(100000, ROWS, "\n");
    struct outcome o = read_text();
    ck_assert_int_eq(o.status, 0);
    ck_assert_uint_eq(o.count.not_finite, 2);
    ck_assert_uint_eq(o.count.first_not_finite, 61001);
    ck_assert_uint_eq(o.points.n, ROWS);
    array_free(&o.points);
}
END_TEST

/* A count of rows, kept or not; rows with their numbers before them. */
START_TEST(counted)
{
    char count[40];
    sprintf(count, "%d\n", ROWS);
    put_text(count);
    put_rows(0, ROWS, "\n");
    expect_points(ROWS);
    put_text("100000\n");
    put_rows(0, ROWS, "\n");
    expect_error(":100002: a row more than the 100000 of line 1");
    put_text(count);
    put_rows(0, ROWS - 1, "\n");
    expect_error("119999 rows, expected the 120000 of line 1");
    for (int i = 0; i < ROWS; i++) {
        put(count, (size_t)sprintf(count, "%d ", i));
        put_rows(i, i + 1, "\n");
    }
    expect_points(ROWS);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_threads");
    TCase *tests = tcase_create("cloud_threads");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, plain_rows);
    tcase_add_test(tests, no_line_end);
    tcase_add_test(tests, bad_lines);
    tcase_add_test(tests, other_lines);
    tcase_add_test(tests, counted);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    array_free(&text);
    return failed != 0;
}
