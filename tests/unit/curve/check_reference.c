/* Tests of reference.h: points, chords and places of a run, and samples of it. */
#include "curve/reference.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "curve/polyline.h"
#include "trial.h"

START_TEST(places)
{
    struct run run = trial_screw(20, 0.1);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    ck_assert_double_lt(
        vec_distance(reference_point(&t, 3.25), vec_mix(t.point[3], t.point[4], 0.25)), 1e-15);
    ck_assert_double_lt(vec_distance(reference_point(&t, 19), t.point[19]), 1e-15);
    ck_assert_double_lt(fabs(reference_place(&t, reference_point(&t, 7.5), 2) - 7.5), 1e-9);
    ck_assert_double_lt(fabs(reference_place(&t, reference_point(&t, 7.5), 15.3) - 7.5), 1e-9);
    ck_assert_double_eq(reference_place(&t, vec(10, -3, 0), 1), 0);
    ck_assert_double_lt(fabs(vec_length(reference_axis(&t, 4.4)) - 1), 1e-12);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(distances_go_downhill)
{
    struct run run = trial_screw(40, 0.1);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    size_t k = 0;
    struct vec3 beside = vec_add(reference_point(&t, 30.5), vec(0, 0, 0.01));
    ck_assert_double_lt(
        polyline_descend((struct polyline){t.n, t.point}, &t.point_stays, beside, &k), 0.01);
    ck_assert_uint_eq(k, 30);
    double part;
    ck_assert_uint_eq(reference_interval(&t, 30.5, &part), 30);
    ck_assert_double_eq(part, 0.5);
    ck_assert_uint_eq(reference_interval(&t, 39, &part), 38);
    ck_assert_double_eq(part, 1);
    ck_assert(reference_axis_still(&t, 7, 7));
    ck_assert(!reference_axis_still(&t, 7, 8));
    reference_free(&t);
    array_free(&run);
}
END_TEST

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
        struct reference t = reference_distinct(&run, centre);
        ck_assert_uint_eq(t.n, 3);
        ck_assert(t.offset == (centre ? -8 : 8));
        for (size_t k = 0; k < 3; k++) {
            struct vec3 point = centre ? item[k].ball : item[k].tip;
            struct vec3 other = centre ? item[k].tip : item[k].ball;
            ck_assert(vec_distance(t.point[k], point) == 0);
            ck_assert_double_lt(vec_distance(t.other[k], other), 1e-14);
        }
        double tip = vec_distance(item[0].tip, item[1].tip);
        double ball = vec_distance(item[0].ball, item[1].ball);
        ck_assert_double_eq_tol(t.chord[0], sqrt((tip * tip + ball * ball) / 2), 1e-14);
        reference_free(&t);
    }
}
END_TEST

/* What is 0 in every axis stays 0. */
START_TEST(axes_in_a_plane)
{
    struct run_point item[] = {pose(0, 0.1), pose(1, 0.2), pose(3, 0.3)};
    struct run run = {.n = 3, .item = item, .radius = 8};
    struct reference t = reference_distinct(&run, false);
    struct vec3 off = vec_unit(vec(0.2, 1e-3, 1)), flat = reference_flat_axis(&t, off);

    ck_assert(!t.flat[0] && t.flat[1] && !t.flat[2]);
    ck_assert_double_eq(flat.y, 0);
    ck_assert_double_eq_tol(vec_length(flat), 1, 1e-12);
    ck_assert_double_lt(vec_distance(flat, off), 1.1e-3);
    flat = reference_flat(&t, vec(1, 2, 3), vec(4, 5, 6));
    ck_assert_double_eq(vec_distance(flat, vec(1, 5, 3)), 0);
    reference_free(&t);
    item[1].axis = off;
    t = reference_distinct(&run, false);
    ck_assert(!t.flat[0] && !t.flat[1] && !t.flat[2]);
    ck_assert_double_eq(vec_distance(reference_flat_axis(&t, off), off), 0);
    reference_free(&t);
}
END_TEST

START_TEST(repeats_go_and_the_last_point_stays)
{
    struct run_point item[] = {pose(0, 0), pose(0, 0),    pose(1, 0),   pose(1, 0),
                               pose(2, 0), pose(2, 5e-9), pose(2, 1e-8)};
    struct run run = {.n = 7, .item = item, .radius = 8};
    struct reference t = reference_distinct(&run, false);

    ck_assert_uint_eq(t.n, 3);
    ck_assert(t.axis[2].x == item[6].axis.x);
    ck_assert(t.chord[0] == 1);
    reference_free(&t);

    run.n = 2;
    t = reference_distinct(&run, false);
    ck_assert_uint_eq(t.n, 1);
    ck_assert(!t.turns);
    reference_free(&t);
}
END_TEST

/* Only the axis turns: the ball's way, or 1 mm's where there is no ball, gives the chords. */
START_TEST(a_turn_in_place_has_length)
{
    struct run_point item[] = {pose(0, 0), pose(0, 0.1)};
    struct run run = {.n = 2, .item = item, .radius = 0};
    struct reference t = reference_distinct(&run, false);

    ck_assert_uint_eq(t.n, 2);
    ck_assert_double_eq_tol(t.chord[0], 2 * sin(0.05) / sqrt(2), 1e-14);
    ck_assert(t.offset == 0);
    reference_free(&t);
}
END_TEST

START_TEST(on_the_chords_and_evenly)
{
    static const size_t points[] = {2, 5, 40, 3000};

    for (int i = 0; i < 4; i++) {
        struct run run = trial_motion(points[i], 8);
        struct reference track = reference_distinct(&run, i % 2 == 1);
        struct reference t = reference_sample(&track, 100);
        double way = 0;

        for (size_t k = 0; k + 1 < track.n; k++)
            way += track.chord[k];
        ck_assert_uint_ge(t.n, 80);
        ck_assert_uint_le(t.n, 250);
        ck_assert(t.length[0] == 0);
        ck_assert_double_eq_tol(t.length[t.n - 1], way, 1e-9);
        ck_assert(vec_distance(t.point[0], track.point[0]) == 0);
        ck_assert(vec_distance(t.point[t.n - 1], track.point[track.n - 1]) == 0);
        for (size_t k = 0; k < t.n; k++) {
            ck_assert_double_lt(trial_off_chain(t.point[k], track.point, track.n), 1e-9);
            ck_assert_double_lt(trial_off_chain(t.other[k], track.other, track.n), 1e-9);
            ck_assert_double_eq_tol(vec_length(t.axis[k]), 1, 1e-12);
            ck_assert(k == 0 || t.length[k] > t.length[k - 1]);
            ck_assert(k == 0 || t.length[k] - t.length[k - 1] < 2 * way / 100);
        }
        reference_free(&t);
        reference_free(&track);
        array_free(&run);
    }
}
END_TEST

START_TEST(a_fixed_axis_has_no_other_end)
{
    struct run run = trial_motion(50, 8);

    for (size_t i = 0; i < run.n; i++)
        run.item[i].axis = vec(0, 0, 1);
    struct reference track = reference_distinct(&run, false);
    struct reference t = reference_sample(&track, 20);
    ck_assert(t.other == NULL && t.axis == NULL && !t.other_leads);
    reference_free(&t);
    reference_free(&track);
    array_free(&run);
}
END_TEST

START_TEST(all_figures_of_a_deviation_count)
{
    struct deviation a = {1, 2, 3}, b = {2, 1, 3}, worst = deviation_worst(a, b);

    ck_assert(worst.point == 2 && worst.other == 2 && worst.axis == 3);
    ck_assert(deviation_within(&a, &worst) && deviation_within(&b, &worst));
    ck_assert(!deviation_within(&worst, &a) && !deviation_within(&worst, &b));
    worst.axis = 2;
    ck_assert(!deviation_within(&a, &worst));
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("reference");
    tcase_add_test(t, places);
    tcase_add_test(t, distances_go_downhill);
    tcase_add_test(t, tip_and_centre);
    tcase_add_test(t, axes_in_a_plane);
    tcase_add_test(t, repeats_go_and_the_last_point_stays);
    tcase_add_test(t, a_turn_in_place_has_length);
    tcase_add_test(t, on_the_chords_and_evenly);
    tcase_add_test(t, a_fixed_axis_has_no_other_end);
    tcase_add_test(t, all_figures_of_a_deviation_count);
    Suite *s = suite_create("reference");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
