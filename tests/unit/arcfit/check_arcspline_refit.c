/* Tests of arcspline_refit.h: as many arcs as are asked for in the place of a part, or none. */
#include "arcfit/arcspline_refit.h"

#include <check.h>
#include <stdlib.h>

#include "arcfit/arc_beam.h"
#include "trial.h"

static const struct arc_deviation WITHIN = {0.01, 0.01, 0.02};

/* Pieces [from, to) of a chain put anew with so many more; the whole chain with them, or none. */
static void put_anew(double lean, size_t from, size_t to, int more, bool expected)
{
    struct trace t = trial_wave(401, 0.25, lean, 0);
    struct pieces old = {0}, some = {0}, all = {0};

    arc_beam_fit(&t, &WITHIN, 6, &old);
    struct arcspline_refit part = {.trace = &t,
                                   .within = &WITHIN,
                                   .digits = 6,
                                   .old = old.item + from,
                                   .n = to - from,
                                   .start_held = from > 0,
                                   .end_held = true};
    ck_assert_uint_lt(to, old.n);
    ck_assert(arcspline_refit_fit(&part, (size_t)((int)part.n + more), &some) == expected);
    if (expected) {
        ck_assert_uint_eq(some.n, (size_t)((int)part.n + more));
        for (size_t i = 0; i < from; i++)
            *array_push(&all) = old.item[i];
        for (size_t i = 0; i < some.n; i++)
            *array_push(&all) = some.item[i];
        for (size_t i = to; i < old.n; i++)
            *array_push(&all) = old.item[i];
        trial_assert_chain(&t, &WITHIN, &all);
        for (size_t i = 1; i < some.n; i++) {
            struct vec3 joint = some.item[i].arc.from;
            ck_assert_double_lt(vec_distance(joint, vec_round(joint, 6)), 1e-12);
        }
    }
    array_free(&old);
    array_free(&some);
    array_free(&all);
    trace_free(&t);
}

START_TEST(as_many_or_more)
{
    put_anew(0, 4, 14, 0, true);
    put_anew(0, 4, 14, 1, true);
    put_anew(0, 0, 10, 1, true);
    put_anew(0.3, 10, 18, 0, true);
    put_anew(0.3, 10, 18, 1, true);
}
END_TEST

START_TEST(half_as_many_are_none)
{
    put_anew(0, 4, 14, -5, false);
    put_anew(0.3, 10, 18, -5, false);
    put_anew(0, 4, 14, -10, false);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcpart");
    tcase_set_timeout(t, 20);
    tcase_add_test(t, as_many_or_more);
    tcase_add_test(t, half_as_many_are_none);
    Suite *s = suite_create("arcpart");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_ENV);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
