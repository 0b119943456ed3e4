/* curve_length: circles, a parabola and a polyline against their formulas, and back; a curve that
 * rests in one place. */
#include <check.h>

#include "math/elementary.h"
#include "nurbs/construct.h"
#include "nurbs/curve_length.h"

/* There and back at every place. */
static void expect_back(const struct curve_length *l)
{
    const struct nurbs_axis *t = &l->curve->t;
    for (int i = 0; i <= 97; i++) {
        double at = t->from + (t->to - t->from) * i / 97;
        ck_assert_double_le(fabs(curve_length_at(l, curve_length_to(l, at)) - at),
                            1e-12 * (t->to - t->from));
    }
    ck_assert_double_eq(curve_length_at(l, -1), t->from);
    ck_assert_double_eq(curve_length_at(l, 2 * l->length[l->n]), t->to);
}

START_TEST(circle)
{
    struct transform place = construct_place(vec(1, 2, 3), vec(1, 1, 0), vec(0, 0, 1));
    struct nurbs_curve c = construct_ellipse(&place, 7, 7, 0.3, 0.3 + 1.7 * PI);
    struct curve_length l = curve_length(&c);
    for (int i = 0; i <= 50; i++) {
        struct vec3 p = nurbs_curve_point(&c, curve_length_at(&l, 7 * 1.7 * PI * i / 50));
        double angle = 0.3 + 1.7 * PI * i / 50;
        struct vec3 q = transform_point(&place, vec(7 * cos(angle), 7 * sin(angle), 0));
        ck_assert_double_le(vec_distance(p, q), 1e-10);
    }
    expect_back(&l);
    curve_length_free(&l);
    nurbs_curve_free(&c);
}
END_TEST

START_TEST(parabola)
{
    struct transform place = transform_identity();
    struct nurbs_curve c = construct_parabola(&place, 1, 0, 3); /* (t^2, 2 t) */
    struct curve_length l = curve_length(&c);
    for (int i = 0; i <= 30; i++) {
        double t = i / 10.0, w = sqrt(1 + t * t);
        ck_assert_double_le(fabs(curve_length_to(&l, t) - (t * w + log(t + w))), 1e-10);
    }
    expect_back(&l);
    curve_length_free(&l);
    nurbs_curve_free(&c);
}
END_TEST

START_TEST(polyline_and_point)
{
    const struct vec3 corner[3] = {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}};
    struct nurbs_curve c = construct_polyline(corner, 3);
    struct curve_length l = curve_length(&c);
    ck_assert_double_le(fabs(curve_length_to(&l, 1) - 17), 1e-12);
    ck_assert_double_le(fabs(curve_length_at(&l, 5) - 0.5), 1e-12);
    ck_assert_double_le(fabs(curve_length_at(&l, 11) - 0.75), 1e-12);
    curve_length_free(&l);
    nurbs_curve_free(&c);
    c = construct_line(vec(1, 2, 3), vec(1, 2, 3));
    l = curve_length(&c);
    ck_assert_double_eq(curve_length_to(&l, 1), 0);
    ck_assert_double_eq(curve_length_at(&l, 0), 0);
    curve_length_free(&l);
    nurbs_curve_free(&c);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("curve_length");
    TCase *tests = tcase_create("curve_length");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, circle);
    tcase_add_test(tests, parabola);
    tcase_add_test(tests, polyline_and_point);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
