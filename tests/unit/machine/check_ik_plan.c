/*
 * ik_plan: turns back along spirals are as few as arithmetic allows, turns back and way on random
 * passes are those of an exhaustive search, angles stay in the travel and have the directions, and
 * what cannot be is refused.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "chains.h"
#include "machine/ik_plan.h"
#include "turnsearch.h"

enum { EACH = 72 }; /* places of one turn */

static struct kinematic_chain table_ac(double a_min, double a_max, double c_min, double c_max)
{
    return (struct kinematic_chain){
        .n = 2,
        .master = 1,
        .tool = {0, 0, 1},
        .rotary = {{{0, 0, 1}, {0, 0, 0}, true, RADIANS(c_min), RADIANS(c_max), 0},
                   {{1, 0, 0}, {0, 0, 0}, true, RADIANS(a_min), RADIANS(a_max), 0}}};
}

/* So many turns of a direction at this tilt. */
static struct ik_plan_place *spiral(int turns, double tilt, size_t *n)
{
    *n = (size_t)(turns * EACH) + 1;
    struct ik_plan_place *place = mem_alloc(*n, sizeof *place);
    for (size_t i = 0; i < *n; i++) {
        double w = 2 * PI * (double)i / EACH, s = sin(RADIANS(tilt));
        place[i].axis = vec(s * sin(w), -s * cos(w), cos(RADIANS(tilt))); /* C is w, A the tilt */
        place[i].may_turn = true;
    }
    return place;
}

static int plan_of(const struct kinematic_chain *chain, struct ik_plan_place *place, size_t n)
{
    const double from[ROTARY_MAX] = {0};
    struct ik_plan plan = {.chain = chain};
    struct ik_plan_cost cost;
    return ik_plan_make(&plan, place, n, from, &cost) == 0 ? (int)cost.turns : -1;
}

static void check_places(const struct kinematic_chain *chain, const struct ik_plan_place *place,
                         size_t n, int turns)
{
    int counted = 0;
    for (size_t i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++) {
            ck_assert_double_ge(place[i].q[k], chain->rotary[k].min - 1e-9);
            ck_assert_double_le(place[i].q[k], chain->rotary[k].max + 1e-9);
            if (i > 0 && !place[i - 1].turn)
                ck_assert_double_lt(fabs(place[i].q[k] - place[i - 1].q[k]), PI / 2);
        }
        ck_assert_double_lt(vec_angle(chain_axis(chain, place[i].q), place[i].axis), 1e-9);
        counted += place[i].turn;
    }
    ck_assert_int_eq(counted, turns);
}

static const struct {
    int turns;
    double tilt, a_min, a_max, c_min, c_max;
    int back;
} wound[] = {
    {5, 50, -30, 120, -360, 360, 2}, /* -360 to 360, twice back by 720, and half of it */
    {5, 50, -120, 120, -360, 360, 2},
    {3, 20, -30, 120, -360, 360, 1},
    {2, 20, -30, 120, -360, 360, 0}, /* just so */
    {5, 50, -60, 120, -900, 900, 0}, /* just so, with A -50 and C a half turn on */
    {5, 50, -30, 120, -900, 900, 1}, /* A 50 alone starts at C -720 */
    {5, 50, -30, 120, -99999, 99999, 0},
    {5, 50, -30, 120, -200, 210, 5}, /* 0 to 210, then 360 each time */
    {1, 50, -30, 120, -190, 190, 1},
    {4, 110, -120, 30, -720, 0, 2}, /* A -110 starts at C -540 */
};

START_TEST(fewest_turns)
{
    struct kinematic_chain chain =
        table_ac(wound[_i].a_min, wound[_i].a_max, wound[_i].c_min, wound[_i].c_max);
    size_t n;
    struct ik_plan_place *place = spiral(wound[_i].turns, wound[_i].tilt, &n);
    int turns = plan_of(&chain, place, n);
    ck_assert_int_eq(turns, wound[_i].back);
    check_places(&chain, place, n, turns);
    free(place);
}
END_TEST

START_TEST(no_way)
{
    struct kinematic_chain chain = table_ac(-30, 40, -360, 360),
                           narrow = table_ac(-60, 60, -80, 80);
    size_t n;
    struct ik_plan_place *place = spiral(1, 50, &n);
    ck_assert_int_eq(plan_of(&chain, place, n), -1);
    ck_assert_int_eq(plan_of(&narrow, place, n), -1);
    free(place);
}
END_TEST

/* Straight over the pole: A goes on through zero where it may, else there is one turn back. */
START_TEST(over_the_pole)
{
    struct ik_plan_place place[61];
    for (int i = 0; i < 61; i++) {
        double w = RADIANS(i - 30);
        place[i] = (struct ik_plan_place){.axis = {0, sin(w), cos(w)}, .may_turn = true};
    }
    struct kinematic_chain both = table_ac(-120, 120, -360, 360),
                           one = table_ac(-5, 120, -360, 360);
    ck_assert_int_eq(plan_of(&both, place, 61), 0);
    check_places(&both, place, 61, 0);
    for (int i = 1; i < 61; i++)
        ck_assert_double_eq_tol(place[i].q[0], place[0].q[0], 1e-9);
    ck_assert_int_eq(plan_of(&one, place, 61), 1);
    check_places(&one, place, 61, 1);
}
END_TEST

/* ---- an exhaustive search */

enum { PLACES = 7 };

/* All ways from the angles q at place j on; by block, or turned back at j and then by block. */
static void try_all(const struct kinematic_chain *chain, const struct angles all[], int j,
                    const double q[], unsigned turns, double way, struct ik_plan_cost *least)
{
    if (turns > least->turns || (turns == least->turns && way >= least->travel))
        return;
    if (j + 1 == PLACES) {
        *least = (struct ik_plan_cost){turns, way};
        return;
    }
    for (int t = -1; t < all[j].n; t++) {
        const double *from = t < 0 ? q : all[j].q[t];
        for (int k = 0; k < all[j + 1].n; k++) {
            const double *to = all[j + 1].q[k];
            if (fabs(to[0] - from[0]) < PI / 2 && fabs(to[1] - from[1]) < PI / 2)
                try_all(chain, all, j + 1, to, turns + (t >= 0),
                        way + angles_way(chain, q, from) + angles_way(chain, from, to), least);
        }
    }
}

/* A machine with narrow travel, and a pass of a few directions. */
static struct kinematic_chain narrow_chain(int i)
{
    struct kinematic_chain chain = chain_of(i % KINDS);
    for (int k = 0; k < 2; k++) {
        chain.rotary[k].min = -(0.3 + 4 * chance());
        chain.rotary[k].max = 0.3 + 4 * chance();
        chain.rotary[k].rapid = i % 4 == 0 ? 0 : 50 + 200 * chance();
    }
    return chain;
}

static void random_pass(struct ik_plan_place place[])
{
    double tilt = 0.15 + chance(), turn = 2 * PI * chance();
    double step = 0.15 * chance() - 0.05, wind = 1.3 * (2 * chance() - 1);
    for (int j = 0; j < PLACES; j++) {
        double t = fmax(0.1, tilt + step * j), c = turn + wind * j;
        place[j] = (struct ik_plan_place){.axis = {sin(t) * sin(c), -sin(t) * cos(c), cos(t)},
                                          .may_turn = true};
    }
}

START_TEST(as_by_trying)
{
    int found = 0, back = 0;
    seed = 90;
    for (int i = 0; i < 600; i++) {
        struct kinematic_chain chain = narrow_chain(i);
        struct ik_plan plan = {.chain = &chain};
        struct ik_plan_place place[PLACES];
        struct ik_plan_cost cost, least = {99, HUGE_VAL};
        struct angles all[PLACES];
        const double from[2] = {4 * chance() - 2, 2 * chance() - 1};
        random_pass(place);
        for (int j = 0; j < PLACES; j++)
            all[j] = angles_all(&chain, place[j].axis);
        for (int k = 0; k < all[0].n; k++)
            try_all(&chain, all, 0, all[0].q[k], 0, angles_way(&chain, from, all[0].q[k]), &least);
        int result = ik_plan_make(&plan, place, PLACES, from, &cost);
        ck_assert_int_eq(result, least.turns < 99 ? 0 : -1);
        if (result != 0)
            continue;
        ck_assert_uint_eq(cost.turns, least.turns);
        ck_assert_double_eq_tol(cost.travel, least.travel, 1e-6);
        check_places(&chain, place, PLACES, (int)cost.turns);
        found++;
        back += cost.turns > 0;
    }
    ck_assert_int_gt(found, 200);
    ck_assert_int_gt(back, 60);
}
END_TEST

/* Half-way along the block the axis is within 0.1 degrees of where it is meant to be. */
static bool near_at_the_middle(const void *with, size_t from, size_t to, const double q0[],
                               const double q1[])
{
    const struct kinematic_chain *chain = with;
    const double half[] = {(q0[0] + q1[0]) / 2, (q0[1] + q1[1]) / 2};
    struct vec3 meant = vec_unit(vec_add(chain_axis(chain, q0), chain_axis(chain, q1)));
    ck_assert_uint_eq(to - from, 400);
    return vec_angle(chain_axis(chain, half), meant) < RADIANS(0.1);
}

/* Beside the singular direction a block may lead past it, to the other solution: half a turn of the
 * first axis is saved, and where the second one may not follow it is turned after all. */
START_TEST(past_the_pole)
{
    struct kinematic_chain both = table_ac(-120, 120, -99999, 99999),
                           one = table_ac(-2, 120, -99999, 99999);
    const double from[ROTARY_MAX] = {0, 0};
    struct ik_plan_cost cost;
    struct ik_plan_place place[401];
    for (int i = 0; i <= 400; i++) {
        struct vec3 at = vec(RADIANS(0.05 * (i - 200)), RADIANS(0.03), 1);
        place[i] = (struct ik_plan_place){.axis = vec_unit(at), .may_turn = i == 400};
    }
    place[400].crossing = 400;
    struct ik_plan plan = {.chain = &both, .may_cross = near_at_the_middle, .with = &both};
    ck_assert_int_eq(ik_plan_make(&plan, place, 401, from, &cost), 0);
    ck_assert_uint_eq(cost.turns, 0);
    ck_assert_double_eq_tol(DEGREES(cost.travel), 10 + 90 + 20, 1);
    ck_assert(place[1].passed && place[399].passed && !place[400].passed && !place[0].passed);
    ck_assert_double_eq_tol(fabs(DEGREES(place[400].q[1] - place[0].q[1])), 20, 0.3);
    place[400].crossing = 0;
    ck_assert_int_eq(ik_plan_make(&plan, place, 401, from, &cost), 0);
    ck_assert_double_eq_tol(DEGREES(cost.travel), 10 + 90 + 20 + 180, 1);
    place[400].crossing = 400;
    plan.chain = &one;
    ck_assert_int_eq(ik_plan_make(&plan, place, 401, from, &cost), 0);
    ck_assert_double_eq_tol(DEGREES(cost.travel), 10 + 90 + 20 + 180, 1);
    ck_assert(!place[1].passed);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ik_plan");
    TCase *tests = tcase_create("plans");

    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, fewest_turns, 0, (int)(sizeof wound / sizeof *wound));
    tcase_add_test(tests, no_way);
    tcase_add_test(tests, over_the_pole);
    tcase_add_test(tests, as_by_trying);
    tcase_add_test(tests, past_the_pole);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
