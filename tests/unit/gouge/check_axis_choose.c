/* axis_choose - the directions of nodes: the rule's where it is open and nothing is to be won, near
 * it where play lets the rotary axes rest, and what is open elsewhere. */
#include <check.h>
#include <stdlib.h>

#include "axis_bench.h"

static double level(int i)
{
    return 0 * i + 0.2;
}

static double flutter(int i)
{
    return 0.3 + 0.15 * (i / 4 % 2 ? 1 : -1);
}

static double travel_of(const struct nodes *nodes, bool rule)
{
    double travel = 0;

    for (size_t i = 1; i < nodes->n; i++) {
        const struct node *a = &nodes->item[i - 1], *b = a + 1;
        travel += rotary_travel(rule ? a->rule : a->axis, rule ? b->rule : b->axis);
    }
    return travel;
}

START_TEST(the_rule_stays)
{
    struct axis_bench b;

    axis_bench_begin(&b, 0, level);
    axis_bench_nodes(&b);
    axis_choose(&b.work, 0, b.work.nodes.n);
    for (size_t i = 0; i < b.work.nodes.n; i++) {
        ck_assert(b.work.nodes.item[i].by_rule);
        ck_assert_int_eq(b.work.nodes.item[i].begins, i == 0);
    }
    axis_bench_free(&b);
}
END_TEST

START_TEST(play_is_used)
{
    struct axis_bench b;

    axis_bench_begin(&b, RADIANS(15), flutter);
    axis_bench_nodes(&b);
    axis_choose(&b.work, 0, b.work.nodes.n);
    ck_assert_double_gt(travel_of(&b.work.nodes, true), 1);
    ck_assert_double_lt(travel_of(&b.work.nodes, false), 0.2);
    for (size_t i = 0; i < b.work.nodes.n; i++)
        ck_assert_double_le(vec_angle(b.work.nodes.item[i].axis, b.work.nodes.item[i].rule),
                            RADIANS(15));
    axis_bench_free(&b);
}
END_TEST

/* All that leans less than half a right angle is shut at some nodes. */
START_TEST(what_is_shut_is_left)
{
    struct axis_bench b;

    axis_bench_begin(&b, RADIANS(15), level);
    axis_bench_nodes(&b);
    for (size_t i = 6; i < 9; i++) {
        struct node *node = &b.work.nodes.item[i];
        node->rule_open = false;
        for (int j = 0; j < b.planner->grid.n; j++)
            if (b.planner->grid.at[j].z > cos(PI / 4))
                node->state[j] = ACCESS_BLOCKED;
    }
    axis_choose(&b.work, 0, b.work.nodes.n);
    for (size_t i = 6; i < 9; i++)
        ck_assert_double_gt(vec_angle(b.work.nodes.item[i].axis, vec(0, 0, 1)), PI / 4 - 1e-9);
    axis_bench_free(&b);
}
END_TEST

START_TEST(neighbours_are_near)
{
    struct axis_bench b;

    axis_bench_begin(&b, 0, level);
    const struct axis_planner *p = b.planner;
    for (int i = 0; i < p->grid.n; i += 7) {
        const struct neighbours *beside = &p->beside[i];
        ck_assert_int_ge(beside->n, 4);
        for (int k = 0; k < beside->n; k++) {
            struct vec3 to = p->grid.at[beside->index[k]];
            ck_assert_double_le(vec_angle(p->grid.at[i], to), 0.2301);
            ck_assert_double_ge(beside->travel[k] + 1e-6, vec_angle(p->grid.at[i], to) / 1.5);
        }
    }
    ck_assert_double_eq_tol(axis_choose_play(p), 0, 1e-12);
    axis_bench_free(&b);
    axis_bench_begin(&b, RADIANS(15), level);
    ck_assert_double_eq_tol(axis_choose_play(b.planner), RADIANS(14.4), 1e-12);
    axis_bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_choose");
    TCase *tests = tcase_create("axis_choose");

    tcase_add_test(tests, the_rule_stays);
    tcase_add_test(tests, play_is_used);
    tcase_add_test(tests, what_is_shut_is_left);
    tcase_add_test(tests, neighbours_are_near);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
