/* Tests of arcfit_calm: axes that are off by turns are put where they turn evenly. */
#include "arcfit/arcfit.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

/* A chord for every `each` points of a screw line, on which the axis leans by the same and its
 * bearing turns evenly; those at inner joints leaned and turned off it in turns, radians. */
static struct pieces off_in_turns(const struct reference *t, size_t each, double off)
{
    struct pieces p = {0};
    for (size_t i = 0; i + each < t->n; i += each) {
        struct arc arc = arc_to(t->point[i], t->tangent[i], t->point[i + each]);
        *array_push(&p) = arc_piece_of(t, arc, (double)i, (double)(i + each));
    }
    for (size_t k = 1; k < p.n; k++) {
        struct vec3 a = p.item[k].axis, side = vec_unit(vec_cross(vec(0, 0, 1), a));
        double by = k % 2 ? off : -off;
        a = vec_unit(vec_along(vec_along(a, by, side), by / 2, vec_cross(a, side)));
        p.item[k - 1].axis_to = p.item[k].axis = a;
    }
    return p;
}

/* Sum of squares of the changes of the bearing's and the lean's speed, by formulas of its own. */
static void jumps(const struct pieces *p, double *bearing, double *lean)
{
    *bearing = *lean = 0;
    for (size_t k = 1; k < p->n; k++) {
        double speed[2][2];
        for (size_t i = 0; i < 2; i++) {
            const struct arc_piece *q = &p->item[k - 1 + i];
            double length = arc_length(&q->arc);
            struct vec3 a = q->axis, b = q->axis_to;
            double cross = a.x * b.y - a.y * b.x, dot = a.x * b.x + a.y * b.y;
            speed[i][0] = atan2(cross, dot) / length;
            speed[i][1] = (acos(b.z) - acos(a.z)) / length;
        }
        *bearing += (speed[1][0] - speed[0][0]) * (speed[1][0] - speed[0][0]);
        *lean += (speed[1][1] - speed[0][1]) * (speed[1][1] - speed[0][1]);
    }
}

static void assert_calmed(double tolerance, double off, double part)
{
    struct run run = trial_screw(401, 0.02);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = off_in_turns(&t, 8, off), was = off_in_turns(&t, 8, off);
    const struct deviation within = {tolerance, tolerance, 0.02};
    double bearing[2], lean[2];
    jumps(&p, &bearing[0], &lean[0]);
    ck_assert_double_gt(bearing[0], 1e-5);
    arcfit_calm(&t, &within, 0, p.n, &p);
    jumps(&p, &bearing[1], &lean[1]);
    ck_assert_double_lt(bearing[1], part * bearing[0]);
    ck_assert_double_lt(lean[1], part * lean[0]);
    ck_assert_uint_eq(p.n, was.n);
    for (size_t i = 0; i < p.n; i++) {
        struct deviation d = arc_piece_deviation(&t, &p.item[i], 8, NULL);
        ck_assert_double_le(d.other, 1.01 * tolerance);
        ck_assert_double_eq(vec_distance(p.item[i].arc.to, was.item[i].arc.to), 0);
        ck_assert(i == 0 || vec_distance(p.item[i - 1].axis_to, p.item[i].axis) < 1e-15);
    }
    ck_assert_double_eq(vec_distance(p.item[0].axis, was.item[0].axis), 0);
    ck_assert_double_eq(vec_distance(p.item[p.n - 1].axis_to, was.item[was.n - 1].axis_to), 0);
    array_free(&p);
    array_free(&was);
    array_free(&run);
    reference_free(&t);
}

START_TEST(even_again)
{
    assert_calmed(0.02, 0.001, 0.02);
    assert_calmed(0.01, 0.0005, 0.02);
}
END_TEST

/* A ball of 4 may be off by no more than what it is already where the axis is off by 0.001. */
START_TEST(as_far_as_the_tolerance_allows)
{
    assert_calmed(0.0046, 0.001, 0.9);
}
END_TEST

START_TEST(beyond_the_range_all_stays)
{
    struct run run = trial_screw(401, 0.02);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    const struct deviation within = {0.02, 0.02, 0.02};
    struct pieces p = off_in_turns(&t, 8, 0.001), was = off_in_turns(&t, 8, 0.001);
    arcfit_calm(&t, &within, 10, 20, &p);
    int moved = 0;
    for (size_t i = 0; i < p.n; i++) {
        bool same = vec_distance(p.item[i].axis_to, was.item[i].axis_to) <= 0;
        moved += !same;
        ck_assert(same || (i >= 10 && i < 19));
    }
    ck_assert_int_gt(moved, 5);
    arcfit_calm(&t, &within, 30, 31, &p);
    arcfit_calm(&t, &within, 30, 30, &p);
    ck_assert_double_eq(vec_distance(p.item[30].axis_to, was.item[30].axis_to), 0);
    array_free(&p);
    array_free(&was);
    array_free(&run);
    reference_free(&t);
}
END_TEST

START_TEST(a_fixed_axis_stays)
{
    struct reference t = trial_wave(201, 0.25, 0, 0);
    const struct deviation within = {0.01, 0.01, 0.02};
    struct pieces p = {0};
    arcfit_beam(&t, &within, 6, ARCFIT_QUICK, &p);
    struct vec3 axis = p.item[0].axis;
    arcfit_calm(&t, &within, 0, p.n, &p);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_eq(vec_distance(p.item[i].axis_to, axis), 0);
    array_free(&p);
    reference_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc_calm");
    tcase_add_test(t, even_again);
    tcase_add_test(t, as_far_as_the_tolerance_allows);
    tcase_add_test(t, beyond_the_range_all_stays);
    tcase_add_test(t, a_fixed_axis_stays);
    Suite *s = suite_create("arc_calm");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
