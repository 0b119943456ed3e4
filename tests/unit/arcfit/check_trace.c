/* Tests of trace.h: places on a screw line, and the points they are. */
#include "arcfit/trace.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

START_TEST(places)
{
    struct run run = trial_screw(20, 0.1);
    struct trace t = trace_of(&run, 0, run.n, false, false);
    ck_assert_double_lt(vec_distance(trace_point(&t, 3.25), vec_mix(t.p[3], t.p[4], 0.25)), 1e-15);
    ck_assert_double_lt(vec_distance(trace_point(&t, 19), t.p[19]), 1e-15);
    ck_assert_double_lt(fabs(trace_place(&t, trace_point(&t, 7.5), 2) - 7.5), 1e-9);
    ck_assert_double_lt(fabs(trace_place(&t, trace_point(&t, 7.5), 15.3) - 7.5), 1e-9);
    ck_assert_double_eq(trace_place(&t, vec(10, -3, 0), 1), 0);
    ck_assert_double_lt(fabs(vec_length(trace_axis(&t, 4.4)) - 1), 1e-12);
    trace_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(distances_go_downhill)
{
    struct run run = trial_screw(40, 0.1);
    struct trace t = trace_of(&run, 0, run.n, false, false);
    size_t k = 0;
    struct vec3 beside = vec_add(trace_point(&t, 30.5), vec(0, 0, 0.01));
    ck_assert_double_lt(trace_distance(t.p, t.n, beside, &k), 0.01);
    ck_assert_uint_eq(k, 30);
    double part;
    ck_assert_uint_eq(trace_interval(&t, 30.5, &part), 30);
    ck_assert_double_eq(part, 0.5);
    ck_assert_uint_eq(trace_interval(&t, 39, &part), 38);
    ck_assert_double_eq(part, 1);
    ck_assert(trace_axis_still(&t, 7, 7));
    ck_assert(!trace_axis_still(&t, 7, 8));
    trace_free(&t);
    array_free(&run);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("trace");
    tcase_add_test(t, places);
    tcase_add_test(t, distances_go_downhill);
    Suite *s = suite_create("trace");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
