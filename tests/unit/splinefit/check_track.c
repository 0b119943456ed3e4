/*
 * track, against the run it was made from.
 */
#include <check.h>
#include <stdlib.h>

#include "splinefit/track.h"

static struct run_point pose(double x, double tilt)
{
    struct vec3 axis = vec(sin(tilt), 0, cos(tilt)), tip = vec(x, 1, 2);
    return (struct run_point){.tip = tip, .ball = vec_along(tip, 8, axis), .axis = axis};
}

START_TEST(tip_and_centre)
{
    struct run_point item[] = {pose(0, 0), pose(1, 0.1), pose(3, 0.2)};
    struct run run = {.n = 3, .item = item, .radius = 8};

    for (int centre = 0; centre < 2; centre++) {
        struct track t = track_new(&run, centre);
        ck_assert_uint_eq(t.n, 3);
        ck_assert(t.offset == (centre ? -8 : 8));
        for (size_t k = 0; k < 3; k++) {
            struct vec3 point = centre ? item[k].ball : item[k].tip;
            struct vec3 other = centre ? item[k].tip : item[k].ball;
            ck_assert(vec_distance(t.point[k], point) == 0);
            ck_assert_double_lt(vec_distance(t.other[k], other), 1e-14);
            ck_assert_double_lt(
                vec_distance(t.head[k], vec_along(point, TRACK_LENGTH, item[k].axis)), 1e-13);
        }
        double tip = vec_distance(item[0].tip, item[1].tip);
        double ball = vec_distance(item[0].ball, item[1].ball);
        ck_assert_double_eq_tol(t.chord[0], sqrt((tip * tip + ball * ball) / 2), 1e-14);
        track_free(&t);
    }
}
END_TEST

START_TEST(repeats_go_and_the_last_point_stays)
{
    struct run_point item[] = {pose(0, 0), pose(0, 0),    pose(1, 0),   pose(1, 0),
                               pose(2, 0), pose(2, 5e-9), pose(2, 1e-8)};
    struct run run = {.n = 7, .item = item, .radius = 8};
    struct track t = track_new(&run, false);

    ck_assert_uint_eq(t.n, 3);
    ck_assert(t.axis[2].x == item[6].axis.x);
    ck_assert(t.chord[0] == 1);
    track_free(&t);

    run.n = 2;
    t = track_new(&run, false);
    ck_assert_uint_eq(t.n, 1);
    ck_assert(t.head == NULL); /* one axis only */
    track_free(&t);
}
END_TEST

/* Only the axis turns: the ball's way, or 1 mm's where there is no ball, gives the chords. */
START_TEST(a_turn_in_place_has_length)
{
    struct run_point item[] = {pose(0, 0), pose(0, 0.1)};
    struct run run = {.n = 2, .item = item, .radius = 0};
    struct track t = track_new(&run, false);

    ck_assert_uint_eq(t.n, 2);
    ck_assert_double_eq_tol(t.chord[0], 2 * sin(0.05) / sqrt(2), 1e-14);
    ck_assert(t.offset == 0);
    track_free(&t);
}
END_TEST

START_TEST(curves_of_degree_1)
{
    struct run_point item[] = {pose(0, 0), pose(1, 0.1), pose(3, 0.2)};
    struct run run = {.n = 3, .item = item, .radius = 8};
    struct track t = track_new(&run, false);
    struct bspline line = track_straight(&t), chain = track_polyline(&t);

    ck_assert(line.degree == 1 && line.poles == 2 && line.length == TRACK_LENGTH);
    ck_assert_double_lt(vec_distance(bspline_at(&line, line.pole, 0.5), vec(1.5, 1, 2)), 1e-14);
    ck_assert_uint_eq(chain.poles, 3);
    for (size_t k = 0; k < 3; k++) {
        double u = chain.knot[k + 1];
        ck_assert_double_lt(vec_distance(bspline_at(&chain, chain.pole, u), t.point[k]), 1e-14);
        ck_assert_double_lt(vec_distance(bspline_at(&chain, chain.head, u), t.head[k]), 1e-12);
    }
    bspline_free(&chain);
    bspline_free(&line);
    track_free(&t);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("track");
    TCase *tests = tcase_create("track");

    tcase_add_test(tests, tip_and_centre);
    tcase_add_test(tests, repeats_go_and_the_last_point_stays);
    tcase_add_test(tests, a_turn_in_place_has_length);
    tcase_add_test(tests, curves_of_degree_1);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
