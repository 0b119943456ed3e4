/* arc_reverse: what was fitted from the end, told from the start. */
#include "arcfit/arc_reverse.h"

#include <check.h>
#include <stdlib.h>

#include "arcfit/arc_beam.h"

static struct trace wave(void)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 200; i++) {
        double s = 0.2 * i;
        struct run_point p = {.axis = vec_unit(vec(0.1 * sin(s / 9), 0.2, 1))};
        p.tip = vec(s, 2 * sin(s / 5), 0.5 * cos(s / 4));
        p.ball = vec_along(p.tip, 4, p.axis);
        *array_push(&run) = p;
    }
    struct trace trace = trace_of(&run, 0, run.n, false, false);
    array_free(&run);
    return trace;
}

START_TEST(a_trace_turned_round_twice_is_itself)
{
    struct trace t = wave(), back = arc_reverse_trace(&t), again = arc_reverse_trace(&back);
    ck_assert_uint_eq(back.n, t.n);
    for (size_t i = 0; i < t.n; i++) {
        ck_assert_double_eq(vec_distance(again.p[i], t.p[i]), 0);
        ck_assert_double_eq(vec_distance(again.other[i], t.other[i]), 0);
        ck_assert_double_eq(vec_distance(again.axis[i], t.axis[i]), 0);
        ck_assert_double_eq(vec_distance(again.tangent[i], t.tangent[i]), 0);
        ck_assert_double_eq_tol(again.length[i], t.length[i], 1e-9);
        ck_assert_double_eq_tol(back.length[i], vec_distance(back.p[i], back.p[0]), 4);
    }
    ck_assert_double_eq(vec_distance(back.p[0], t.p[t.n - 1]), 0);
    trace_free(&t);
    trace_free(&back);
    trace_free(&again);
}
END_TEST

START_TEST(pieces_from_the_end_follow_the_trace)
{
    struct trace t = wave(), back = arc_reverse_trace(&t);
    struct arc_deviation within = {0.01, 0.01, 0.02};
    struct pieces pieces = {0};
    arc_beam_fit(&back, &within, 6, &pieces);
    ck_assert_uint_gt(pieces.n, 3);
    arc_reverse_pieces(&pieces, t.n);
    ck_assert_double_eq(pieces.item[0].from, 0);
    ck_assert_double_eq(pieces.item[pieces.n - 1].to, (double)(t.n - 1));
    for (size_t i = 0; i < pieces.n; i++) {
        struct arc_deviation stray = arc_piece_deviation(&t, &pieces.item[i], 8, NULL);
        ck_assert(stray.tracked < 0.010001 && stray.other < 0.010001 && stray.axis < 0.020001);
        if (i == 0)
            continue;
        const struct arc_piece *a = &pieces.item[i - 1], *b = &pieces.item[i];
        ck_assert_double_eq(a->to, b->from);
        ck_assert_double_eq(vec_distance(a->arc.to, b->arc.from), 0);
        ck_assert_double_eq(vec_distance(a->axis_to, b->axis), 0);
        ck_assert_double_lt(vec_angle(arc_tangent(&a->arc, 1), b->arc.tangent), 2 * ARCFIT_KINK);
    }
    array_free(&pieces);
    trace_free(&t);
    trace_free(&back);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arcback");
    TCase *tests = tcase_create("arcback");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_trace_turned_round_twice_is_itself);
    tcase_add_test(tests, pieces_from_the_end_follow_the_trace);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
