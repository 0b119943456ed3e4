/* Tests of arcspline.h: tangents passed on from arc to arc, pieces that hang together. */
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
    arcspline_turn(&c, 0);
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
    arcspline_turn(&moved, 2);
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

START_TEST(the_axis_leans_sideways_by_what_it_is_told)
{
    struct run run = {.radius = 5};
    for (int i = 0; i < 20; i++) {
        struct vec3 tip = vec(i, 0, 0), axis = vec_unit(vec(0, 0.01 * i, 1));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis, .given = true};
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct arcspline c = arcspline_new(1);
    c.joint[1] = (struct joint){.p = vec(7.5, 0.3, 0.1), .place = 3, .side = 0.02};
    arcspline_lean(&c, &t, 1);
    ck_assert_double_eq_tol(c.joint[1].place, 7.5, 1e-9);
    struct vec3 other = vec_scale(5, vec_sub(c.joint[1].axis, trace_axis(&t, 7.5)));
    ck_assert_double_eq_tol(vec_length(other), 0.02, 1e-6);
    ck_assert_double_lt(fabs(other.x), 1e-3); /* not ahead */
    struct pieces pieces = {0};
    c.joint[0] = (struct joint){.tangent = vec(1, 0, 0), .axis = t.axis[0]};
    c.joint[1].place = 7.5;
    arcspline_pieces(&c, &t, &pieces);
    ck_assert_uint_eq(pieces.n, 1);
    ck_assert_double_eq_tol(pieces.item[0].to, 7.5, 1e-9);
    ck_assert_double_lt(vec_distance(pieces.item[0].axis_to, c.joint[1].axis), 1e-15);
    array_free(&pieces);
    arcspline_free(&c);
    trace_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcchain");
    tcase_add_test(t, each_arc_starts_in_the_direction_where_the_last_one_ended);
    tcase_add_test(t, a_joint_turns_all_behind_it_and_nothing_before);
    tcase_add_test(t, the_axis_leans_sideways_by_what_it_is_told);
    Suite *s = suite_create("arcchain");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
