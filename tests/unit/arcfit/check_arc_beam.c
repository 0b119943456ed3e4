/* Tests of arcfit_beam: its windows on circles and lines, where all is known (arc_window.h); the
 * axis at an end (arc_axis.h); chains that are G1, within the tolerance, and of fewer pieces than
 * biarcs make. */
#include "arcfit/arc_axis.h"
#include "arcfit/arc_window.h"

#include <check.h>
#include <stdlib.h>

#include "arcfit/arcfit.h"
#include "trial.h"

static struct reference around(double radius, size_t n, double step)
{
    struct run run = {.radius = 1};
    for (size_t i = 0; i < n; i++) {
        double u = step * (double)i / radius;
        struct vec3 p = vec(radius * sin(u), radius * (1 - cos(u)), 0);
        *array_push(&run) = (struct run_point){.tip = p, .ball = p, .axis = vec(0, 0, 1)};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

START_TEST(a_circle_can_be_followed_to_its_end)
{
    struct reference t = around(20, 60, 0.5);
    struct arc_windows w = {0};
    ck_assert_uint_eq(arc_look_ahead(&t, 0, t.point[0], vec(1, 0, 0), 0.01, 1.0 / 40, &w), 59);
    ck_assert_uint_eq(w.item[w.n - 1].point, 59);
    struct vec3 k = arc_window_curvature(&w.item[w.n - 1], 0.5, 0.5);
    ck_assert_double_lt(vec_distance(k, vec(0, 1.0 / 20, 0)), 1e-5);
    ck_assert(!arc_window_holds_line(&w.item[w.n - 1]));
    array_free(&w);
    reference_free(&t);
}
END_TEST

START_TEST(a_wrong_direction_ends_it)
{
    /* turned by a against a line, the curvatures at s are 2 a / s give or take 2 d / s^2; the
     * largest lower bound is a^2 / (2 d), and all bounds meet up to s = 2 (1 + sqrt 2) d / a */
    double a = 0.01, l = 2 * (1 + sqrt(2)) * 0.01 / a;
    struct reference t = around(1e6, 400, 0.02);
    size_t to = arc_look_ahead(&t, 0, t.point[0], vec(cos(a), sin(a), 0), 0.01, 1.0 / 40, NULL);
    ck_assert_double_lt(fabs(t.length[to] - l), 0.15);
    ck_assert_uint_eq(arc_look_ahead(&t, 0, t.point[0], vec(-1, 0, 0), 0.01, 1.0 / 40, NULL), 0);
    reference_free(&t);
}
END_TEST

START_TEST(a_line_holds_the_straight_one)
{
    struct reference t = around(1e9, 50, 1);
    struct arc_windows w = {0};
    arc_look_ahead(&t, 5, vec_add(t.point[5], vec(0, 0.005, 0)), vec(1, 0, 0), 0.01, 1.0 / 40, &w);
    ck_assert_uint_eq(w.item[w.n - 1].point, 49);
    ck_assert(arc_window_holds_line(&w.item[w.n - 1]));
    array_free(&w);
    reference_free(&t);
}
END_TEST

static const struct deviation WITHIN = {0.01, 0.01, 0.02};

/* Along x; the axis leans ahead and aside, first not at all and then faster and faster. */
static struct reference leaning(double lean)
{
    struct run run = {.radius = 6};
    for (size_t i = 0; i <= 40; i++) {
        double x = 0.1 * (double)i;
        struct vec3 tip = vec(x, 0, 0), axis = vec_unit(vec(0.6, lean * x * x, 1));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, run.radius, axis), .axis = axis, .given = true};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

START_TEST(the_other_end_strays_less)
{
    struct reference t = leaning(0.0005);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.point[0], t.point[40]), 0, 40);
    struct deviation before = arc_piece_deviation(&t, &piece, 4, NULL);
    piece.axis_to = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    struct deviation after = arc_piece_deviation(&t, &piece, 4, NULL);
    ck_assert_double_eq_tol(vec_length(piece.axis_to), 1, 1e-15);
    ck_assert_double_lt(after.other, 0.8 * before.other);
    reference_free(&t);
}
END_TEST

START_TEST(the_end_stays_within_its_part)
{
    struct reference t = leaning(0.01);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.point[0], t.point[40]), 0, 40);
    struct vec3 axis = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    double moved = vec_distance(vec_scale(t.offset, axis), vec_scale(t.offset, piece.axis_to));
    ck_assert_double_le(moved, 0.85 * WITHIN.other + 1e-7);
    ck_assert_double_gt(moved, 0.8 * WITHIN.other);
    reference_free(&t);
}
END_TEST

START_TEST(what_follows_already_is_left)
{
    struct reference t = leaning(0);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.point[0], t.point[40]), 0, 40);
    struct vec3 axis = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    ck_assert_double_lt(vec_distance(axis, piece.axis_to), 1e-9); /* its digits */
    reference_free(&t);
}
END_TEST

START_TEST(a_wave_takes_a_third_less_than_biarcs)
{
    struct reference t = trial_wave(401, 0.25, 0, 0);
    struct pieces arcs = {0}, biarcs = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &arcs);
    arcfit_biarcs(&t, &WITHIN, &biarcs);
    trial_assert_chain(&t, &WITHIN, &arcs);
    ck_assert_uint_lt(4 * arcs.n, 3 * biarcs.n);
    array_free(&arcs);
    array_free(&biarcs);
    reference_free(&t);
}
END_TEST

START_TEST(the_far_end_of_the_lever_is_kept_too)
{
    struct reference t = trial_wave(401, 0.25, 0.3, 0);
    struct pieces arcs = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &arcs);
    trial_assert_chain(&t, &WITHIN, &arcs);
    array_free(&arcs);
    reference_free(&t);
}
END_TEST

START_TEST(lines_and_single_intervals)
{
    for (size_t n = 2; n < 6; n++) {
        struct run run = {.radius = 6};
        for (size_t i = 0; i < n; i++) {
            struct vec3 tip = vec(2 * (double)i, 1, 0);
            *array_push(&run) = (struct run_point){
                .tip = tip, .ball = vec_add(tip, vec(0, 0, 6)), .axis = vec(0, 0, 1)};
        }
        struct reference t = reference_of(&run, 0, run.n, false, false);
        struct pieces arcs = {0};
        arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &arcs);
        ck_assert_uint_eq(arcs.n, 1);
        ck_assert(arc_straight(&arcs.item[0].arc));
        array_free(&arcs);
        reference_free(&t);
        array_free(&run);
    }
}
END_TEST

/* Where some points of a wave are lifted the pieces about these are found anew, from the start, in
 * the middle and to the end: those before stay, those behind where the old ones are met again, and
 * the chain is one. */
static void assert_again(size_t from, size_t to, size_t *stayed)
{
    struct reference t = trial_wave(401, 0.25, 0.3, 0);
    struct pieces p = {0}, old = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_HURRIED, &p);
    to = to < p.n ? to : p.n;
    for (size_t i = 0; i < p.n; i++)
        *array_push(&old) = p.item[i];
    size_t first = (size_t)ceil(p.item[from].to), last = (size_t)p.item[to - 1].from;
    for (size_t i = first; i <= last; i++) {
        double lift = 0.05 * sin(PI * (double)(i - first) / (double)(last - first + 1));
        t.point[i].z += lift;
        t.other[i].z += lift;
    }
    ck_assert(arcfit_again(&t, &WITHIN, 6, ARCFIT_HURRIED, from, to, &p));
    trial_assert_chain(&t, &WITHIN, &p);
    for (size_t i = 0; i < from; i++)
        ck_assert_double_eq(vec_distance(p.item[i].arc.to, old.item[i].arc.to), 0);
    for (*stayed = 0; *stayed < old.n - from; ++*stayed)
        if (vec_distance(p.item[p.n - 1 - *stayed].arc.from,
                         old.item[old.n - 1 - *stayed].arc.from) > 0)
            break;
    ck_assert_uint_le(p.n, old.n + 8);
    array_free(&old);
    array_free(&p);
    reference_free(&t);
}

START_TEST(a_part_is_found_anew)
{
    size_t stayed;
    assert_again(0, 5, &stayed);
    ck_assert_uint_gt(stayed, 4);
    assert_again(3, 9, &stayed);
    ck_assert_uint_gt(stayed, 4);
    assert_again(6, 1000, &stayed);
    ck_assert_uint_eq(stayed, 0);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc_beam");
    tcase_add_test(t, a_circle_can_be_followed_to_its_end);
    tcase_add_test(t, a_wrong_direction_ends_it);
    tcase_add_test(t, a_line_holds_the_straight_one);
    tcase_add_test(t, the_other_end_strays_less);
    tcase_add_test(t, the_end_stays_within_its_part);
    tcase_add_test(t, what_follows_already_is_left);
    tcase_add_test(t, a_wave_takes_a_third_less_than_biarcs);
    tcase_add_test(t, the_far_end_of_the_lever_is_kept_too);
    tcase_add_test(t, lines_and_single_intervals);
    tcase_add_test(t, a_part_is_found_anew);
    Suite *s = suite_create("arc_beam");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
