/*
 * ncpoly: the printed polynomials, by the formula of the manual, are the curve, to the fifth
 * degree; a wrong factor is seen; the width is that of the words as the manual writes them.
 */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "post/ncpoly.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* Head points 100 above the tip, leaning up to 30 degrees. */
static struct bspline any_curve(int degree, size_t poles)
{
    struct bspline b = bspline_new(degree, poles, true);
    size_t p = (size_t)degree;
    for (size_t i = 0; i < poles + p + 1; i++)
        b.knot[i] = i <= p ? 2 : b.knot[i - 1] + (i > poles ? 0 : 0.3 + 30 * chance());
    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(10 * (double)i + chance(), 100 * chance(), 4 * chance() - 300);
        b.head[i] = vec_add(b.pole[i], vec(50 * chance(), 10 * chance(), 90));
    }
    b.length = 100;
    return b;
}

/* X(p) = x0 + a1 p + a2 p^2 + ..., a1 from X(h) = xe. */
static double by_manual(double from, double to, const double a[], int n, double h, double p)
{
    double a1 = (to - from) / h, x = from;
    for (int i = 0; i < n; i++) {
        a1 -= a[i] * pow(h, i + 1);
        x += a[i] * pow(p, i + 2);
    }
    return x + a1 * p;
}

static struct vec3 point_by_manual(struct vec3 from, struct vec3 to, const struct vec3 *a, int n,
                                   double h, double p)
{
    double x[8], y[8], z[8];
    for (int i = 0; i < n; i++) {
        x[i] = a[i].x;
        y[i] = a[i].y;
        z[i] = a[i].z;
    }
    return vec(by_manual(from.x, to.x, x, n, h, p), by_manual(from.y, to.y, y, n, h, p),
               by_manual(from.z, to.z, z, n, h, p));
}

START_TEST(the_curve_itself)
{
    for (int i = 0; i < 200; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 4, factors = nc_poly_factors(degree);
        struct bspline b = any_curve(degree, (size_t)degree + 1 + (size_t)i % 9);
        struct nc_spans spans = {0};
        ck_assert(nc_poly_words(&spans, &b, 5));
        ck_assert_uint_eq(spans.n, b.poles - (size_t)degree);
        struct vec3 tip = b.pole[0], head = b.head[0];
        for (size_t s = 0; s < spans.n; s++) {
            const struct nc_span *n = &spans.item[s];
            double from = b.knot[(size_t)degree + s], to = b.knot[(size_t)degree + s + 1];
            for (int k = 0; k <= 20; k++) {
                double u = from + (to - from) * k / 20, p = n->h * k / 20;
                struct vec3 at = point_by_manual(tip, n->end, n->factor, factors, n->h, p);
                ck_assert_double_lt(vec_distance(at, bspline_at(&b, b.pole, u)), 2e-5);
                at = point_by_manual(head, n->head_end, n->head_factor, factors, n->h, p);
                ck_assert_double_lt(vec_distance(at, bspline_at(&b, b.head, u)), 2e-5);
            }
            tip = n->end;
            head = n->head_end;
        }
        array_free(&spans);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(faults_are_seen)
{
    struct interpolation f = {.mode = INTERPOLATE_VECTOR};
    struct pose_deviation allowed = {0.001, 0.001};
    for (int i = 0; i < 40; i++) {
        seed = (uint64_t)i + 1;
        int degree = 2 + i % 4;
        struct bspline b = any_curve(degree, (size_t)degree + 5);
        struct nc_spans spans = {0};
        struct doubles more = {0};
        struct pose from = {b.pole[0], vec(0, 0, 1)}, to = {b.pole[b.poles - 1], vec(0, 0, 1)};
        struct motion motion = motion_spline(from, to, &b);
        ck_assert(nc_poly_words(&spans, &b, 5));
        struct pose_deviation d =
            nc_poly_deviation(&spans, &b, &f, b.pole[0], b.head[0], &motion, allowed, &more);
        ck_assert_double_lt(d.point, 2e-5);
        ck_assert_double_lt(d.axis, 1e-6);
        ck_assert_uint_eq(more.n, 0);
        /* bent by 0.01 mm in its middle: a (p^2 - p h) is a h^2 / 4 there */
        struct nc_span *bad = &spans.item[2];
        bad->factor[0].y += 0.04 / (bad->h * bad->h);
        d = nc_poly_deviation(&spans, &b, &f, b.pole[0], b.head[0], &motion, allowed, &more);
        ck_assert_double_eq_tol(d.point, 0.01, 1e-4);
        ck_assert_uint_eq(more.n, 1);
        double middle = (b.knot[degree + 2] + b.knot[degree + 3]) / 2;
        ck_assert_double_eq_tol(more.item[0], middle, 1e-12);
        array_free(&more);
        array_free(&spans);
        bspline_free(&b);
    }
}
END_TEST

START_TEST(width)
{
    struct nc_span s = {.h = 1, .digits = 7};
    struct nc_spans spans = {1, 1, &s};
    s.end = vec(-12.5, 0, 100.12345);
    s.factor[0] = vec(-1.1234567, 2, 0);
    s.factor[1] = vec(0, 0.5, 0);
    const char words[] = " PO[X]=(-12.5,-1.1234567,0) PO[Y]=(0,2,0.5) PO[Z]=(100.12345,0,0)";
    /* one letter more for the H of a head, which is not there yet */
    ck_assert_uint_eq(nc_poly_width(&spans, 3, false, 5), strlen(words) + 3);
    s.head_end = s.end;
    memcpy(s.head_factor, s.factor, sizeof s.factor);
    ck_assert_uint_eq(nc_poly_width(&spans, 2, true, 5), 2 * (strlen(words) + 3));
    ck_assert_uint_eq(nc_poly_width(&spans, 5, false, 5), strlen(words) + 3 + 6 * strlen(",0"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncpoly");
    TCase *tests = tcase_create("polynomials");
    tcase_add_test(tests, the_curve_itself);
    tcase_add_test(tests, faults_are_seen);
    tcase_add_test(tests, width);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
