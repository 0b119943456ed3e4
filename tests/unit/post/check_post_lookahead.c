/*
 * post_lookahead: over random walks of the tool axis, on machines of every kind, what is found has
 * the axis where the path has it, at each place; the travel is that from place to place, and where
 * the control turns vectors there is nothing to be found.
 */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "machine/ik_choose.h"
#include "planners.h"
#include "post/post_lookahead.h"

enum { POINTS = 40 };

/* A walk of the axis in small steps, well off the singular direction. */
static void walk(struct bench *b)
{
    struct pose pose = b->planner.state.pose;

    for (int i = 0; i < POINTS; i++) {
        struct vec3 a;
        do
            a = vec_unit(vec_along(pose.a, 0.1 * chance(), random_unit()));
        while (a.z > 0.93 || a.z < 0.5);
        pose = (struct pose){vec_along(pose.p, 1 + chance(), random_unit()), a};
        *array_push(&b->path.item) = (struct path_item){.kind = PATH_POINT, .to = pose};
    }
}

static void begin(struct bench *b, int kind, enum interpolation_mode mode)
{
    struct vec3 axis;
    do
        axis = random_unit();
    while (axis.z > 0.9 || axis.z < 0.55);
    bench_begin(b, kind, mode, vec(0, 0, 0), (double[]){0, 0});
    struct chain_solutions found = chain_angles(&b->machine.chain, axis);
    ck_assert_int_gt(found.n, 0);
    bench_free(b);
    bench_begin(b, kind, mode, vec(0, 0, 0), found.q[0]);
}

/* The tool stands at its start before the first place. */
START_TEST(axes_at_places)
{
    seed = 700 + (uint64_t)_i;
    for (int trial = 0; trial < 20; trial++) {
        struct bench b;
        struct lookahead ahead;
        begin(&b, _i, INTERPOLATE_ROTARY);
        walk(&b);
        ck_assert(post_lookahead_over(&ahead, &b.planner, 0, POINTS));
        ck_assert_uint_eq(ahead.start.n, POINTS + 1);
        ck_assert_uint_eq(ahead.s.n, ahead.n);
        ck_assert_uint_eq(ahead.cost.turns, 0); /* a turn and a half either way is enough */
        double travel = 0, last[ROTARY_MAX] = {b.planner.state.at.q[0], b.planner.state.at.q[1]};
        for (size_t i = 0; i < ahead.n; i++) {
            const struct ik_plan_place *place = &ahead.item[i];
            ck_assert(!place->passed && !place->turn);
            ck_assert_double_lt(vec_distance(bench_axis(&b, place->q), place->axis), 1e-9);
            travel += ik_travel(&b.machine.chain, place->q, last);
            last[0] = place->q[0], last[1] = place->q[1];
        }
        ck_assert_double_eq_tol(travel, ahead.cost.travel, 1e-9);
        for (size_t i = 0; i < POINTS; i++) {
            struct vec3 want = b.path.item.item[i].to.a;
            size_t end = ahead.start.item[i + 1];
            ck_assert_double_lt(vec_distance(ahead.item[end].axis, want), 1e-12);
            ck_assert_double_eq(ahead.s.item[end], 1);
        }
        post_lookahead_free(&ahead);
        array_free(&b.path.item);
        bench_free(&b);
    }
}
END_TEST

START_TEST(not_of_vectors)
{
    struct bench b;
    struct lookahead ahead;

    seed = 720;
    begin(&b, 0, INTERPOLATE_VECTOR);
    walk(&b);
    ck_assert(!post_lookahead_over(&ahead, &b.planner, 0, POINTS));
    ck_assert_uint_eq(ahead.n, 0);
    post_lookahead_free(&ahead);
    array_free(&b.path.item);
    bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_lookahead");
    TCase *tests = tcase_create("post_lookahead");
    SRunner *runner = srunner_create(suite);

    tcase_add_loop_test(tests, axes_at_places, 0, KINDS);
    tcase_add_test(tests, not_of_vectors);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
