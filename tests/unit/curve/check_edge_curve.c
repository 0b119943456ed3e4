/* edge_curve: against a circle, and its own derivative. */
#include <check.h>

#include "curve/edge_curve.h"

static struct edge_curve arc(double radius, double angle)
{
    struct vec3 a = vec(0, 0, 1), b = vec(sin(angle), 0, cos(angle));

    return edge_curve(vec_scale(radius, a), a, vec_scale(radius, b), b);
}

START_TEST(an_edge_of_a_circle_is_round)
{
    for (double angle = 0.05; angle < 0.9; angle += 0.05) {
        struct edge_curve c = arc(50, angle);
        double off = 0, sagitta = 50 * (1 - cos(angle / 2));
        for (double s = 0; s <= 1; s += 0.01)
            off = fmax(off, fabs(vec_length(edge_curve_at(&c, s)) - 50));
        ck_assert_double_lt(off, sagitta * 0.004 * angle * angle);
    }
}
END_TEST

START_TEST(ends_are_vertices_and_slopes_are_in_tangent_planes)
{
    struct edge_curve c = arc(50, 0.3);

    ck_assert_double_lt(vec_distance(edge_curve_at(&c, 0), vec(0, 0, 50)), 1e-12);
    ck_assert_double_lt(vec_distance(edge_curve_at(&c, 1), vec(50 * sin(0.3), 0, 50 * cos(0.3))),
                        1e-12);
    ck_assert_double_lt(fabs(edge_curve_slope(&c, 0).z), 1e-12);
    for (double s = 0.1; s < 1; s += 0.1) {
        struct vec3 d = vec_sub(edge_curve_at(&c, s + 1e-6), edge_curve_at(&c, s - 1e-6));
        ck_assert_double_lt(vec_distance(vec_scale(1 / 2e-6, d), edge_curve_slope(&c, s)), 1e-6);
    }
}
END_TEST

START_TEST(a_step_stays_straight)
{
    /* One chord 40 degrees out of the tangent plane, both ways round. */
    struct vec3 p = vec(0, 0, 0), q = vec(1, 0, tan(RADIANS(40))), up = vec(0, 0, 1);
    struct vec3 leaning = vec_unit(vec(-tan(RADIANS(40)), 0, 1));
    struct edge_curve a = edge_curve(p, up, q, leaning), b = edge_curve(p, leaning, q, up);

    for (double s = 0; s <= 1; s += 0.125) {
        ck_assert_double_lt(vec_distance(edge_curve_at(&a, s), vec_mix(p, q, s)), 1e-12);
        ck_assert_double_lt(vec_distance(edge_curve_at(&b, s), vec_mix(p, q, s)), 1e-12);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_curve");
    TCase *tests = tcase_create("edge_curve");
    tcase_add_test(tests, an_edge_of_a_circle_is_round);
    tcase_add_test(tests, ends_are_vertices_and_slopes_are_in_tangent_planes);
    tcase_add_test(tests, a_step_stays_straight);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
