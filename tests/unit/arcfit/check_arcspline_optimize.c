/* Tests of arcspline_optimize.h: arcs that a curve was made of are found again; what can't be is
 * given up. */
#include "arcfit/arcspline_optimize.h"

#include <check.h>
#include <stdlib.h>

/* Points on an S of two arcs of radius 20 with a quarter's turn each, and 0.2 mm between points. */
static struct trace two_arcs(void)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 314; i++) {
        double u = 0.01 * i, v = u - PI / 2;
        struct vec3 tip = u <= PI / 2 ? vec(20 * sin(u), 20 - 20 * cos(u), 1)
                                      : vec(40 - 20 * cos(v), 20 + 20 * sin(v), 1);
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_add(tip, vec(0, 0, 5)), .axis = vec(0, 0, 1), .given = true};
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

static struct arcspline_optimize moves_of(const struct trace *t, size_t arcs, const double *place)
{
    struct arcspline_optimize m = {.trace = t,
                                   .chain = arcspline_new(arcs),
                                   .passing = passing_of(t, 0, t->n - 1, 60),
                                   .tolerance = 0.02,
                                   .other = 0.02};
    for (size_t i = 0; i <= arcs; i++) {
        m.chain.joint[i] = (struct joint){.p = trace_point(t, place[i]), .place = place[i]};
        arcspline_lean(&m.chain, t, i);
    }
    m.chain.joint[0].tangent = t->tangent[0];
    return m;
}

static void moves_free(struct arcspline_optimize *m)
{
    arcspline_free(&m->chain);
    passing_free(&m->passing);
}

START_TEST(a_joint_goes_to_where_the_bend_changes)
{
    struct trace t = two_arcs();
    const double place[] = {0, 120, 314};
    struct arcspline_optimize m = moves_of(&t, 2, place);
    ck_assert_double_le(arcspline_optimize_settle(&m, 0.5), 0.5);
    /* where the turn-about is not sharp it may be elsewhere by what 0.01 mm allow */
    ck_assert_double_lt(vec_distance(m.chain.joint[1].p, vec(20, 20, 1)), 1);
    struct arc arc = arcspline_arc(&m.chain, 0);
    ck_assert_double_eq_tol(arc.radius, 20, 0.1);
    moves_free(&m);
    trace_free(&t);
}
END_TEST

START_TEST(held_tangents_stay)
{
    struct trace t = two_arcs();
    const double place[] = {0, 80, 170, 240, 314};
    struct arcspline_optimize m = moves_of(&t, 4, place);
    m.start_held = m.end_held = true;
    m.chain.joint[0].tangent = vec(1, 0, 0);
    m.end = vec_unit(vec(sin(3.14 - PI / 2), cos(3.14 - PI / 2), 0));
    ck_assert_double_le(arcspline_optimize_settle(&m, 0.5), 0.5);
    ck_assert_double_lt(vec_distance(m.chain.joint[0].tangent, vec(1, 0, 0)), 1e-15);
    ck_assert_double_lt(vec_angle(m.chain.joint[4].tangent, m.end), 2e-4);
    moves_free(&m);
    trace_free(&t);
}
END_TEST

START_TEST(one_arc_for_both_is_hopeless)
{
    struct trace t = two_arcs();
    const double place[] = {0, 314};
    struct arcspline_optimize m = moves_of(&t, 1, place);
    ck_assert_double_gt(arcspline_optimize_settle(&m, 0.5), 1);
    moves_free(&m);
    trace_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcmoves");
    tcase_add_test(t, a_joint_goes_to_where_the_bend_changes);
    tcase_add_test(t, held_tangents_stay);
    tcase_add_test(t, one_arc_for_both_is_hopeless);
    Suite *s = suite_create("arcmoves");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
