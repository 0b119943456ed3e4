/* Tests of arcspline.h: joints and tangents, residuals, joints that are moved. */
#include "arcfit/arcspline.h"

#include <check.h>
#include <stdlib.h>

/* Joints on a helix, which arcs of three points can't be taken from. */
static struct arcspline chain_of(size_t n)
{
    struct arcspline c = arcspline_new(n);
    for (size_t i = 0; i <= n; i++) {
        double t = 0.4 * (double)i;
        c.joint[i] = (struct joint){.p = vec(9 * cos(t), 9 * sin(t), t), .axis = vec(0, 0, 1)};
    }
    c.joint[0].tangent = vec_unit(vec(0.1, 1, 0.2));
    arcspline_set_tangents(&c, 0);
    return c;
}

START_TEST(each_arc_starts_in_the_direction_where_the_last_one_ended)
{
    struct arcspline c = chain_of(7);
    for (size_t i = 0; i < c.n; i++) {
        struct arc arc = arcspline_arc(&c, i);
        struct vec3 end = arc_tangent(&arc, 1);
        ck_assert_double_lt(vec_distance(end, c.joint[i + 1].tangent), 1e-12);
        ck_assert_double_lt(vec_distance(arc.to, c.joint[i + 1].p), 1e-12);
        ck_assert_double_lt(vec_distance(arc.tangent, c.joint[i].tangent), 1e-12);
    }
    arcspline_free(&c);
}
END_TEST

START_TEST(a_joint_turns_all_behind_it_and_nothing_before)
{
    struct arcspline c = chain_of(7), moved = chain_of(7);
    moved.joint[3].p.z += 0.01;
    arcspline_set_tangents(&moved, 2);
    for (size_t i = 0; i <= c.n; i++) {
        double turned = vec_distance(c.joint[i].tangent, moved.joint[i].tangent);
        if (i < 3)
            ck_assert_double_le(turned, 0);
        else
            ck_assert_double_gt(turned, 1e-4);
    }
    arcspline_free(&c);
    arcspline_free(&moved);
}
END_TEST

/* But not out of a plane that all axes lie in (_i). */
START_TEST(the_axis_leans_sideways_by_what_it_is_told)
{
    struct run run = {.radius = 5};
    for (int i = 0; i < 20; i++) {
        struct vec3 tip = vec(i, 0, 0), axis = vec_unit(vec(_i ? 0 : 1e-4, 0.01 * i, 1));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis, .given = true};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct arcspline c = arcspline_new(1);
    c.joint[1] = (struct joint){.p = vec(7.5, 0.3, 0.1), .place = 3, .side = 0.006};
    arcspline_set_axis(&c, &t, 1);
    ck_assert_double_eq_tol(c.joint[1].place, 7.5, 1e-9);
    struct vec3 other = vec_scale(5, vec_sub(c.joint[1].axis, reference_axis(&t, 7.5)));
    ck_assert_double_eq_tol(vec_length(other), 0.006, _i ? 1e-5 : 1e-6);
    ck_assert_double_lt(fabs(other.x), 1e-3); /* not ahead */
    ck_assert_int_eq(c.joint[1].axis.x == 0, _i);
    struct pieces pieces = {0};
    c.joint[0] = (struct joint){.tangent = vec(1, 0, 0), .axis = t.axis[0]};
    c.joint[1].place = 7.5;
    arcspline_pieces(&c, &t, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    ck_assert_double_eq_tol(pieces.item[0].to, 7.5, 1e-9);
    ck_assert_double_lt(vec_distance(pieces.item[0].axis_to, c.joint[1].axis), 1e-15);
    array_free(&pieces);
    arcspline_free(&c);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(points_about_a_circle_are_off_by_their_radius)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 60; i++) {
        double u = RADIANS(i), r = 40 + 0.01 * sin(7 * u);
        struct vec3 tip = vec(r * cos(u), r * sin(u), 0.02 * cos(5 * u));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_add(tip, vec(0, 0, 5)), .axis = vec(0, 0, 1), .given = true};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct arcspline c = arcspline_new(2);
    for (size_t i = 0; i <= 2; i++) {
        double u = RADIANS(30.0 * (double)i);
        c.joint[i] = (struct joint){.p = vec(40 * cos(u), 40 * sin(u), 0), .axis = vec(0, 0, 1)};
    }
    c.joint[0].tangent = vec(0, 1, 0);
    arcspline_set_tangents(&c, 0);
    struct arc_feet feet = arc_feet_of(&t, 0, 60, 30);
    ck_assert_uint_eq(feet.n, 30);
    double *off = mem_alloc(4 * feet.n, sizeof *off);
    arcspline_residual(&c, 0, &feet, off);
    for (size_t i = 0; i < feet.n; i++) {
        struct vec3 p = feet.item[i].p;
        double truth = hypot(hypot(p.x, p.y) - 40, p.z);
        ck_assert_double_eq_tol(hypot(off[2 * i], off[2 * i + 1]), truth, 2e-6);
        ck_assert_uint_eq(feet.item[i].arc, atan2(p.y, p.x) > RADIANS(30));
        struct vec3 at = feet.item[i].at;
        ck_assert_double_eq_tol(hypot(at.x, at.y), 40, 1e-9); /* the conic is the circle */
    }
    arc_feet_free(&feet);
    feet = arc_feet_of(&t, 20, 30, 30); /* fewer points than that: middles between them, too */
    ck_assert_uint_eq(feet.n, 19);
    for (size_t i = 0; i < feet.n; i++) {
        struct vec3 from = t.point[20 + (i + 1) / 2], to = t.point[20 + (i + 2) / 2];
        ck_assert_double_lt(vec_distance(feet.item[i].p, vec_mix(from, to, 0.5)), 1e-12);
        ck_assert_double_lt(fabs(vec_dot(feet.item[i].u, vec_sub(to, from))), 1e-9);
    }
    free(off);
    arc_feet_free(&feet);
    arcspline_free(&c);
    reference_free(&t);
    array_free(&run);
}
END_TEST

/* Points on an S of two arcs of radius 20 with a quarter's turn each, and 0.2 mm between points. */
static struct reference two_arcs(void)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 314; i++) {
        double u = 0.01 * i, v = u - PI / 2;
        struct vec3 tip = u <= PI / 2 ? vec(20 * sin(u), 20 - 20 * cos(u), 1)
                                      : vec(40 - 20 * cos(v), 20 + 20 * sin(v), 1);
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_add(tip, vec(0, 0, 5)), .axis = vec(0, 0, 1), .given = true};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

static struct arcspline_fit moves_of(const struct reference *t, size_t arcs, const double *place)
{
    struct arcspline_fit m = {.reference = t,
                              .spline = arcspline_new(arcs),
                              .feet = arc_feet_of(t, 0, t->n - 1, 60),
                              .tolerance = 0.02,
                              .other = 0.02};
    for (size_t i = 0; i <= arcs; i++) {
        m.spline.joint[i] = (struct joint){.p = reference_point(t, place[i]), .place = place[i]};
        arcspline_set_axis(&m.spline, t, i);
    }
    m.spline.joint[0].tangent = t->tangent[0];
    return m;
}

static void moves_free(struct arcspline_fit *m)
{
    arcspline_free(&m->spline);
    arc_feet_free(&m->feet);
}

START_TEST(a_joint_goes_to_where_the_bend_changes)
{
    struct reference t = two_arcs();
    const double place[] = {0, 120, 314};
    struct arcspline_fit m = moves_of(&t, 2, place);
    ck_assert_double_le(arcspline_optimize(&m, 0.5), 0.5);
    /* where the turn-about is not sharp it may be elsewhere by what 0.01 mm allow */
    ck_assert_double_lt(vec_distance(m.spline.joint[1].p, vec(20, 20, 1)), 1);
    struct arc arc = arcspline_arc(&m.spline, 0);
    ck_assert_double_eq_tol(arc.radius, 20, 0.1);
    moves_free(&m);
    reference_free(&t);
}
END_TEST

START_TEST(held_tangents_stay)
{
    struct reference t = two_arcs();
    const double place[] = {0, 80, 170, 240, 314};
    struct arcspline_fit m = moves_of(&t, 4, place);
    m.start_held = m.end_held = true;
    m.spline.joint[0].tangent = vec(1, 0, 0);
    m.end = vec_unit(vec(sin(3.14 - PI / 2), cos(3.14 - PI / 2), 0));
    ck_assert_double_le(arcspline_optimize(&m, 0.5), 0.5);
    ck_assert_double_lt(vec_distance(m.spline.joint[0].tangent, vec(1, 0, 0)), 1e-15);
    ck_assert_double_lt(vec_angle(m.spline.joint[4].tangent, m.end), 2e-4);
    moves_free(&m);
    reference_free(&t);
}
END_TEST

START_TEST(one_arc_for_both_is_hopeless)
{
    struct reference t = two_arcs();
    const double place[] = {0, 314};
    struct arcspline_fit m = moves_of(&t, 1, place);
    ck_assert_double_gt(arcspline_optimize(&m, 0.5), 1);
    moves_free(&m);
    reference_free(&t);
}
END_TEST

/* Beside the pole of Z a turn to the side would turn a rotary axis about Z far: by no more than
 * 0.02 radians it does; a leaning axis goes where it has to. */
START_TEST(beside_the_pole_the_axis_keeps_its_bearing)
{
    for (int k = 0; k < 2; k++) {
        struct run run = {.radius = 5};
        struct vec3 axis = vec_unit(vec(k ? 0.5 : 2e-5, k ? -0.3 : -3e-5, 1));
        for (int i = 0; i <= 20; i++)
            *array_push(&run) = (struct run_point){
                .tip = vec(i, 0, 0), .ball = vec_along(vec(i, 0, 0), 5, axis), .axis = axis};
        struct reference t = reference_of(&run, 0, run.n, false, false);
        struct arcspline s = arcspline_new(2);
        s.joint[1] = (struct joint){.p = vec(8, 0, 0), .place = 8, .side = 0.006};
        arcspline_set_axis(&s, &t, 1);
        struct vec3 a = s.joint[1].axis;
        double turn = fabs(atan2(a.y, a.x) - atan2(axis.y, axis.x));
        ck_assert_double_le(turn, k ? 1 : 0.0201);
        ck_assert_double_eq_tol(vec_angle(a, axis), k ? 0.006 / 5 : 0.02 * 3.6056e-5,
                                k ? 1e-6 : 1e-8);
        arcspline_free(&s);
        reference_free(&t);
        array_free(&run);
    }
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcspline");
    tcase_add_test(t, beside_the_pole_the_axis_keeps_its_bearing);
    tcase_add_test(t, each_arc_starts_in_the_direction_where_the_last_one_ended);
    tcase_add_test(t, a_joint_turns_all_behind_it_and_nothing_before);
    tcase_add_loop_test(t, the_axis_leans_sideways_by_what_it_is_told, 0, 2);
    tcase_add_test(t, points_about_a_circle_are_off_by_their_radius);
    tcase_add_test(t, a_joint_goes_to_where_the_bend_changes);
    tcase_add_test(t, held_tangents_stay);
    tcase_add_test(t, one_arc_for_both_is_hopeless);
    Suite *s = suite_create("arcspline");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
