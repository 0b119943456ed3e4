/* ik_near: the quick way to the next angles, against the angles themselves. */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "machine/ik_choose.h"
#include "machine/ik_near.h"

/* From one direction to the next, small steps and turned about axes in no plane; cosines and sines
 * with it. */
START_TEST(beside_the_last)
{
    int found = 0, others = 0;
    seed = 70;
    for (int i = 0; i < 300; i++) {
        struct kinematic_chain chain = chain_of(i % KINDS);
        if (i % 4 == 3) /* three axes in no plane */
            chain.rotary[1].axis = vec_unit(vec(0.1 * chance(), 1, chance() - 0.5));
        if (i % 4 == 3)
            chain.tool = vec_unit(vec(chance() - 0.5, 0.2, 1));
        struct ik_near_table ways = ik_near_table(&chain);
        double from[2] = {6 * chance() - 3, 6 * chance() - 3}, q[2], by[2] = {0};
        struct turned turned = chain_turned(&chain, from);
        for (int k = 0; k < 100; k++) {
            const double next[2] = {from[0] + 0.1 * chance() * chance() - 0.03,
                                    from[1] + 0.1 * chance() * chance() - 0.03};
            struct vec3 axis = chain_axis(&chain, next);
            if (!ik_near(&ways, axis, from, &turned, q, &turned))
                break;
            found++;
            ck_assert_double_lt(vec_distance(chain_axis(&chain, q), axis), 1e-11);
            /* at the edge of what is in reach the other solution may be as near, or nearer */
            double other = fmax(fabs(q[0] - next[0]), fabs(q[1] - next[1]));
            if (other > 1e-11 &&
                ik_most_turn(&chain, q, from) <= ik_most_turn(&chain, next, from)) {
                others++;
                break;
            }
            for (int j = 0; j < 2; j++) {
                ck_assert_double_lt(fabs(q[j] - next[j]), 1e-11);
                ck_assert_double_lt(fabs(turned.cosine[j] - cos(q[j])), 1e-12);
                ck_assert_double_lt(fabs(turned.sine[j] - sin(q[j])), 1e-12);
                from[j] = RADIANS(round(1000 * DEGREES(q[j])) / 1000); /* as printed */
                by[j] = from[j] - q[j];
            }
            turned = ik_turned_on(&turned, by);
            ck_assert_double_lt(
                vec_distance(chain_axis_of(&chain, &turned), chain_axis(&chain, from)), 1e-12);
            ck_assert_double_lt(
                vec_distance(ik_near_axis(&ways, &turned), chain_axis(&chain, from)), 1e-12);
        }
    }
    ck_assert_int_gt(found, 15000);
    ck_assert_int_lt(others, 10);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ik_near");
    TCase *tests = tcase_create("places");

    tcase_add_test(tests, beside_the_last);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
