/* axis_settle - angles along nodes made smooth, none further off its rule than it may be. */
#include <check.h>
#include <stdlib.h>

#include "axis_bench.h"

static double swaying(int i)
{
    return 0.6 + 0.1 * sin(i * 0.8);
}

static double bend_of(const struct nodes *nodes)
{
    double sum = 0;

    for (size_t i = 1; i + 1 < nodes->n; i++) {
        const struct node *n = &nodes->item[i];
        sum += vec_length(vec_sub(vec_add(n[-1].axis, n[1].axis), vec_scale(2, n->axis)));
    }
    return sum;
}

static void begin(struct axis_bench *b, double play)
{
    axis_bench_begin(b, play, swaying);
    axis_bench_nodes(b);
    for (size_t i = 0; i < b->work.nodes.n; i++) {
        struct node *node = &b->work.nodes.item[i];
        node->axis = node->rule;
        node->by_rule = true;
    }
}

START_TEST(within_play)
{
    struct axis_bench b;

    begin(&b, RADIANS(15));
    double before = bend_of(&b.work.nodes);
    struct vec3 first = b.work.nodes.item[0].axis;
    axis_settle(&b.work, 0, b.work.nodes.n);
    ck_assert_double_lt(bend_of(&b.work.nodes), before / 5);
    ck_assert_double_lt(vec_distance(first, b.work.nodes.item[0].axis), 1e-9); /* the ends stay */
    for (size_t i = 0; i < b.work.nodes.n; i++) {
        const struct node *node = &b.work.nodes.item[i];
        struct vec3 axis = rotary_axis(&b.planner->frame, node->angles);
        ck_assert_double_le(vec_angle(node->axis, node->rule), RADIANS(15));
        ck_assert_double_lt(vec_distance(axis, node->axis), 1e-9);
    }
    axis_bench_free(&b);
}
END_TEST

START_TEST(none_without_play)
{
    struct axis_bench b;

    begin(&b, 0);
    axis_settle(&b.work, 0, b.work.nodes.n);
    for (size_t i = 0; i < b.work.nodes.n; i++)
        ck_assert_double_lt(vec_distance(b.work.nodes.item[i].axis, b.work.nodes.item[i].rule),
                            1e-6);
    axis_bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_settle");
    TCase *tests = tcase_create("axis_settle");

    tcase_add_test(tests, within_play);
    tcase_add_test(tests, none_without_play);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
