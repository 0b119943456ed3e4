/*
 * trim_tidy: on a flat square of 10 mm, whose parameters are 0 to 1, with a tolerance of 0.1 mm:
 * corners within 0.005 mm of the border are on it, within 0.001 mm of each other they are one, and
 * ways there and back are gone, wherever the loop begins.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/trim_tidy.h"

static struct patch flat;

static void setup(void)
{
    flat = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
}

static void teardown(void)
{
    patch_free(&flat);
}

/* The loop of these corners from number `first` on, tidied, has those. */
static void becomes(const struct uv *at, size_t n, size_t first, const struct uv *wanted,
                    size_t most)
{
    struct uvs loop = {0};
    for (size_t i = 0; i < n; i++)
        *array_push(&loop) = at[(first + i) % n];
    trim_tidy(&flat.surface, 0.1, &loop);
    ck_assert_uint_eq(loop.n, most);
    size_t shift = 0;
    while (shift < most && !(fabs(loop.item[shift].u - wanted[0].u) < 2e-4 &&
                             fabs(loop.item[shift].v - wanted[0].v) < 2e-4))
        shift++;
    ck_assert_uint_lt(shift, most);
    for (size_t i = 0; i < most; i++) {
        struct uv got = loop.item[(shift + i) % most];
        ck_assert_double_eq_tol(got.u, wanted[i].u, 2e-4);
        ck_assert_double_eq_tol(got.v, wanted[i].v, 2e-4);
    }
    array_free(&loop);
}

static const struct uv square[] = {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};

START_TEST(as_it_was)
{
    for (size_t first = 0; first < 4; first++)
        becomes(square, 4, first, square, 4);
}
END_TEST

START_TEST(onto_the_border)
{
    struct uvs loop = {0};
    /* the reach is 0.0001 of the range at most: 0.001 mm of 10 */
    static const struct uv at[] = {{-0.00009, 0.5}, {0.5, 0.00009}, {1.00009, 0.5}, {0.5, 0.99991}},
                           on[] = {{0, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}},
                           off[] = {{0.00011, 0.5}, {0.5, 0.00011}, {0.99989, 0.5}, {0.5, 0.99989}};
    for (size_t i = 0; i < 4; i++)
        *array_push(&loop) = at[i];
    trim_tidy(&flat.surface, 0.1, &loop);
    ck_assert_uint_eq(loop.n, 4);
    for (size_t i = 0; i < 4; i++) {
        ck_assert_double_eq(loop.item[i].u, on[i].u);
        ck_assert_double_eq(loop.item[i].v, on[i].v);
        loop.item[i] = off[i];
    }
    trim_tidy(&flat.surface, 0.1, &loop);
    for (size_t i = 0; i < 4; i++) {
        ck_assert_double_eq(loop.item[i].u, off[i].u);
        ck_assert_double_eq(loop.item[i].v, off[i].v);
    }
    array_free(&loop);
}
END_TEST

START_TEST(repeated)
{
    /* the reach of corners is a fifth of that */
    static const struct uv at[] = {{0.2, 0.2},     {0.80001, 0.2}, {0.8, 0.20001},    {0.8, 0.8},
                                   {0.8, 0.80001}, {0.2, 0.8},     {0.20001, 0.20001}};
    for (size_t first = 0; first < 7; first++)
        becomes(at, 7, first, square, 4);
    static const struct uv apart[] = {
        {0.2, 0.2}, {0.8, 0.2}, {0.8, 0.2001}, {0.8, 0.8}, {0.2, 0.8}};
    for (size_t first = 0; first < 5; first++)
        becomes(apart, 5, first, apart, 5);
}
END_TEST

START_TEST(there_and_back)
{
    static const struct uv one[] = {{0.2, 0.2}, {0.8, 0.2}, {0.9, 0.1},
                                    {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};
    static const struct uv two[] = {{0.2, 0.2}, {0.8, 0.2}, {0.9, 0.1}, {0.95, 0.3},
                                    {0.9, 0.1}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}};
    for (size_t first = 0; first < 6; first++)
        becomes(one, 6, first, square, 4);
    for (size_t first = 0; first < 8; first++)
        becomes(two, 8, first, square, 4);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_tidy");
    TCase *tests = tcase_create("trim_tidy");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, as_it_was);
    tcase_add_test(tests, onto_the_border);
    tcase_add_test(tests, repeated);
    tcase_add_test(tests, there_and_back);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
