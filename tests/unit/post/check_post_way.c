/*
 * post_way: ways of random length and turn on machines of every kind, the rotary axes in
 * proportion, against where the linear axes stand at many more places.
 */
#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "planners.h"
#include "post/post_ik.h"
#include "post/post_way.h"

enum { STEPS = 480, WAYS = 3000 };

/* How far X, Y or Z is out of its travel when the tip is there, mm; less than 0: within. */
static double beyond(const struct bench *b, struct vec3 tip, const double q[])
{
    const struct machine *m = &b->machine;
    struct vec3 p = chain_linear(&m->chain, tip, q);
    const double at[3] = {p.x, p.y, p.z};
    double most = -HUGE_VAL;
    for (int i = 0; i < 3; i++)
        most = fmax(most, fmax(m->min[i] - at[i], at[i] - m->max[i]));
    return most;
}

/* While the rotary axes turn in proportion. */
static double worst_on_way(const struct bench *b, const struct block_pose *from,
                           const struct block_pose *to)
{
    double worst = -HUGE_VAL;
    for (int k = 0; k <= STEPS; k++) {
        double s = (double)k / STEPS, q[ROTARY_MAX];
        for (int i = 0; i < ROTARY_MAX; i++)
            q[i] = from->q[i] + s * (to->q[i] - from->q[i]);
        worst = fmax(worst, beyond(b, vec_mix(from->p, to->p, s), q));
    }
    return worst;
}

static void limit_travel(struct bench *b, double far)
{
    for (int i = 0; i < 3; i++) {
        b->machine.min[i] = -far;
        b->machine.max[i] = far;
    }
    b->planner.safe_radius = post_ik_safe_radius(&b->machine);
}

static struct machine_pose any_place(const struct bench *b)
{
    const double q[ROTARY_MAX] = {2 * chance() - 1, 2 * chance() - 1};
    struct pose to = {vec_scale(100 + 150 * chance(), random_unit()), bench_axis(b, q)};
    return post_ik_pose(&b->planner, to, q);
}

START_TEST(test_ways)
{
    const double q0[ROTARY_MAX] = {0.3, 0.4};
    struct bench b;
    int out = 0, between = 0;
    bench_begin(&b, _i, INTERPOLATE_ROTARY, vec(0, 0, 0), q0);
    limit_travel(&b, 200);
    for (int i = 0; i < WAYS; i++) {
        struct machine_pose from = any_place(&b), to = any_place(&b);
        double start = beyond(&b, from.at.p, from.at.q), end = beyond(&b, to.at.p, to.at.q);
        struct nc_over over = post_way_over(&b.planner, &from.at, &to.at);
        double worst = worst_on_way(&b, &from.at, &to.at);
        if (start > 0) /* it was told of there */
            continue;
        if (over.is)
            ck_assert_msg(worst > -1e-4 && fabs(over.value) > 200, "way %d: %g", i, worst);
        if (end > 1e-5 || worst > 8) /* more than what is between two looks */
            ck_assert_msg(over.is, "way %d: %g beyond, %g at its end", i, worst, end);
        out += over.is;
        between += over.is && end < 0;
    }
    ck_assert_msg(out > 100 && between > 0, "%d out, %d between", out, between);
    bench_free(&b);
}
END_TEST

/* From home: where the axes stand at zero first, the place or one nearer to the middle is within
 * the travel there, on the turn, and turned. */
START_TEST(test_from_home)
{
    const double zero[ROTARY_MAX] = {0, 0};
    int moved = 0, none = 0;
    struct bench b;
    bench_begin(&b, _i, INTERPOLATE_ROTARY, vec(0, 0, 0), zero);
    limit_travel(&b, 200);
    b.plan.ability.tcp = true;
    b.plan.top = -HUGE_VAL;
    for (int i = 0; i < WAYS; i++) {
        struct machine_pose to = any_place(&b);
        if (beyond(&b, to.at.p, to.at.q) > 0)
            continue;
        struct block_pose by, home = {.p = to.at.p};
        struct nc_over over = post_way_from_home(&b.planner, &to.at, to.at.a, &by);
        home.p = by.p;
        if (over.is) {
            ck_assert(fabs(over.value) > 200);
            none++;
            continue;
        }
        ck_assert_double_lt(worst_on_way(&b, &home, &by), 8);
        ck_assert_double_lt(beyond(&b, by.p, zero), 1e-5);
        ck_assert_double_eq(by.p.z, to.at.p.z);
        ck_assert(by.q[0] == to.at.q[0] && by.q[1] == to.at.q[1]);
        moved += vec_distance(by.p, to.at.p) > 0;
    }
    ck_assert_msg(moved > 20, "%d moved, %d have no way", moved, none);
    b.machine.tcp_frame = TCP_FRAME_STANDS;
    struct machine_pose far =
        post_ik_pose(&b.planner, (struct pose){vec(199, 199, 0), vec(0, 0, 1)}, (double[]){0.5, 0});
    struct block_pose by;
    ck_assert(!post_way_from_home(&b.planner, &far.at, vec(0, 0, 1), &by).is);
    bench_free(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_way");
    TCase *ways = tcase_create("ways"), *home = tcase_create("home");
    tcase_add_loop_test(ways, test_ways, 0, KINDS);
    tcase_add_loop_test(home, test_from_home, 0, KINDS);
    suite_add_tcase(suite, ways);
    suite_add_tcase(suite, home);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
