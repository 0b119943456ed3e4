/*
 * post_group: programs of random passes on machines of every kind turn back as seldom, and turn
 * their axes as little, as the shortest way by trying, with tool-centre-point control and without.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>

#include "chains.h"
#include "post/dialect.h"
#include "post/post_group.h"
#include "turnsearch.h"

enum { POINTS = 60 };

static const char *const kinds[] = {"table-ac",      "head-table-bc",  "head-ca",
                                    "nutating-head", "nutating-table", "head-cb"};
enum { KINDS_SHIPPED = sizeof kinds / sizeof *kinds };

static struct machine narrow_machine(int kind, bool tcp)
{
    struct machine m = machine_default();
    struct error error;
    char text[500];
    const char *folder = getenv("SRC");
    snprintf(text, sizeof text, "%s/machines/%s.txt", folder ? folder : ".", kinds[kind]);
    ck_assert_msg(machine_read(&m, text, &error) == 0, "%s", error.text);
    m.tcp = tcp;
    for (int k = MACHINE_A; k < MACHINE_AXES; k++) {
        m.min[k] = floor(-20 - (k == MACHINE_C ? 300 : 100) * chance());
        m.max[k] = ceil(20 + (k == MACHINE_C ? 300 : 100) * chance());
        m.rapid[k] = 3000 + 9000 * chance();
    }
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    return m;
}

/* Once about, or back and forth, tilted more and less, and never near the pole. */
static void random_axes(struct vec3 axis[])
{
    double tilt = 0.3 + 0.5 * chance(), turn = 2 * PI * chance(), wind = 0.2 * chance() - 0.1;
    double swing = 2 * chance(), lean = 0.2 * chance();
    for (int j = 0; j < POINTS; j++) {
        double t = tilt + lean * sin(0.15 * j), c = turn + wind * j + swing * sin(0.07 * j);
        axis[j] = vec(sin(t) * sin(c), -sin(t) * cos(c), cos(t));
    }
}

static struct path path_of(const struct vec3 axis[])
{
    struct path path = {.name = "pass"};
    path.head.clearance = NAN;
    for (int j = 0; j < POINTS; j++) {
        struct pose at = {vec(0.5 * j, 3, 0.1 * j), axis[j]}, above = at;
        above.p = vec_along(at.p, 60, at.a);
        if (j == 0)
            path_add_point(&path, above, true);
        path_add_point(&path, at, false);
        if (j + 1 == POINTS)
            path_add_point(&path, above, true);
    }
    return path;
}

static double way_of_plan(const struct kinematic_chain *chain, const struct nc_plan *plan)
{
    double way = 0, q[2] = {0};
    for (size_t i = 0; i < plan->move.n; i++) {
        way += angles_way(chain, q, plan->move.item[i].q);
        q[0] = plan->move.item[i].q[0];
        q[1] = plan->move.item[i].q[1];
    }
    return way;
}

/* Trying turns back at the points alone.  Where that finds no way, or one with more turns, the
 * plan may have turned between two of them, at an end of the travel: it did turn, and nothing in it
 * is beyond the travel. */
static void check_turned_between(const struct machine *m, const struct nc_plan *plan)
{
    const double digit = RADIANS(0.0011);
    ck_assert_uint_ge(plan->total.turns, 1);
    for (size_t i = 0; i < plan->move.n; i++)
        for (int k = 0; k < m->chain.n; k++) {
            ck_assert_double_ge(plan->move.item[i].q[k], m->chain.rotary[k].min - digit);
            ck_assert_double_le(plan->move.item[i].q[k], m->chain.rotary[k].max + digit);
        }
}

/* By trying, with places between the points, on the great circle: a step from point to point may go
 * over to the other solution, less than a right angle away, which no tool on its way can. */
static double way_in_small_steps(const struct machine *m, const struct vec3 axis[])
{
    enum { EACH = 8 };
    struct vec3 small[EACH * (POINTS - 1) + 1];
    const double from[2] = {0};
    double way = 0;
    small[EACH * (POINTS - 1)] = axis[POINTS - 1];
    for (int j = 0; j < EACH * (POINTS - 1); j++)
        small[j] = vec_slerp(axis[j / EACH], axis[j / EACH + 1], j % EACH / (double)EACH);
    ck_assert_int_ge(angles_least(&m->chain, small, EACH * (POINTS - 1) + 1, from, &way), 0);
    return way;
}

/* One pass planned, and by trying: 1 when it can be, then *turns more of them. */
static int try_pass(const struct machine *m, const struct vec3 axis[], int *turns)
{
    const double from[2] = {0};
    const struct nc_plan_options options = {
        .chord = 0.01, .axis_tolerance = RADIANS(0.1), .feed = 1000, .unit = 1};
    struct nc_plan plan;
    struct error error;
    double way = 0;
    struct path path = path_of(axis);
    struct nc_ability ability = dialect_ability(CONTROL_fanuc, m, POST_AXIS_ROTARY, false, 1);
    int least = angles_least(&m->chain, axis, POINTS, from, &way);
    int result = nc_plan_make(&plan, &path, m, ability, options, &error);
    bool between = result == 0 && (least < 0 || plan.total.turns < (size_t)least);
    if (between)
        check_turned_between(m, &plan);
    else
        ck_assert_msg(result == (least < 0 ? -1 : 0), "%d turns, %s", least, error.text);
    if (result == 0 && !between) {
        double got = way_of_plan(&m->chain, &plan);
        ck_assert_uint_eq(plan.total.turns, (size_t)least);
        /* a turn at the very end of the travel, between two points, may save a planner */
        const double saved = RADIANS(1 + 60 * least);
        if (!(got < 1.011 * way + RADIANS(1)) || !(got > way - saved))
            way = way_in_small_steps(m, axis);
        ck_assert_msg(got < 1.011 * way + RADIANS(1), "way %g of %g, %d turns", DEGREES(got),
                      DEGREES(way), least);
        ck_assert_double_gt(got, way - saved);
        *turns += least;
    }
    nc_plan_free(&plan);
    path_free(&path);
    return result == 0;
}

START_TEST(as_by_trying)
{
    int found = 0, back = 0;
    seed = 200 + (uint64_t)_i;
    /* at least so many machines, and on until some can and one had to turn back, as few have to */
    for (int i = 0; i < 16 || ((found <= 5 || back == 0) && i < 160); i++) {
        struct machine m = narrow_machine(_i / 2, _i % 2);
        struct vec3 axis[POINTS];
        random_axes(axis);
        found += try_pass(&m, axis, &back);
    }
    ck_assert_int_gt(found, 5);
    ck_assert_int_gt(back, 0);
}
END_TEST

/* A nutating axis: the tool leans more and more while it turns about, which by one solution the
 * first axis does and by the other it hardly has to.  It begins near either. */
START_TEST(solutions_that_differ)
{
    int back = 0;
    seed = 230;
    for (int i = 0; i < 24; i++) {
        struct machine m = narrow_machine(i % 2 ? 3 : 4, i % 4 < 2);
        struct vec3 axis[POINTS];
        struct error error;
        double start = 2 * PI * chance(), wind = (i % 8 < 4 ? 0.02 : -0.02) * chance();
        m.min[MACHINE_B] = -185;
        m.max[MACHINE_B] = 185;
        m.min[MACHINE_C] = -720;
        m.max[MACHINE_C] = 720;
        ck_assert_int_eq(machine_finish(&m, &error), 0);
        for (int j = 0; j < POINTS; j++) {
            double t = 0.2 + 0.018 * j, c = start + wind * j;
            axis[j] = vec(sin(t) * sin(c), -sin(t) * cos(c), cos(t));
        }
        ck_assert_int_eq(try_pass(&m, axis, &back), 1);
    }
    ck_assert_int_eq(back, 0);
}
END_TEST

/* A line on which the tool leans from one side of the singular direction to the other, `miss`
 * radians beside it, far from the centre of the table. */
static struct path path_past_pole(double miss)
{
    double lean = 0.0126, far = -0.2;
    struct path path = {.name = "past"};
    struct pose from = {vec(2.1, -75.9, 13.6), vec_unit(vec(lean, miss, 1))};
    struct pose to = {vec(-3.3, -75.7, 11.9), vec_unit(vec(far, miss, 1))}, above = from;
    path.head.clearance = NAN;
    above.p.z = 60;
    path_add_point(&path, above, true);
    path_add_point(&path, from, false);
    path_add_point(&path, to, false);
    above = to;
    above.p.z = 60;
    path_add_point(&path, above, true);
    return path;
}

/* The pose of the machine after a block. */
static struct pose pose_of(const struct machine *m, const struct nc_move *move)
{
    struct pose pose = {move->p, chain_axis(&m->chain, move->q)};
    if (!m->tcp)
        pose.p = chain_tip(&m->chain, move->p, move->q);
    return pose;
}

/* How far a pose is off a straight motion: the tip, and where it is beside it the axis. */
static void check_beside(struct pose at, struct pose from, struct pose to, double chord)
{
    struct vec3 way = vec_sub(to.p, from.p);
    double s = vec_dot(vec_sub(at.p, from.p), way) / vec_dot(way, way);
    s = fmin(fmax(s, 0), 1);
    ck_assert_double_lt(vec_distance(at.p, vec_mix(from.p, to.p, s)), chord);
    ck_assert_double_lt(vec_angle(at.a, vec_slerp(from.a, to.a, s)), RADIANS(0.06));
}

/* Whatever passes beside the singular direction goes on: by a turn of the first axis there, or, as
 * near as the tolerance, past it with that axis all but still. */
START_TEST(past_the_pole)
{
    static const double miss[] = {1e-6, 2e-5, 1e-4, 2e-4, 4e-4, 1e-3, 5e-3};
    for (int tcp = 0; tcp < 2; tcp++) {
        const struct nc_plan_options options = {
            .chord = 0.002, .axis_tolerance = RADIANS(0.05), .feed = 800, .unit = 1};
        struct machine m = machine_default();
        struct error error;
        m.tcp = tcp;
        ck_assert_int_eq(machine_finish(&m, &error), 0);
        struct nc_ability ability = dialect_ability(CONTROL_fanuc, &m, POST_AXIS_ROTARY, false, 1);
        struct path path = path_past_pole(miss[_i]);
        struct nc_plan plan;
        ck_assert_msg(nc_plan_make(&plan, &path, &m, ability, options, &error) == 0, "%s",
                      error.text);
        ck_assert_uint_eq(plan.total.turns, 0);
        double turn = 0;
        for (size_t i = 1; i < plan.move.n; i++) {
            const struct nc_move *move = &plan.move.item[i];
            if (move->kind != NC_LINE)
                continue;
            turn += fabs(move->q[0] - move[-1].q[0]);
            check_beside(pose_of(&m, move), path.item.item[1].to, path.item.item[2].to, 0.003);
        }
        if (miss[_i] < 3e-4) /* half of the tolerance of the axis */
            ck_assert_double_lt(turn, RADIANS(30));
        ck_assert_double_lt(turn, RADIANS(200));
        nc_plan_free(&plan);
        path_free(&path);
    }
}
END_TEST

/* An arc of radius 20 about (0, 5, 0) over the singular direction, `miss` radians beside it, square
 * to which the tool stands but for these. */
static struct path path_over_pole(double miss)
{
    double x = 20 * sin(RADIANS(40)), z = 20 * cos(RADIANS(40));
    struct path path = {.name = "over"};
    struct pose from = {vec(-x, 5, z), vec_unit(vec(-x / 20, miss, z / 20))}, above = from;
    struct pose to = {vec(x, 5, z), vec_unit(vec(x / 20, miss, z / 20))};
    path.head.clearance = NAN;
    above.p.z = 60;
    path_add_point(&path, above, true);
    path_add_point(&path, from, false);
    path_add_arc(&path, to, (struct path_arc){vec(0, 5, 0), vec(0, 1, 0), 20});
    above = to;
    above.p.z = 60;
    path_add_point(&path, above, true);
    return path;
}

/* In straight blocks of such an arc only a part of it can be the one that goes past the singular
 * direction: where it begins and ends is found, so that the first axis stays all but still. */
START_TEST(over_the_pole)
{
    static const double miss[] = {1e-6, 1e-4, 3e-4, 1e-3};
    for (int tcp = 0; tcp < 2; tcp++) {
        const struct nc_plan_options options = {
            .chord = 0.002, .axis_tolerance = RADIANS(0.05), .feed = 800, .unit = 1};
        struct machine m = machine_default();
        struct error error;
        m.tcp = tcp;
        m.arcs = m.arcs_tcp = m.arcs_space = false;
        ck_assert_int_eq(machine_finish(&m, &error), 0);
        struct nc_ability ability = dialect_ability(CONTROL_fanuc, &m, POST_AXIS_ROTARY, false, 1);
        struct path path = path_over_pole(miss[_i]);
        struct nc_plan plan;
        ck_assert_msg(nc_plan_make(&plan, &path, &m, ability, options, &error) == 0, "%s",
                      error.text);
        ck_assert_uint_eq(plan.total.turns, 0);
        double turn[2] = {0, 0};
        for (size_t i = 1; i < plan.move.n; i++) {
            const struct nc_move *move = &plan.move.item[i];
            if (move->kind != NC_LINE)
                continue;
            struct pose at = pose_of(&m, move);
            struct vec3 a = vec_unit(vec(at.p.x / 20, miss[_i], at.p.z / 20));
            ck_assert_double_lt(fabs(vec_distance(at.p, vec(0, 5, 0)) - 20), 0.003);
            ck_assert_double_lt(vec_angle(at.a, a), RADIANS(0.06));
            for (int k = 0; k < 2; k++)
                turn[k] += fabs(move->q[k] - move[-1].q[k]);
        }
        if (miss[_i] < 4e-4) /* half of the tolerance of the axis */
            ck_assert_double_lt(turn[0], RADIANS(20));
        ck_assert_double_lt(turn[0], RADIANS(181));
        ck_assert_double_eq_tol(turn[1], RADIANS(80), RADIANS(0.3));
        nc_plan_free(&plan);
        path_free(&path);
    }
}
END_TEST

/* With vectors the control turns the axes as it likes: what may go through the pole is said so. */
START_TEST(vectors_through_the_pole)
{
    static const double miss[] = {1e-6, 1e-4, 3e-4, 0.002};
    const struct nc_plan_options options = {
        .chord = 0.002, .axis_tolerance = RADIANS(0.05), .feed = 800, .unit = 1};
    struct machine m = machine_default();
    struct nc_plan plan;
    struct error error;
    bool pole = false;
    m.tcp = true;
    ck_assert_int_eq(machine_finish(&m, &error), 0);
    struct nc_ability ability = dialect_ability(CONTROL_siemens, &m, POST_AXIS_VECTORS, false, 1);
    struct path path = path_past_pole(miss[_i]);
    ck_assert_int_eq(nc_plan_make(&plan, &path, &m, ability, options, &error), 0);
    for (size_t i = 0; i < plan.move.n; i++) {
        const struct nc_move *move = &plan.move.item[i];
        struct pose at = {move->p, vec_unit(plan.vector.item[move->vector])};
        pole = pole || at.a.z == 1;
        if (move->kind == NC_LINE)
            check_beside(at, path.item.item[1].to, path.item.item[2].to, 0.003);
    }
    ck_assert_int_eq(pole, miss[_i] < 4e-4);
    nc_plan_free(&plan);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_group");
    TCase *tests = tcase_create("passes");

    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, as_by_trying, 0, 2 * KINDS_SHIPPED);
    tcase_add_test(tests, solutions_that_differ);
    tcase_add_loop_test(tests, past_the_pole, 0, 7);
    tcase_add_loop_test(tests, over_the_pole, 0, 4);
    tcase_add_loop_test(tests, vectors_through_the_pole, 0, 4);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
