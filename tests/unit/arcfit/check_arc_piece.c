/* Tests of arc_piece.h: deviations against ones measured by sampling without any cleverness.
 */
#include "arcfit/arc_piece.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

static double to_line(struct vec3 q, const struct vec3 *line, size_t from, size_t to)
{
    double best = HUGE_VAL;
    for (size_t i = from; i < to; i++)
        for (int k = 0; k <= 200; k++)
            best = fmin(best, vec_distance(q, vec_mix(line[i], line[i + 1], k / 200.0)));
    return best;
}

/* Both directions, by brute force. */
static void brute(const struct reference *t, const struct arc_piece *p, double *tracked,
                  double *other)
{
    enum { MANY = 400 };
    size_t from = (size_t)p->from, to = (size_t)ceil(p->to);
    struct vec3 at[MANY + 1], far[MANY + 1];
    *tracked = *other = 0;
    for (int k = 0; k <= MANY; k++) {
        double s = (double)k / MANY;
        at[k] = arc_at(&p->arc, s);
        far[k] = vec_along(at[k], t->offset, vec_slerp(p->axis, p->axis_to, s));
        *tracked = fmax(*tracked, to_line(at[k], t->point, 0, t->n - 1));
        *other = fmax(*other, to_line(far[k], t->other, 0, t->n - 1));
    }
    for (size_t i = from + 1; i <= to; i++) {
        *tracked = fmax(*tracked, to_line(t->point[i], at, 0, MANY));
        *other = fmax(*other, to_line(t->other[i], far, 0, MANY));
    }
}

START_TEST(stray_is_what_brute_force_finds)
{
    struct run run = trial_screw(60, 0.02);
    for (int centre = 0; centre < 2; centre++) {
        struct reference t = reference_of(&run, 0, run.n, centre, false);
        for (size_t to = 10; to < 60; to += 16) {
            struct vec3 aim = vec_add(t.point[to], vec(0.01, 0.02, -0.03));
            struct arc arc = arc_to(t.point[3], t.tangent[3], aim);
            struct arc_piece p = arc_piece_of(&t, arc, 3, (double)to);
            struct deviation off = arc_piece_deviation(&t, &p, 4, NULL);
            double tracked, other;
            brute(&t, &p, &tracked, &other);
            ck_assert_double_lt(fabs(off.point - tracked), 0.02 * tracked + 1e-4);
            ck_assert_double_lt(fabs(off.other - other), 0.02 * other + 1e-4);
        }
        reference_free(&t);
    }
    array_free(&run);
}
END_TEST

START_TEST(an_axis_out_of_step_is_seen)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 10; i++) { /* turns in the second half of the way alone */
        struct vec3 axis = vec_turn(vec(0, 0, 1), vec(1, 0, 0), i > 5 ? RADIANS(2) * (i - 5) : 0);
        struct vec3 tip = vec(i, 0, 0);
        *array_push(&run) =
            (struct run_point){.tip = tip, .ball = vec_along(tip, 5, axis), .axis = axis};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct arc_piece p = arc_piece_of(&t, arc_line(t.point[0], t.point[10]), 0, 10);
    struct deviation off = arc_piece_deviation(&t, &p, 1, NULL);
    ck_assert_double_eq(off.point, 0);
    ck_assert_double_eq_tol(DEGREES(off.axis), 5, 1e-9);
    ck_assert_double_gt(off.other, 0.3);
    struct deviation within = {1, 0.1, 1};
    off = arc_piece_deviation(&t, &p, 1, &within);
    ck_assert(!deviation_within(&off, &within));
    reference_free(&t);
    array_free(&run);
}
END_TEST

/* Pieces a little and far off, by limits about what they are off: the decision is that of the
 * figures, each by itself, but where other figures end the search for one. */
START_TEST(a_decision_is_what_the_figures_say)
{
    struct run run = trial_screw(60, 0.02);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    int yes = 0, no = 0;

    for (int i = 0; i < 2000; i++) {
        double x = sin(7.0 * i), y = cos(11.0 * i), far = 0.05 * (1 + i % 5);
        size_t from = (size_t)(i % 9), to = from + 2 + (size_t)(i % 37);
        struct vec3 aim = vec_add(t.point[to], vec(far * x, far * y, -far * x * y));
        struct arc arc = arc_to(t.point[from], t.tangent[from], aim);
        struct arc_piece p = arc_piece_of(&t, arc, (double)from, (double)to);
        p.axis_to = vec_unit(vec_add(p.axis_to, vec(0.01 * y, 0.02 * x, 0)));
        struct deviation off = arc_piece_deviation(&t, &p, 4, NULL);
        double part = 0.7 + 0.6 * fabs(sin(3.0 * i)), more = 0.7 + 0.6 * fabs(cos(5.0 * i));
        struct deviation within = {part * off.point, more * off.other, PI};
        struct deviation found = arc_piece_deviation(&t, &p, 4, &within);
        struct deviation decided = arc_piece_decision(&t, &p, 4, &within);
        ck_assert_int_eq(found.point <= within.point, decided.point <= within.point);
        ck_assert_int_eq(found.other <= within.other, decided.other <= within.other);
        yes += deviation_within(&found, &within);
        no += !deviation_within(&found, &within);
    }
    ck_assert_int_gt(yes, 200);
    ck_assert_int_gt(no, 200);
    reference_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc_piece");
    tcase_add_test(t, stray_is_what_brute_force_finds);
    tcase_add_test(t, an_axis_out_of_step_is_seen);
    tcase_add_test(t, a_decision_is_what_the_figures_say);
    Suite *s = suite_create("arc_piece");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
