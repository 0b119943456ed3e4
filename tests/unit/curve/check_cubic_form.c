/*
 * cubic_form: what is a cubic on its knots comes out as it is, whatever its degree was written as;
 * any other curve comes nearer with the fourth power of its spans, ends and smoothness kept.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "curve/cubic_form.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* Inner knots repeated up to `times` times. */
static struct bspline any_curve(int degree, size_t poles, int times, bool head)
{
    struct bspline b = bspline_new(degree, poles, head);
    size_t p = (size_t)degree;
    for (size_t i = 0; i < poles + p + 1; i++) {
        bool same = i > p + 1 && i < poles && (int)(4 * chance()) < times - 1 &&
                    (i < p + (size_t)times || b.knot[i - 1] > b.knot[i - (size_t)times]);
        b.knot[i] = i <= p ? 0 : b.knot[i - 1] + (i > poles || same ? 0 : 1 + 2 * chance());
    }
    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(3 * (double)i + chance(), 4 * chance(), 4 * chance());
        if (head)
            b.head[i] = vec_add(b.pole[i], vec(10 * chance(), 10 * chance(), 90));
    }
    b.length = 100;
    return b;
}

static double distance(const struct bspline *a, const struct bspline *b, bool head)
{
    double most = 0, end = a->knot[a->poles];
    for (int i = 0; i <= 1000; i++) {
        double u = end * i / 1000;
        struct vec3 p = bspline_at(a, head ? a->head : a->pole, u);
        struct vec3 q = bspline_at(b, head ? b->head : b->pole, u);
        most = fmax(most, vec_distance(p, q));
    }
    return most;
}

START_TEST(cubics_stay)
{
    for (int i = 0; i < 400; i++) {
        seed = (uint64_t)i + 1;
        int degree = 1 + i % 3;
        size_t poles = (size_t)degree + 1 + (size_t)(12 * chance());
        struct bspline b = any_curve(degree, poles, 1 + i % degree, i % 2);
        struct bspline c = cubic_form(&b, NULL, 0);
        ck_assert_int_eq(c.degree, 3);
        ck_assert_double_lt(distance(&b, &c, false), 1e-10);
        if (b.head)
            ck_assert_double_lt(distance(&b, &c, true), 1e-10);
        bspline_free(&c);
        double more = 0.317 * b.knot[poles];
        c = cubic_form(&b, &more, 1);
        ck_assert_double_lt(distance(&b, &c, false), 1e-10);
        bspline_free(&c);
        bspline_free(&b);
    }
}
END_TEST

/* Every span of the curve in n parts. */
static struct bspline finer(const struct bspline *b, int n)
{
    struct doubles more = {0};
    for (size_t i = (size_t)b->degree; i < b->poles; i++)
        for (int k = n - 1; k > 0 && b->knot[i + 1] > b->knot[i]; k--)
            *array_push(&more) = b->knot[i] + (b->knot[i + 1] - b->knot[i]) * k / n;
    struct bspline c = cubic_form(b, more.item, more.n);
    array_free(&more);
    return c;
}

START_TEST(others_come_near)
{
    for (int i = 0; i < 100; i++) {
        seed = (uint64_t)i + 1;
        int degree = 4 + i % 4;
        struct bspline b = any_curve(degree, (size_t)degree + 6, 1 + i % degree, true);
        struct bspline coarse = finer(&b, 8), fine = finer(&b, 32);
        double far = distance(&b, &coarse, false), near = distance(&b, &fine, false);
        ck_assert_double_gt(far, 0);
        ck_assert_double_lt(near, far / 70); /* 4^4 = 256 in the limit, 4^3 = 64 */
        ck_assert_double_lt(distance(&b, &fine, true), distance(&b, &coarse, true) / 70);
        ck_assert_double_lt(vec_distance(fine.pole[0], b.pole[0]), 1e-12);
        ck_assert_double_lt(vec_distance(fine.pole[fine.poles - 1], b.pole[b.poles - 1]), 1e-12);
        ck_assert_double_eq(fine.length, b.length);
        bspline_free(&coarse);
        bspline_free(&fine);
        bspline_free(&b);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cubic_form");
    TCase *tests = tcase_create("curves");
    tcase_add_test(tests, cubics_stay);
    tcase_add_test(tests, others_come_near);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
