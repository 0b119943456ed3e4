/* Tests of arcfit.h: greedy biarcs, a biarc each, a reference followed from its end. */
#include "arcfit/arcfit.h"

#include <check.h>
#include <stdlib.h>
#include "seed.h"

static const struct deviation WITHIN = {0.01, 0.01, 0.02};

static void add(struct run *run, double x, double y, double z)
{
    struct vec3 tip = vec(x, y, z), axis = vec(0, 0, 1);
    *array_push(run) = (struct run_point){
        .tip = tip, .ball = vec_along(tip, run->radius, axis), .axis = axis, .given = true};
}

/* One after the other, each on from where and in which direction the last one ended. */
static void assert_chain(const struct reference *t, const struct pieces *p)
{
    ck_assert_uint_gt(p->n, 0);
    ck_assert_double_eq(p->item[0].from, 0);
    ck_assert_double_eq(p->item[p->n - 1].to, (double)(t->n - 1));
    for (size_t i = 0; i < p->n; i++) {
        struct deviation off = arc_piece_deviation(t, &p->item[i], 4, NULL);
        ck_assert_double_le(off.point, 1.01 * WITHIN.point);
        if (i == 0)
            continue;
        const struct arc *before = &p->item[i - 1].arc, *here = &p->item[i].arc;
        ck_assert_double_eq(p->item[i - 1].to, p->item[i].from);
        ck_assert_double_lt(vec_distance(before->to, here->from), 1e-12);
        ck_assert_double_le(vec_angle(arc_tangent(before, 1), here->tangent), 1.01 * ARCFIT_KINK);
    }
}

START_TEST(a_line_is_one_line)
{
    struct run run = {.radius = 4};
    for (int i = 0; i < 50; i++)
        add(&run, i * 0.7, i * 0.2, 5);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_eq(p.n, 1);
    ck_assert(arc_straight(&p.item[0].arc));
    array_free(&p);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(a_circle_is_few_arcs)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 200; i++)
        add(&run, 20 * cos(i * 0.01), 20 * sin(i * 0.01), 1);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_le(p.n, 2);
    ck_assert_double_lt(fabs(p.item[0].arc.radius - 20), 0.02);
    array_free(&p);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(a_wave_in_space_is_followed)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 2000; i++) {
        double x = i * 0.05;
        add(&run, x, 3 * sin(x / 9), 2 * cos(x / 5));
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_lt(p.n, 40);
    array_free(&p);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(a_biarc_for_each_interval)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 10; i++)
        add(&run, 20 * cos(i * 0.1), 20 * sin(i * 0.1), 1);
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    ck_assert_uint_eq(arcfit_each(&t, &p), 0);
    ck_assert_uint_eq(p.n, 20);
    for (size_t i = 0; i < p.n; i++) {
        ck_assert_double_lt(fabs(p.item[i].arc.radius - 20), 1e-6);
        ck_assert(p.item[i].biarc == (i % 2 == 0));
    }
    array_free(&p);
    reference_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(what_nothing_fits_goes_from_point_to_point)
{
    unsigned seed = 9;
    struct run run = {.radius = 4};
    for (int i = 0; i < 60; i++) {
        seed = seed * 1664525u + seed_step_32();
        add(&run, i * 0.1, (seed >> 24) / 64.0, 0);
        if (i % 7 == 0)
            add(&run, i * 0.1, (seed >> 24) / 64.0, 0); /* the same point again */
    }
    struct reference t = reference_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    ck_assert_double_eq(p.item[p.n - 1].to, (double)(t.n - 1));
    for (size_t i = 0; i < p.n; i++) {
        struct deviation off = arc_piece_deviation(&t, &p.item[i], 4, NULL);
        ck_assert_double_le(off.point, 1.01 * WITHIN.point);
    }
    array_free(&p);
    reference_free(&t);
    array_free(&run);
}
END_TEST

static struct reference wave(void)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 200; i++) {
        double s = 0.2 * i;
        struct run_point p = {.axis = vec_unit(vec(0.1 * sin(s / 9), 0.2, 1))};
        p.tip = vec(s, 2 * sin(s / 5), 0.5 * cos(s / 4));
        p.ball = vec_along(p.tip, 4, p.axis);
        *array_push(&run) = p;
    }
    struct reference reference = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return reference;
}

START_TEST(a_trace_turned_round_twice_is_itself)
{
    struct reference t = wave(), back = arcfit_reverse_reference(&t),
                     again = arcfit_reverse_reference(&back);
    ck_assert_uint_eq(back.n, t.n);
    for (size_t i = 0; i < t.n; i++) {
        ck_assert_double_eq(vec_distance(again.point[i], t.point[i]), 0);
        ck_assert_double_eq(vec_distance(again.other[i], t.other[i]), 0);
        ck_assert_double_eq(vec_distance(again.axis[i], t.axis[i]), 0);
        ck_assert_double_eq(vec_distance(again.tangent[i], t.tangent[i]), 0);
        ck_assert_double_eq_tol(again.length[i], t.length[i], 1e-9);
        ck_assert_double_eq_tol(back.length[i], vec_distance(back.point[i], back.point[0]), 4);
    }
    ck_assert_double_eq(vec_distance(back.point[0], t.point[t.n - 1]), 0);
    reference_free(&t);
    reference_free(&back);
    reference_free(&again);
}
END_TEST

START_TEST(pieces_from_the_end_follow_the_trace)
{
    struct reference t = wave(), back = arcfit_reverse_reference(&t);
    struct deviation within = {0.01, 0.01, 0.02};
    struct pieces pieces = {0};
    arcfit_beam(&back, &within, 6, ARCFIT_THOROUGH, &pieces);
    ck_assert_uint_gt(pieces.n, 3);
    arcfit_reverse_pieces(&pieces, t.n);
    ck_assert_double_eq(pieces.item[0].from, 0);
    ck_assert_double_eq(pieces.item[pieces.n - 1].to, (double)(t.n - 1));
    for (size_t i = 0; i < pieces.n; i++) {
        struct deviation off = arc_piece_deviation(&t, &pieces.item[i], 8, NULL);
        ck_assert(off.point < 0.010001 && off.other < 0.010001 && off.axis < 0.020001);
        if (i == 0)
            continue;
        const struct arc_piece *a = &pieces.item[i - 1], *b = &pieces.item[i];
        ck_assert_double_eq(a->to, b->from);
        ck_assert_double_eq(vec_distance(a->arc.to, b->arc.from), 0);
        ck_assert_double_eq(vec_distance(a->axis_to, b->axis), 0);
        ck_assert_double_lt(vec_angle(arc_tangent(&a->arc, 1), b->arc.tangent), 2 * ARCFIT_KINK);
    }
    array_free(&pieces);
    reference_free(&t);
    reference_free(&back);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcfit");
    tcase_add_test(t, a_line_is_one_line);
    tcase_add_test(t, a_circle_is_few_arcs);
    tcase_add_test(t, a_wave_in_space_is_followed);
    tcase_add_test(t, a_biarc_for_each_interval);
    tcase_add_test(t, what_nothing_fits_goes_from_point_to_point);
    tcase_add_test(t, a_trace_turned_round_twice_is_itself);
    tcase_add_test(t, pieces_from_the_end_follow_the_trace);
    Suite *s = suite_create("arcfit");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
