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

/* At the second point, and at the last but one. */
START_TEST(a_corner_beside_an_end_is_kept)
{
    struct run run = {.radius = 0};
    size_t corner = _i == 0 ? 1 : 4;
    for (size_t i = 0; i <= 5; i++) {
        double x = i < corner ? (double)i - (double)corner : 0;
        struct vec3 p = vec(2 * x, i > corner ? 2 * (double)(i - corner) : 0, 0);
        *array_push(&run) =
            (struct run_point){.tip = p, .ball = p, .axis = vec(0, 0, 1), .given = true};
    }
    struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02};
    struct arcrun_report report = {0};
    struct path out = {0};
    arcrun_fit(&run, &options, NULL, &out, &report);
    ck_assert_uint_eq(report.lines, 2);
    ck_assert_uint_eq(report.arcs, 0);
    ck_assert_double_lt(vec_length(out.item.item[0].to.p), 1e-12);
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

/* A long row of dense points with hills, 0.5 mm apart, the tool upright or swinging. */
static struct run hills(double lean)
{
    struct run run = {.radius = 5};
    for (int i = 0; i <= 400; i++) {
        double x = 0.5 * i;
        struct run_point p = {.given = true, .axis = vec_unit(vec(0, lean * sin(x / 30), 1))};
        p.ball = vec(x, 0.3 * sin(x / 17), 3 * sin(x / 9) + cos(x / 4));
        p.tip = vec_along(p.ball, -5, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

static void lift_at(struct run *run, size_t at, double by)
{
    for (size_t i = at - 3; i <= at + 3; i++) {
        struct run_point *p = &run->item[i];
        p->ball = vec_along(p->ball, by, p->axis);
        p->tip = vec_along(p->tip, by, p->axis);
    }
}

/* So many items at the end, or at the beginning, are the same. */
static size_t alike(const struct path *a, const struct path *b, bool from_end)
{
    size_t n = 0, most = a->item.n < b->item.n ? a->item.n : b->item.n;
    while (n < most) {
        const struct path_item *p = &a->item.item[from_end ? a->item.n - 1 - n : n],
                               *q = &b->item.item[from_end ? b->item.n - 1 - n : n];
        if (p->kind != q->kind || vec_distance(p->to.p, q->to.p) > 0 ||
            vec_distance(p->to.a, q->to.a) > 0)
            break;
        n++;
    }
    return n;
}

/* Of all pieces of a row only those at the two places that were lifted are others, and what is off
 * is still known. */
START_TEST(a_lift_refits_what_it_moved)
{
    for (int swinging = 0; swinging < 2; swinging++) {
        struct run run = hills(swinging ? 0.3 : 0);
        struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02, .guarded = true};
        struct arcrun_report before = {0}, after = {0};
        struct arcrun_memo memo = {0};
        struct path first = {0}, second = {0};
        arcrun_fit(&run, &options, &memo, &first, &before);
        lift_at(&run, 180, 0.004);
        lift_at(&run, 220, 0.006);
        arcrun_fit(&run, &options, &memo, &second, &after);
        size_t same = alike(&first, &second, false) + alike(&first, &second, true);
        ck_assert_uint_gt(first.item.n, 30);
        ck_assert_uint_gt(same, first.item.n * 2 / 3);
        ck_assert_uint_lt(same, first.item.n); /* it has moved */
        ck_assert_uint_le(second.item.n, first.item.n + 4);
        ck_assert_double_le(after.spent, 0.01);
        ck_assert_double_gt(after.spent, 0.001);
        arcrun_memo_free(&memo);
        path_free(&first);
        path_free(&second);
        array_free(&run);
    }
}
END_TEST

/* Over a flat part: a ball that leads from one cut to the next, `high` above it in the middle. */
static struct run over_flat(double high)
{
    struct run run = {.radius = 2};
    for (int i = 0; i <= 24; i++) {
        double s = i / 24.0, up = high * (1 - pow(2 * s - 1, 8));
        struct run_point p = {.given = true, .axis = vec(0, 0, 1)};
        p.ball = vec(8 * s, 0, 2 + up);
        p.tip = vec_along(p.ball, -2, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

/* What is so near to the part amid a link that it takes off more than may be left is a cut, and no
 * link; what touches it only beside its ends is one. */
START_TEST(a_link_that_cuts_is_none)
{
    const double high[] = {0, 0.02, 0.1, 1}, left = 0.03;
    struct vec3s points = {0};
    for (int i = -40; i <= 120; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.1 * i, 0.1 * k, 0);
    struct gouge_check *guard = gouge_new(points, 1);
    const struct gouge_refit_options gouge = {.guard = guard, .radius = 2, .tolerance = 0.01};
    const struct arcrun_options options = {.tolerance = 0.01, .axis = 0.02, .guarded = true};
    const struct arcrun_link link = {.left = left, .gouge = &gouge};

    for (size_t k = 0; k < sizeof high / sizeof *high; k++) {
        struct run run = over_flat(high[k]);
        struct arcrun_report report = {0};
        struct path out = {0};
        bool fitted = arcrun_fit_link(&run, &link, &options, &out, &report);
        ck_assert_msg(fitted == (high[k] > left), "%g mm over the part", high[k]);
        ck_assert_uint_eq(out.item.n > 0, fitted);
        ck_assert_uint_lt(out.item.n, run.n);
        path_free(&out);
        array_free(&run);
    }
    gouge_free(guard);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcrun");
    tcase_add_test(t, sparse_points_are_fitted_as_the_smooth_path_they_mean);
    tcase_add_test(t, paper_makes_two_arcs_an_interval);
    tcase_add_test(t, a_corner_is_kept);
    tcase_add_loop_test(t, a_corner_beside_an_end_is_kept, 0, 2);
    tcase_add_test(t, chords_keep_the_tolerance);
    tcase_add_test(t, a_lift_refits_what_it_moved);
    tcase_add_test(t, a_link_that_cuts_is_none);
    Suite *s = suite_create("arcrun");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
