/* toolpath_thin - of two points in one place one stays, within a part and where two meet. */
#include <check.h>
#include <stdlib.h>

#include "stage/toolpath_parts.h"

static const double R = 5;

static struct gouge_check *make_floor(void)
{
    struct vec3s points = {0};

    for (int i = -20; i <= 20; i++)
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(i, k, 0);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static void put(struct run *run, double x, double y)
{
    struct run_point p = {.contact = vec(x, y, 0),
                          .normal = vec(0, 0, 1),
                          .ball = vec(x, y, R),
                          .axis = vec(0, 0, 1),
                          .tip = vec(x, y, 0)};
    *array_push(run) = p;
}

/* A row of points a millimetre apart with one more 0.01 mm beside the fourth, and back beside it
 * another, which begins 0.015 mm off the first one's end. */
static struct toolpath make(struct gouge_check *guard, bool between)
{
    struct toolpath t = {
        .rule = {.radius = R, .longest = 6, .clearance = 20, .approach = 3},
        .lift = {.guard = guard, .offset = R, .limit = R, .tolerance = 0.01, .between = between}};

    for (int k = 0; k < 2; k++) {
        struct toolpath_strip strip = {.lift = t.lift};
        strip.lifted.run.radius = R;
        for (int i = 0; i <= 8; i++) {
            double x = k == 0 ? i : 8 - i;
            put(&strip.lifted.run, x, k == 0 ? 0 : 0.015 + 0.1 * i);
            if (k == 0 && i == 3)
                put(&strip.lifted.run, x + 0.01, 0);
        }
        *array_push(&strip.lifted.end) = strip.lifted.run.n;
        *array_push(&t.strip) = strip;
    }
    return t;
}

static void free_all(struct toolpath *t, struct toolpath_parts *parts)
{
    toolpath_parts_free(parts);
    for (size_t k = 0; k < t->strip.n; k++)
        lifted_strip_free(&t->strip.item[k].lifted);
    array_free(&t->strip);
}

static double nearest(const struct toolpath *t, const struct toolpath_parts *parts)
{
    double least = HUGE_VAL;
    struct vec3 last = {0, 0, -100};

    for (size_t k = 0; k < parts->n; k++) {
        struct run run = toolpath_part_run(t, &parts->item[k]);
        for (size_t i = 0; i < run.n; i++) {
            least = fmin(least, vec_distance(last, run.item[i].tip));
            last = run.item[i].tip;
        }
    }
    return least;
}

START_TEST(one_of_two)
{
    struct gouge_check *guard = make_floor();
    struct toolpath t = make(guard, true);
    struct toolpath_parts parts = toolpath_parts_of(&t);

    parts.item[1].low = true;
    ck_assert_double_lt(nearest(&t, &parts), 0.011);
    toolpath_thin(&t, &parts);
    ck_assert_double_gt(nearest(&t, &parts), 0.9);
    struct run first = toolpath_part_run(&t, &parts.item[0]),
               second = toolpath_part_run(&t, &parts.item[1]);
    ck_assert_uint_eq(first.n, 9);
    ck_assert_uint_eq(second.n, 8);
    ck_assert_double_eq(first.item[0].tip.x, 0);
    ck_assert_double_eq(first.item[8].tip.x, 8);
    ck_assert_double_eq(second.item[7].tip.x, 0);
    free_all(&t, &parts);
    gouge_free(guard);
}
END_TEST

/* Over the clearance plane two parts do not meet; and nodes of a mesh alone stay as they are. */
START_TEST(what_stays)
{
    struct gouge_check *guard = make_floor();
    struct toolpath t = make(guard, true), nodes = make(guard, false);
    struct toolpath_parts parts = toolpath_parts_of(&t), all = toolpath_parts_of(&nodes);

    toolpath_thin(&t, &parts);
    ck_assert_uint_eq(toolpath_part_run(&t, &parts.item[0]).n, 9);
    ck_assert_uint_eq(toolpath_part_run(&t, &parts.item[1]).n, 9);
    all.item[1].low = true;
    toolpath_thin(&nodes, &all);
    ck_assert_uint_eq(toolpath_part_run(&nodes, &all.item[0]).n, 10);
    ck_assert_uint_eq(toolpath_part_run(&nodes, &all.item[1]).n, 9);
    free_all(&t, &parts);
    free_all(&nodes, &all);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("toolpath_thin");
    TCase *tests = tcase_create("toolpath_thin");

    tcase_add_test(tests, one_of_two);
    tcase_add_test(tests, what_stays);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
