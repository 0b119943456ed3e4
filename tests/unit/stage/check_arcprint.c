/* arcprint: what the digits say is what was meant, to their last place. */
#include "stage/arcprint.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static struct arc_piece arc_piece(void)
{
    struct vec3 a = vec_unit(vec(0.2, -0.3, 1)), u = vec_perpendicular(a), v = vec_cross(a, u);
    struct vec3 centre = vec(10.1234567, -4.7654321, 3.3333333);
    struct arc_piece piece = {.axis = vec(0, 0, 1), .axis_to = vec_unit(vec(0.3, 0, 1))};
    piece.arc = arc_about(vec_along(centre, 7, u), vec_along(centre, 7, v), centre, a);
    return piece;
}

START_TEST(an_arc_goes_through_its_rounded_ends)
{
    struct arc_piece piece = arc_piece();
    struct vec3 from = vec_round(piece.arc.from, PATH_COORDINATE);
    struct printed p = arcprint_piece(&piece, from);
    ck_assert_double_eq_tol(p.arc.radius, 7, 1e-5);
    ck_assert_double_lt(vec_distance(p.arc.centre, vec(10.123457, -4.765432, 3.333333)), 1e-5);
    ck_assert(vec_distance(p.piece.arc.from, from) == 0);
    ck_assert(vec_distance(p.piece.arc.to, vec_round(piece.arc.to, 6)) == 0);
    for (int i = 0; i <= 10; i++)
        ck_assert_double_lt(
            vec_distance(arc_at(&p.piece.arc, i / 10.0), arc_at(&piece.arc, i / 10.0)), 1e-5);
}
END_TEST

START_TEST(what_is_too_short_is_a_line)
{
    struct arc_piece piece = arc_piece();
    piece.arc = arc_to(vec(0, 0, 0), vec(1, 0, 0), vec(6e-4, 1e-4, 0));
    ck_assert_double_eq(arcprint_piece(&piece, vec(0, 0, 0)).arc.radius, 0);
    piece.arc = arc_to(vec(0, 0, 0), vec(1, 0, 0), vec(5, 1, 0));
    ck_assert_double_eq_tol(arcprint_piece(&piece, vec(0, 0, 0)).arc.radius, 13, 1e-5);
}
END_TEST

START_TEST(chords_keep_the_sagitta)
{
    struct arc_piece piece = arc_piece();
    int n = arcprint_chords(&piece, 0, 0.01);
    double half = piece.arc.angle / n / 2;
    ck_assert_double_le(7 * (1 - cos(half)), 0.01);
    ck_assert_double_gt(7 * (1 - cos(2 * half)), 0.01);
    ck_assert_int_ge(arcprint_chords(&piece, 50, 0.01), n); /* the far end turns more */
    /* an arc that goes on by nothing while its axis turns: of the far end, at 50, all is in that */
    piece.arc.angle = 1e-9;
    piece.axis = vec(0, 0, 1);
    piece.axis_to = vec(sin(0.4), 0, cos(0.4));
    n = arcprint_chords(&piece, 50, 0.01);
    ck_assert_double_le(50 * (1 - cos(0.2 / n)), 0.01);
    ck_assert_double_gt(50 * (1 - cos(0.4 / n)), 0.01);
    ck_assert_int_eq(arcprint_chords(&piece, 0, 0.01), 1);
}
END_TEST

/* Two arcs along a quarter of a circle of radius 20, points 0.2 mm apart, as pieces of a reference.
 */
static struct reference quarter(struct pieces *pieces)
{
    struct run run = {.radius = 0};
    for (int i = 0; i <= 160; i++) {
        double u = i / 160.0 * PI / 2;
        struct vec3 p = vec(20 * sin(u), 20 - 20 * cos(u), 1);
        *array_push(&run) = (struct run_point){.tip = p, .ball = p, .axis = vec(0, 0, 1)};
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct arc first = arc_to(t.point[0], vec(1, 0, 0), t.point[80]);
    struct arc second = arc_to(t.point[80], arc_tangent(&first, 1), t.point[160]);
    *array_push(pieces) = arc_piece_of(&t, first, 0, 80);
    *array_push(pieces) = arc_piece_of(&t, second, 80, 160);
    array_free(&run);
    return t;
}

START_TEST(a_lost_end_strays_without_limit)
{
    struct pieces pieces = {0};
    struct printeds printed = {0};
    struct reference t = quarter(&pieces);
    struct deviation whole = arcprint_pieces(&t, &pieces, NULL, &printed);
    ck_assert_double_lt(whole.point, 3e-4); /* the sagitta of the reference, 0.2^2 / (8 20) */
    ck_assert_uint_eq(printed.n, 2);
    pieces.n = 1; /* what there is of it is as near as before */
    ck_assert_double_gt(arcprint_pieces(&t, &pieces, NULL, &printed).point, 1e9);
    ck_assert_uint_eq(printed.n, 1);
    pieces.n = 0;
    ck_assert_double_gt(arcprint_pieces(&t, &pieces, NULL, &printed).point, 1e9);
    array_free(&pieces);
    array_free(&printed);
    reference_free(&t);
}
END_TEST

/* A list of which a part was measured before is off by as much as without that. */
START_TEST(what_was_measured_before_is_off_as_much)
{
    struct pieces pieces = {0};
    struct printeds before = {0}, printed = {0}, again = {0};
    struct reference t = quarter(&pieces);
    arcprint_pieces(&t, &pieces, NULL, &before);
    before.item[0].off.point = 0.125; /* it tells whether it was asked */
    struct deviation off = arcprint_pieces(&t, &pieces, &before, &printed);
    ck_assert_double_eq(off.point, 0.125);
    struct arc_piece *first = &pieces.item[0], *last = &pieces.item[1];
    first->arc = arc_to(first->arc.from, vec_unit(vec(1, 0.01, 0)), first->arc.to);
    last->axis_to = vec_unit(vec(0.001, 0, 1));
    off = arcprint_pieces(&t, &pieces, &before, &printed);
    struct deviation alone = arcprint_pieces(&t, &pieces, NULL, &again);
    ck_assert_double_eq(off.point, alone.point);
    array_free(&pieces);
    array_free(&before);
    array_free(&printed);
    array_free(&again);
    reference_free(&t);
}
END_TEST

/* The end's own joint is where it should not be: the last piece stops short of it. */
START_TEST(an_end_beside_the_traces_strays_without_limit)
{
    struct pieces pieces = {0};
    struct printeds printed = {0};
    struct reference t = quarter(&pieces);
    struct arc_piece *last = &pieces.item[1];
    last->arc = arc_to(last->arc.from, last->arc.tangent, t.point[159]);
    ck_assert_double_gt(arcprint_pieces(&t, &pieces, NULL, &printed).point, 1e9);
    array_free(&pieces);
    array_free(&printed);
    reference_free(&t);
}
END_TEST

START_TEST(comments_carry_all_seven_numbers)
{
    char text[ARCPRINT_MAX];
    struct path_arc arc = {vec(1, -2.5, 3.1234567), vec(0, 0.6, 0.8), 12};
    arcprint_comment(&arc, text);
    ck_assert_str_eq(text, "$$ CIRCLE/1.000000,-2.500000,3.123457,0.000000000,0.600000000,"
                           "0.800000000,12.000000");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arcprint");
    TCase *tests = tcase_create("arcprint");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, an_arc_goes_through_its_rounded_ends);
    tcase_add_test(tests, what_is_too_short_is_a_line);
    tcase_add_test(tests, chords_keep_the_sagitta);
    tcase_add_test(tests, a_lost_end_strays_without_limit);
    tcase_add_test(tests, what_was_measured_before_is_off_as_much);
    tcase_add_test(tests, an_end_beside_the_traces_strays_without_limit);
    tcase_add_test(tests, comments_carry_all_seven_numbers);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
