/*
 * post_travel: the way of the rotary axes over random groups, on machines of every kind, summed
 * here once more; and whether another way is shorter, by following both solutions from place to
 * place, or by the shortest of all ways that change between them.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "chains.h"
#include "planners.h"
#include "post/post_travel.h"

enum { PLACES = 240 };

/* Weighed by how much slower an axis is than the other one's: the slowest counts as it is. */
static double way_between(const struct kinematic_chain *chain, const double a[], const double b[])
{
    double slow = fmin(chain->rotary[0].rapid, chain->rotary[1].rapid), way = 0;
    for (int i = 0; i < 2; i++)
        way += fabs(b[i] - a[i]) * slow / chain->rotary[i].rapid;
    return way;
}

static void nearest_turn(const double from[], const double to[], double q[])
{
    for (int i = 0; i < 2; i++)
        q[i] = to[i] + 2 * PI * round((from[i] - to[i]) / (2 * PI));
}

/* A bench at q on a chain without ends, one axis up to four times as fast as the other. */
static void begin(struct bench *b, int kind, const double q[])
{
    bench_begin(b, kind, INTERPOLATE_ROTARY, vec(0, 0, 0), q);
    for (int i = 0; i < ROTARY_MAX; i++) {
        b->machine.chain.rotary[i].min = -100;
        b->machine.chain.rotary[i].max = 100;
        b->machine.chain.rotary[i].rapid = 1000 + 3000 * chance();
    }
}

static void end(struct bench *b)
{
    path_free(&b->path);
    bench_free(b);
}

/* The rapids lead to the first place, all others are cuts. */
static void path_through(struct bench *b, const struct vec3 axis[])
{
    for (int i = 0; i < PLACES; i++)
        path_add_point(&b->path, (struct pose){vec(0.1 * i, 0, 0), axis[i]}, i == 0);
}

/* Of both solutions at a place the one nearer to q goes to q: where they are apart, the same as
 * before. */
static void follow(const struct bench *b, struct vec3 axis, double q[])
{
    const struct kinematic_chain *chain = &b->machine.chain;
    struct chain_solutions found = chain_angles(chain, axis);
    double best[2] = {0}, least = HUGE_VAL;
    for (int k = 0; k < found.n; k++) {
        double at[2], most;
        nearest_turn(q, found.q[k], at);
        most = fmax(fabs(at[0] - q[0]), fabs(at[1] - q[1]));
        if (most >= least)
            continue;
        least = most;
        best[0] = at[0], best[1] = at[1];
    }
    ck_assert_double_le(vec_distance(bench_axis(b, best), axis), 1e-9);
    q[0] = best[0], q[1] = best[1];
}

/* From the start to solution k and on by it; the moves go to the plan where it is given. */
static double way_by(const struct bench *b, const double start[], const struct vec3 axis[], int k,
                     struct nc_plan *plan)
{
    const struct kinematic_chain *chain = &b->machine.chain;
    double q[2], way;
    struct chain_solutions found = chain_angles(chain, axis[0]);
    nearest_turn(start, found.q[k], q);
    way = way_between(chain, start, q);
    for (int i = 0; i < PLACES; i++) {
        const double from[2] = {q[0], q[1]};
        follow(b, axis[i], q);
        way += way_between(chain, from, q);
        if (plan)
            *array_push(&plan->move) =
                (struct nc_move){.kind = i ? NC_LINE : NC_RAPID, .q = {q[0], q[1]}};
    }
    return way;
}

/* The shortest of all that change between the solutions at any place. */
static double way_least(const struct bench *b, const double start[], const struct vec3 axis[])
{
    const struct kinematic_chain *chain = &b->machine.chain;
    double way[2], q[2][2];
    struct chain_solutions found = chain_angles(chain, axis[0]);
    for (int k = 0; k < 2; k++) {
        nearest_turn(start, found.q[k], q[k]);
        way[k] = way_between(chain, start, q[k]);
    }
    for (int i = 1; i < PLACES; i++) {
        double to[2][2] = {{0}}, sum[2] = {HUGE_VAL, HUGE_VAL};
        struct chain_solutions next = chain_angles(chain, axis[i]);
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 2; j++) {
                double at[2];
                nearest_turn(q[j], next.q[k], at);
                double more = way[j] + way_between(chain, q[j], at);
                if (more >= sum[k])
                    continue;
                sum[k] = more;
                to[k][0] = at[0], to[k][1] = at[1];
            }
        for (int k = 0; k < 2; k++) {
            way[k] = sum[k];
            q[k][0] = to[k][0], q[k][1] = to[k][1];
        }
    }
    return fmin(way[0], way[1]);
}

/* Up along the first axis. */
static struct vec3 pole_of(const struct kinematic_chain *chain)
{
    struct vec3 pole = chain->rotary[0].axis;
    return vec_dot(pole, chain->tool) < 0 ? vec_scale(-1, pole) : pole;
}

/* Around the direction of the first axis, off it by 0.3 to 0.8 radians. */
static void random_cone(const struct kinematic_chain *chain, struct vec3 axis[])
{
    struct vec3 pole = pole_of(chain), x = vec_perpendicular(pole), y = vec_cross(pole, x);
    double tilt = 0.4 + 0.3 * chance(), turn = 2 * PI * chance(), wind = 0.04 * (chance() - 0.5);
    double swing = chance(), lean = 0.1 * chance();
    for (int i = 0; i < PLACES; i++) {
        double t = tilt + lean * sin(0.05 * i), c = turn + wind * i + swing * sin(0.03 * i);
        struct vec3 across = vec_along(vec_scale(cos(c), x), sin(c), y);
        axis[i] = vec_unit(vec_along(vec_scale(cos(t), pole), sin(t), across));
    }
}

/* Past the direction of the first axis again and again. */
static void random_loops(const struct kinematic_chain *chain, struct vec3 axis[])
{
    struct vec3 pole = pole_of(chain), x = vec_perpendicular(pole), y = vec_cross(pole, x);
    double wide = 0.1 + 0.3 * chance(), flat = 0.1 * chance(), aside = 0.03 + 0.2 * chance();
    double turns = 0.3 + 2 * chance();
    for (int i = 0; i < PLACES; i++) {
        double w = 2 * PI * turns * i / PLACES;
        axis[i] = vec_unit(vec_along(vec_along(pole, wide * sin(w), x), flat * cos(w) + aside, y));
    }
}

/* ---- tests */

START_TEST(a_hundredth_is_worth_it)
{
    ck_assert(post_travel_saves(0.9899, 1));
    ck_assert(!post_travel_saves(0.9901, 1));
    ck_assert(post_travel_saves(4.949, 5));
    ck_assert(!post_travel_saves(4.951, 5));
    ck_assert(!post_travel_saves(0, 0));
}
END_TEST

/* Moves before the start and what does not move count for nothing. */
START_TEST(moves_since)
{
    struct bench b;
    const double zero[2] = {0};
    seed = 1500 + (uint64_t)_i;
    begin(&b, _i, zero);
    double q[2] = {0.3, -0.2}, way = 0;
    *array_push(&b.plan.move) = (struct nc_move){.kind = NC_LINE, .q = {2, 2}};
    *array_push(&b.plan.move) = (struct nc_move){.kind = NC_LINE, .q = {0.3, -0.2}};
    const struct nc_group_start since = {2, {0.3, -0.2}};
    ck_assert(post_travel_since(&b.planner, &since) == 0);
    for (int i = 0; i < 50; i++) {
        static const enum nc_kind kinds[] = {NC_RAPID, NC_LINE, NC_PASS,  NC_ARC, NC_SPLINE,
                                             NC_TEXT,  NC_HOLE, NC_PLANE, NC_TOOL};
        enum nc_kind kind = kinds[i % 9];
        double to[2] = {4 * chance() - 2, 2 * chance() - 1};
        *array_push(&b.plan.move) = (struct nc_move){.kind = kind, .q = {to[0], to[1]}};
        if (kind == NC_PASS || kind == NC_TEXT || kind == NC_TOOL || kind == NC_PLANE)
            continue;
        way += way_between(&b.machine.chain, q, to);
        q[0] = to[0], q[1] = to[1];
    }
    ck_assert_double_eq_tol(post_travel_since(&b.planner, &since), way, 1e-12 * way);
    end(&b);
}
END_TEST

/* A vector says no angle, and one axis has one way. */
START_TEST(no_other_way)
{
    struct bench b;
    struct vec3 axis[PLACES];
    const double start[2] = {0};
    seed = 1510;
    begin(&b, KIND_NUTATING_HEAD, start);
    random_cone(&b.machine.chain, axis);
    path_through(&b, axis);
    /* a detour that saves much */
    *array_push(&b.plan.move) = (struct nc_move){.kind = NC_LINE, .q = {90, 90}};
    const struct nc_group_start since = {0, {0, 0}};
    ck_assert(!post_travel_is_least(&b.planner, &since, 0, PLACES));
    b.planner.follow.mode = INTERPOLATE_VECTOR;
    ck_assert(post_travel_is_least(&b.planner, &since, 0, PLACES));
    b.planner.follow.mode = INTERPOLATE_ROTARY;
    b.machine.chain.n = 1;
    ck_assert(post_travel_is_least(&b.planner, &since, 0, PLACES));
    end(&b);
}
END_TEST

/* Two nutating axes, whose solutions turn differently: the planned one is least unless the other
 * saves a hundredth; with a doubt it is looked for anyway. */
START_TEST(solutions_that_turn_differently)
{
    int least = 0, other = 0;
    seed = 1520 + (uint64_t)_i;
    for (int i = 0; i < 200; i++) {
        struct bench b;
        struct vec3 axis[PLACES];
        const double start[2] = {3 * chance() - 1.5, chance() - 0.5};
        const struct nc_group_start since = {0, {start[0], start[1]}};
        begin(&b, _i, start);
        random_cone(&b.machine.chain, axis);
        path_through(&b, axis);
        int planned = chance() < 0.5;
        double way = way_by(&b, start, axis, planned, &b.plan);
        double best = fmin(way, way_by(&b, start, axis, !planned, NULL));
        ck_assert_double_eq_tol(post_travel_since(&b.planner, &since), way, 1e-9);
        bool is_least = post_travel_is_least(&b.planner, &since, 0, PLACES);
        if (fabs(best / way - 0.99) > 1e-6)
            ck_assert_int_eq(is_least, best > 0.99 * way);
        b.planner.doubtful = true;
        ck_assert(!post_travel_is_least(&b.planner, &since, 0, PLACES));
        least += is_least;
        other += !is_least;
        end(&b);
    }
    ck_assert_int_ge(least, 20);
    ck_assert_int_ge(other, 20);
}
END_TEST

/* Axes at right angles: without a doubt the nearest way is taken for least; with one by the
 * shortest of all ways. */
START_TEST(solutions_that_turn_alike)
{
    int least = 0, other = 0;
    seed = 1530 + (uint64_t)_i;
    for (int i = 0; i < 200; i++) {
        struct bench b;
        struct vec3 axis[PLACES];
        const double start[2] = {3 * chance() - 1.5, chance() - 0.5};
        const struct nc_group_start since = {0, {start[0], start[1]}};
        begin(&b, _i, start);
        random_loops(&b.machine.chain, axis);
        path_through(&b, axis);
        double way = way_by(&b, start, axis, i % 2, &b.plan);
        double best = way_least(&b, start, axis);
        ck_assert_double_le(best, way * (1 + 1e-12));
        ck_assert(post_travel_is_least(&b.planner, &since, 0, PLACES));
        b.planner.doubtful = true;
        bool is_least = post_travel_is_least(&b.planner, &since, 0, PLACES);
        if (fabs(best / way - 0.99) > 1e-4)
            ck_assert_int_eq(is_least, best > 0.99 * way);
        least += is_least;
        other += !is_least;
        end(&b);
    }
    ck_assert_int_ge(least, 20);
    ck_assert_int_ge(other, 20);
}
END_TEST

/* The tool leans in one plane from the start on: whatever the doubt, no way is shorter. */
START_TEST(a_first_axis_that_stays)
{
    for (int kind = KIND_TABLE_AC; kind <= KIND_HEAD_HEAD; kind++) {
        struct bench b;
        struct vec3 axis[PLACES];
        const double start[2] = {0.7, 0.3};
        const struct nc_group_start since = {0, {0.7, 0.3}};
        seed = 1540 + (uint64_t)kind;
        begin(&b, kind, start);
        for (int i = 0; i < PLACES; i++) {
            double q[2] = {0.7, 0.3 + 0.002 * i};
            axis[i] = bench_axis(&b, q);
            *array_push(&b.plan.move) =
                (struct nc_move){.kind = i ? NC_LINE : NC_RAPID, .q = {q[0], q[1]}};
        }
        path_through(&b, axis);
        b.planner.doubtful = true;
        ck_assert_double_ge(way_least(&b, start, axis),
                            (1 - 1e-9) * post_travel_since(&b.planner, &since));
        ck_assert(post_travel_is_least(&b.planner, &since, 0, PLACES));
        end(&b);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_travel");
    TCase *tests = tcase_create("post_travel");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_hundredth_is_worth_it);
    tcase_add_loop_test(tests, moves_since, 0, KINDS);
    tcase_add_test(tests, no_other_way);
    tcase_add_loop_test(tests, solutions_that_turn_differently, KIND_NUTATING_HEAD, KINDS);
    tcase_add_loop_test(tests, solutions_that_turn_alike, KIND_TABLE_AC, KIND_NUTATING_HEAD);
    tcase_add_test(tests, a_first_axis_that_stays);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
