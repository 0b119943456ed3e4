/* Tests of arcrun.h: what is written is what was proven. */
#include "stage/arcrun.h"

#include <check.h>
#include <stdlib.h>

#include "base/num.h"

/* Sparse points, 3 mm apart, of a ball going round in a cylinder of radius 30 along its axis a
 * little, the tool leaning. */
static struct run coil(void)
{
    struct run run = {.radius = 5};
    for (int i = 0; i < 12; i++) {
        double u = 0.1 * i;
        struct vec3 n = vec(-cos(u), -sin(u), 0);
        struct run_point p = {.normal = n, .given = true};
        p.contact = vec(30 * cos(u), 30 * sin(u), 4 * u);
        p.ball = vec_along(p.contact, 5, n);
        p.axis = vec_unit(vec_add(n, vec(0, 0, 0.4)));
        p.tip = vec_along(p.ball, -5, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

static double off_digits(struct vec3 v, int digits)
{
    return fmax(fabs(v.x - num_round(v.x, digits)),
                fmax(fabs(v.y - num_round(v.y, digits)), fabs(v.z - num_round(v.z, digits))));
}

START_TEST(sparse_points_are_fitted_as_the_smooth_path_they_mean)
{
    struct run run = coil();
    struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02};
    struct arcrun_report report = {0};
    struct path out = {0};
    arcrun_fit(&run, &options, NULL, &out, &report);
    ck_assert_uint_eq(report.points, 12);
    ck_assert_uint_eq(report.arcs, out.arc.n);
    ck_assert_uint_lt(report.arcs + report.lines, 12);
    ck_assert_double_le(report.spent, 0.01);
    struct vec3 at = run.item[0].tip;
    for (size_t i = 0; i < out.item.n; i++) {
        const struct path_item *item = &out.item.item[i];
        ck_assert(item->touches);
        struct vec3 contact = out.contact.item[item->contact].p;
        ck_assert_double_lt(fabs(hypot(contact.x, contact.y) - 30), 0.01);
        struct vec3 ball = vec_along(item->to.p, 5, item->to.a);
        ck_assert_double_lt(fabs(hypot(ball.x, ball.y) - 25), 0.012);
        if (item->kind == PATH_ARC) {
            const struct path_arc *arc = &out.arc.item[item->index];
            ck_assert_double_eq(off_digits(arc->centre, 6), 0);
            ck_assert_double_lt(off_digits(arc->axis, 9), 1e-9);
            double r0 = vec_distance(at, arc->centre), r1 = vec_distance(item->to.p, arc->centre);
            ck_assert_double_lt(fabs(r0 - arc->radius), 2e-6);
            ck_assert_double_lt(fabs(r1 - arc->radius), 2e-6);
        }
        at = item->to.p;
    }
    ck_assert_double_lt(vec_distance(at, run.item[11].tip), 1e-6);
    path_free(&out);
    array_free(&run);
}
END_TEST

START_TEST(paper_makes_two_arcs_an_interval)
{
    struct run run = coil();
    struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02, .paper = true};
    struct arcrun_report report = {0};
    struct path out = {0};
    arcrun_fit(&run, &options, NULL, &out, &report);
    ck_assert_uint_eq(report.arcs, 22);
    ck_assert_uint_eq(report.c + report.s, 11);
    path_free(&out);
    array_free(&run);
}
END_TEST

START_TEST(a_corner_is_kept)
{
    struct run run = {.radius = 0};
    for (int i = 0; i <= 8; i++) {
        struct vec3 p = i < 4 ? vec(i, 0, 0) : vec(4, i - 4, 0);
        *array_push(&run) =
            (struct run_point){.tip = p, .ball = p, .axis = vec(0, 0, 1), .given = true};
    }
    struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02};
    struct arcrun_report report = {0};
    struct path out = {0};
    arcrun_fit(&run, &options, NULL, &out, &report);
    ck_assert_uint_eq(report.corners, 1);
    ck_assert_uint_eq(report.lines, 2);
    ck_assert_uint_eq(report.arcs, 0);
    ck_assert_double_lt(vec_distance(out.item.item[0].to.p, vec(4, 0, 0)), 1e-12);
    path_free(&out);
    array_free(&run);
}
END_TEST

START_TEST(chords_keep_the_tolerance)
{
    struct run run = coil();
    struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02, .chords = true};
    struct arcrun_report report = {0};
    struct path out = {0};
    arcrun_fit(&run, &options, NULL, &out, &report);
    ck_assert_double_le(report.spent, 0.01);
    ck_assert_uint_eq(out.arc.n, 0);
    ck_assert_uint_eq(out.text.n, report.arcs);
    struct vec3 before = run.item[0].ball;
    for (size_t i = 0; i < out.item.n; i++) {
        const struct path_item *item = &out.item.item[i];
        if (item->kind != PATH_POINT)
            continue;
        struct vec3 ball = vec_along(item->to.p, 5, item->to.a), mid = vec_mix(before, ball, 0.5);
        ck_assert_double_lt(fabs(hypot(mid.x, mid.y) - 25), 0.012);
        before = ball;
    }
    path_free(&out);
    array_free(&run);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcrun");
    tcase_add_test(t, sparse_points_are_fitted_as_the_smooth_path_they_mean);
    tcase_add_test(t, paper_makes_two_arcs_an_interval);
    tcase_add_test(t, a_corner_is_kept);
    tcase_add_test(t, chords_keep_the_tolerance);
    Suite *s = suite_create("arcrun");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
