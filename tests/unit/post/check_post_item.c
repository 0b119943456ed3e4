/*
 * post_item: what each item of a path becomes on machines of every kind: the way down before a cut
 * and the way up after it, holes of a cycle, another tool, notes.  All lengths are known.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "chains.h"
#include "planners.h"
#include "post/post_item.h"

static const double rounded = 2e-5; /* mm: the words of two poses */

/* Somewhere with a leaning axis; the program has not begun.  Returns a pose with that axis. */
static struct pose begin(struct bench *b, int kind)
{
    double q[2] = {0.1 + 0.4 * chance(), 0.1 + 0.4 * chance()};
    struct vec3 tip = vec(30 * chance(), 30 * chance(), 5);
    bench_begin(b, kind, INTERPOLATE_ROTARY, tip, q);
    b->planner.state.begun = false;
    b->path.head.clearance = NAN;
    return b->planner.state.pose;
}

static void end(struct bench *b)
{
    path_free(&b->path);
    bench_free(b);
}

/* All items of the path; -1 at the first that cannot be. */
static int plan_items(struct bench *b)
{
    for (size_t i = 0; i < b->path.item.n; i++)
        if (post_item(&b->planner, &b->path.item.item[i]) != 0)
            return -1;
    return 0;
}

static const struct nc_move *move_at(const struct bench *b, size_t k)
{
    ck_assert_uint_lt(k, b->plan.move.n);
    return &b->plan.move.item[k];
}

static void check_place(struct vec3 got, struct vec3 expected)
{
    ck_assert_double_le(vec_distance(got, expected), rounded);
}

/* A path that starts with a cut comes down its axis, and ends by going up it. */
START_TEST(cut_without_rapids)
{
    struct bench b;
    seed = 600 + (uint64_t)_i;
    struct pose first = begin(&b, _i), last = first;
    last.p = vec_add(first.p, vec(10, 0, 0));
    path_add_point(&b.path, first, false);
    path_add_point(&b.path, last, false);
    b.planner.state.feed = 0;
    ck_assert_int_eq(plan_items(&b), 0);
    ck_assert_int_eq(post_item_retract(&b.planner), 0);
    ck_assert_uint_eq(b.plan.move.n, 4);

    const double up = b.machine.retract;
    ck_assert_int_eq(move_at(&b, 0)->kind, NC_RAPID);
    ck_assert_int_eq(move_at(&b, 0)->why, NC_WHY_APPROACH);
    check_place(move_at(&b, 0)->p, vec_along(first.p, up, first.a));
    for (size_t k = 1; k < 3; k++) {
        ck_assert_int_eq(move_at(&b, k)->kind, NC_LINE);
        ck_assert_int_eq(move_at(&b, k)->why, NC_WHY_PATH);
        ck_assert_double_eq(move_at(&b, k)->feed, 1000);
    }
    check_place(move_at(&b, 1)->p, first.p);
    check_place(move_at(&b, 2)->p, last.p);
    ck_assert_int_eq(move_at(&b, 3)->kind, NC_RAPID);
    ck_assert_int_eq(move_at(&b, 3)->why, NC_WHY_RETRACT);
    check_place(move_at(&b, 3)->p, vec_along(last.p, up, last.a));

    const struct nc_total *total = &b.plan.total;
    ck_assert(total->feed_assumed && total->approach_made && total->retract_made);
    ck_assert_double_eq_tol(total->cut, up + 10, rounded);

    /* it is off the part: there is nothing more to do */
    ck_assert_int_eq(post_item_retract(&b.planner), 0);
    ck_assert_uint_eq(b.plan.move.n, 4);
    end(&b);
}
END_TEST

/* One that comes and goes at rapid gets neither. */
START_TEST(cut_between_rapids)
{
    struct bench b;
    seed = 620 + (uint64_t)_i;
    struct pose cut = begin(&b, _i), above = cut;
    above.p = vec_along(cut.p, 20, cut.a);
    path_add_point(&b.path, above, true);
    path_add_feed(&b.path, 345);
    path_add_point(&b.path, cut, false);
    path_add_point(&b.path, above, true);
    ck_assert_int_eq(plan_items(&b), 0);
    ck_assert_int_eq(post_item_retract(&b.planner), 0);
    ck_assert_uint_eq(b.plan.move.n, 3);
    ck_assert_int_eq(move_at(&b, 1)->kind, NC_LINE);
    ck_assert_double_eq(move_at(&b, 1)->feed, 345);
    const struct nc_total *total = &b.plan.total;
    ck_assert(!total->feed_assumed && !total->approach_made && !total->retract_made);
    end(&b);
}
END_TEST

/* Feeds of the contact point: the tip goes as much faster as its way is longer, up to ten times. */
START_TEST(contact_feeds)
{
    const double way[] = {10, 2.5, 0.5};
    const double faster[] = {1, 4, 10};
    for (int i = 0; i < 3; i++) {
        struct bench b;
        seed = 630;
        struct pose at = begin(&b, KIND_TABLE_AC), to = at;
        to.p = vec_add(at.p, vec(10, 0, 0));
        b.planner.options.contact_feed = true;
        struct contact from = {vec(0, 0, 0), vec(0, 0, 1)}, touch = {vec(way[i], 0, 0), from.n};
        path_set_contact(&b.path, path_add_point(&b.path, at, false), from);
        path_set_contact(&b.path, path_add_point(&b.path, to, false), touch);
        ck_assert_int_eq(plan_items(&b), 0);
        ck_assert_double_eq_tol(move_at(&b, 2)->feed, 1000 * faster[i], 1e-9);
        end(&b);
    }
}
END_TEST

START_TEST(curve_before_any_point)
{
    struct bench b;
    seed = 640;
    struct pose at = begin(&b, KIND_TABLE_AC);
    struct path_arc arc = {vec_add(at.p, vec(5, 0, 0)), vec(0, 0, 1), 5};
    path_add_arc(&b.path, at, arc);
    ck_assert_int_eq(plan_items(&b), -1);
    ck_assert_ptr_nonnull(strstr(b.error.text, "found a curve before any point"));
    end(&b);
}
END_TEST

/* Two holes of a cycle and one of another depth, with digits that are not printed. */
START_TEST(holes)
{
    struct bench b;
    const struct path_cycle cycle = {
        .kind = CYCLE_DRILL, .depth = 12.000001, .clear = 2, .retract = 7, .feed = 150};
    bench_begin(&b, KIND_TABLE_AC, INTERPOLATE_ROTARY, vec(0, 0, 50), (double[]){0, 0});
    *array_push(&b.path.cycle) = cycle;
    *array_push(&b.path.cycle) = cycle;
    b.path.cycle.item[1].depth = 5;
    for (int k = 0; k < 3; k++)
        path_add_hole(&b.path, (struct pose){vec(10 * k + 10, 0, 0), vec(0, 0, 1)}, k == 2);
    ck_assert_int_eq(plan_items(&b), 0);

    const enum nc_kind kinds[] = {NC_RAPID, NC_RAPID, NC_HOLE, NC_HOLE, NC_RAPID, NC_HOLE};
    const struct vec3 ends[] = {vec(10, 0, 50), vec(10, 0, 7), vec(10, 0, 7),
                                vec(20, 0, 7),  vec(30, 0, 7), vec(30, 0, 7)};
    ck_assert_uint_eq(b.plan.move.n, 6);
    for (size_t k = 0; k < 6; k++) {
        ck_assert_int_eq(move_at(&b, k)->kind, kinds[k]);
        check_place(move_at(&b, k)->p, ends[k]);
    }
    ck_assert_double_eq(b.plan.hole.item[0].depth, 12);
    ck_assert_double_eq(b.plan.hole.item[2].depth, 5);
    ck_assert_double_eq(move_at(&b, 2)->feed, 150);

    const struct nc_total *total = &b.plan.total;
    ck_assert_uint_eq(total->holes, 3);
    ck_assert_double_eq_tol(total->cut, 14 + 14 + 7, rounded);
    /* there, each out and down again to where the feed begins, and from one to the next */
    double rapid = 10 + 43 + 2 * (19 + 5) + 10 + 10 + (12 + 5);
    ck_assert_double_eq_tol(total->rapid, rapid, rounded);

    /* it ends off the part */
    ck_assert_int_eq(post_item_retract(&b.planner), 0);
    ck_assert_uint_eq(b.plan.move.n, 6);
    end(&b);
}
END_TEST

/* Another tool: off the part, a note, and the program begins anew; at the end of a path nothing. */
START_TEST(other_tool)
{
    struct bench b;
    seed = 660;
    struct pose at = begin(&b, KIND_HEAD_HEAD);
    const struct path_tool tool = {.number = 2, .cutter = {8, 4}, .cutter_n = 2};
    path_add_point(&b.path, at, false);
    path_add_tool(&b.path, tool);
    path_add_point(&b.path, at, false);
    path_add_tool(&b.path, tool);
    post_item_tool(&b.planner, 3);
    struct pose_deviation before = b.planner.allowed;
    ck_assert_int_eq(plan_items(&b), 0);

    const enum nc_kind kinds[] = {NC_RAPID, NC_LINE, NC_RAPID, NC_TOOL, NC_RAPID, NC_LINE};
    ck_assert_uint_eq(b.plan.move.n, 6);
    for (size_t k = 0; k < 6; k++)
        ck_assert_int_eq(move_at(&b, k)->kind, kinds[k]);
    ck_assert_int_eq(move_at(&b, 2)->why, NC_WHY_RETRACT);
    ck_assert_uint_eq(move_at(&b, 3)->index, 0);
    ck_assert_double_eq(b.planner.follow.ball, 4);
    /* the larger ball moves further by the rounding of the same angle */
    double step = RADIANS(sqrt(2) * 0.5e-5);
    ck_assert_double_eq_tol(b.planner.allowed.point - before.point, step, 1e-12);
    ck_assert_double_eq(b.planner.allowed.axis, before.axis);

    b.path.head.track = TRACK_CENTRE; /* the tip is the other point then */
    post_item_tool(&b.planner, 4);
    ck_assert_double_eq(b.planner.follow.ball, -4);
    end(&b);
}
END_TEST

START_TEST(notes)
{
    struct bench b;
    seed = 670;
    begin(&b, KIND_TABLE_AC);
    path_add_pass(&b.path, 7);
    path_add_text(&b.path, "COOLNT/ON");
    ck_assert_int_eq(plan_items(&b), 0);
    ck_assert_uint_eq(b.plan.move.n, 2);
    ck_assert_int_eq(move_at(&b, 0)->kind, NC_PASS);
    ck_assert_uint_eq(move_at(&b, 0)->index, 7);
    ck_assert_int_eq(move_at(&b, 1)->kind, NC_TEXT);
    ck_assert_uint_eq(b.planner.state.pass, 7);
    ck_assert_uint_eq(b.plan.total.passes, 1);
    end(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_item");
    TCase *tests = tcase_create("items");

    tcase_add_loop_test(tests, cut_without_rapids, 0, KINDS);
    tcase_add_loop_test(tests, cut_between_rapids, 0, KINDS);
    tcase_add_test(tests, contact_feeds);
    tcase_add_test(tests, curve_before_any_point);
    tcase_add_test(tests, holes);
    tcase_add_test(tests, other_tool);
    tcase_add_test(tests, notes);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
