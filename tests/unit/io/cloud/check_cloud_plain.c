/* cloud_plain: even columns are told from others, and both ways of reading give the same points, in
 * their order, up to the first row that is not plain. */
#include "io/cloud/cloud_plain.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "seed.h"

static uint64_t state;

static unsigned below(unsigned n)
{
    state = state * 6364136223846793005u + seed_step();
    return (unsigned)(state >> 33) % n;
}

static bool is_even(const char *text)
{
    return cloud_plain_even(text, text + strlen(text));
}

START_TEST(even_columns)
{
    ck_assert(is_even("1.25 2.5 3.125\n"));
    ck_assert(is_even("1.25 2.5 3.125\n10.00 -2.0 30.000\n1.11 2.2 3.333\n"));
    ck_assert(is_even("1 2 3\n10 20 30\n"));
    ck_assert(is_even("1.2,2.3,3.4,0.5\n1.2,2.3,3.4,0.55\n1.2,2.3,3.4,0.5555\n")); /* a fourth */
    ck_assert(is_even("1.2,2.3,3.4,0.5,1.25\n1.2,2.3,3.4,0.55,1.5\n"));
    char text[4000] = "";
    for (int row = 0; row < 70; row++)
        sprintf(text + strlen(text), "1.%s 2.0 3.0\n", row % 5 ? "25" : "5");
    ck_assert(!is_even(text)); /* one in five ends with a zero that is left out */
    ck_assert(
        !is_even("1.25 2.5 3.125\n1.25 2.5 3.12\n1.2 2.5 3.125\n1.25 2 3.125\n1 2 3\n4 5 6\n"));
}
END_TEST

/* A number of some digits; many have as many decimals. */
static size_t put_number(char *to, int places)
{
    return (size_t)sprintf(to, "%s%.*f", below(3) ? "" : "-", below(8) ? places : (int)below(9),
                           below(100000) / (1.0 + below(999)));
}

static void same_both_ways(const struct cloud_options *style, const char *text, size_t n,
                           size_t most)
{
    struct vec3s points[2] = {{0}, {0}};
    size_t rows[2], taken[2];

    for (int even = 0; even < 2; even++)
        taken[even] =
            cloud_plain_rows(style, even == 1, 1, text, text + n, most, &points[even], &rows[even]);
    ck_assert_uint_eq(taken[0], taken[1]);
    ck_assert_uint_eq(rows[0], rows[1]);
    ck_assert_uint_le(rows[0], most);
    ck_assert_uint_eq(points[0].n, rows[0]);
    ck_assert_uint_eq(points[1].n, rows[1]);
    ck_assert(rows[0] == 0 ||
              memcmp(points[0].item, points[1].item, rows[0] * sizeof *points[0].item) == 0);
    array_free(&points[0]);
    array_free(&points[1]);
}

START_TEST(both_ways)
{
    enum { MOST_ROWS = 400 };
    static char text[MOST_ROWS * 100 + 16]; /* some bytes behind it may be looked at */
    static const char dirt[] = " ,;.-+0123456789eEdD#/nai\txyz";
    static const char delimiter[] = {' ', ',', ';'};

    for (int round = 0; round < 600; round++) {
        struct cloud_options style = {.delimiter = delimiter[round % 3], .column = {0, 1, 2}};
        unsigned rows = 1 + below(MOST_ROWS);
        int places = (int)below(7);
        size_t n = 0;
        for (unsigned row = 0; row < rows; row++)
            for (int k = 0; k < 3; k++) {
                n += put_number(text + n, places);
                text[n++] = k < 2 ? style.delimiter : '\n';
            }
        for (unsigned changes = below(3); changes > 0; changes--) {
            size_t at = below((unsigned)n - 1);
            text[at] = text[at] == '\n' ? '\n' : dirt[below(sizeof dirt - 1)];
        }
        same_both_ways(&style, text, n, below(2) ? rows : below(rows) + 1);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_plain");
    TCase *tests = tcase_create("cloud_plain");
    tcase_add_test(tests, even_columns);
    tcase_add_test(tests, both_ways);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
