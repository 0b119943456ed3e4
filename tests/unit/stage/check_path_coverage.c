/* path_coverage: rows over a floor leave what geometry says; rest passes cut it; what no ball
 * reaches is told apart, and how much may be left decides the exit status. */
#include "stage/path_coverage.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "said.h"
#include "shapes.h"
#include "stage/path_options.h"
#include "toolpath/scallop.h"

static const double R = 4;

static struct mesh mesh;
static struct vec3s scan;
static struct gouge_check *guard;
static struct path path;
static struct toolpath t;

static struct vec3 floor_point(double x, double y, struct vec3 *normal)
{
    *normal = vec(0, 0, 1);
    return vec(x, y, 0);
}

/* A floor over 20 x 20, points 0.25 apart; with `slot` two walls 3 mm apart stand on it, 6 high,
 * so that no ball of 4 comes to what is between them. */
static void make(bool slot)
{
    for (int i = -40; i <= 40; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&scan) = vec(0.25 * i, 0.25 * k, 0);
    for (int k = -40; slot && k <= 40; k++)
        for (int h = 1; h <= 24; h++) {
            *array_push(&scan) = vec(-1.5, 0.25 * k, 0.25 * h);
            *array_push(&scan) = vec(1.5, 0.25 * k, 0.25 * h);
        }
    mesh = shape_grid(floor_point, -10, -10, 10, 10, 10, 10);
    guard = gouge_from_points(scan.item, scan.n);
    path_options.radius = R;
    path_options.scallop = 0.05;
    path_options.left_share = 0.5;
    path_options.noise = 0;
    path_options.body.ball_only = true;
    path_options.certain = path_options.believed = scan;
    path = (struct path){.name = "path"};
    t = (struct toolpath){
        .path = &path,
        .rule =
            {.radius = R, .feed = 800, .plunge = 300, .clearance = 30, .approach = 3, .longest = 6},
        .lift = {.guard = guard,
                 .offset = R,
                 .limit = R,
                 .tolerance = 0.01,
                 .step = 0.05,
                 .axis = {.kind = AXIS_FIXED, .direction = {0, 0, 1}},
                 .feed = {.side = {0, 1, 0}}},
        .threads = 1};
}

static void teardown(void)
{
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
    mesh_free(&mesh);
    array_free(&scan);
    path_options.certain = path_options.doubtful = path_options.believed = (struct vec3s){0};
}

/* Rows along x at these y. */
static void rows(double from, double to, double step)
{
    size_t pass = 0;
    for (double y = from; y <= to + 1e-9; y += step) {
        struct contact contact[41];
        for (int i = 0; i < 41; i++)
            contact[i] = (struct contact){vec(0.5 * i - 10, y, 0), vec(0, 0, 1)};
        toolpath_strip(&t, ++pass, contact, 41, vec(1, 0, 0));
    }
    toolpath_cut(&t);
}

/* Rows that leave less than the scallop. */
static void close_rows(void)
{
    rows(-10, 10, 20 / ceil(20 / scallop_step(0.05, R, 0)));
}

/* What stays at d from a row is R - sqrt(R^2 - d^2), and the limit scallop + tolerance. */
static size_t left_by_truth(double from, double to, double step, double limit)
{
    size_t n = 0;
    for (size_t i = 0; i < scan.n; i++) {
        double d = INFINITY;
        for (double y = from; y <= to + 1e-9; y += step)
            d = fmin(d, fabs(scan.item[i].y - y));
        /* the ball touches a point where it comes within R and the limit */
        n += sqrt(R * R + d * d) > R + limit;
    }
    return n;
}

static int concluded(const struct path_coverage *c, struct path_head *head, const char **text)
{
    said_begin();
    int status = path_coverage_conclude(c, head);
    *text = said_end();
    return status;
}

START_TEST(what_rows_leave)
{
    make(false);
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_double_eq(c.options.limit, 0.05 + 0.01);
    ck_assert_double_eq(c.options.tolerance, 0.01);
    ck_assert_double_eq(c.options.radius, R);
    ck_assert(c.options.upright);
    rows(-10, 10, 2.5);                       /* 1.25 from a row: sqrt(17.5625) - 4 = 0.19 stays */
    path_coverage_rest(&c, vec(0, 0, 0), &t); /* in no planes: only looked at later */
    ck_assert_uint_eq(c.rounds, 0);
    toolpath_end(&t);
    path_coverage_measure(&c, &t);
    struct coverage_report r = coverage_report(c.coverage);
    size_t left = left_by_truth(-10, 10, 2.5, 0.06);
    ck_assert_uint_gt(left, scan.n / 3);
    ck_assert_uint_eq(r.points, scan.n);
    ck_assert_uint_eq(r.left.n, left);
    ck_assert_uint_eq(r.out.n + r.kept.n, 0);
    ck_assert_double_eq_tol(r.left.highest, sqrt(R * R + 1.25 * 1.25) - R, 0.01);
    struct path_head head = {.tool = 0};
    const char *text;
    ck_assert_int_eq(concluded(&c, &head, &text), EXIT_UNMET);
    ck_assert_ptr_nonnull(strstr(text, "left though within reach"));
    ck_assert_uint_eq(head.unmet.n, 1);
    unmets_free(&head.unmet);
    /* as much may be left: told, and no fault */
    path_options.left_share = 100.0 * (double)left / (double)scan.n + 0.01;
    ck_assert_int_eq(concluded(&c, &head, &text), EXIT_DONE);
    ck_assert_ptr_nonnull(strstr(text, "left though within reach"));
    ck_assert_uint_eq(head.unmet.n, 0);
    path_options.left_share -= 0.02;
    ck_assert_int_eq(concluded(&c, &head, &text), EXIT_UNMET);
    unmets_free(&head.unmet);
    c.scallop = 0; /* nothing was promised */
    ck_assert_int_eq(concluded(&c, &head, &text), EXIT_DONE);
    path_coverage_free(&c);
}
END_TEST

START_TEST(rest_passes_cut_it)
{
    make(false);
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    rows(-10, 10, 2.5);
    said_begin();
    path_coverage_rest(&c, vec(0, 1, 0), &t);
    said_end();
    ck_assert_uint_ge(c.rounds, 1);
    ck_assert_uint_ge(c.strips, 7); /* between nine rows */
    toolpath_end(&t);
    path_coverage_measure(&c, &t);
    struct coverage_report r = coverage_report(c.coverage);
    ck_assert_uint_eq(r.left.n, 0);
    struct path_head head = {.tool = 0};
    const char *text;
    ck_assert_int_eq(concluded(&c, &head, &text), EXIT_DONE);
    ck_assert_str_eq(text, "");
    for (size_t i = 0; i < path.item.n; i++) /* all of it on the floor, or above */
        if (path.item.item[i].kind == PATH_POINT)
            ck_assert_double_ge(path.item.item[i].to.p.z, -0.01);
    path_coverage_free(&c);
}
END_TEST

/* Close rows: nothing is left, and no pass is added. */
START_TEST(nothing_is_left)
{
    make(false);
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    close_rows();
    path_coverage_rest(&c, vec(0, 1, 0), &t);
    ck_assert_uint_eq(c.rounds, 0);
    ck_assert_uint_eq(c.strips, 0);
    path_coverage_free(&c);
}
END_TEST

/* The floor between two walls, 6 high: in its middle a ball on top of both is 5.7 off, one beside a
 * wall, on the floor, is nearer. */
START_TEST(out_of_reach)
{
    make(true);
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    close_rows();
    said_begin();
    path_coverage_rest(&c, vec(0, 1, 0), &t);
    said_end();
    toolpath_end(&t);
    path_coverage_measure(&c, &t);
    struct coverage_report r = coverage_report(c.coverage);
    double stays = hypot(1.5 + R, R) - R;
    ck_assert_double_ge(r.out.highest, stays - 0.01); /* so far a ball may be in */
    ck_assert_double_le(r.out.highest, 1.02 * stays);
    ck_assert_double_eq_tol(r.out.at.z, 0, 1e-12);
    ck_assert_double_lt(fabs(r.out.at.x), 0.26);
    size_t between = 0; /* eleven columns of the floor, and the walls' inner sides */
    for (size_t i = 0; i < scan.n; i++)
        between += fabs(scan.item[i].x) < 1.4;
    ck_assert_uint_ge(r.out.n, between);
    struct path_head head = {.tool = 0};
    const char *text;
    concluded(&c, &head, &text);
    unmets_free(&head.unmet);
    char want[60];
    snprintf(want, sizeof want, "out of reach of ball and tool: %zu of %zu points", r.out.n,
             scan.n);
    ck_assert_msg(strstr(text, want) != NULL, "%s", text);
    path_coverage_free(&c);
}
END_TEST

/* A ridge that the guard assumes and the scan does not have keeps the ball off the floor beside it:
 * who judges by the scan takes that for left, and so it is no success.  Nor is it where that is
 * more than scallop and tolerance, and less than stages to come may leave: none need come.  But up
 * to twice as much as may be is left to a fitter, which the path's head says. */
START_TEST(kept_off_is_left)
{
    const double ridge[] = {0, 1, 0.045, 0.045}, share = path_options.left_share;
    const bool much = _i == 1 || _i == 2;
    make(false);
    struct vec3s assumed = {0};
    for (size_t i = 0; i < scan.n; i++)
        *array_push(&assumed) = scan.item[i];
    for (int k = -40; _i > 0 && k <= 40; k++)
        *array_push(&assumed) = vec(0, 0.25 * k, ridge[_i]);
    gouge_free(guard);
    guard = gouge_from_points(assumed.item, assumed.n);
    array_free(&assumed);
    t.lift.guard = guard;
    t.rule.chain = (struct kinematic_chain){.n = 0, .tool = {0, 0, 1}};
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_double_eq_tol(c.rows, 0.05, 1e-15);
    ck_assert_double_eq_tol(c.allowed, 0.06, 1e-15);
    ck_assert_double_eq_tol(c.options.near, (0.05 + 0.01 + 2 * 0.01) / 2, 1e-15);
    close_rows();
    toolpath_end(&t);
    path_coverage_measure(&c, &t);
    struct coverage_report r = coverage_report(c.coverage);
    struct path_head head = {.tool = 0};
    const char *text;
    if (_i == 2)
        path_options.left_share = share / 2;
    ck_assert_int_eq(concluded(&c, &head, &text), much ? EXIT_UNMET : EXIT_DONE);
    path_options.left_share = share;
    ck_assert_ptr_eq(strstr(text, "alone takes") ? text : NULL, much ? text : NULL);
    ck_assert_uint_eq(head.unmet.n > 0, much);
    ck_assert_uint_eq(head.unfitted.n, _i == 3);
    ck_assert_ptr_eq(strstr(text, "without a fitter") ? text : NULL, _i == 3 ? text : NULL);
    if (_i == 1) { /* a ball of 4 beside a ridge 1 high is 2.65 off it */
        double side = sqrt(2 * R * 1 - 1);
        ck_assert_double_ge((double)(r.kept.n + r.left.n), 0.8 * 2 * side / 20 * (double)scan.n);
        ck_assert_uint_eq(r.out.n, 0);
        size_t judged = 0;
        sscanf(strstr(text, "alone takes"), "alone takes %zu", &judged);
        ck_assert_uint_eq(judged, r.kept.n);
    }
    if (_i >= 2) { /* with what the lift leaves over a ridge */
        ck_assert_double_gt(r.kept.highest, 0.06 + 0.001);
        ck_assert_double_lt(r.kept.highest, 0.06 + 2 * 0.01);
    }
    unmets_free(&head.unmet);
    unmets_free(&head.unfitted);
    path_coverage_free(&c);
}
END_TEST

/* Without a scan the mesh is sampled half a row apart; without a guard nothing is measured. */
START_TEST(of_the_mesh)
{
    make(false);
    path_options.certain = (struct vec3s){0};
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_ptr_null(c.bare);
    ck_assert_ptr_eq(c.options.guard, guard);
    size_t n;
    coverage_points(c.coverage, &n);
    double half = scallop_step(0.05, R, 0) / 2;
    ck_assert_double_ge((double)n, 20 * 20 / (half * half));
    ck_assert_double_le((double)n, 8 * 20 * 20 / (half * half));
    path_coverage_free(&c);
    t.lift.guard = NULL;
    c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_ptr_null(c.coverage);
    const char *text;
    ck_assert_int_eq(concluded(&c, NULL, &text), EXIT_DONE);
    ck_assert_str_eq(text, "");
    path_coverage_free(&c);
}
END_TEST

/* Noise widens the limit by 1.5 deviations, and what the ball may be in by half of one. */
START_TEST(noise)
{
    make(false);
    path_options.noise = 0.04;
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_double_eq_tol(c.options.limit, 0.05 + 0.01 + 0.06, 1e-15);
    ck_assert_double_eq_tol(c.options.tolerance, 0.01 + 0.02, 1e-15);
    path_coverage_free(&c);
    path_options.noise = -1;  /* not measured */
    path_options.scallop = 0; /* rows of the mesh: by 0.02 */
    c = path_coverage_new(&mesh, &mesh, &t);
    ck_assert_double_eq_tol(c.options.limit, 0.02 + 0.01, 1e-15);
    rows(-10, 10, 2.5);
    path_coverage_rest(&c, vec(0, 1, 0), &t);
    ck_assert_uint_eq(c.rounds, 0); /* nothing is promised */
    path_coverage_free(&c);
}
END_TEST

/* What is left on points that were put elsewhere is told by where a judge has them. */
START_TEST(judged_where_the_judge_has_them)
{
    struct vec3s lower = {0};
    struct path_head head = {0};
    const char *text;

    make(false);
    for (size_t i = 0; i < scan.n; i++)
        *array_push(&lower) = vec_sub(scan.item[i], vec(0, 0, scan.item[i].x > 5 ? 0.2 : 0));
    path_options.noise = 0.04;
    *(_i == 0 ? &path_options.certain : &path_options.believed) = lower;
    struct path_coverage c = path_coverage_new(&mesh, &mesh, &t);
    close_rows();
    toolpath_end(&t);
    path_coverage_measure(&c, &t);
    ck_assert_int_eq(concluded(&c, &head, &text), _i == 0 ? EXIT_DONE : EXIT_UNMET);
    unmets_free(&head.unmet);
    unmets_free(&head.unfitted);
    path_coverage_free(&c);
    array_free(&lower);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_coverage");
    TCase *tests = tcase_create("path_coverage");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, what_rows_leave);
    tcase_add_test(tests, rest_passes_cut_it);
    tcase_add_test(tests, nothing_is_left);
    tcase_add_test(tests, out_of_reach);
    tcase_add_loop_test(tests, kept_off_is_left, 0, 4);
    tcase_add_test(tests, of_the_mesh);
    tcase_add_test(tests, noise);
    tcase_add_loop_test(tests, judged_where_the_judge_has_them, 0, 2);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
