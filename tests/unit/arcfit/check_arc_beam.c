/* Tests of arc_beam.h: G1 chains within the tolerance, fewer than biarcs make. */
#include "arcfit/arc_beam.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

static const struct arc_deviation WITHIN = {0.01, 0.01, 0.02};

START_TEST(a_wave_takes_a_third_less_than_biarcs)
{
    struct trace t = trial_wave(401, 0.25, 0, 0);
    struct pieces arcs = {0}, biarcs = {0};
    arc_beam_fit(&t, &WITHIN, 6, &arcs);
    arcfit_biarcs(&t, &WITHIN, &biarcs);
    trial_assert_chain(&t, &WITHIN, &arcs);
    ck_assert_uint_lt(4 * arcs.n, 3 * biarcs.n);
    array_free(&arcs);
    array_free(&biarcs);
    trace_free(&t);
}
END_TEST

START_TEST(the_far_end_of_the_lever_is_kept_too)
{
    struct trace t = trial_wave(401, 0.25, 0.3, 0);
    struct pieces arcs = {0};
    arc_beam_fit(&t, &WITHIN, 6, &arcs);
    trial_assert_chain(&t, &WITHIN, &arcs);
    array_free(&arcs);
    trace_free(&t);
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
        struct trace t = trace_of(&run, 0, run.n, false, false);
        struct pieces arcs = {0};
        arc_beam_fit(&t, &WITHIN, 6, &arcs);
        ck_assert_uint_eq(arcs.n, 1);
        ck_assert(arc_straight(&arcs.item[0].arc));
        array_free(&arcs);
        trace_free(&t);
        array_free(&run);
    }
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcbeam");
    tcase_add_test(t, a_wave_takes_a_third_less_than_biarcs);
    tcase_add_test(t, the_far_end_of_the_lever_is_kept_too);
    tcase_add_test(t, lines_and_single_intervals);
    Suite *s = suite_create("arcbeam");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
