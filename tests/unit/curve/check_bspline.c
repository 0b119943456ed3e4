/*
 * bspline, against the Cox - de Boor recursion written out (an independent formula), the worked
 * example 2.3 of Piegl and Tiller, The NURBS Book, and curves that are known: a straight line, a
 * cubic polynomial by its blossom.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "curve/bspline.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* N_{i,p}(u) by its definition; the last span holds its right end too. */
static double recursion(const double *knot, size_t knots, size_t i, int p, double u)
{
    if (p == 0) {
        double end = knot[knots - 1];
        if (u == end)
            return knot[i] < end && knot[i + 1] == end ? 1 : 0;
        return knot[i] <= u && u < knot[i + 1] ? 1 : 0;
    }
    double a = knot[i + (size_t)p] - knot[i], b = knot[i + (size_t)p + 1] - knot[i + 1];
    double value = 0;
    if (a > 0)
        value += (u - knot[i]) / a * recursion(knot, knots, i, p - 1, u);
    if (b > 0)
        value += (knot[i + (size_t)p + 1] - u) / b * recursion(knot, knots, i + 1, p - 1, u);
    return value;
}

/* Clamped, with inner knots that are sometimes double. */
static struct bspline random_curve(int degree, size_t poles, bool with_head)
{
    struct bspline b = bspline_new(degree, poles, with_head);
    size_t p = (size_t)degree;
    double u = 10 * chance() - 5;

    b.length = 100;
    for (size_t i = 0; i < poles + p + 1; i++) {
        if (i > p && i <= poles && (i == poles || p < 2 || chance() < 0.8 || b.knot[i - 2] == u))
            u += 0.1 + chance();
        b.knot[i] = u;
    }
    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(10 * chance(), 10 * chance(), 10 * chance());
        if (with_head)
            b.head[i] = vec_add(b.pole[i], vec(chance(), chance(), 100));
    }
    return b;
}

static double random_place(const struct bspline *b)
{
    double s = chance();
    double from = b->knot[0], to = b->knot[b->poles];

    return s < 0.05 ? from : s > 0.95 ? to : from + (to - from) * chance();
}

START_TEST(worked_example)
{
    const double knot[] = {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5};
    double value[9];
    size_t span = bspline_span(2, 8, knot, 2.5);

    ck_assert_uint_eq(span, 4);
    bspline_basis_derivatives(2, knot, span, 2.5, 2, value);
    const double expected[] = {1.0 / 8, 6.0 / 8, 1.0 / 8, -0.5, 0, 0.5, 1, -2, 1};
    for (int i = 0; i < 9; i++)
        ck_assert_double_eq_tol(value[i], expected[i], 1e-15);
}
END_TEST

START_TEST(span_at_the_ends)
{
    const double knot[] = {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5};

    ck_assert_uint_eq(bspline_span(2, 8, knot, 0), 2);
    ck_assert_uint_eq(bspline_span(2, 8, knot, 1), 3);
    ck_assert_uint_eq(bspline_span(2, 8, knot, 4), 7);
    ck_assert_uint_eq(bspline_span(2, 8, knot, 5), 7);
    ck_assert_uint_eq(bspline_span(2, 8, knot, 6), 7);
    ck_assert_uint_eq(bspline_span(2, 8, knot, -1), 2);
}
END_TEST

/* Wherever it begins: as without a place to begin, at knots, between, before and behind them. */
START_TEST(span_from_another)
{
    for (int round = 0; round < 200; round++) {
        int degree = 1 + round % 5;
        size_t poles = (size_t)degree + 1 + (size_t)(12 * chance());
        struct bspline b = random_curve(degree, poles, false);
        for (int k = 0; k < 50; k++) {
            size_t from = (size_t)degree + (size_t)(chance() * (double)(poles - (size_t)degree));
            double first = b.knot[0], last = b.knot[poles];
            double u = k % 2 ? b.knot[(size_t)(chance() * (double)(poles + (size_t)degree + 1))]
                             : first + (1.2 * chance() - 0.1) * (last - first);
            ck_assert_uint_eq(bspline_span_from(degree, poles, b.knot, u, from),
                              bspline_span(degree, poles, b.knot, u));
        }
        bspline_free(&b);
    }
}
END_TEST

START_TEST(basis_is_the_recursion)
{
    seed = 1;
    for (int turn = 0; turn < 2000; turn++) {
        int degree = 1 + turn % BSPLINE_DEGREE_MAX;
        size_t poles = (size_t)degree + 1 + (size_t)(8 * chance());
        struct bspline b = random_curve(degree, poles, false);
        double u = random_place(&b), value[BSPLINE_DEGREE_MAX + 1], sum = 0;
        size_t span = bspline_span(degree, poles, b.knot, u), first = span - (size_t)degree;

        bspline_basis(degree, b.knot, span, u, value);
        for (size_t i = 0; i < poles; i++) {
            double n = recursion(b.knot, poles + (size_t)degree + 1, i, degree, u);
            double got = i >= first && i <= span ? value[i - first] : 0;
            ck_assert_double_eq_tol(got, n, 1e-13);
            sum += got;
        }
        ck_assert_double_eq_tol(sum, 1, 1e-13);
        bspline_free(&b);
    }
}
END_TEST

/* The derivative of a B-spline is the B-spline of the differences of its poles (eq 3.4). */
START_TEST(derivatives_are_the_hodograph)
{
    seed = 2;
    for (int turn = 0; turn < 500; turn++) {
        int degree = 1 + turn % BSPLINE_DEGREE_MAX;
        size_t poles = (size_t)degree + 1 + (size_t)(8 * chance()), p = (size_t)degree;
        struct bspline b = random_curve(degree, poles, true);
        double u = random_place(&b);
        struct vec3 d[3], e[2];
        struct bspline slope = bspline_new(degree - 1, poles - 1, false);

        for (size_t i = 0; i < poles - 1; i++)
            slope.pole[i] = vec_scale(degree / (b.knot[i + p + 1] - b.knot[i + 1]),
                                      vec_sub(b.head[i + 1], b.head[i]));
        for (size_t i = 0; i < poles + p - 1; i++)
            slope.knot[i] = b.knot[i + 1];
        bspline_derivatives(&b, b.head, u, 2, d);
        bspline_derivatives(&slope, slope.pole, u, 1, e);
        ck_assert_double_lt(vec_distance(d[0], bspline_at(&b, b.head, u)), 1e-12);
        ck_assert_double_lt(vec_distance(d[1], e[0]), 1e-9 * (1 + vec_length(e[0])));
        ck_assert_double_lt(vec_distance(d[2], e[1]), 1e-9 * (1 + vec_length(e[1])));
        bspline_free(&slope);
        bspline_free(&b);
    }
}
END_TEST

/* x = t^3 has the blossom t1 t2 t3, so its poles are products of knots; y = t their mean. */
START_TEST(a_cubic_is_reproduced)
{
    seed = 3;
    for (int turn = 0; turn < 200; turn++) {
        struct bspline b = random_curve(3, 4 + (size_t)(turn % 9), false);
        struct vec3 d[5];

        for (size_t i = 0; i < b.poles; i++) {
            double t0 = b.knot[i + 1], t1 = b.knot[i + 2], t2 = b.knot[i + 3];
            b.pole[i] = vec(t0 * t1 * t2, (t0 + t1 + t2) / 3, 7);
        }
        double u = random_place(&b);
        bspline_derivatives(&b, b.pole, u, 4, d);
        ck_assert_double_lt(vec_distance(d[0], vec(u * u * u, u, 7)), 1e-11);
        ck_assert_double_lt(vec_distance(d[1], vec(3 * u * u, 1, 0)), 1e-9);
        ck_assert_double_lt(vec_distance(d[2], vec(6 * u, 0, 0)), 1e-8);
        ck_assert_double_lt(vec_distance(d[3], vec(6, 0, 0)), 1e-7);
        ck_assert(vec_length(d[4]) == 0);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(a_knot_more_changes_nothing)
{
    seed = 4;
    for (int turn = 0; turn < 300; turn++) {
        int degree = 1 + turn % BSPLINE_DEGREE_MAX;
        struct bspline b = random_curve(degree, (size_t)degree + 2 + (size_t)(turn % 5), true);
        struct bspline more = bspline_copy(&b);
        size_t p = (size_t)degree;
        double from = b.knot[0], to = b.knot[b.poles];
        /* now and then onto a knot that is there already */
        double u = degree > 2 && chance() < 0.3 ? b.knot[p + 1] : from + (to - from) * chance();

        bspline_insert(&more, u);
        ck_assert_uint_eq(more.poles, b.poles + 1);
        for (size_t i = 0; i + 1 < more.poles + p + 1; i++)
            ck_assert_double_le(more.knot[i], more.knot[i + 1]);
        for (int k = 0; k <= 20; k++) {
            double t = from + (to - from) * k / 20;
            ck_assert_double_lt(
                vec_distance(bspline_at(&b, b.pole, t), bspline_at(&more, more.pole, t)), 1e-12);
            ck_assert_double_lt(
                vec_distance(bspline_at(&b, b.head, t), bspline_at(&more, more.head, t)), 1e-12);
        }
        bspline_free(&more);
        bspline_free(&b);
    }
}
END_TEST

/* A part of a curve runs where the whole does, and ends where it is cut. */
START_TEST(parts_are_the_curve)
{
    seed = 21;
    for (int i = 0; i < 300; i++) {
        int degree = 2 + i % 3;
        struct bspline b = random_curve(degree, (size_t)degree + 1 + (size_t)(8 * chance()), true);
        double from = b.knot[0], range = b.knot[b.poles] - from;
        double a = i % 5 ? 0.6 * chance() : 0, c = i % 7 ? a + 0.05 + (0.95 - a) * chance() : 1;
        if (i % 11 == 0) /* at a knot */
            c = (b.knot[b.poles - 1] - from) / range;
        if (c <= a)
            c = 1;
        struct bspline part = bspline_part(&b, from + a * range, from + c * range);
        ck_assert_double_eq_tol(part.knot[degree], from + a * range, 1e-12 * range);
        ck_assert_double_eq_tol(part.knot[part.poles], from + c * range, 1e-12 * range);
        for (int k = 0; k <= 20; k++) {
            double u = from + (a + (c - a) * k / 20) * range;
            ck_assert_double_lt(
                vec_distance(bspline_at(&b, b.pole, u), bspline_at(&part, part.pole, u)), 1e-11);
            ck_assert_double_lt(
                vec_distance(bspline_at(&b, b.head, u), bspline_at(&part, part.head, u)), 1e-11);
        }
        ck_assert_double_lt(vec_distance(part.pole[0], bspline_at(&b, b.pole, from + a * range)),
                            1e-11);
        bspline_free(&part);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(uniform_knots)
{
    struct bspline b = bspline_new(3, 7, false);
    const double knot[] = {0, 0, 0, 0, 2.5, 5, 7.5, 10, 10, 10, 10};

    for (size_t i = 0; i < 11; i++)
        b.knot[i] = knot[i];
    ck_assert(bspline_uniform(&b));
    b.knot[5] = 5.0000005; /* as printed with six decimals */
    ck_assert(bspline_uniform(&b));
    b.knot[5] = 5.00001;
    ck_assert(!bspline_uniform(&b));
    b.knot[5] = 2.5;
    ck_assert(!bspline_uniform(&b));
    bspline_free(&b);
    ck_assert(b.knot == NULL && b.pole == NULL && b.poles == 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("bspline");
    TCase *tests = tcase_create("curves");

    tcase_add_test(tests, worked_example);
    tcase_add_test(tests, span_at_the_ends);
    tcase_add_test(tests, span_from_another);
    tcase_add_test(tests, basis_is_the_recursion);
    tcase_add_test(tests, derivatives_are_the_hodograph);
    tcase_add_test(tests, a_cubic_is_reproduced);
    tcase_add_test(tests, a_knot_more_changes_nothing);
    tcase_add_test(tests, parts_are_the_curve);
    tcase_add_test(tests, uniform_knots);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
