/*
 * ppform: polynomials against de Boor's algorithm; derivatives by knots against differences.
 */
#include <check.h>
#include <stdlib.h>

#include "splinefit/ppform.h"

static unsigned long seed = 1;

static double random_number(void)
{
    seed = (seed * 1103515245 + 12345) % 2147483648UL;
    return (double)seed / 2147483648.0;
}

static struct bspline random_curve(int degree, size_t poles, bool with_head)
{
    struct bspline b = bspline_new(degree, poles, with_head);
    size_t p = (size_t)degree;

    for (size_t i = 0; i < poles; i++) {
        b.pole[i] = vec(random_number(), random_number(), random_number());
        if (with_head)
            b.head[i] = vec(random_number(), random_number(), random_number());
    }
    for (size_t j = p + 1; j <= poles + p; j++)
        b.knot[j] = j <= poles ? b.knot[j - 1] + 0.1 + random_number() : b.knot[poles];
    return b;
}

START_TEST(same_as_de_boor)
{
    for (int degree = 1; degree <= 6; degree++)
        for (int head = 0; head < 2; head++) {
            struct bspline b = random_curve(degree, (size_t)degree + 6, head == 1);
            struct ppform f = ppform_new(&b);
            size_t near = 0;

            ppform_curve(&f, &b);
            for (int k = 0; k <= 100; k++) {
                double u = b.knot[b.poles] * k / 100, value[6], first[6], second[6];
                struct vec3 d[3];
                near = ppform_span(&f, near, u);
                ppform_at(&f, near, u, value, first, second);
                bspline_derivatives(&b, b.pole, u, 2, d);
                ck_assert_double_eq_tol(value[0], d[0].x, 1e-12);
                ck_assert_double_eq_tol(first[1], d[1].y, 1e-10);
                if (degree > 1)
                    ck_assert_double_eq_tol(second[2], d[2].z, 1e-9);
                if (head == 1)
                    ck_assert_double_eq_tol(value[4], bspline_at(&b, b.head, u).y, 1e-12);
            }
            ppform_free(&f);
            bspline_free(&b);
        }
}
END_TEST

/* The x of the derivative by knot j at u, from the span's polynomial. */
static double slope_at(const struct ppform *f, size_t j, double u)
{
    size_t p = (size_t)f->degree, span = ppform_span(f, 0, u);
    double s = ppform_place(f, span, u), power = 1, sum = 0;

    if (j < span + 1 || j > span + 2 * p)
        return 0;
    const double *c = &f->slope[(span * 2 * p + j - span - 1) * (p + 1) * (size_t)f->width];
    for (size_t k = 0; k <= p; k++, power *= s)
        sum += c[k * (size_t)f->width] * power;
    return sum;
}

START_TEST(derivatives_by_knots)
{
    for (int degree = 2; degree <= 5; degree++) {
        struct bspline b = random_curve(degree, (size_t)degree + 7, degree % 2 == 0);
        struct ppform f = ppform_new(&b);

        ppform_curve(&f, &b);
        ppform_slopes(&f, &b);
        for (size_t j = (size_t)degree + 1; j < b.poles; j++)
            for (int k = 1; k < 60; k++) {
                double u = b.knot[b.poles] * k / 60, knot = b.knot[j], step = 1e-6;
                if (fabs(u - knot) < 1e-3)
                    continue;
                b.knot[j] = knot + step;
                double after = bspline_at(&b, b.pole, u).x;
                b.knot[j] = knot - step;
                double before = bspline_at(&b, b.pole, u).x;
                b.knot[j] = knot;
                ck_assert_double_eq_tol(slope_at(&f, j, u), (after - before) / (2 * step), 1e-7);
            }
        ppform_free(&f);
        bspline_free(&b);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("spanform");
    TCase *tests = tcase_create("spanform");

    tcase_add_test(tests, same_as_de_boor);
    tcase_add_test(tests, derivatives_by_knots);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
