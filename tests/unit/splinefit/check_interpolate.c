/*
 * interpolate: the curve meets all points with two continuous derivatives; its ends are what they
 * are called; parabolas come back as they are, circles with the fourth power of the spacing.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/interpolate.h"

enum { MOST = 200 };

/* n points of a circle about the origin, by a spacing that changes; the axis turns with it. */
static struct reference circle(size_t n, double radius, bool turns)
{
    struct run run = {.radius = 5};

    for (size_t k = 0; k < n; k++) {
        double t = (double)k / (double)(n - 1), angle = 2 * (t + 0.05 * sin(9 * t));
        struct vec3 tip = vec(radius * cos(angle), radius * sin(angle), 0);
        struct vec3 axis =
            vec_unit(turns ? vec(0.3 * cos(angle), 0.3 * sin(angle), 1) : vec(0, 0, 1));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis, .given = true};
    }
    struct reference reference = reference_distinct(&run, false);
    array_free(&run);
    return reference;
}

static struct reference parabola(size_t n)
{
    struct run run = {.radius = 0};

    for (size_t k = 0; k < n; k++) {
        double x = 3.0 * (double)k * (1 + 0.02 * (double)k);
        struct vec3 tip = vec(x, 0, 0);
        *array_push(&run) = (struct run_point){.tip = tip, .ball = tip, .axis = vec(0, 0, 1)};
    }
    struct reference reference = reference_distinct(&run, false);
    array_free(&run);
    for (size_t k = 0; k < n; k++) /* by its length in x: a parabola over its parameter */
        reference.point[k].z = 0.01 * reference.length[k] * reference.length[k];
    return reference;
}

/* The derivatives at u, of poles that are not always the curve's own. */
static struct vec3 derivative(const struct bspline *b, const struct vec3 *pole, double u, int order)
{
    struct vec3 d[4];

    bspline_derivatives(b, pole, u, 3, d);
    return d[order];
}

static void check_smooth(const struct bspline *b, const struct vec3 *pole, const double *u,
                         size_t n)
{
    for (size_t k = 1; k + 1 < n; k++) {
        double h = fmin(u[k] - u[k - 1], u[k + 1] - u[k]) * 1e-6;
        for (int order = 1; order <= 2; order++) {
            struct vec3 before = derivative(b, pole, u[k] - h, order);
            struct vec3 after = derivative(b, pole, u[k] + h, order);
            ck_assert_double_lt(vec_distance(before, after), 1e-5);
        }
    }
}

START_TEST(meets_all_points)
{
    for (int ends = ENDS_NATURAL; ends <= ENDS_BESSEL; ends++) {
        struct reference r = circle(MOST, 20, true);
        struct bspline b = spline_through(&r, (enum spline_ends)ends);
        ck_assert_uint_eq(b.poles, r.n + 2);
        for (size_t k = 0; k < r.n; k++) {
            struct vec3 p = bspline_at(&b, b.pole, r.length[k]);
            struct vec3 h = bspline_at(&b, b.head, r.length[k]);
            ck_assert_double_lt(vec_distance(p, r.point[k]), 1e-10);
            ck_assert_double_lt(vec_distance(vec_unit(vec_sub(h, p)), r.axis[k]), 1e-10);
        }
        check_smooth(&b, b.pole, r.length, r.n);
        check_smooth(&b, b.head, r.length, r.n);
        bspline_free(&b);
        reference_free(&r);
    }
}
END_TEST

START_TEST(natural_ends)
{
    struct reference r = circle(40, 20, false);
    struct bspline b = spline_through(&r, ENDS_NATURAL);

    ck_assert_double_lt(vec_length(derivative(&b, b.pole, 0, 2)), 1e-10);
    ck_assert_double_lt(vec_length(derivative(&b, b.pole, r.length[r.n - 1], 2)), 1e-10);
    ck_assert_double_gt(vec_length(derivative(&b, b.pole, r.length[r.n / 2], 2)), 0.01);
    bspline_free(&b);
    reference_free(&r);
}
END_TEST

/* On a circle the tangent that paper 1 has at ends is the circle's own, but for the three-point
 * tangent beside it. */
START_TEST(clamped_ends)
{
    struct reference r = circle(MOST, 20, false);
    struct bspline b = spline_through(&r, ENDS_CLAMPED);
    double end = r.length[r.n - 1], angle = atan2(r.point[r.n - 1].y, r.point[r.n - 1].x);
    struct vec3 first = derivative(&b, b.pole, 0, 1), last = derivative(&b, b.pole, end, 1);

    ck_assert_double_lt(vec_distance(first, vec(0, 1, 0)), 1e-3);
    ck_assert_double_lt(vec_distance(last, vec(-sin(angle), cos(angle), 0)), 1e-3);
    bspline_free(&b);
    reference_free(&r);
}
END_TEST

START_TEST(bessel_ends)
{
    struct reference r = parabola(12);
    struct bspline b = spline_through(&r, ENDS_BESSEL);

    for (int i = 0; i <= 100; i++) {
        double u = r.length[r.n - 1] * i / 100;
        ck_assert_double_eq_tol(bspline_at(&b, b.pole, u).z, 0.01 * u * u, 1e-10);
    }
    bspline_free(&b);
    reference_free(&r);
}
END_TEST

static double off_circle(size_t n, enum spline_ends ends, double radius)
{
    struct reference r = circle(n, radius, false);
    struct bspline b = spline_through(&r, ends);
    double worst = 0;

    for (int i = 0; i <= 2000; i++) {
        struct vec3 p = bspline_at(&b, b.pole, r.length[r.n - 1] * i / 2000);
        worst = fmax(worst, fabs(hypot(p.x, p.y) - radius));
    }
    bspline_free(&b);
    reference_free(&r);
    return worst;
}

START_TEST(order_of_error)
{
    /* natural ends leave an error of the second order beside them, the others fall faster */
    ck_assert_double_lt(off_circle(80, ENDS_BESSEL, 20), off_circle(40, ENDS_BESSEL, 20) / 8);
    ck_assert_double_lt(off_circle(80, ENDS_CLAMPED, 20), off_circle(40, ENDS_CLAMPED, 20) / 8);
    ck_assert_double_gt(off_circle(80, ENDS_NATURAL, 20), off_circle(80, ENDS_BESSEL, 20));
}
END_TEST

START_TEST(few_points)
{
    for (size_t n = 2; n <= 4; n++)
        for (int ends = ENDS_NATURAL; ends <= ENDS_BESSEL; ends++) {
            struct reference r = circle(n, 20, false);
            struct bspline b = spline_through(&r, (enum spline_ends)ends);
            ck_assert_uint_eq(b.poles, n + 2);
            for (size_t k = 0; k < n; k++)
                ck_assert_double_lt(vec_distance(bspline_at(&b, b.pole, r.length[k]), r.point[k]),
                                    1e-10);
            bspline_free(&b);
            reference_free(&r);
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("interpolate");
    TCase *tests = tcase_create("ends");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, meets_all_points);
    tcase_add_test(tests, natural_ends);
    tcase_add_test(tests, clamped_ends);
    tcase_add_test(tests, bessel_ends);
    tcase_add_test(tests, order_of_error);
    tcase_add_test(tests, few_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
