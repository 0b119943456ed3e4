/* ik_bound: never more than the travel that ik_plan finds, with ends of travel or without, over all
 * places or a few of them; the same where nothing but the two solutions bounds the way. */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "machine/ik_bound.h"
#include "machine/ik_choose.h"
#include "machine/ik_plan.h"

enum { PLACES = 400, EACH = 8 };

static double plan_travel(const struct kinematic_chain *chain, const struct vec3 axis[],
                          const double from[])
{
    static struct ik_plan_place place[PLACES];
    struct ik_plan plan = {.chain = chain};
    struct ik_plan_cost cost;
    for (int i = 0; i < PLACES; i++)
        place[i] = (struct ik_plan_place){.axis = axis[i]};
    return ik_plan_make(&plan, place, PLACES, from, &cost) == 0 && cost.turns == 0 ? cost.travel
                                                                                   : HUGE_VAL;
}

static double bound_travel(const struct kinematic_chain *chain, const struct vec3 axis[],
                           const double from[], int step)
{
    struct ik_near_table near = ik_near_table(chain);
    struct ik_bound bound = ik_bound_from(&near, from);
    for (int i = 0; i < PLACES; i += step)
        ik_bound_to(&bound, axis[i]);
    return ik_bound_least(&bound);
}

/* Loops of random size about a random place beside the singular direction, past it or over it again
 * and again. */
static void random_pass(const struct kinematic_chain *chain, struct vec3 axis[])
{
    struct vec3 pole = chain->rotary[0].axis, x = vec_perpendicular(pole), y = vec_cross(pole, x);
    double wide = 0.1 + 0.3 * chance(), flat = 0.1 * chance(), aside = 0.06 + 0.1 * chance();
    double turns = 1 + 3 * chance();
    for (int i = 0; i < PLACES; i++) {
        double w = 2 * PI * turns * i / PLACES;
        axis[i] = vec_unit(vec_along(vec_along(pole, wide * sin(w), x), flat * cos(w) + aside, y));
    }
}

/* No step turns the first axis by more than a quarter: to change the solution, which turns it by
 * what is left of a half, is no shorter anywhere. */
static bool is_calm(const struct kinematic_chain *chain, const struct vec3 axis[])
{
    struct vec3 pole = chain->rotary[0].axis, last = vec_cross(pole, axis[0]);
    for (int i = 1; i < PLACES; i++) {
        struct vec3 next = vec_cross(pole, axis[i]);
        if (!(vec_dot(last, next) > 0))
            return false;
        last = next;
    }
    return true;
}

START_TEST(never_more)
{
    int calm = 0, same = 0, switched = 0;
    seed = 171;
    for (int i = 0; i < 300; i++) {
        static const int kind[] = {KIND_TABLE_AC, KIND_TABLE_BC, KIND_HEAD_TABLE, KIND_HEAD_HEAD};
        struct kinematic_chain chain = chain_of(kind[i % 4]);
        struct vec3 axis[PLACES];
        double from[ROTARY_MAX] = {6 * chance() - 3, chance() - 0.5};
        random_pass(&chain, axis);
        for (int ends = 0; ends < 2; ends++) {
            for (int k = 0; k < 2 && ends; k++) {
                chain.rotary[k].min = -1 - 5 * chance();
                chain.rotary[k].max = 1 + 5 * chance();
            }
            double travel = plan_travel(&chain, axis, from);
            double all = bound_travel(&chain, axis, from, 1);
            double few = bound_travel(&chain, axis, from, EACH);
            ck_assert_double_le(all, travel);
            ck_assert_double_le(few, all * (1 + 1e-9));
            ck_assert_double_gt(few, 0);
            bool alike = !ends && is_calm(&chain, axis);
            calm += alike;
            if (alike)
                ck_assert_double_ge(all, travel * (1 - 1e-6));
            same += ends && all > travel * (1 - 1e-6);
            switched += ends && travel < HUGE_VAL && all < travel * (1 - 1e-6);
        }
    }
    /* steps are 0.025 at most, 14 % of the loops have a side within half of that: 258 less 5 sigma
     */
    ck_assert_int_gt(calm, 228);
    ck_assert_int_gt(same, 20);
    ck_assert_int_gt(switched, 0);
}
END_TEST

/* Straight over the pole: the other solution costs nothing there, the same one half a turn. */
START_TEST(over_the_pole)
{
    struct kinematic_chain chain = chain_of(KIND_TABLE_AC);
    struct ik_near_table near = ik_near_table(&chain);
    struct vec3 x = vec(0, 1, 0), pole = chain.rotary[0].axis;
    double q[ROTARY_MAX];
    int over;
    struct vec3 first = vec_unit(vec_along(pole, -0.2, x));
    const double zero[ROTARY_MAX] = {0};
    ck_assert_int_eq(ik_choose(&chain, first, zero, true, -1, q, &over), 0);
    struct ik_bound bound = ik_bound_from(&near, q);
    for (int i = -20; i <= 20; i++)
        ik_bound_to(&bound, vec_unit(vec_along(pole, 0.01 * i, x)));
    ck_assert_double_eq_tol(ik_bound_least(&bound), 2 * atan(0.2) * ik_weight(&chain, 1), 1e-6);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ik_bound");
    TCase *tests = tcase_create("all");
    tcase_add_test(tests, never_more);
    tcase_add_test(tests, over_the_pole);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
