/* trim_clip: one line through a cell leaves what is on its left, two leave what is between or
 * beside; lines that cross are refused. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "nurbs/trim_clip.h"

/* Vertices 0 to 3 are the corners of the cell from the lower left, counter-clockwise; others lie at
 * `x` and `y`. */
static const double x[] = {0, 1, 1, 0, 0.3, 0.3, 0.7, 0.7}, y[] = {0, 0, 1, 1, 0, 1, 1, 0};
static const int corner[4] = {0, 1, 2, 3};

static double area(const struct polygons *p)
{
    double sum = 0;
    for (size_t k = 0, from = 0; k < p->end.n; from = p->end.item[k++]) {
        double part = 0;
        size_t n = p->end.item[k] - from;
        for (size_t i = 0; i < n; i++) {
            int a = p->id.item[from + i], b = p->id.item[from + (i + 1) % n];
            part += (x[a] * y[b] - x[b] * y[a]) / 2;
        }
        ck_assert_double_gt(part, 0);
        sum += part;
    }
    return sum;
}

/* From the bottom (0) to the top (2) at the place of vertices 4 and 5, or 6 and 7 downwards. */
static const struct trim_chain up = {
    .first = 0, .n = 2, .side_in = 0, .in = 0.3, .side_out = 2, .out = -0.3};
static const struct trim_chain down = {
    .first = 2, .n = 2, .side_in = 2, .in = -0.7, .side_out = 0, .out = 0.7};

START_TEST(one_line)
{
    static const int id[] = {4, 5, 6, 7};
    struct polygons p = {0};
    struct trim_chain chain[1] = {up};
    ck_assert(trim_clip(chain, 1, id, corner, &p));
    ck_assert_double_lt(fabs(area(&p) - 0.3), 1e-15);
    chain[0] = down;
    ck_assert(trim_clip(chain, 1, id, corner, &p));
    ck_assert_double_lt(fabs(area(&p) - 0.3), 1e-15); /* right of 0.7 is on its left */
    polygons_free(&p);
}
END_TEST

START_TEST(two_lines)
{
    static const int beside[] = {4, 5, 6, 7}, between[] = {7, 6, 5, 4};
    struct polygons p = {0};
    struct trim_chain chain[2] = {up, down};
    ck_assert(trim_clip(chain, 2, beside, corner, &p));
    ck_assert_uint_eq(p.end.n, 2);
    ck_assert_double_lt(fabs(area(&p) - 0.6), 1e-15);
    struct trim_chain inner[2] = {up, down};
    inner[0].in = 0.7, inner[0].out = -0.7, inner[1].in = -0.3, inner[1].out = 0.3;
    ck_assert(trim_clip(inner, 2, between, corner, &p));
    ck_assert_uint_eq(p.end.n, 1);
    ck_assert_double_lt(fabs(area(&p) - 0.4), 1e-15);
    polygons_free(&p);
}
END_TEST

START_TEST(both_upwards)
{
    static const int id[] = {4, 5, 7, 6};
    struct polygons p = {0};
    struct trim_chain chain[2] = {up, up};
    chain[1].first = 2;
    chain[1].in = 0.7, chain[1].out = -0.7;
    ck_assert(!trim_clip(chain, 2, id, corner, &p));
    polygons_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_clip");
    TCase *tests = tcase_create("trim_clip");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, one_line);
    tcase_add_test(tests, two_lines);
    tcase_add_test(tests, both_upwards);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
