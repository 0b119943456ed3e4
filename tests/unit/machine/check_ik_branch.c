/* ik_branch: the states of a chain are all the angles that have a direction within the travel, each
 * once; an end of the travel on the way is met where arithmetic says. */
#include <check.h>
#include <stdlib.h>

#include "machine/ik_branch.h"

static struct kinematic_chain table_ac(double a_min, double a_max, double c_min, double c_max)
{
    return (struct kinematic_chain){
        .n = 2,
        .master = 1,
        .tool = {0, 0, 1},
        .rotary = {{{0, 0, 1}, {0, 0, 0}, true, RADIANS(c_min), RADIANS(c_max), 0},
                   {{1, 0, 0}, {0, 0, 0}, true, RADIANS(a_min), RADIANS(a_max), 0}}};
}

static struct vec3 leaning(double tilt, double turn)
{
    return vec(sin(tilt) * sin(turn), -sin(tilt) * cos(turn), cos(tilt));
}

/* ahead: a direction, NULL: none. */
static struct ik_branch_target target_of(const struct kinematic_chain *chain, double cone,
                                         struct vec3 near, struct vec3 axis,
                                         const struct vec3 *ahead)
{
    struct chain_solutions found = chain_angles(chain, axis), then = {0};
    if (ahead)
        then = chain_angles(chain, *ahead);
    return ik_branch_target(chain, cone, near, axis, &found, ahead ? &then : NULL);
}

/* For both solutions every whole turn within the travel is a state of its own, whose angles have
 * the direction; what is outside of it is none. */
START_TEST(states)
{
    static const double ends[][2] = {{-180, 180}, {-360, 360}, {0, 360}, {-540, 900}, {-10, 400}};
    const double from[ROTARY_MAX] = {0};
    for (size_t e = 0; e < sizeof ends / sizeof *ends; e++) {
        struct kinematic_chain chain = table_ac(-120, 120, ends[e][0], ends[e][1]);
        struct ik_branches s = ik_branches(&chain);
        for (int i = 0; i < 24; i++) {
            struct vec3 up = vec(0, 0, 1), axis = leaning(0.7, 0.1 + PI * i / 12);
            struct ik_branch_target t = target_of(&chain, 0.01, up, axis, NULL);
            int within = 0, truth = 0;
            for (int state = 0; state < s.n; state++) {
                double q[ROTARY_MAX];
                ik_branch_angles(&s, &t, state, from, q);
                ck_assert_double_le(vec_angle(chain_axis(&chain, q), axis), 1e-9);
                int k = state < s.n / 2 ? 0 : 1;
                int at = ik_branch_at(&s, k, q, t.found.q[k]);
                ck_assert_int_eq(at, ik_branch_within(&chain, q) ? state : -1);
                within += at == state;
            }
            for (int k = 0; k < 2; k++) /* whole turns of C whose angle is within */
                for (int turns = -5; turns <= 5; turns++) {
                    double c = t.found.q[k][0] + 2 * PI * turns;
                    truth += c >= RADIANS(ends[e][0]) && c <= RADIANS(ends[e][1]);
                }
            ck_assert_int_eq(within, truth);
        }
    }
}
END_TEST

/* An axis without end turns the nearest way. */
START_TEST(endless)
{
    struct kinematic_chain chain = table_ac(-120, 120, -1e6, 1e6);
    struct ik_branches s = ik_branches(&chain);
    ck_assert(s.range[0].endless && !s.range[1].endless);
    for (int i = 0; i < 40; i++) {
        double from[ROTARY_MAX] = {0.37 * i * i, 0.7}, q[ROTARY_MAX];
        struct ik_branch_target t = target_of(&chain, 0.01, vec(0, 0, 1), leaning(0.7, i), NULL);
        for (int state = 0; state < s.n; state++) {
            ik_branch_angles(&s, &t, state, from, q);
            ck_assert_double_le(fabs(q[0] - from[0]), PI + 1e-9);
        }
    }
}
END_TEST

/* From a to b in C, with an end at 100 degrees: (100 - a) / (b - a) of the way. */
START_TEST(ends)
{
    struct kinematic_chain chain = table_ac(-120, 120, -200, 100);
    static const double way[][2] = {{80, 110}, {99, 101}, {110, 90}, {50, 90}, {-170, -130}};
    for (size_t i = 0; i < sizeof way / sizeof *way; i++) {
        double a = way[i][0], b = way[i][1], share, truth = (100 - a) / (b - a);
        struct chain_solutions from = chain_angles(&chain, leaning(0.7, RADIANS(a)));
        struct chain_solutions to = chain_angles(&chain, leaning(0.7, RADIANS(b)));
        /* the lower end, -200, is 160 a turn on */
        bool meets = truth > 0 && truth < 1, found = false;
        for (int k = 0; k < from.n; k++) {
            if (fabs(remainder(from.q[k][0] - RADIANS(a), 2 * PI)) > 1e-6)
                continue;
            found = true;
            ck_assert_int_eq(ik_branch_end(&chain, &from, &to, k, &share), meets);
            ck_assert_double_eq_tol(share, meets ? truth : 1, 1e-9);
        }
        ck_assert(found);
    }
}
END_TEST

/* Where the first axis is free it stays, or turns to where it will be needed; near there the
 * direction changes in small steps. */
START_TEST(free_axis)
{
    struct kinematic_chain chain = table_ac(-120, 120, -360, 360);
    struct ik_branches s = ik_branches(&chain);
    struct vec3 up = vec(0, 0, 1), ahead = leaning(0.5, 1.1);
    const double from[ROTARY_MAX] = {0.8, 0};
    struct ik_branch_target stays = target_of(&chain, 0.01, leaning(0.5, 0.8), up, &ahead);
    struct ik_branch_target turns = target_of(&chain, 0.01, up, up, &ahead);
    bool kept = false, turned = false;
    ck_assert(stays.stays && !turns.stays && turns.loose);
    for (int state = 0; state < s.n; state++) {
        double q[ROTARY_MAX];
        ik_branch_angles(&s, &stays, state, from, q);
        kept = kept || fabs(q[0] - 0.8) < 1e-9;
        ik_branch_angles(&s, &turns, state, from, q);
        turned = turned || fabs(q[0] - 1.1) < 1e-9;
    }
    ck_assert(kept && turned);
    ck_assert(!target_of(&chain, 0.01, leaning(0.5, 0.8), leaning(0.5, 0.9), NULL).loose);
    ck_assert(target_of(&chain, 0.1, leaning(0.05, 0.8), leaning(0.05, 2), NULL).loose);
    ck_assert_double_lt(ik_branch_step(&chain, leaning(0.01, 1)), 0.004);
    ck_assert_double_ge(ik_branch_step(&chain, leaning(1, 1)), 0.03);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ik_branch");
    TCase *tests = tcase_create("ik_branch");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, states);
    tcase_add_test(tests, endless);
    tcase_add_test(tests, ends);
    tcase_add_test(tests, free_axis);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
