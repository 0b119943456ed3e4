/* Tests of arc_update.h: arcs beside what has changed stay, the chain holds. */
#include "arcfit/arc_update.h"

#include <check.h>
#include <stdlib.h>

#include "arcfit/arc_beam.h"
#include "trial.h"

static const struct arc_deviation WITHIN = {0.01, 0.01, 0.02};

/* Lifts the points around k, most in the middle, by `height` mm. */
static void lift(struct trace *t, size_t k, double height)
{
    for (size_t i = k - 30; i <= k + 30; i++) {
        double share = (1 + cos(((double)i - (double)k) / 30 * PI)) / 2;
        t->p[i].z += share * height;
        t->other[i].z += share * height;
    }
}

/* Lifted at these points, so high; returns how many pieces are no longer there. */
static size_t changed_by(double lean, const size_t *at, size_t n, double height)
{
    struct trace old = trial_wave(601, 0.25, lean, 0), now = trial_wave(601, 0.25, lean, 0);
    struct pieces before = {0}, after = {0};
    size_t same = 0;

    arc_beam_fit(&old, &WITHIN, 6, &before);
    for (size_t i = 0; i < n; i++)
        lift(&now, at[i], height);
    ck_assert(arc_update(&old, &now, &WITHIN, 6, &before, &after));
    trial_assert_chain(&now, &WITHIN, &after);
    for (size_t i = 0; i < before.n; i++) {
        for (size_t k = 0; k < after.n; k++)
            same += vec_distance(before.item[i].arc.from, after.item[k].arc.from) <= 0 &&
                    vec_distance(before.item[i].arc.to, after.item[k].arc.to) <= 0;
    }
    size_t gone = before.n - same;
    array_free(&before);
    array_free(&after);
    trace_free(&old);
    trace_free(&now);
    return gone;
}

START_TEST(arcs_beside_stay)
{
    const size_t at[] = {150, 450};

    for (int leaning = 0; leaning < 2; leaning++) {
        size_t one = changed_by(0.3 * leaning, at, 1, 0.02);
        size_t two = changed_by(0.3 * leaning, at, 2, 0.02);
        ck_assert_uint_ge(one, 1);
        ck_assert_uint_le(one, 12);
        ck_assert_uint_gt(two, one);
        ck_assert_uint_le(two, 24);
        ck_assert_uint_eq(changed_by(0.3 * leaning, at, 0, 0), 0);
    }
}
END_TEST

START_TEST(a_point_more_moves_the_places)
{
    struct trace now = trial_wave(601, 0.25, 0, 0), old = trial_wave(601, 0.25, 0, 0);
    struct pieces before = {0}, after = {0};

    for (size_t i = 301; i < 601; i++) { /* the old one without point 300 */
        old.p[i - 1] = now.p[i];
        old.other[i - 1] = now.other[i];
        old.tangent[i - 1] = now.tangent[i];
        old.length[i - 1] = now.length[i];
    }
    old.n = 600;
    arc_beam_fit(&old, &WITHIN, 6, &before);
    ck_assert(arc_update(&old, &now, &WITHIN, 6, &before, &after));
    trial_assert_chain(&now, &WITHIN, &after);
    ck_assert_double_eq(before.item[before.n - 1].to, 599);
    ck_assert_double_eq(after.item[after.n - 1].to, 600);
    array_free(&before);
    array_free(&after);
    trace_free(&old);
    trace_free(&now);
}
END_TEST

START_TEST(another_end_is_no_change_but_a_new_trace)
{
    struct trace now = trial_wave(201, 0.25, 0, 0), old = trial_wave(201, 0.25, 0, 0);
    struct pieces before = {0}, after = {0};

    arc_beam_fit(&old, &WITHIN, 6, &before);
    now.p[200].z += 1e-6;
    ck_assert(!arc_update(&old, &now, &WITHIN, 6, &before, &after));
    now.p[200] = old.p[200];
    lift(&now, 100, 5); /* nothing goes there and back in so few arcs */
    ck_assert(!arc_update(&old, &now, &WITHIN, 6, &before, &after));
    array_free(&before);
    array_free(&after);
    trace_free(&old);
    trace_free(&now);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcmend");
    tcase_set_timeout(t, 20);
    tcase_add_test(t, arcs_beside_stay);
    tcase_add_test(t, a_point_more_moves_the_places);
    tcase_add_test(t, another_end_is_no_change_but_a_new_trace);
    Suite *s = suite_create("arcmend");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_ENV);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
