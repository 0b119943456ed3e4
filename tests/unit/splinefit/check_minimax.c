/*
 * minimax: the largest distance becomes smaller than by least squares, or nothing where it can;
 * what is out of reach is given up, and so is what takes too long.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/minimax.h"
#include "trial.h"

/* y = x^4 / 512 from -4 to 4: no cubic, but a curve of degree 4. */
static struct track quartic(void)
{
    struct run run = {0};

    for (int k = 0; k <= 400; k++) {
        double x = k / 50.0 - 4;
        struct run_point p = {.tip = vec(x, pow(x, 4) / 512, 0), .axis = vec(0, 0, 1)};
        p.ball = p.tip;
        *array_push(&run) = p;
    }
    struct track track = track_new(&run, false);
    array_free(&run);
    return track;
}

/* The least distance that a fit reaches, by trying smaller and smaller ones. */
static double reached(const struct target *t, int degree, size_t poles)
{
    double effort = 1e9, goal = 1;

    for (bool done = true; done; goal *= 0.97) {
        struct attempt a = trial_attempt(t, degree, poles, 1);
        done = minimax_fit(t, goal, 1, &a, &effort);
        ck_assert(!done || a.feet.worst <= goal);
        attempt_free(&a);
    }
    return goal / 0.97 / 0.97;
}

/* The best curve of one polynomial piece is off by the same amount, to both sides in turn: the norm
 * of the 64th power comes near to that, squares do not. */
START_TEST(the_largest_distances_are_alike)
{
    struct track track = quartic();
    struct target t = target_new(&track, 200, 0.001, 0.02);
    struct attempt a = trial_attempt(&t, 3, 4, 1);
    double effort = 1e9, goal = reached(&t, 3, 4);
    size_t tops = 0;

    ck_assert(minimax_fit(&t, goal, 1, &a, &effort));
    for (size_t k = 1; k + 1 < t.n; k++)
        tops += a.feet.off[k] > a.feet.off[k - 1] && a.feet.off[k] >= a.feet.off[k + 1] &&
                a.feet.off[k] > 0.9 * a.feet.worst;
    ck_assert_uint_ge(tops, 3);
    attempt_free(&a);
    target_free(&t);
    track_free(&track);
}
END_TEST

/* A degree that has the curve itself: all of it goes away. */
START_TEST(what_can_be_exact_becomes_so)
{
    struct track track = quartic();
    struct target t = target_new(&track, 200, 0.001, 0.02);
    struct attempt a = trial_attempt(&t, 4, 5, 1);
    double effort = 1e9;

    ck_assert(minimax_fit(&t, 1e-4, 1, &a, &effort));
    ck_assert_double_le(a.feet.worst, 1e-4);
    attempt_free(&a);
    target_free(&t);
    track_free(&track);
}
END_TEST

START_TEST(out_of_reach_and_out_of_time)
{
    struct track track = quartic();
    struct target t = target_new(&track, 200, 0.001, 0.02);
    struct attempt a = trial_attempt(&t, 3, 4, 1), b = trial_attempt(&t, 4, 5, 1);
    double effort = 1e9, none = 0;

    ck_assert(!minimax_fit(&t, 1e-7, 1, &a, &effort));
    ck_assert_double_gt(effort, 1e9 - 200 * 200.0); /* and soon */
    ck_assert(!minimax_fit(&t, 1e-4, 1, &b, &none));
    ck_assert_double_gt(none, -1000.0);
    attempt_free(&a);
    attempt_free(&b);
    target_free(&t);
    track_free(&track);
}
END_TEST

/* On other places of the same track the curve is the same, and the feet are near. */
START_TEST(onto_other_places)
{
    struct track track = quartic();
    struct target t = target_new(&track, 50, 0.001, 0.02);
    struct target fine = target_new(&track, 300, 0.001, 0.02);
    struct attempt a = trial_attempt(&t, 3, 6, 1);
    double effort = 1e9;

    minimax_fit(&t, 1e9, 1, &a, &effort);
    struct attempt b = attempt_onto(&a, &t, &fine);
    ck_assert_uint_eq(b.curve.poles, a.curve.poles);
    ck_assert_double_eq_tol(fine.at[b.feet.where], t.at[a.feet.where], 0.1);
    for (size_t k = 0; k < fine.n; k++)
        ck_assert_double_lt(
            vec_distance(bspline_at(&b.curve, b.curve.pole, b.feet.u[k]), fine.point[k]),
            a.feet.worst + 0.02);
    attempt_free(&a);
    attempt_free(&b);
    target_free(&t);
    target_free(&fine);
    track_free(&track);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("minimax");
    TCase *tests = tcase_create("minimax");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, the_largest_distances_are_alike);
    tcase_add_test(tests, what_can_be_exact_becomes_so);
    tcase_add_test(tests, out_of_reach_and_out_of_time);
    tcase_add_test(tests, onto_other_places);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
