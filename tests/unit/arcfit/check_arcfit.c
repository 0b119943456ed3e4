/* Tests of arcfit.h: chains of biarcs on curves whose fewest arcs are known. */
#include "arcfit/arcfit.h"

#include <check.h>
#include <stdlib.h>

static const struct arc_deviation WITHIN = {0.01, 0.01, 0.02};

static void add(struct run *run, double x, double y, double z)
{
    struct vec3 tip = vec(x, y, z), axis = vec(0, 0, 1);
    *array_push(run) = (struct run_point){
        .tip = tip, .ball = vec_along(tip, run->radius, axis), .axis = axis, .given = true};
}

/* One after the other, each on from where and in which direction the last one ended. */
static void assert_chain(const struct trace *t, const struct pieces *p)
{
    ck_assert_uint_gt(p->n, 0);
    ck_assert_double_eq(p->item[0].from, 0);
    ck_assert_double_eq(p->item[p->n - 1].to, (double)(t->n - 1));
    for (size_t i = 0; i < p->n; i++) {
        struct arc_deviation stray = arc_piece_deviation(t, &p->item[i], 4, NULL);
        ck_assert_double_le(stray.tracked, 1.01 * WITHIN.tracked);
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
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_eq(p.n, 1);
    ck_assert(arc_straight(&p.item[0].arc));
    array_free(&p);
    trace_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(a_circle_is_few_arcs)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 200; i++)
        add(&run, 20 * cos(i * 0.01), 20 * sin(i * 0.01), 1);
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_le(p.n, 2);
    ck_assert_double_lt(fabs(p.item[0].arc.radius - 20), 0.02);
    array_free(&p);
    trace_free(&t);
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
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    assert_chain(&t, &p);
    ck_assert_uint_lt(p.n, 40);
    array_free(&p);
    trace_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(a_biarc_for_each_interval)
{
    struct run run = {.radius = 4};
    for (int i = 0; i <= 10; i++)
        add(&run, 20 * cos(i * 0.1), 20 * sin(i * 0.1), 1);
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    ck_assert_uint_eq(arcfit_each(&t, &p), 0);
    ck_assert_uint_eq(p.n, 20);
    for (size_t i = 0; i < p.n; i++) {
        ck_assert_double_lt(fabs(p.item[i].arc.radius - 20), 1e-6);
        ck_assert(p.item[i].biarc == (i % 2 == 0));
    }
    array_free(&p);
    trace_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(what_nothing_fits_goes_from_point_to_point)
{
    unsigned seed = 9;
    struct run run = {.radius = 4};
    for (int i = 0; i < 60; i++) {
        seed = seed * 1664525u + 1013904223u;
        add(&run, i * 0.1, (seed >> 24) / 64.0, 0);
        if (i % 7 == 0)
            add(&run, i * 0.1, (seed >> 24) / 64.0, 0); /* the same point again */
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct pieces p = {0};
    arcfit_biarcs(&t, &WITHIN, &p);
    ck_assert_double_eq(p.item[p.n - 1].to, (double)(t.n - 1));
    for (size_t i = 0; i < p.n; i++) {
        struct arc_deviation stray = arc_piece_deviation(&t, &p.item[i], 4, NULL);
        ck_assert_double_le(stray.tracked, 1.01 * WITHIN.tracked);
    }
    array_free(&p);
    trace_free(&t);
    array_free(&run);
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
    Suite *s = suite_create("arcfit");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
