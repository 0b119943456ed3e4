/* reader: lines with every end and of any length, bytes, peeking, and the whole lines ahead. */
#include <check.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/reader.h"
#include "scratch.h"
#include "seed.h"

static struct reader r;
static struct error error;

static void open_bytes(const void *bytes, size_t n)
{
    reader_close(&r);
    ck_assert_int_eq(reader_open(&r, scratch_bytes(bytes, n), &error), 0);
}

static void next_is(const char *want, size_t number)
{
    char *line;
    size_t n;
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), 1);
    ck_assert_str_eq(line, want);
    ck_assert_uint_eq(n, strlen(want));
    ck_assert_uint_eq(r.line, number);
}

static void at_end(void)
{
    char *line;
    size_t n;
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), 0);
}

static void lines(const char *text, size_t count, const char *const want[])
{
    open_bytes(text, strlen(text));
    for (size_t i = 0; i < count; i++)
        next_is(want[i], i + 1);
    at_end();
}

START_TEST(every_line_end)
{
    static const char *const want[] = {"a", "", "b", "c"};
    lines("a\n\nb\nc\n", 4, want);
    lines("a\r\n\r\nb\r\nc\r\n", 4, want);
    lines("a\r\rb\rc\r", 4, want);
    lines("a\n\rb\r\nc", 4, want);
    lines("a\r\n\nb\rc", 4, want);
    lines("\xEF\xBB\xBF"
          "a\n\nb\nc",
          4, want);
    lines("", 0, want);
    lines("\xEF\xBB\xBF", 0, want);
    static const char *const mark_inside[] = {"a\xEF\xBB\xBF", "\xEF\xBB\xBF"};
    lines("a\xEF\xBB\xBF\n\xEF\xBB\xBF\n", 2, mark_inside);
}
END_TEST

START_TEST(ended_says_how_the_last_line_ends)
{
    open_bytes("a\nb", 3);
    next_is("a", 1);
    ck_assert(r.ended);
    next_is("b", 2);
    ck_assert(!r.ended);
    open_bytes("a\r", 2);
    next_is("a", 1);
    ck_assert(r.ended);
}
END_TEST

START_TEST(unread_gives_it_again)
{
    open_bytes("a b\r\nc\rd", 8);
    next_is("a b", 1);
    reader_unread(&r);
    next_is("a b", 1);
    next_is("c", 2);
    reader_unread(&r);
    next_is("c", 2);
    next_is("d", 3);
    reader_unread(&r);
    next_is("d", 3);
    at_end();
}
END_TEST

static uint64_t state = 1;

static unsigned below(unsigned n)
{
    state = state * 6364136223846793005u + seed_step();
    return (unsigned)(state >> 33) % n;
}

/* Lines of 0 to 200,000 letters with random ends, over many buffers, against a plain search. */
START_TEST(random_lines)
{
    enum { SIZE = 3000000 };
    char *text = malloc(SIZE + 1);
    for (int round = 0; round < 6; round++) {
        size_t n = 0;
        unsigned longest = round % 2 ? 200000 : 60;
        while (n < SIZE - 200002) {
            for (unsigned k = below(longest); k; k--)
                text[n++] = (char)('a' + below(26));
            const char *end[] = {"\n", "\r\n", "\r"};
            n += strlen(strcpy(text + n, end[round < 2 ? 0 : round < 4 ? 2 : below(3)]));
        }
        text[n] = '\0';
        open_bytes(text, n);
        ck_assert_uint_eq(r.size, n);
        for (size_t at = 0, number = 1; at < n; number++) {
            char *line;
            size_t length = strcspn(text + at, "\r\n"), got;
            if (reader_line(&r, &line, &got, &error) != 1 || got != length ||
                memcmp(line, text + at, length) != 0 || line[length] != '\0' || r.line != number)
                ck_abort_msg("line %zu of round %d", number, round);
            at += length;
            at += text[at] == '\r' && text[at + 1] == '\n' ? 2 : 1;
        }
        at_end();
    }
    free(text);
}
END_TEST

/* A file cut off after it was opened is not taken for a shorter one; from the middle on it is. */
START_TEST(ends_before_its_length)
{
    static const char text[] = "a\nb\nc\n";
    char *line;
    size_t n;
    const char *file = scratch_bytes(text, 6);
    reader_close(&r);
    ck_assert_int_eq(reader_open(&r, file, &error), 0);
    ck_assert_int_eq(truncate(file, 3), 0);
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), 1);
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "ends after 3 bytes, expected 6"));
    ck_assert(error.file && error.system);

    reader_close(&r);

    int standard = dup(0), fd = open(scratch_bytes(text, 6), O_RDONLY);
    ck_assert_int_eq(lseek(fd, 2, SEEK_SET), 2);
    dup2(fd, 0);
    ck_assert_int_eq(reader_open(&r, "-", &error), 0);
    ck_assert_uint_eq(r.size, 4);
    next_is("b", 1);
    next_is("c", 2);
    at_end();
    dup2(standard, 0);
    close(standard);
    close(fd);
}
END_TEST

/* Lines taken from the buffer and lines read, in turn, are all lines in order. */
START_TEST(ahead_and_lines_in_turn)
{
    enum { LINES = 40000 };
    char *text = malloc(LINES * 12), *p = text;
    for (unsigned i = 0; i < LINES; i++)
        p += sprintf(p, "%u%s", i, i % 7 ? "\n" : "\r\n");
    open_bytes(text, (size_t)(p - text));
    unsigned next = 0, taken = 0;
    while (next < LINES) {
        const char *ahead;
        size_t n = reader_ahead(&r, &ahead), from = 0;
        size_t count = 0;
        if (n > 0)
            ck_assert_int_eq(ahead[n - 1], '\n');
        for (unsigned want = below(3000); want && from < n; want--, count++) {
            ck_assert_uint_eq(strtoul(ahead + from, NULL, 10), next++);
            from +=
                (size_t)((const char *)memchr(ahead + from, '\n', n - from) + 1 - (ahead + from));
        }
        reader_take(&r, from, count);
        taken += (unsigned)count;
        ck_assert_uint_eq(r.line, next);
        if (next < LINES) {
            char want[20];
            sprintf(want, "%u", next);
            next_is(want, ++next);
        }
    }
    ck_assert_uint_gt(taken, LINES / 2);
    at_end();
    free(text);
}
END_TEST

START_TEST(bytes_behind_lines)
{
    static const char text[] = "head\n\0\n\r\xFF tail";
    const char *peeked;
    char byte[20];
    open_bytes(text, sizeof text - 1);
    ck_assert_int_eq(reader_peek(&r, &peeked, 4, &error), 4);
    ck_assert_mem_eq(peeked, "head", 4);
    next_is("head", 1);
    ck_assert_int_eq(reader_peek(&r, &peeked, 4096, &error), 9);
    ck_assert_int_eq(reader_bytes(&r, byte, 3, &error), 3);
    ck_assert_mem_eq(byte, "\0\n\r", 3);
    ck_assert_int_eq(reader_bytes(&r, byte, 20, &error), 6);
    ck_assert_mem_eq(byte, "\xFF tail", 6);
    ck_assert_int_eq(reader_bytes(&r, byte, 20, &error), 0);
}
END_TEST

START_TEST(nul_is_counted)
{
    char *line;
    size_t n;
    open_bytes("a\0b\nc", 5);
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), 1);
    ck_assert_uint_eq(n, 3);
    ck_assert_mem_eq(line, "a\0b", 4);
}
END_TEST

START_TEST(what_is_no_file)
{
    struct reader none;
    ck_assert_int_eq(reader_open(&none, "/nonexistent/file", &error), -1);
    ck_assert_str_eq(error.text, "/nonexistent/file: cannot open: No such file or directory");
    ck_assert_int_eq(reader_open(&none, "/", &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "/: is a directory"));
}
END_TEST

/* A line as long as may be, and one that goes on and on: holes in a file, which are bytes of 0. */
START_TEST(longest_line)
{
    char *line;
    size_t n;
    scratch_text("");
    ck_assert_int_eq(truncate(scratch_name(), READER_LINE), 0);
    ck_assert_int_eq(reader_open(&r, scratch_name(), &error), 0);
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), 1);
    ck_assert_uint_eq(n, READER_LINE);
    reader_close(&r);
    ck_assert_int_eq(truncate(scratch_name(), 4 * (off_t)READER_LINE), 0);
    ck_assert_int_eq(reader_open(&r, scratch_name(), &error), 0);
    ck_assert_int_eq(reader_line(&r, &line, &n, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, ":1: found a line of more than 268435456 bytes"));
    ck_assert_uint_le(r.got, 2 * (size_t)READER_LINE + (1 << 20));
    ck_assert_int_eq(truncate(scratch_name(), 0), 0);
}
END_TEST

START_TEST(what_is_read_once)
{
    ck_assert(reader_reads_once(NULL));
    ck_assert(reader_reads_once("-"));
    ck_assert(!reader_reads_once(scratch_text("1 2 3\n")));
    ck_assert(!reader_reads_once("/nonexistent/file"));
    ck_assert_int_eq(unlink(scratch_name()), 0);
    ck_assert_int_eq(mkfifo(scratch_name(), 0600), 0);
    ck_assert(reader_reads_once(scratch_name()));
    ck_assert_int_eq(unlink(scratch_name()), 0);
}
END_TEST

static void begin(void)
{
    memset(&r, 0, sizeof r);
}

static void end(void)
{
    reader_close(&r);
}

int main(void)
{
    Suite *suite = suite_create("reader");
    TCase *tests = tcase_create("reader");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, every_line_end);
    tcase_add_test(tests, ended_says_how_the_last_line_ends);
    tcase_add_test(tests, unread_gives_it_again);
    tcase_add_test(tests, random_lines);
    tcase_add_test(tests, ends_before_its_length);
    tcase_add_test(tests, ahead_and_lines_in_turn);
    tcase_add_test(tests, bytes_behind_lines);
    tcase_add_test(tests, nul_is_counted);
    tcase_add_test(tests, what_is_no_file);
    tcase_add_test(tests, longest_line);
    tcase_add_test(tests, what_is_read_once);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
