/* axis_chain - which stations are bad is the same whether all are looked at or those that moved. */
#include "gouge/axis_chain.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "machine/machine.h"
#include "seed.h"

enum { RADIUS = 5, POINTS = 40 };

static const struct holder flute = {1, {{RADIUS, RADIUS, 30}}};

/* A floor, and a wall beside the points from x = 4 to 12. */
static struct gouge_check *floor_and_wall(void)
{
    struct vec3s points = {0};

    for (int i = -20; i <= 100; i++)
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(i * 0.25, k * 0.5, 0);
    for (int i = 0; i <= 32; i++)
        for (int k = 1; k <= 100; k++)
            *array_push(&points) = vec(4 + i * 0.25, 6, k * 0.25);
    return gouge_new(points, 1);
}

struct scene {
    struct gouge_check *guard;
    struct run_point point[POINTS];
    struct vec3 rule[POINTS];
    struct axis_calm_options options;
    struct axis_chain chain;
};

static void put_point(struct scene *s, int i, double x, double lean)
{
    struct run_point p = {.contact = vec(x, 0, 0), .normal = vec(0, 0, 1)};

    p.ball = vec(x, 0, RADIUS);
    p.axis = s->rule[i] = vec(0, sin(lean), cos(lean));
    p.tip = vec_along(p.ball, -RADIUS, p.axis);
    s->point[i] = p;
}

static void setup_chain(struct scene *s, int points)
{
    struct machine machine = machine_default();
    struct error error;

    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    s->options = (struct axis_calm_options){s->guard, &flute, machine.chain, RADIUS, 0.01, 0, 1};
    struct axis_calm_run run = {s->point, s->rule, (size_t)points, RADIANS(15), false};
    s->chain = axis_chain_of(&s->options, &run, 1);
    for (int i = 0; i < points; i++)
        s->chain.at[i].part = 1;
}

/* Points along X, all axes leaning 20 degrees from the wall. */
static void setup_scene(struct scene *s, int points)
{
    s->guard = floor_and_wall();
    for (int i = 0; i < points; i++)
        put_point(s, i, 0.5 * i, -RADIANS(20));
    setup_chain(s, points);
}

static void teardown_scene(struct scene *s)
{
    free(s->chain.at);
    gouge_free(s->guard);
}

/* The way to a station is not looked at while the one before is bad; it is when that is no more,
 * though neither has moved. */
START_TEST(a_way_from_what_was_bad_is_looked_at)
{
    struct scene s;
    const double turn = RADIANS(10);

    setup_scene(&s, 3);
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    s.chain.at[0].angles.lean += turn;
    s.chain.at[2].angles.lean -= turn;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 1);
    ck_assert(s.chain.at[1].bad);
    s.chain.at[0].angles.lean -= turn;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 1);
    ck_assert(s.chain.at[2].bad);
    s.chain.at[2].angles.lean += turn;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    teardown_scene(&s);
}
END_TEST

/* Two stations of which C, with little travel, has each by another solution: none has the way. */
START_TEST(a_way_out_of_the_travel_is_bad)
{
    const double lean = RADIANS(3), off = RADIANS(25);
    struct scene s = {.guard = floor_and_wall()};

    for (int i = 0; i < 2; i++) {
        put_point(&s, i, 0.5 * i, lean);
        s.point[i].axis = s.rule[i] =
            vec(-sin(lean) * sin(off), (i == 0 ? -1 : 1) * sin(lean) * cos(off), cos(lean));
    }
    setup_chain(&s, 2);
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    s.options.chain.rotary[0].min = -RADIANS(30);
    s.options.chain.rotary[0].max = RADIANS(30);
    for (int i = 0; i < 2; i++) {
        s.chain.at[i].seen.lean = NAN;
        ck_assert(rotary_reaches(&s.options.chain, s.point[i].axis));
    }
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 1);
    ck_assert(s.chain.at[1].bad);
    teardown_scene(&s);
}
END_TEST

/* The lean to the wall, of a tool at x, with which a point of the wall is so deep in the flute. */
static double lean_into_wall(const struct holder_sweep *sweep, double x, double depth)
{
    double clear = 0, deep = RADIANS(12);

    for (int k = 0; k < 50; k++) {
        double lean = (clear + deep) / 2;
        struct run_point p = {.ball = vec(x, 0, RADIUS), .axis = vec(0, sin(lean), cos(lean))};
        if (holder_sweep_clearance(sweep, &p, AXIS_CHAIN_FAR) < -depth)
            deep = lean;
        else
            clear = lean;
    }
    return clear;
}

/* Before the wall a tool that stays is deeper than who moves may be, though within the tolerance;
 * on its way behind the wall it leans away.  Leaning there as before it is clear, too, but beside
 * the wall it would be three times as deep as it may be. */
START_TEST(a_way_from_what_stays_deep_is_looked_at)
{
    struct scene s = {.guard = floor_and_wall()};
    const struct holder_sweep sweep = {s.guard, &flute, 0.005};
    const double before = 3.5, behind = 13, depth = 0.0077;
    double lean = lean_into_wall(&sweep, before, depth);
    struct run_point beside = {.ball = vec(8, 0, RADIUS), .axis = vec(0, sin(lean), cos(lean))};

    ck_assert_double_lt(holder_sweep_clearance(&sweep, &beside, AXIS_CHAIN_FAR), -0.03);
    put_point(&s, 0, before, lean);
    put_point(&s, 1, behind, -RADIANS(20));
    setup_chain(&s, 2);
    struct axis_station *at = s.chain.at;
    at[0].part = at[1].part = 0;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    ck_assert_double_lt(at[0].clear, -sweep.slack);
    at[1].angles = at[0].was;
    at[1].part = 1;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 1);
    ck_assert_double_gt(at[1].clear, 0);
    ck_assert(at[1].bad);
    at[1].part = 0;
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    teardown_scene(&s);
}
END_TEST

/* Axes moved by chance, some into the wall: what is found after each move is none, if none is
 * found by who looks at all. */
START_TEST(moved_by_chance_none_is_forgotten)
{
    struct scene s;
    uint32_t state = (uint32_t)_i + 1;

    setup_scene(&s, POINTS);
    for (int round = 0; round < 60; round++) {
        for (int k = 0; k < 4; k++) {
            state = state * 1664525u + seed_step_32();
            struct axis_station *at = &s.chain.at[(state >> 16) % POINTS];
            at->angles.lean = at->was.lean + RADIANS(3) * ((double)(state >> 28) - 7);
        }
        size_t found = axis_chain_find_bad(&s.chain);
        for (int i = 0; i < POINTS; i++)
            s.chain.at[i].seen.lean = NAN;
        ck_assert_uint_eq(found > 0, axis_chain_find_bad(&s.chain) > 0);
        for (int i = 0; i < POINTS && round % 3 == 2; i += 2)
            s.chain.at[i].angles = s.chain.at[i].was;
    }
    teardown_scene(&s);
}
END_TEST

/* What is told of a station is what the guard says, or a bound of it on the same side. */
START_TEST(a_clearance_is_on_the_side_of_the_guards)
{
    struct scene s;
    uint32_t state = (uint32_t)_i + 1;
    int clear = 0;

    setup_scene(&s, POINTS);
    const struct holder_sweep sweep = {s.guard, &flute, 0.005};
    for (int k = 0; k < 4000; k++) {
        state = state * 1664525u + seed_step_32();
        struct axis_station *at = &s.chain.at[(state >> 24) % POINTS];
        double lean = RADIANS(0.01) * ((double)(state >> 12 & 4095) - 2300);
        struct run_point p = {.ball = at->point->ball, .axis = vec(0, -sin(lean), cos(lean))};
        double told = axis_chain_clearance(&s.chain, &sweep, at, p.axis, k % 5 == 0);
        double truth = holder_sweep_clearance(&sweep, &p, AXIS_CHAIN_FAR);
        ck_assert_int_eq(told >= -sweep.slack, truth >= -sweep.slack);
        ck_assert(k % 5 != 0 || told == truth);
        ck_assert(told < -sweep.slack || told <= truth);
        clear += truth >= -sweep.slack;
    }
    ck_assert_int_gt(clear, 1000);
    ck_assert_int_lt(clear, 3000);
    teardown_scene(&s);
}
END_TEST

/* Points along X up to before the wall's end, leaning to it by so much; the last but two, which is
 * out of its reach, by LONE more. */
enum { LONER = POINTS - 3 };

static const double LONE = RADIANS(2.2);

static void setup_lone(struct scene *s, double lean)
{
    for (int i = 0; i < POINTS; i++)
        put_point(s, i, 0.5 * i - 20, lean);
    setup_chain(s, POINTS);
    s->chain.at[LONER].angles.lean += copysign(LONE, s->chain.at[LONER].was.lean);
    ck_assert_uint_eq(axis_chain_find_bad(&s->chain), 0);
}

/* The most that the axis turns from a station to the next, radians. */
static double turns_by(const struct scene *s)
{
    double most = 0;

    for (int i = 1; i < POINTS; i++)
        most = fmax(most, vec_angle(axis_chain_point(&s->chain, &s->chain.at[i - 1]).axis,
                                    axis_chain_point(&s->chain, &s->chain.at[i]).axis));
    return most;
}

START_TEST(axes_lead_to_a_lone_one_and_back)
{
    struct scene s = {.guard = floor_and_wall()};

    setup_lone(&s, -RADIANS(20));
    ck_assert_double_gt(turns_by(&s), 0.99 * LONE);
    struct rotary_angles lone = s.chain.at[LONER].angles;
    axis_chain_lead_to_lone(&s.chain);
    ck_assert(axis_chain_same(s.chain.at[LONER].angles, lone));
    ck_assert_double_lt(turns_by(&s), 0.032 * 0.5);
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    teardown_scene(&s);
}
END_TEST

/* The wall is in the way of the last, if it leans more, too: all stay. */
START_TEST(axes_stay_that_would_not_be_clear)
{
    struct scene s = {.guard = floor_and_wall()};
    const struct holder_sweep sweep = {s.guard, &flute, 0.005};
    struct axis_station before[POINTS];

    setup_lone(&s, lean_into_wall(&sweep, -0.5, 0.0045));
    for (int i = 0; i < POINTS; i++)
        before[i] = s.chain.at[i];
    axis_chain_lead_to_lone(&s.chain);
    for (int i = 0; i < POINTS; i++)
        ck_assert(axis_chain_same(s.chain.at[i].angles, before[i].angles));
    ck_assert_uint_eq(axis_chain_find_bad(&s.chain), 0);
    teardown_scene(&s);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_chain");
    TCase *tcase = tcase_create("axis_chain");
    tcase_add_test(tcase, a_way_from_what_was_bad_is_looked_at);
    tcase_add_test(tcase, a_way_out_of_the_travel_is_bad);
    tcase_add_test(tcase, a_way_from_what_stays_deep_is_looked_at);
    tcase_add_loop_test(tcase, moved_by_chance_none_is_forgotten, 0, 3);
    tcase_add_loop_test(tcase, a_clearance_is_on_the_side_of_the_guards, 0, 3);
    tcase_add_test(tcase, axes_lead_to_a_lone_one_and_back);
    tcase_add_test(tcase, axes_stay_that_would_not_be_clear);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
