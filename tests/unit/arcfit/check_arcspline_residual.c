/* Tests of arcspline_residual.h: distances from known circles, slopes against differences of the
 * distances. */
#include "arcfit/arcspline_residual.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

/* n arcs near the trace. */
static struct arcspline chain_on(const struct trace *t, size_t n)
{
    struct arcspline c = arcspline_new(n);
    for (size_t i = 0; i <= n; i++) {
        double place = (double)(i * (t->n - 1)) / (double)n;
        c.joint[i] = (struct joint){.p = trace_point(t, place), .place = place, .side = 0.003};
        c.joint[i].p.y += i % 2 ? 0.004 : 0;
        arcspline_lean(&c, t, i);
    }
    c.joint[0].tangent = t->tangent[0];
    arcspline_turn(&c, 0);
    return c;
}

START_TEST(points_about_a_circle_are_off_by_their_radius)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 60; i++) {
        double u = RADIANS(i), r = 40 + 0.01 * sin(7 * u);
        struct vec3 tip = vec(r * cos(u), r * sin(u), 0.02 * cos(5 * u));
        *array_push(&run) = (struct run_point){
            .tip = tip, .ball = vec_add(tip, vec(0, 0, 5)), .axis = vec(0, 0, 1), .given = true};
    }
    struct trace t = trace_of(&run, 0, run.n, false, false);
    struct arcspline c = arcspline_new(2);
    for (size_t i = 0; i <= 2; i++) {
        double u = RADIANS(30.0 * (double)i);
        c.joint[i] = (struct joint){.p = vec(40 * cos(u), 40 * sin(u), 0), .axis = vec(0, 0, 1)};
    }
    c.joint[0].tangent = vec(0, 1, 0);
    arcspline_turn(&c, 0);
    struct passing passing = passing_of(&t, 0, 60, 30);
    ck_assert_uint_eq(passing.n, 30);
    double *off = mem_alloc(4 * passing.n, sizeof *off);
    arcspline_residual(&c, 0, &passing, off);
    for (size_t i = 0; i < passing.n; i++) {
        struct vec3 p = passing.item[i].p;
        double truth = hypot(hypot(p.x, p.y) - 40, p.z);
        ck_assert_double_eq_tol(hypot(off[2 * i], off[2 * i + 1]), truth, 2e-6);
        ck_assert_uint_eq(passing.item[i].arc, atan2(p.y, p.x) > RADIANS(30));
        struct vec3 at = passing.item[i].at;
        ck_assert_double_eq_tol(hypot(at.x, at.y), 40, 1e-9); /* the conic is the circle */
    }
    free(off);
    passing_free(&passing);
    arcspline_free(&c);
    trace_free(&t);
    array_free(&run);
}
END_TEST

START_TEST(slopes_are_what_the_distances_do)
{
    struct trace t = trial_wave(161, 0.25, 0.2, 0);
    struct arcspline c = chain_on(&t, 9), moved = arcspline_new(9);
    struct passing passing = passing_of(&t, 0, t.n - 1, 100);
    size_t all = 4 * passing.n;
    double *off = mem_alloc(3 * all, sizeof *off), *then = off + all, *slope = then + all;
    for (int k = 0; k < 4; k++) {
        double by = 1e-6;
        arcspline_copy(&moved, &c);
        struct joint *j = &moved.joint[4];
        *(k == 0 ? &j->p.x : k == 1 ? &j->p.y : k == 2 ? &j->p.z : &j->side) += by;
        arcspline_lean(&moved, &t, 4);
        arcspline_turn(&moved, 3);
        arcspline_residual(&moved, t.lever, &passing, then);
        arcspline_residual(&c, t.lever, &passing, off);
        size_t from = passing_first(&passing, 3);
        ck_assert_uint_eq(passing.item[from].arc, 3);
        ck_assert_uint_eq(passing.item[from - 1].arc, 2);
        arcspline_residual_slope(&moved, t.lever, &passing, from, passing.n, by, slope);
        for (size_t i = 2 * from; i < 2 * passing.n; i++) {
            ck_assert_double_eq_tol(slope[i], (then[i] - off[i]) / by, 0.05);
            size_t o = i + 2 * passing.n;
            ck_assert_double_eq_tol(slope[o], (then[o] - off[o]) / by, 0.1);
        }
    }
    free(off);
    passing_free(&passing);
    arcspline_free(&c);
    arcspline_free(&moved);
    trace_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcmiss");
    tcase_add_test(t, points_about_a_circle_are_off_by_their_radius);
    tcase_add_test(t, slopes_are_what_the_distances_do);
    Suite *s = suite_create("arcmiss");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
