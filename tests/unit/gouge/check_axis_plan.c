/* axis_plan - a pass past a wall: the tool is clear at every pose in between, turns evenly, and
 * where nothing is in the way the axes are those of the rule, or near them and calmer. */
#include "gouge/axis_plan.h"

#include <check.h>
#include <stdlib.h>

#include "machine/machine.h"
#include "machine/rotary_cost.h"

enum { RADIUS = 5, FLUTE = 30, POINTS = 120 };

static const struct holder flute = {1, {{RADIUS, RADIUS, FLUTE}}};

/* A floor, and across it from x = 20 to 40 a wall beside the path, at y = 6, up to this height. */
static struct gouge_check *floor_and_wall(double height, struct vec3s *copy)
{
    struct vec3s points = {0};

    for (int i = 0; i <= 240; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(i * 0.25, k * 0.25, 0);
    for (int i = 0; i <= 80; i++)
        for (int k = 1; k <= height * 4; k++)
            *array_push(&points) = vec(20 + i * 0.25, 6, k * 0.25);
    for (size_t i = 0; copy && i < points.n; i++)
        *array_push(copy) = points.item[i];
    return gouge_new(points, 1);
}

/* Along X on the floor, the axis leaning by `lean` towards the wall, or to and fro. */
static struct run pass(double lean, double flutter)
{
    struct run run = {.radius = RADIUS};

    for (int i = 0; i <= POINTS; i++) {
        double a = lean + flutter * sin(i);
        struct run_point p = {.contact = vec(i * 0.5, 0, 0),
                              .normal = vec(0, 0, 1),
                              .ball = vec(i * 0.5, 0, RADIUS),
                              .axis = vec(0, sin(a), cos(a))};
        p.tip = vec_along(p.ball, -RADIUS, p.axis);
        *array_push(&run) = p;
    }
    return run;
}

static struct axis_planner *planner_of(const struct gouge_check *guard, double play)
{
    struct machine machine = machine_default();
    struct error error;

    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    struct axis_planner_options options = {.guard = guard,
                                           .radius = RADIUS,
                                           .holder = flute,
                                           .chain = machine.chain,
                                           .tolerance = 0.01,
                                           .between = true,
                                           .play = play,
                                           .limit = RADIANS(85)};
    return axis_planner_new(&options);
}

/* How deep any of the points is in the flute, at poses not more than 0.1 mm and 0.5 degrees apart.
 */
static double deepest(const struct axis_plan *plan, const struct vec3s *points)
{
    double deep = -HUGE_VAL;

    for (size_t i = 0; i + 1 < plan->run.n; i++) {
        const struct run_point *a = &plan->run.item[i], *b = a + 1;
        for (int k = 0; k <= 8; k++) {
            struct vec3 ball = vec_mix(a->ball, b->ball, k / 8.0);
            struct vec3 axis = vec_slerp(a->axis, b->axis, k / 8.0);
            for (size_t m = 0; m < points->n; m++) {
                struct vec3 d = vec_sub(points->item[m], ball);
                double h = vec_dot(d, axis);
                if (h > 0 && h < FLUTE)
                    deep = fmax(deep, RADIUS - sqrt(vec_dot(d, d) - h * h));
            }
        }
    }
    return deep;
}

START_TEST(past_a_wall_the_tool_is_clear)
{
    struct vec3s points = {0};
    struct gouge_check *guard = floor_and_wall(25, &points);
    struct axis_planner *planner = planner_of(guard, RADIANS(15 * _i));
    struct run run = pass(RADIANS(15), 0);
    struct axis_plan plan = {.leaned = 0};

    axis_plan_run(planner, &run, &plan);
    ck_assert_uint_ge(plan.run.n, run.n);
    for (size_t i = 0; i < plan.run.n; i++)
        ck_assert_int_eq(plan.state.item[i], AXIS_PLAN_CUT);
    ck_assert_double_le(deepest(&plan, &points), 0.006);
    ck_assert_double_ge(plan.leaned, RADIANS(12)); /* 1 mm of room on 30 mm of flute */
    ck_assert_double_le(plan.leaned, RADIANS(35));
    double turn = 0;
    for (size_t i = 1; i < plan.run.n; i++)
        turn += vec_angle(plan.run.item[i - 1].axis, plan.run.item[i].axis);
    ck_assert_double_le(turn, RADIANS(90)); /* away from the wall and back */
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
    array_free(&points);
}
END_TEST

/* A machine of one rotary axis, about X: the tool leans away from the wall within its circle; where
 * it may lean to the other side alone, it does not come to the wall. */
START_TEST(past_a_wall_on_a_circle)
{
    struct vec3s points = {0};
    struct gouge_check *guard = floor_and_wall(25, &points);
    const struct axis_planner_options options = {
        .guard = guard,
        .radius = RADIUS,
        .holder = flute,
        .chain = {.n = 1,
                  .rotary = {{.axis = {1, 0, 0},
                              .table = true,
                              .min = -RADIANS(60),
                              .max = _i < 2 ? RADIANS(60) : -RADIANS(5)}},
                  .tool = {0, 0, 1}},
        .tolerance = 0.01,
        .between = true,
        .play = RADIANS(15 * (_i % 2)),
        .limit = RADIANS(85)};
    struct axis_planner *planner = axis_planner_new(&options);
    struct run run = pass(RADIANS(15), 0);
    struct axis_plan plan = {.leaned = 0}, cut = {.leaned = 0};
    size_t skipped = 0;

    axis_plan_run(planner, &run, &plan);
    for (size_t i = 0; i < plan.run.n; i++) {
        const struct run_point *p = &plan.run.item[i];
        bool beside = p->ball.x > 20 && p->ball.x < 40;
        skipped += plan.state.item[i] == AXIS_PLAN_SKIP;
        ck_assert(plan.state.item[i] != AXIS_PLAN_SKIP || (_i >= 2 && p->ball.x > 10));
        ck_assert(_i < 2 || !beside || plan.state.item[i] == AXIS_PLAN_SKIP);
        ck_assert_double_eq_tol(p->axis.x, 0, 1e-12);
        if (_i < 2)
            *array_push(&cut.run) = *p;
    }
    ck_assert_int_eq(skipped > 0, _i >= 2);
    ck_assert_double_le(deepest(&cut, &points), 0.006);
    array_free(&run);
    axis_plan_free(&plan);
    axis_plan_free(&cut);
    axis_planner_free(planner);
    gouge_free(guard);
    array_free(&points);
}
END_TEST

START_TEST(without_a_wall_the_rule_stays)
{
    struct gouge_check *guard = floor_and_wall(0, NULL);
    struct axis_planner *planner = planner_of(guard, 0);
    struct run run = pass(RADIANS(15), RADIANS(10));
    struct axis_plan plan = {.leaned = 0};

    axis_plan_run(planner, &run, &plan);
    ck_assert_uint_ge(plan.run.n, run.n);
    for (size_t i = 0, k = 0; i < plan.run.n && k < run.n; i++)
        if (vec_distance(plan.run.item[i].ball, run.item[k].ball) < 1e-9)
            ck_assert_double_le(vec_angle(plan.run.item[i].axis, run.item[k++].axis), 1e-9);
    ck_assert_double_eq(plan.leaned, 0);
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
}
END_TEST

static double travel_of(const struct run *run)
{
    double travel = 0;

    for (size_t i = 1; i < run->n; i++)
        travel += rotary_travel(run->item[i - 1].axis, run->item[i].axis);
    return travel;
}

START_TEST(with_play_the_rotary_axes_turn_little)
{
    struct gouge_check *guard = floor_and_wall(0, NULL);
    struct axis_planner *planner = planner_of(guard, RADIANS(15));
    struct run run = pass(RADIANS(15), RADIANS(10));
    struct axis_plan plan = {.leaned = 0};

    axis_plan_run(planner, &run, &plan);
    ck_assert_double_le(travel_of(&plan.run), 0.1 * travel_of(&run));
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
}
END_TEST

/* The axis comes through the pole a hundredth of a mm beside a point: it passes it at that
 * point. */
START_TEST(no_point_so_near_to_the_pole_but_at_it)
{
    struct gouge_check *guard = floor_and_wall(0, NULL);
    struct axis_planner *planner = planner_of(guard, RADIANS(15));
    struct run run = pass(0, 0);
    struct axis_plan plan = {.leaned = 0};
    size_t at_pole = 0;

    for (size_t i = 0; i < run.n; i++) {
        struct run_point *p = &run.item[i];
        double a = 0.02 * ((double)i - 60 + (_i - 1) * 0.004);
        p->axis = vec(0, sin(a), cos(a));
        p->tip = vec_along(p->ball, -RADIUS, p->axis);
    }
    axis_plan_run(planner, &run, &plan);
    for (size_t i = 1; i < plan.run.n; i++) {
        const struct run_point *p = &plan.run.item[i];
        ck_assert_double_gt(vec_distance(p[-1].ball, p->ball), 0.02);
        at_pole += vec_length(vec_sub(p->axis, vec(0, 0, 1))) < 1e-12;
    }
    ck_assert_uint_eq(at_pole, 1);
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
}
END_TEST

/* Walls on both sides nearer than the ball's radius leave no direction: the points are told. */
START_TEST(what_no_direction_reaches_is_skipped)
{
    struct vec3s points = {0};
    for (int side = -1; side <= 1; side += 2)
        for (int i = 0; i <= 80; i++)
            for (int k = 20; k <= 100; k++)
                *array_push(&points) = vec(20 + i * 0.25, 4.5 * side, k * 0.25);
    struct gouge_check *guard = gouge_new(points, 1);
    struct axis_planner *planner = planner_of(guard, RADIANS(15));
    struct run run = pass(0, 0);
    struct axis_plan plan = {.leaned = 0};

    axis_plan_run(planner, &run, &plan);
    for (size_t i = 0; i < plan.run.n; i++) {
        double x = plan.run.item[i].ball.x;
        if (x > 21 && x < 39)
            ck_assert_int_eq(plan.state.item[i], AXIS_PLAN_SKIP);
        else if (x < 8 || x > 52)
            ck_assert_int_ne(plan.state.item[i], AXIS_PLAN_SKIP);
    }
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
}
END_TEST

/* An axis at its travel's end on one side of the machine, then on the other: the way between, on
 * which the tool would hang from below, is no turn but a lift. */
START_TEST(no_axis_leaves_its_travel_on_a_sudden_turn)
{
    struct gouge_check *guard = floor_and_wall(0, NULL);
    struct axis_planner *planner = planner_of(guard, 0);
    struct run run = pass(RADIANS(118), 0);
    struct axis_plan plan = {.leaned = 0};
    bool parted = false;

    for (size_t i = 0; i < run.n; i++) {
        struct run_point *p = &run.item[i];
        p->ball.z += 200;
        p->normal = vec(0, 0, 0);
        p->axis.y *= i < run.n / 2 ? 1 : -1;
        p->tip = vec_along(p->ball, -RADIUS, p->axis);
    }
    axis_plan_run(planner, &run, &plan);
    for (size_t i = 0; i < plan.run.n; i++) {
        if (plan.state.item[i] == AXIS_PLAN_SKIP)
            continue;
        ck_assert_double_ge(plan.run.item[i].axis.z, cos(RADIANS(120)));
        parted = parted || (i > 0 && plan.state.item[i] == AXIS_PLAN_BREAK);
        if (i > 0 && plan.state.item[i] == AXIS_PLAN_CUT)
            ck_assert_double_ge(vec_dot(plan.run.item[i - 1].axis, plan.run.item[i].axis), 0);
    }
    ck_assert(parted);
    array_free(&run);
    axis_plan_free(&plan);
    axis_planner_free(planner);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_plan");
    TCase *tcase = tcase_create("axis_plan");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, past_a_wall_the_tool_is_clear, 0, 2);
    tcase_add_loop_test(tcase, past_a_wall_on_a_circle, 0, 4);
    tcase_add_test(tcase, without_a_wall_the_rule_stays);
    tcase_add_test(tcase, with_play_the_rotary_axes_turn_little);
    tcase_add_loop_test(tcase, no_point_so_near_to_the_pole_but_at_it, 0, 3);
    tcase_add_test(tcase, what_no_direction_reaches_is_skipped);
    tcase_add_test(tcase, no_axis_leaves_its_travel_on_a_sudden_turn);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? 1 : 0;
}
