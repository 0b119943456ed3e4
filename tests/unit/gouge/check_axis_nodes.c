/* axis_nodes - nodes evenly along a pass, once in each place, with what is open there; and one
 * where the axis goes through the pole. */
#include <check.h>
#include <stdlib.h>

#include "axis_bench.h"

static double level(int i)
{
    return 0 * i + 0.2;
}

static double through(int i)
{
    return 0.02 * (i - 25.3);
}

START_TEST(evenly_and_open)
{
    struct axis_bench b;

    axis_bench_begin(&b, 0, level);
    axis_bench_nodes(&b);
    const struct nodes *nodes = &b.work.nodes;
    ck_assert_uint_eq(nodes->n, 16); /* 30 mm in steps of no more than 2 */
    for (size_t i = 0; i < nodes->n; i++) {
        const struct node *node = &nodes->item[i];
        ck_assert_double_eq_tol(node->along, 2 * (double)i, 1e-9);
        ck_assert_double_eq_tol(node->ball.x, 2 * (double)i, 1e-9);
        ck_assert(node->rule_open && axis_nodes_has_axis(node));
        ck_assert_int_gt(node->open, 100);
    }
    struct run_point p = axis_nodes_place(&b.work, 3, 1.25);
    ck_assert_double_eq_tol(p.ball.x, 1.25, 1e-12);
    ck_assert_double_eq_tol(p.contact.x, 1.25, 1e-12);
    ck_assert(run_point_touches(&p));
    axis_bench_free(&b);
}
END_TEST

START_TEST(one_in_a_place)
{
    struct axis_bench b;

    axis_bench_begin(&b, 0, level);
    axis_bench_nodes(&b);
    axis_nodes_add_strict(&b.work, 20, 4);
    axis_nodes_add_strict(&b.work, 20, 4.6);
    axis_nodes_sort(&b.work.nodes);
    const struct nodes *nodes = &b.work.nodes;
    ck_assert_uint_eq(nodes->n, 17);
    ck_assert(nodes->item[2].strict && nodes->item[3].strict);
    ck_assert_double_eq_tol(nodes->item[3].along, 4.6, 1e-12);
    ck_assert(!nodes->item[1].strict && !nodes->item[4].strict);
    axis_bench_free(&b);
}
END_TEST

START_TEST(at_the_pole)
{
    struct axis_bench b;

    axis_bench_begin(&b, RADIANS(15), through);
    axis_bench_nodes(&b);
    struct nodes *nodes = &b.work.nodes;
    for (size_t i = 0; i < nodes->n; i++) {
        struct node *node = &nodes->item[i];
        node->axis = node->rule;
        node->angles = (struct rotary_angles){through((int)(node->along * 2 + 0.5)), 0};
    }
    axis_nodes_add_poles(&b.work);
    size_t poles = 0;
    for (size_t i = 0; i < nodes->n; i++) {
        if (!nodes->item[i].pole)
            continue;
        poles++;
        ck_assert_double_eq_tol(nodes->item[i].along, 12.65, 1e-6);
        ck_assert_double_eq_tol(nodes->item[i].axis.z, 1, 1e-15);
    }
    ck_assert_uint_eq(poles, 1);
    size_t n = nodes->n;
    axis_nodes_sort(nodes); /* they are for one round alone */
    ck_assert_uint_eq(nodes->n, n - 1);
    axis_bench_free(&b);
}
END_TEST

/* None where there is no way from one side to the other that is planned: a side without an axis,
 * one that begins, or both as their rule has them. */
START_TEST(no_way_through_the_pole)
{
    struct axis_bench b;
    size_t poles = 0;

    axis_bench_begin(&b, RADIANS(15), through);
    axis_bench_nodes(&b);
    struct nodes *nodes = &b.work.nodes;
    for (size_t i = 0; i < nodes->n; i++) {
        struct node *node = &nodes->item[i];
        bool before = node->along < 12.65, bare = _i == 0 ? before : _i == 1 && !before;
        node->axis = node->rule;
        if (bare) {
            node->open = 0;
            node->rule_open = false;
        }
        node->begins = _i == 2 && !before;
        node->by_rule = _i == 3 || (_i == 4 && before);
        node->angles = (struct rotary_angles){through((int)(node->along * 2 + 0.5)), 0};
    }
    axis_nodes_add_poles(&b.work);
    for (size_t i = 0; i < nodes->n; i++)
        poles += nodes->item[i].pole;
    ck_assert_uint_eq(poles, _i == 4);
    axis_bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_nodes");
    TCase *tests = tcase_create("axis_nodes");

    tcase_add_test(tests, evenly_and_open);
    tcase_add_test(tests, one_in_a_place);
    tcase_add_test(tests, at_the_pole);
    tcase_add_loop_test(tests, no_way_through_the_pole, 0, 5);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
