/* Tests of arc_window.h: on a circle and a line all is known. */
#include "arcfit/arc_window.h"

#include <check.h>
#include <stdlib.h>

static struct trace around(double radius, size_t n, double step)
{
    struct run run = {.radius = 1};
    for (size_t i = 0; i < n; i++) {
        double u = step * (double)i / radius;
        struct vec3 p = vec(radius * sin(u), radius * (1 - cos(u)), 0);
        *array_push(&run) = (struct run_point){.tip = p, .ball = p, .axis = vec(0, 0, 1)};
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

START_TEST(a_circle_can_be_followed_to_its_end)
{
    struct trace t = around(20, 60, 0.5);
    struct arc_windows w = {0};
    ck_assert_uint_eq(arc_window(&t, 0, t.p[0], vec(1, 0, 0), 0.01, &w), 59);
    ck_assert_uint_eq(w.item[w.n - 1].point, 59);
    struct vec3 k = arc_window_at(&w.item[w.n - 1], 0.5, 0.5);
    ck_assert_double_lt(vec_distance(k, vec(0, 1.0 / 20, 0)), 1e-5);
    ck_assert(!arc_window_straight(&w.item[w.n - 1]));
    array_free(&w);
    trace_free(&t);
}
END_TEST

START_TEST(a_wrong_direction_ends_it)
{
    /* turned by a against a line, the curvatures at s are 2 a / s give or take 2 d / s^2; the
     * largest lower bound is a^2 / (2 d), and all bounds meet up to s = 2 (1 + sqrt 2) d / a */
    double a = 0.01, l = 2 * (1 + sqrt(2)) * 0.01 / a;
    struct trace t = around(1e6, 400, 0.02);
    size_t to = arc_window(&t, 0, t.p[0], vec(cos(a), sin(a), 0), 0.01, NULL);
    ck_assert_double_lt(fabs(t.length[to] - l), 0.15);
    ck_assert_uint_eq(arc_window(&t, 0, t.p[0], vec(-1, 0, 0), 0.01, NULL), 0);
    trace_free(&t);
}
END_TEST

START_TEST(a_line_holds_the_straight_one)
{
    struct trace t = around(1e9, 50, 1);
    struct arc_windows w = {0};
    arc_window(&t, 5, vec_add(t.p[5], vec(0, 0.005, 0)), vec(1, 0, 0), 0.01, &w);
    ck_assert_uint_eq(w.item[w.n - 1].point, 49);
    ck_assert(arc_window_straight(&w.item[w.n - 1]));
    array_free(&w);
    trace_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("outlook");
    tcase_add_test(t, a_circle_can_be_followed_to_its_end);
    tcase_add_test(t, a_wrong_direction_ends_it);
    tcase_add_test(t, a_line_holds_the_straight_one);
    Suite *s = suite_create("outlook");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
