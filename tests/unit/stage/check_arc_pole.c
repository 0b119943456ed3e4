/* arc_pole: a tool that leans to one side, comes upright and leans to the other, its plane turning
 * about Z as it goes: known by its formula. */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/num.h"
#include "stage/arc_pole.h"
#include "stage/arcrun.h"

enum { POINTS = 81, POLE = 40 };

/* Along X, half a millimetre each; the axis at the pole in the middle.  The bearing turns by `turn`
 * radians/mm. */
static struct run over_pole(double turn)
{
    struct run run = {.radius = 5};
    for (int i = 0; i < POINTS; i++) {
        double x = 0.5 * (i - POLE), lean = 0.01 * x, bearing = 0.3 + turn * x;
        struct run_point p = {.given = true, .normal = vec(0, 0, 1)};
        p.ball = vec(x, 0.2 * sin(0.2 * x), 5);
        p.contact = vec_along(p.ball, -5, p.normal);
        p.axis = vec(sin(lean) * cos(bearing), sin(lean) * sin(bearing), cos(lean));
        p.tip = vec_along(p.ball, -5, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

static double bearing(struct vec3 axis)
{
    return atan2(axis.y, axis.x);
}

START_TEST(the_pole_and_its_plane)
{
    struct run run = over_pole(0.004);
    for (size_t i = 1; i + 1 < run.n; i++)
        ck_assert_int_eq(arc_pole_at(&run, i), i == POLE);
    struct vec3 plane = arc_pole_plane(&run, POLE); /* by symmetry that of the middle */
    ck_assert_double_lt(vec_length(vec_add(plane, vec(cos(0.3), sin(0.3), 0))), 1e-6);
    run.item[POLE + 1].axis = vec_unit(vec(0, 0.1, 1));
    ck_assert_double_eq(vec_length(arc_pole_plane(&run, POLE)), 0); /* it turns there */
    array_free(&run);
}
END_TEST

START_TEST(turned_into_the_plane)
{
    struct vec3 plane = vec(cos(0.3), sin(0.3), 0);
    for (double b = -3; b < 3; b += 0.37) {
        struct vec3 axis = vec(sin(0.1) * cos(b), sin(0.1) * sin(b), cos(0.1));
        struct vec3 in = arc_pole_into(axis, plane);
        ck_assert_double_lt(fabs(vec_length(in) - 1), 1e-12);
        ck_assert_double_eq(in.z, axis.z);
        ck_assert_double_lt(fabs(in.x * plane.y - in.y * plane.x), 1e-15);
        ck_assert_double_ge(vec_dot(vec(axis.x, axis.y, 0), in), 0); /* to the side it was on */
    }
}
END_TEST

/* How much the bearing changes at the pole from the motion that comes there to the one after, of
 * what was fitted; motions are counted.  Each axis turns on a great circle, which from the pole has
 * one bearing. */
static double turn_at_pole(const struct path *out, struct vec3 before, size_t *motions)
{
    double turned = -1;
    *motions = 0;
    for (size_t i = 0; i + 1 < out->item.n; i++) {
        struct vec3 a = out->item.item[i].to.a, next = out->item.item[i + 1].to.a;
        ++*motions;
        if (hypot(a.x, a.y) < 1e-12)
            turned = fabs(remainder(bearing(before) - bearing(next), acos(-1)));
        before = a;
    }
    return turned;
}

START_TEST(no_turn_at_the_pole)
{
    for (double turn = 0; turn < 0.012; turn += 0.002) {
        struct run run = over_pole(turn);
        struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02};
        struct arcrun_report report = {0};
        struct path out = {0};
        size_t motions;
        arcrun_fit(&run, &options, NULL, &out, &report);
        ck_assert_double_le(report.spent, 0.01);
        double turned = turn_at_pole(&out, run.item[0].axis, &motions);
        ck_assert_double_ge(turned, 0);
        ck_assert_double_lt(turned, 1e-6);
        ck_assert_uint_lt(motions, 20);
        path_free(&out);
        array_free(&run);
    }
}
END_TEST

START_TEST(a_joint_beside_the_pole)
{
    struct run run = over_pole(0.02);
    struct reference reference = reference_of(&run, POLE, POINTS - POLE, false, false);
    struct vec3 plane = arc_pole_plane(&run, POLE);
    for (int end = 0; end < 2; end++) {
        struct pieces pieces = {0};
        struct vec3 a = reference.point[end ? 20 : 0], b = reference.point[end ? 40 : 20];
        struct arc arc = arc_to(a, reference.tangent[end ? 20 : 0], b);
        *array_push(&pieces) = arc_piece_of(&reference, arc, end ? 20 : 0, end ? 40 : 20);
        arc_pole_divide(&reference, &pieces, end, 0.25, plane);
        ck_assert_uint_eq(pieces.n, 2);
        const struct arc_piece *p = pieces.item;
        ck_assert_double_lt(vec_distance(p[0].arc.to, arc_at(&arc, end ? 0.75 : 0.25)), 1e-12);
        ck_assert_double_lt(vec_distance(p[1].arc.to, arc.to), 1e-12);
        ck_assert_double_lt(vec_distance(arc_tangent(&p[0].arc, 1), p[1].arc.tangent), 1e-9);
        ck_assert_double_lt(fabs(p[0].arc.radius - arc.radius), 1e-6 * arc.radius);
        ck_assert_double_eq(p[0].to, p[1].from);
        ck_assert_double_lt(fabs(p[0].to - (end ? 35 : 5)), 0.3);
        ck_assert_double_lt(vec_distance(p[0].axis_to, p[1].axis), 1e-15);
        double x = p[1].axis.x * plane.y - p[1].axis.y * plane.x;
        ck_assert_double_lt(fabs(x), 1e-12);
        array_free(&pieces);
    }
    reference_free(&reference);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arc_pole");
    TCase *tests = tcase_create("arc_pole");
    tcase_add_test(tests, the_pole_and_its_plane);
    tcase_add_test(tests, turned_into_the_plane);
    tcase_add_test(tests, no_turn_at_the_pole);
    tcase_add_test(tests, a_joint_beside_the_pole);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
