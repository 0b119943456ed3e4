/* axis_points - the points of a run with the axes of its nodes, and more where the axis bends. */
#include <check.h>
#include <stdlib.h>

#include "axis_bench.h"

static double level(int i)
{
    return 0 * i + 0.2;
}

static double node_lean(double along)
{
    return along < 10 ? 0.2 : 0.2 + 0.03 * (along - 10);
}

static void begin(struct axis_bench *b)
{
    axis_bench_begin(b, RADIANS(15), level);
    axis_bench_nodes(b);
    for (size_t i = 0; i < b->work.nodes.n; i++) {
        struct node *node = &b->work.nodes.item[i];
        double lean = node_lean(node->along);
        node->axis = vec(0, sin(lean), cos(lean));
        node->angles = rotary_angles_near(&b->planner->frame, node->axis,
                                          (struct rotary_angles){.lean = 0, .turn = 0});
        node->allow = 1;
    }
}

START_TEST(axes_of_the_nodes)
{
    struct axis_bench b;
    struct run to = {.radius = 5};
    struct doubles along = {0};

    begin(&b);
    axis_points_put(&b.work, &to, &along);
    ck_assert_uint_ge(to.n, b.run.n);
    ck_assert_uint_eq(along.n, to.n);
    for (size_t i = 0; i < to.n; i++) {
        double lean = node_lean(along.item[i]);
        struct vec3 axis = vec(0, sin(lean), cos(lean));
        ck_assert_double_eq_tol(to.item[i].ball.x, along.item[i], 1e-9);
        ck_assert_double_le(vec_angle(to.item[i].axis, axis), RADIANS(0.16));
        ck_assert_double_lt(
            vec_distance(to.item[i].tip, vec_along(to.item[i].ball, -5, to.item[i].axis)), 1e-9);
        ck_assert(i == 0 || along.item[i] > along.item[i - 1]);
    }
    array_free(&to);
    array_free(&along);
    axis_bench_free(&b);
}
END_TEST

START_TEST(without_an_axis)
{
    struct axis_bench b;

    begin(&b);
    for (size_t i = 5; i < 8; i++) {
        b.work.nodes.item[i].open = 0;
        b.work.nodes.item[i].rule_open = false;
    }
    size_t n = b.work.nodes.n;
    ck_assert(!axis_points_without(&b.work, n, 4)); /* one of the two has one */
    ck_assert(axis_points_without(&b.work, n, 5));
    ck_assert(axis_points_without(&b.work, n, 6));
    ck_assert(!axis_points_without(&b.work, n, 7));
    ck_assert(!axis_points_without(&b.work, n, n - 1));
    axis_bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_points");
    TCase *tests = tcase_create("axis_points");

    tcase_add_test(tests, axes_of_the_nodes);
    tcase_add_test(tests, without_an_axis);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
