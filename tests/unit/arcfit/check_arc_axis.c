/* Tests of arc_axis.h: an axis that turns unevenly is followed better with its end set free. */
#include "arcfit/arc_axis.h"

#include <check.h>
#include <stdlib.h>

static const struct arc_deviation WITHIN = {0.01, 0.01, 0.02};

/* Along x; the axis leans aside, first not at all and then faster and faster. */
static struct trace leaning(double lean)
{
    struct run run = {.radius = 6};
    for (size_t i = 0; i <= 40; i++) {
        double x = 0.1 * (double)i;
        struct vec3 tip = vec(x, 0, 0), axis = vec_unit(vec(0, lean * x * x, 1));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_along(tip, run.radius, axis), .axis = axis, .given = true};
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    array_free(&run);
    return t;
}

START_TEST(the_other_end_strays_less)
{
    struct trace t = leaning(0.0005);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.p[0], t.p[40]), 0, 40);
    struct arc_deviation before = arc_piece_deviation(&t, &piece, 4, NULL);
    piece.axis_to = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    struct arc_deviation after = arc_piece_deviation(&t, &piece, 4, NULL);
    ck_assert_double_eq_tol(vec_length(piece.axis_to), 1, 1e-15);
    ck_assert_double_lt(after.other, 0.8 * before.other);
    trace_free(&t);
}
END_TEST

START_TEST(the_end_stays_within_its_part)
{
    struct trace t = leaning(0.01);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.p[0], t.p[40]), 0, 40);
    struct vec3 axis = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    double moved = vec_distance(vec_scale(t.lever, axis), vec_scale(t.lever, piece.axis_to));
    ck_assert_double_le(moved, 0.85 * WITHIN.other + 1e-7);
    ck_assert_double_gt(moved, 0.8 * WITHIN.other);
    trace_free(&t);
}
END_TEST

START_TEST(what_follows_already_is_left)
{
    struct trace t = leaning(0);
    struct arc_piece piece = arc_piece_of(&t, arc_line(t.p[0], t.p[40]), 0, 40);
    struct vec3 axis = arc_axis_end(&t, &piece, &WITHIN, 0.85, 9);
    ck_assert_double_lt(vec_distance(axis, piece.axis_to), 1e-15);
    trace_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("swing");
    tcase_add_test(t, the_other_end_strays_less);
    tcase_add_test(t, the_end_stays_within_its_part);
    tcase_add_test(t, what_follows_already_is_left);
    Suite *s = suite_create("swing");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
