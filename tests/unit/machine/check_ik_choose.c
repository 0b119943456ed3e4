/* ik_choose: travel and the choice of a solution. */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "machine/ik_choose.h"

START_TEST(travel_and_choice)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    const double from[2] = {0, 0};
    double q[2];
    int over;
    struct vec3 axis = vec(sin(0.6), 0, cos(0.6)); /* A 0.6 C 90 or A -0.6 C -90 */
    ck_assert_int_eq(ik_choose(&chain, axis, from, false, -1, q, &over), 0);
    chain.rotary[1].min = -1.9;
    chain.rotary[1].max = 0.5;
    ck_assert_int_eq(ik_choose(&chain, axis, from, false, -1, q, &over), 0);
    ck_assert_double_eq_tol(q[1], -0.6, 1e-12);
    ck_assert_double_eq_tol(q[0], -PI / 2, 1e-12);

    /* nearest to where it stands, by whole turns */
    const double wound[2] = {-20 * PI, -0.5};
    ck_assert_int_eq(ik_choose(&chain, axis, wound, false, -1, q, &over), 0);
    ck_assert_double_eq_tol(q[0], -20 * PI - PI / 2, 1e-9);
    chain.rotary[0].min = -4 * PI;
    chain.rotary[0].max = 4 * PI;
    ck_assert_int_eq(ik_choose(&chain, axis, wound, false, -1, q, &over), 0);
    ck_assert_double_eq_tol(q[0], -2.5 * PI, 1e-9);

    /* free at the singular direction: it stays */
    const double turned[2] = {1.25, 0.1};
    ck_assert_int_eq(ik_choose(&chain, vec(0, 0, 1), turned, true, -1, q, &over), 0);
    ck_assert_double_eq(q[0], 1.25);
    ck_assert_double_eq_tol(q[1], 0, 1e-12);

    /* none */
    chain.rotary[1].min = -0.5;
    ck_assert_int_eq(ik_choose(&chain, axis, from, false, -1, q, &over), -1);
    ck_assert_int_eq(over, 1);
}
END_TEST

/* Over the singular direction: with the tool in the cut the tilt goes through zero, the smallest
 * move of the master alone would spin the other axis by half a turn. */
START_TEST(over_the_pole)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    const double from[2] = {0, -0.02};
    const double beyond[2] = {0, 0.02};
    struct vec3 axis = chain_axis(&chain, beyond);
    double q[2];
    int over;
    ck_assert_int_eq(ik_choose(&chain, axis, from, true, -1, q, &over), 0);
    ck_assert_double_eq_tol(q[0], 0, 1e-9);
    ck_assert_double_eq_tol(q[1], 0.02, 1e-9);
    ck_assert_int_eq(ik_choose(&chain, axis, from, false, -1, q, &over), 0);
    ck_assert_double_eq_tol(q[1], -0.02, 1e-9);
}
END_TEST

/* The angles may be chosen in the very place where those before stand: several turns from zero, on
 * both sides of it.  What is chosen brings the tool there, by no more than half a turn. */
START_TEST(chosen_in_place)
{
    struct kinematic_chain chain = chain_of(_i);
    seed = 5;
    for (int i = 0; i < 20000; i++) {
        struct vec3 axis = random_unit();
        const double from[2] = {40 * chance() - 20, 40 * chance() - 20};
        double beside[2], place[2] = {from[0], from[1]};
        int over, over_in_place;
        int result = ik_choose(&chain, axis, from, true, -1, beside, &over);
        ck_assert_int_eq(ik_choose(&chain, axis, place, true, -1, place, &over_in_place), result);
        if (result != 0)
            continue;
        ck_assert(place[0] == beside[0] && place[1] == beside[1]);
        ck_assert_double_lt(vec_distance(chain_axis(&chain, place), axis), 1e-9);
        ck_assert(fabs(place[0] - from[0]) < PI + 1e-9 && fabs(place[1] - from[1]) < PI + 1e-9);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ik_choose");
    TCase *tests = tcase_create("choices");

    tcase_add_test(tests, travel_and_choice);
    tcase_add_test(tests, over_the_pole);
    tcase_add_loop_test(tests, chosen_in_place, 0, KINDS);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
