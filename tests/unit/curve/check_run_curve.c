/*
 * run_curve: against the circle that its ends are on, and the great circle between two axes.
 */
#include <check.h>
#include <stdlib.h>

#include "curve/run_curve.h"

static const double RADIUS = 20, BALL = 4;

static struct run_point on_circle(double angle)
{
    struct vec3 n = vec(sin(angle), 0, cos(angle));
    struct run_point p = {.axis = n, .normal = n, .ball = vec_scale(RADIUS, n)};

    p.contact = vec_along(p.ball, -BALL, n);
    p.tip = p.contact;
    return p;
}

static struct run_curve_end end_of(const struct run_point *p, double angle)
{
    struct vec3 tangent = vec(cos(angle), 0, -sin(angle));

    return (struct run_curve_end){p, tangent, vec_scale(1 / RADIUS, tangent)};
}

/* With a circle's tangents, a cubic over the angle a is off by less than R a^4 / 2000 or so; the
 * axis turns evenly with it. */
START_TEST(between_points_of_a_circle)
{
    for (int k = 1; k <= 8; k++) {
        double angle = k * PI / 30, allowed = RADIUS * pow(angle, 4) / 2000;
        struct run_point a = on_circle(0), b = on_circle(angle);
        struct run_curve c = run_curve_between(end_of(&a, 0), end_of(&b, angle));
        for (int i = 0; i <= 100; i++) {
            struct run_point p = run_curve_at(&c, i / 100.0, BALL);
            ck_assert_double_le(fabs(vec_length(p.ball) - RADIUS), allowed + 1e-12);
            ck_assert_double_lt(vec_angle(p.axis, p.ball), 0.01 * angle * angle);
            ck_assert_double_lt(vec_distance(vec_along(p.tip, BALL, p.axis), p.ball), 1e-12);
            ck_assert_double_eq_tol(run_point_height(&p), BALL, 1e-12);
        }
        ck_assert_double_lt(vec_distance(run_curve_at(&c, 0, BALL).ball, a.ball), 1e-12);
        ck_assert_double_lt(vec_distance(run_curve_at(&c, 1, BALL).ball, b.ball), 1e-12);
    }
}
END_TEST

/* The sagitta of the chord, and of those that it is made of then. */
START_TEST(points_put_between_keep_the_chord_error)
{
    double angle = PI / 6, sagitta = RADIUS * (1 - cos(angle / 2));
    struct run_point a = on_circle(0), b = on_circle(angle);
    struct run_curve c = run_curve_between(end_of(&a, 0), end_of(&b, angle));

    for (double chord = 1; chord > 1e-5; chord /= 10) {
        struct run dense = {.radius = BALL};
        ck_assert_double_eq_tol(run_curve_densify(&c, chord, &dense), sagitta, 0.001);
        double parts = ceil(angle / (2 * acos(1 - chord / RADIUS)));
        ck_assert_double_ge((double)dense.n, parts);
        ck_assert_double_le((double)dense.n, 1.1 * parts + 1);
        ck_assert(vec_distance(dense.item[dense.n - 1].ball, b.ball) == 0);
        struct vec3 from = a.ball;
        for (size_t i = 0; i < dense.n; i++) {
            struct vec3 middle = vec_mix(from, dense.item[i].ball, 0.5);
            ck_assert_double_lt(RADIUS - vec_length(middle), chord + 1e-4);
            from = dense.item[i].ball;
        }
        array_free(&dense);
    }
}
END_TEST

START_TEST(axes_far_apart_go_on_the_great_circle)
{
    struct run_point a = on_circle(0), b = on_circle(0.1);
    b.axis = vec(0, 1, 0);
    struct run_curve c = run_curve_between(end_of(&a, 0), end_of(&b, 0.1));

    for (int i = 0; i <= 10; i++) {
        struct run_point p = run_curve_at(&c, i / 10.0, BALL);
        ck_assert_double_eq_tol(vec_angle(a.axis, p.axis), i * PI / 20, 1e-12);
        ck_assert_double_lt(fabs(p.axis.x), 1e-12);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("runcurve");
    TCase *tests = tcase_create("runcurve");

    tcase_add_test(tests, between_points_of_a_circle);
    tcase_add_test(tests, points_put_between_keep_the_chord_error);
    tcase_add_test(tests, axes_far_apart_go_on_the_great_circle);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
