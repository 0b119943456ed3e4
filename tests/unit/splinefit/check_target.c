/*
 * target: places lie on the track's chords, in order and about equally far apart, whether the track
 * has many points or few.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "splinefit/target.h"
#include "trial.h"

START_TEST(on_the_chords_and_evenly)
{
    static const size_t points[] = {2, 5, 40, 3000};

    for (int i = 0; i < 4; i++) {
        struct run run = trial_motion(points[i], 8);
        struct track track = track_new(&run, i % 2 == 1);
        struct target t = target_new(&track, 100, 0.01, 0.02);
        double way = 0;

        for (size_t k = 0; k + 1 < track.n; k++)
            way += track.chord[k];
        ck_assert_uint_ge(t.n, 80);
        ck_assert_uint_le(t.n, 250);
        ck_assert(t.at[0] == 0);
        ck_assert_double_eq_tol(t.at[t.n - 1], way, 1e-9);
        ck_assert(vec_distance(t.point[0], track.point[0]) == 0);
        ck_assert(vec_distance(t.point[t.n - 1], track.point[track.n - 1]) == 0);
        for (size_t k = 0; k < t.n; k++) {
            ck_assert_double_lt(trial_off_chain(t.point[k], track.point, track.n), 1e-9);
            ck_assert_double_lt(trial_off_chain(t.other[k], track.other, track.n), 1e-9);
            ck_assert_double_eq_tol(vec_length(t.axis[k]), 1, 1e-12);
            ck_assert(k == 0 || t.at[k] > t.at[k - 1]);
            ck_assert(k == 0 || t.at[k] - t.at[k - 1] < 2 * way / 100);
        }
        target_free(&t);
        track_free(&track);
        array_free(&run);
    }
}
END_TEST

START_TEST(a_fixed_axis_has_no_other_end)
{
    struct run run = trial_motion(50, 8);

    for (size_t i = 0; i < run.n; i++)
        run.item[i].axis = vec(0, 0, 1);
    struct track track = track_new(&run, false);
    struct target t = target_new(&track, 20, 0.01, 0.02);
    ck_assert(t.other == NULL && t.axis == NULL && !t.other_leads);
    target_free(&t);
    track_free(&track);
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("target");
    TCase *tests = tcase_create("target");

    tcase_add_test(tests, on_the_chords_and_evenly);
    tcase_add_test(tests, a_fixed_axis_has_no_other_end);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
