/* lift_smooth over shapes where the ball's path is known: raised no more than there is room, clear,
 * and smoother for it. */
#include "gouge/lift_smooth.h"

#include <check.h>
#include <stdlib.h>

#include "noisy.h"

static const double R = 5, TOLERANCE = 0.01;

static struct gouge_lift_options make_rule(const struct gouge_check *guard)
{
    return (struct gouge_lift_options){.guard = guard,
                                       .offset = R,
                                       .limit = R,
                                       .between = true,
                                       .tolerance = TOLERANCE,
                                       .step = 0.05,
                                       .axis = {.kind = AXIS_LEAN, .tilt = 0.2},
                                       .feed = {.along = {1, 0, 0}, .side = {0, 1, 0}}};
}

/* What a path is like. */
struct figures {
    double bends;            /* the sum of its turns, radians */
    double deepest, highest; /* of the ball in the guard on it, of its centre in z, mm */
    double longest;          /* of its steps, mm */
    struct vec3 first, last; /* of its centres */
};

static struct figures figures_of(const struct lifted_strip *lifted, const struct gouge_check *guard)
{
    const struct run_point *p = lifted->run.item;
    size_t n = lifted->run.n;
    struct figures f = {.highest = -HUGE_VAL, .first = p[0].ball, .last = p[n - 1].ball};

    for (size_t i = 0; i < n; i++) {
        f.highest = fmax(f.highest, p[i].ball.z);
        ck_assert_double_lt(vec_distance(p[i].tip, vec_along(p[i].ball, -R, p[i].axis)), 1e-9);
        if (i == 0)
            continue;
        f.longest = fmax(f.longest, vec_distance(p[i - 1].ball, p[i].ball));
        f.deepest = fmax(f.deepest, gouge_depth_along(guard, p[i - 1].ball, p[i].ball, R));
        if (i > 1)
            f.bends +=
                vec_angle(vec_sub(p[i].ball, p[i - 1].ball), vec_sub(p[i - 1].ball, p[i - 2].ball));
    }
    return f;
}

static struct figures raised(struct lifted_strip *lifted, const struct gouge_lift_options *rule,
                             double room)
{
    double *rooms = mem_alloc(lifted->run.n, sizeof *rooms);

    for (size_t i = 0; i < lifted->run.n; i++)
        rooms[i] = room;
    lift_smooth_raise(lifted, rule, rooms);
    free(rooms);
    return figures_of(lifted, rule->guard);
}

/* A row along x over these points, lifted; its contacts are 2 mm lower over a groove. */
static struct lifted_strip lifted_row(const struct gouge_lift_options *rule, double half_groove)
{
    struct run run = {.radius = R};
    struct lifted_strip lifted = {.run = {.radius = R}};

    for (int i = -40; i <= 40; i++)
        gouge_lift_contact(&run, rule, vec(0.25 * i, 0, fabs(0.25 * i) < half_groove ? -2 : 0),
                           vec(0, 0, 1));
    gouge_lift_run(&run, rule, &lifted);
    array_free(&run);
    return lifted;
}

/* Over scattered points the ball runs on the envelope of balls that touch, with a corner at each;
 * it may rise a little to run smoothly, and is no deeper in any point than straight lines may be.
 */
START_TEST(single_points)
{
    enum { POINTS = 3000 };
    const double room = 0.02;
    struct vec3 *point = mem_alloc(POINTS, sizeof *point);

    noisy_seed(9);
    for (int i = 0; i < POINTS; i++)
        point[i] = vec(24 * noisy_uniform() - 12, 8 * noisy_uniform() - 4, 0.002 * noisy_normal());
    struct gouge_check *guard = gouge_from_points(point, POINTS);
    struct gouge_lift_options rule = make_rule(guard);
    struct lifted_strip lifted = lifted_row(&rule, 0);
    struct figures before = figures_of(&lifted, guard);

    lift_smooth_spread(&lifted, &rule);
    struct figures spread = figures_of(&lifted, guard), after = raised(&lifted, &rule, room);
    ck_assert_double_lt(spread.longest, 1.2 * sqrt(TOLERANCE * R));
    ck_assert_double_lt(after.bends, 0.3 * before.bends);
    ck_assert_double_le(after.deepest, GOUGE_SAFE * TOLERANCE + 1e-6);
    ck_assert_double_le(after.highest, spread.highest + room + 1e-9);
    ck_assert_double_lt(vec_distance(after.first, before.first), 1e-12);
    ck_assert_double_lt(vec_distance(after.last, before.last), 1e-12);
    lifted_strip_free(&lifted);
    gouge_free(guard);
    free(point);
}
END_TEST

/* Points as high as the ball's centre, that it passes beside: between two of its places, where it
 * is clear, it is in them by no more than a straight line may be.  Nothing has to be lifted, and
 * to come out of them straight up would take a tenth of a millimetre. */
START_TEST(along_a_flank)
{
    const double step = 0.25, in = 0.0012;
    struct vec3s point = {0};
    struct lifted_strip lifted = {.run = {.radius = R}};

    for (int k = -2; k <= 2; k++)
        *array_push(&point) = vec((4 * k + 0.5) * step, R - in, R);
    struct gouge_check *guard = gouge_new(point, 1);
    struct gouge_lift_options rule = make_rule(guard);
    for (int i = -12; i <= 12; i++)
        gouge_lift_contact(&lifted.run, &rule, vec(step * i, 0, 0), vec(0, 0, 1));
    *array_push(&lifted.end) = lifted.run.n;
    struct figures before = figures_of(&lifted, guard);
    ck_assert_double_eq_tol(before.deepest, in, 1e-6);
    lift_smooth_spread(&lifted, &rule);
    struct figures spread = figures_of(&lifted, guard);
    ck_assert_double_le(spread.highest, R + TOLERANCE);
    ck_assert_double_le(spread.deepest, GOUGE_SAFE * TOLERANCE);
    struct figures after = raised(&lifted, &rule, 0.02);
    ck_assert_double_le(after.deepest, GOUGE_SAFE * TOLERANCE);
    ck_assert_double_le(after.highest, R + 0.02);
    lifted_strip_free(&lifted);
    gouge_free(guard);
}
END_TEST

/* A groove narrower than the ball, which rests on its two edges: its centre has a corner over the
 * middle. */
START_TEST(corner_over_a_groove)
{
    const double half = 3, room = 0.3; /* a round of 1.2 mm */
    struct vec3s point = {0};

    for (double x = -12; x < 12; x += 0.05)
        for (double y = -1; y < 1; y += 0.1)
            if (fabs(x) > half)
                *array_push(&point) = vec(x, y, 0);
    struct gouge_check *guard = gouge_new(point, 1);
    struct gouge_lift_options rule = make_rule(guard);
    struct lifted_strip lifted = lifted_row(&rule, half);
    lift_smooth_spread(&lifted, &rule);
    double sharpest[2] = {0};
    for (int k = 0; k < 2; k++) {
        if (k == 1)
            ck_assert_double_le(raised(&lifted, &rule, room).deepest,
                                GOUGE_SAFE * TOLERANCE + 1e-6);
        const struct run_point *p = lifted.run.item;
        for (size_t i = 2; i < lifted.run.n; i++)
            if (fabs(p[i - 1].ball.x) < 1)
                sharpest[k] = fmax(sharpest[k], vec_angle(vec_sub(p[i].ball, p[i - 1].ball),
                                                          vec_sub(p[i - 1].ball, p[i - 2].ball)));
    }
    /* two slopes of half / sqrt(R^2 - half^2) meet there */
    ck_assert_double_gt(sharpest[0], 0.6);
    ck_assert_double_lt(sharpest[1], 0.5 * sharpest[0]);
    lifted_strip_free(&lifted);
    gouge_free(guard);
}
END_TEST

/* Nothing is raised where there is no room, nor on a plane. */
START_TEST(stays)
{
    struct vec3s plane = {0};

    for (double x = -12; x < 12; x += 0.1)
        for (double y = -1; y < 1; y += 0.1)
            *array_push(&plane) = vec(x, y, 0);
    struct gouge_check *guard = gouge_new(plane, 1);
    for (int k = 0; k < 2; k++) {
        struct gouge_lift_options rule = make_rule(guard);
        struct lifted_strip lifted = lifted_row(&rule, 0);
        double high = figures_of(&lifted, guard).highest;
        lift_smooth_spread(&lifted, &rule);
        ck_assert_double_lt(raised(&lifted, &rule, k * 0.05).highest, high + 0.002);
        lifted_strip_free(&lifted);
    }
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lift_smooth");
    TCase *tests = tcase_create("lift_smooth");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, single_points);
    tcase_add_test(tests, along_a_flank);
    tcase_add_test(tests, corner_over_a_groove);
    tcase_add_test(tests, stays);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
