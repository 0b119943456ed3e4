/* Tests of arcfit_reduce: fewer arcs, within the tolerance. */
#include "arcfit/arcfit.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

static const struct deviation WITHIN = {0.01, 0.01, 0.02};

static void assert_fewer(size_t n, double lean, size_t fewer)
{
    struct reference t = trial_wave(n, 0.25, lean, 0);
    struct pieces p = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &p);
    size_t before = p.n;
    arcfit_reduce(&t, &WITHIN, 6, HUGE_VAL, &p);
    trial_assert_chain(&t, &WITHIN, &p);
    ck_assert_uint_le(p.n + fewer, before);
    array_free(&p);
    reference_free(&t);
}

START_TEST(a_short_wave_saves_some)
{
    assert_fewer(301, 0, 1);
}
END_TEST

START_TEST(a_long_one_window_by_window)
{
    assert_fewer(1201, 0, 2);
}
END_TEST

START_TEST(with_the_axis_swinging)
{
    assert_fewer(601, 0.3, 5);
}
END_TEST

static size_t left_by(const struct reference *t, const struct pieces *before, double feet)
{
    struct pieces p = {0};
    for (size_t i = 0; i < before->n; i++)
        *array_push(&p) = before->item[i];
    arcfit_reduce(t, &WITHIN, 6, feet, &p);
    trial_assert_chain(t, &WITHIN, &p);
    size_t n = p.n;
    array_free(&p);
    return n;
}

/* With few feet looked for some are saved, with many more; and up to the end of the reference, not
 * only where the search begins. */
START_TEST(as_many_as_the_work_allows)
{
    struct reference t = trial_wave(1201, 0.25, 0.3, 0);
    struct pieces p = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_HURRIED, &p);
    size_t none = left_by(&t, &p, 1e-9), few = left_by(&t, &p, 60), all = left_by(&t, &p, HUGE_VAL);
    ck_assert_uint_ge(none + 1, p.n); /* the first is tried before it is known what it takes */
    ck_assert_uint_lt(few, none);
    ck_assert_uint_lt(all, few);
    array_free(&p);
    reference_free(&t);
}
END_TEST

/* As many pieces as are moved all together, some fewer and some more: none is lost. */
START_TEST(from_few_to_many)
{
    int windows = 0;
    for (size_t n = 121; n < 800; n += 120) {
        struct reference t = trial_wave(n, 0.25, 0, 0);
        struct pieces p = {0};
        arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &p);
        windows += p.n > 32;
        arcfit_reduce(&t, &WITHIN, 6, HUGE_VAL, &p);
        trial_assert_chain(&t, &WITHIN, &p);
        array_free(&p);
        reference_free(&t);
    }
    ck_assert_int_gt(windows, 0);
}
END_TEST

START_TEST(a_kink_stays)
{
    struct reference t = trial_wave(201, 0.25, 0, 0.5);
    struct pieces p = {0}, second = {0};
    struct reference half = t;
    half.n = 101;
    arcfit_beam(&half, &WITHIN, 6, ARCFIT_THOROUGH, &p);
    half = (struct reference){.n = 101,
                              .point = t.point + 100,
                              .other = t.other + 100,
                              .axis = t.axis + 100,
                              .tangent = t.tangent + 100,
                              .length = t.length + 100,
                              .offset = t.offset};
    arcfit_beam(&half, &WITHIN, 6, ARCFIT_THOROUGH, &second);
    for (size_t i = 0; i < second.n; i++) {
        struct arc_piece moved = second.item[i];
        moved.from += 100;
        moved.to += 100;
        *array_push(&p) = moved;
    }
    size_t before = p.n, kinks = 0;
    arcfit_reduce(&t, &WITHIN, 6, HUGE_VAL, &p);
    ck_assert_uint_lt(p.n, before);
    for (size_t i = 1; i < p.n; i++) {
        double kink = vec_angle(arc_tangent(&p.item[i - 1].arc, 1), p.item[i].arc.tangent);
        kinks += kink > 2 * ARCFIT_KINK;
        if (kink > 2 * ARCFIT_KINK)
            ck_assert_double_lt(vec_distance(p.item[i].arc.from, t.point[100]), 1e-12);
    }
    ck_assert_uint_eq(kinks, 1);
    array_free(&p);
    array_free(&second);
    reference_free(&t);
}
END_TEST

/* Fitted anew, pieces that keep the tolerance stay; where the reference has moved a little, there
 * are as many, and those outside stay. */
START_TEST(what_still_holds_stays)
{
    static const struct deviation less = {0.0095, 0.0095, 0.019};
    struct reference t = trial_wave(401, 0.25, 0.3, 0);
    struct pieces p = {0}, before = {0};
    arcfit_beam(&t, &less, 6, ARCFIT_QUICK, &p);
    ck_assert_uint_gt(p.n, 10);
    for (size_t i = 0; i < p.n; i++)
        *array_push(&before) = p.item[i];
    ck_assert(arcfit_refit(&t, &WITHIN, 6, 2, 9, ARCFIT_HURRIED, &p));
    ck_assert_uint_eq(p.n, before.n);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_lt(vec_distance(p.item[i].arc.to, before.item[i].arc.to), 2e-6);
    for (size_t i = (size_t)p.item[4].from; i <= (size_t)p.item[6].from; i++) {
        t.point[i].z += 0.005;
        t.other[i].z += 0.005;
    }
    ck_assert(arcfit_refit(&t, &WITHIN, 6, 2, 9, ARCFIT_HURRIED, &p));
    ck_assert_uint_eq(p.n, before.n);
    trial_assert_chain(&t, &WITHIN, &p);
    array_free(&p);
    array_free(&before);
    reference_free(&t);
}
END_TEST

/* Where it has moved so much that as many do not do, some more are looked for, but in a hurry. */
START_TEST(more_are_looked_for_without_hurry)
{
    struct reference t = trial_wave(401, 0.25, 0.3, 0);
    struct pieces p = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_QUICK, &p);
    for (size_t i = (size_t)p.item[4].from; i <= (size_t)p.item[6].from; i++) {
        t.point[i].z += 0.018;
        t.other[i].z += 0.018;
    }
    size_t n = p.n;
    ck_assert(!arcfit_refit(&t, &WITHIN, 6, 2, 9, ARCFIT_HURRIED, &p));
    ck_assert_uint_eq(p.n, n);
    ck_assert(arcfit_refit(&t, &WITHIN, 6, 2, 9, ARCFIT_QUICK, &p));
    ck_assert_uint_gt(p.n, n);
    trial_assert_chain(&t, &WITHIN, &p);
    array_free(&p);
    reference_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcspline_reduce");
    tcase_set_timeout(t, 20);
    tcase_add_test(t, a_short_wave_saves_some);
    tcase_add_test(t, a_long_one_window_by_window);
    tcase_add_test(t, with_the_axis_swinging);
    tcase_add_test(t, as_many_as_the_work_allows);
    tcase_add_test(t, from_few_to_many);
    tcase_add_test(t, a_kink_stays);
    tcase_add_test(t, what_still_holds_stays);
    tcase_add_test(t, more_are_looked_for_without_hurry);
    Suite *s = suite_create("arcspline_reduce");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
