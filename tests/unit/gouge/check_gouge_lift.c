/* gouge_lift over shapes where the highest clear place of a ball is known. */
#include "gouge/gouge_lift.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "seed.h"

static const double R = 5;

static struct gouge_lift_options make_rule(const struct gouge_check *guard, bool between)
{
    return (struct gouge_lift_options){.guard = guard,
                                       .offset = R,
                                       .limit = R,
                                       .between = between,
                                       .tolerance = 0.01,
                                       .step = 0.05,
                                       .axis = {.kind = AXIS_LEAN, .tilt = 0.2},
                                       .feed = {.along = {1, 0, 0}, .side = {0, 1, 0}}};
}

/* A strip of contact points on the plane z = 0, 2 mm apart. */
static struct run strip_on_plane(const struct gouge_lift_options *rule)
{
    struct run run = {.radius = R};
    for (int i = -5; i <= 5; i++)
        gouge_lift_contact(&run, rule, vec(2 * i, 0, 0), vec(0, 0, 1));
    return run;
}

START_TEST(a_point_stands_as_the_offset_says)
{
    struct gouge_lift_options rule = make_rule(NULL, false);
    struct run run = {.radius = R};
    rule.offset = R + 0.6;
    struct vec3 n = vec_unit(vec(0.3, 0.2, 1));
    gouge_lift_contact(&run, &rule, vec(1, 2, 3), n);
    struct run_point p = run.item[0];
    ck_assert_double_lt(vec_distance(p.ball, vec_along(vec(1, 2, 3), 5.6, n)), 1e-12);
    ck_assert_double_lt(vec_distance(p.tip, vec_along(p.ball, -R, p.axis)), 1e-12);
    ck_assert_double_eq_tol(vec_angle(p.axis, n), 0.2, 1e-12);
    array_free(&run);
}
END_TEST

START_TEST(without_a_guard_nothing_is_lifted)
{
    struct gouge_lift_options rule = make_rule(NULL, false);
    struct run run = strip_on_plane(&rule);
    struct lifted_strip lifted = {.run = {.radius = R}};
    gouge_lift_run(&run, &rule, &lifted);
    ck_assert_uint_eq(lifted.run.n, run.n);
    ck_assert_uint_eq(lifted.end.n, 1);
    ck_assert_uint_eq(lifted.end.item[0], run.n);
    ck_assert_uint_eq(lifted.report.lifted, 0);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_eq(vec_distance(run.item[i].ball, lifted.run.item[i].ball), 0);
    lifted_strip_free(&lifted);
    array_free(&run);
}
END_TEST

/* Where a ball that comes down beside a pin of height 1 at (0.7, 0.4) ends. */
static double over_pin(double x)
{
    double across = hypot(x - 0.7, 0.4);
    return across < R ? fmax(R, 1 + sqrt(R * R - across * across)) : R;
}

START_TEST(a_ball_rolls_over_a_pin)
{
    struct vec3 pin = vec(0.7, 0.4, 1);
    struct gouge_check *guard = gouge_from_points(&pin, 1);
    struct gouge_lift_options rule = make_rule(guard, true);
    struct run run = strip_on_plane(&rule);
    struct lifted_strip lifted = {.run = {.radius = R}};
    gouge_lift_run(&run, &rule, &lifted);
    ck_assert_uint_eq(lifted.report.unreachable, 0);
    ck_assert_double_eq_tol(lifted.report.highest, 1 + sqrt(R * R - 0.16) - R, 0.01);
    for (size_t i = 0; i < lifted.run.n; i++) {
        const struct run_point *p = &lifted.run.item[i];
        ck_assert_double_eq_tol(p->ball.z, over_pin(p->ball.x), 2e-6);
        ck_assert_double_lt(vec_distance(p->tip, vec_along(p->ball, -R, p->axis)), 1e-12);
        /* The straight lines too. */
        for (int k = 1; i > 0 && k < 20; k++) {
            struct vec3 c = vec_mix(p[-1].ball, p->ball, k / 20.0);
            ck_assert_double_eq_tol(c.z, over_pin(c.x), 0.015);
        }
    }
    lifted_strip_free(&lifted);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

START_TEST(only_nodes_without_between)
{
    struct vec3 pin = vec(0.7, 0.4, 1);
    struct gouge_check *guard = gouge_from_points(&pin, 1);
    struct gouge_lift_options rule = make_rule(guard, false);
    struct run run = strip_on_plane(&rule);
    struct lifted_strip lifted = {.run = {.radius = R}};
    gouge_lift_run(&run, &rule, &lifted);
    ck_assert_uint_eq(lifted.run.n, run.n);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_eq_tol(lifted.run.item[i].ball.z, over_pin(run.item[i].ball.x), 2e-6);
    lifted_strip_free(&lifted);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

START_TEST(a_tower_is_passed_over_without_a_touch)
{
    /* Much higher than the limit, and so thin that no node is below it. */
    struct vec3s tower = {0};
    for (int i = 0; i <= 100; i++)
        *array_push(&tower) = vec(1, 0, 0.2 * i);
    struct gouge_check *guard = gouge_from_points(tower.item, tower.n);
    for (int between = 0; between < 2; between++) {
        struct gouge_lift_options rule = make_rule(guard, between);
        struct run run = strip_on_plane(&rule);
        struct lifted_strip lifted = {.run = {.radius = R}};
        gouge_lift_run(&run, &rule, &lifted);
        ck_assert_uint_gt(lifted.report.unreachable, 0);
        ck_assert_double_gt(lifted.report.unreachable_by, 19.5);
        ck_assert_double_lt(lifted.report.unreachable_by, 20 + 1e-6);
        ck_assert_uint_eq(lifted.end.n, 1);
        for (size_t i = 0; i < lifted.run.n; i++) {
            const struct run_point *p = &lifted.run.item[i];
            if (p->ball.z > 2 * R + 0.01)
                ck_assert_double_eq(vec_length(p->normal), 0);
            if (i > 0)
                ck_assert_double_le(gouge_depth_along(guard, p[-1].ball, p->ball, R), 0.01);
        }
        lifted_strip_free(&lifted);
        array_free(&run);
    }
    gouge_free(guard);
    array_free(&tower);
}
END_TEST

/* One contact lies 2 mm under the floor, more than the ball is lifted, and a plate hangs over it:
 * from there it would go straight up over the plate and back, 14 mm.  What is as wide as the ball
 * is no speck, and is passed over. */
START_TEST(a_speck_is_passed_by)
{
    for (int wide = 0; wide < 2; wide++) {
        struct vec3s point = {0};
        struct run run = {.radius = R};
        struct lifted_strip lifted = {.run = {.radius = R}};
        double highest = 0;

        for (int i = -30; i <= 30; i++)
            for (int k = -30; k <= 30; k++) {
                *array_push(&point) = vec(i / 2.0, k / 2.0, 0);
                if (abs(i) <= 2 && abs(k) <= 2)
                    *array_push(&point) = vec(i / 2.0, k / 2.0, 14);
            }
        struct gouge_check *guard = gouge_new(point, 1);
        struct gouge_lift_options rule = make_rule(guard, true);
        rule.limit = 1;
        for (int i = -16; i <= 16; i++)
            gouge_lift_contact(&run, &rule, vec(i / 2.0, 0, abs(i) <= 6 * wide ? -2 : 0),
                               vec(0, 0, 1));
        gouge_lift_run(&run, &rule, &lifted);
        for (size_t i = 0; i < lifted.run.n; i++)
            highest = fmax(highest, lifted.run.item[i].ball.z);
        for (size_t i = 1; i < lifted.end.item[0]; i++)
            ck_assert_double_le(
                gouge_depth_along(guard, lifted.run.item[i - 1].ball, lifted.run.item[i].ball, R),
                rule.tolerance);
        ck_assert(wide ? highest > 14 + R - 0.1 : highest < R + 0.1);
        ck_assert(wide == (lifted.report.unreachable > 0));
        ck_assert(wide || lifted.end.n == 1);
        lifted_strip_free(&lifted);
        array_free(&run);
        gouge_free(guard);
    }
}
END_TEST

START_TEST(a_hollow_tighter_than_the_ball_is_spanned)
{
    /* A gutter of radius 4 along y, in points 0.1 mm apart; its flanks go on as planes of 45
     * degrees.  The ball of radius 5 touches both flanks: its centre is 5 sqrt(2) above where they
     * meet. */
    struct vec3s gutter = {0};
    double half = 4 * sin(PI / 4);
    for (int i = -100; i <= 100; i++) {
        double x = 0.1 * i;
        double z = fabs(x) < half ? 4 * sqrt(2) - sqrt(16 - x * x) : fabs(x);
        for (int k = -60; k <= 60; k++)
            *array_push(&gutter) = vec(x, 0.1 * k, z);
    }
    struct gouge_check *guard = gouge_from_points(gutter.item, gutter.n);
    struct gouge_lift_options rule = make_rule(guard, true);
    struct run run = {.radius = R};
    for (int i = -4; i <= 4; i++) {
        double u = PI / 4 * i / 4;
        gouge_lift_contact(&run, &rule, vec(4 * sin(u), 0, 4 * sqrt(2) - 4 * cos(u)),
                           vec(-sin(u), 0, cos(u)));
    }
    struct lifted_strip lifted = {.run = {.radius = R}};
    gouge_lift_run(&run, &rule, &lifted);
    for (size_t i = 0; i < lifted.run.n; i++) {
        struct vec3 c = lifted.run.item[i].ball;
        ck_assert_double_le(gouge_depth(guard, c, R), 1e-6);
        /* Not higher than a ball that touches one flank: |x| + 5 sqrt(2). */
        ck_assert_double_le(c.z, fabs(c.x) + R * sqrt(2) + 1e-3);
        ck_assert_double_ge(c.z, fabs(c.x) + R * sqrt(2) - 0.003);
    }
    /* From the lowest point of the ball to the bottom of the gutter. */
    double bottom = -1;
    for (size_t i = 0; i < lifted.uncut.n; i++)
        if (fabs(lifted.uncut.item[i].contact.x) < 0.01)
            bottom = lifted.uncut.item[i].height;
    ck_assert_double_eq_tol(bottom, (R - 4) * (sqrt(2) - 1), 0.01);
    lifted_strip_free(&lifted);
    array_free(&run);
    gouge_free(guard);
    array_free(&gutter);
}
END_TEST

/* Under the equator of a ball: the axis comes no lower than level, and the point is touched. */
START_TEST(what_looks_down_is_touched_from_the_side)
{
    struct vec3s ball = {0};
    for (int i = 0; i < 60000; i++) {
        double z = 1 - 1.6 * (i + 0.5) / 60000, r = sqrt(1 - z * z), a = i * 2.399963229728653;
        *array_push(&ball) = vec(20 * r * cos(a), 20 * r * sin(a), 20 * z);
    }
    struct gouge_check *guard = gouge_from_points(ball.item, ball.n);
    struct gouge_lift_options rule = make_rule(guard, false);
    for (int down = -10; down <= 28; down += 2) {
        struct run run = {.radius = R};
        struct lifted_strip lifted = {.run = {.radius = R}};
        struct vec3 n = vec(cos(RADIANS(down)), 0, -sin(RADIANS(down)));
        rule.feed.along = vec(0, 1, 0);
        rule.feed.side = vec(0, 0, 1);
        rule.feed.up = vec(1, 0, 0);
        gouge_lift_contact(&run, &rule, vec_scale(20, n), n);
        gouge_lift_run(&run, &rule, &lifted);
        const struct run_point *p = &lifted.run.item[0];
        ck_assert_uint_eq(lifted.report.unreachable, 0);
        ck_assert_double_ge(p->axis.z, 0);
        ck_assert_double_ge(vec_dot(p->axis, n), cos(RADIANS(fmax(down, 12))) - 1e-9);
        ck_assert_double_le(vec_distance(p->ball, vec_scale(20 + R, n)), 0.01);
        ck_assert_double_le(vec_distance(p->tip, vec_along(p->ball, -R, p->axis)), 1e-12);
        lifted_strip_free(&lifted);
        array_free(&run);
    }
    gouge_free(guard);
    array_free(&ball);
}
END_TEST

/* ---- over pins, where the height of a ball that comes down on them is known */

static double uniform(double from, double to)
{
    static uint64_t state = 0;
    state = state ? state : seed_begin(88172645463325252u);
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return from + (to - from) * (double)(state >> 11) / 9007199254740992.0;
}

static double height_over(const struct vec3s *part, double x)
{
    double height = R;
    for (size_t i = 0; i < part->n; i++) {
        struct vec3 p = part->item[i];
        double across2 = (p.x - x) * (p.x - x) + p.y * p.y;
        if (across2 < R * R)
            height = fmax(height, p.z + sqrt(R * R - across2));
    }
    return height;
}

/* Pins of heights below 0.4 mm, so that nothing is out of reach, over 12 mm of a strip. */
static struct vec3s make_pins(size_t n)
{
    struct vec3s pins = {0};
    while (pins.n < n)
        *array_push(&pins) = vec(uniform(-6, 6), uniform(-1, 1), uniform(0, 0.4));
    return pins;
}

/* A strip over the pins, `step` from contact to contact, with an upright axis. */
static struct lifted_strip lift_over(const struct gouge_check *guard, double step, bool between)
{
    struct gouge_lift_options rule = make_rule(guard, between);
    struct lifted_strip lifted = {.run = {.radius = R}};
    struct run run = {.radius = R};
    rule.axis = (struct tool_axis_options){.kind = AXIS_FIXED, .direction = {0, 0, 1}};
    for (double x = -6; x < 6; x += step)
        gouge_lift_contact(&run, &rule, vec(x, 0, 0), vec(0, 0, 1));
    gouge_lift_run(&run, &rule, &lifted);
    array_free(&run);
    return lifted;
}

START_TEST(points_are_where_the_ball_comes_down)
{
    for (int round = 0; round < 20; round++) {
        struct vec3s pins = make_pins(30);
        struct gouge_check *guard = gouge_from_points(pins.item, pins.n);
        struct lifted_strip lifted = lift_over(guard, 0.37, false);
        ck_assert_uint_eq(lifted.report.unreachable, 0);
        for (size_t i = 0; i < lifted.run.n; i++) {
            const struct run_point *p = &lifted.run.item[i];
            ck_assert_double_eq_tol(p->ball.z, height_over(&pins, p->ball.x), 1e-5);
            ck_assert_double_eq_tol(p->ball.z - p->tip.z, R, 1e-12);
        }
        lifted_strip_free(&lifted);
        gouge_free(guard);
        array_free(&pins);
    }
}
END_TEST

/* The lines never go deeper than the tolerance.  Half way they are no higher than that over where
 * the ball comes down; a kink beside the middle leaves about twice as much. */
START_TEST(lines_follow_the_ball_and_are_clear)
{
    size_t put = 0, pairs = 0;
    for (int round = 0; round < 40; round++) {
        struct vec3s pins = make_pins(round % 4 == 0 ? 1 : 25);
        struct gouge_check *guard = gouge_from_points(pins.item, pins.n);
        struct lifted_strip lifted = lift_over(guard, 0.5, true);
        pairs += 23;
        put += lifted.run.n - 24;
        for (size_t i = 1; i < lifted.run.n; i++) {
            const struct run_point *a = &lifted.run.item[i - 1], *b = a + 1;
            ck_assert_double_le(gouge_depth_along(guard, a->ball, b->ball, R), 0.01);
            for (double t = 0.05; t < 1; t += 0.05) {
                struct vec3 c = vec_mix(a->ball, b->ball, t);
                ck_assert_double_le(c.z - height_over(&pins, c.x), 2.5 * 0.01);
            }
        }
        lifted_strip_free(&lifted);
        gouge_free(guard);
        array_free(&pins);
    }
    ck_assert_uint_gt(put, pairs / 10);
    ck_assert_uint_lt(put, 2 * pairs);
}
END_TEST

/* Contacts of a coarse mesh over the bottom of a hollow cylinder about x, radius 12. */
START_TEST(a_contact_that_floats_is_let_down_until_the_ball_touches)
{
    struct vec3s shape = {0};
    for (double x = -6; x <= 6; x += 0.1)
        for (double a = -0.6; a <= 0.6; a += 0.005)
            *array_push(&shape) = vec(x, 12 * sin(a), 12 - 12 * cos(a));
    struct gouge_check *guard = gouge_new(shape, 1);
    struct gouge_lift_options rule = make_rule(guard, true);
    struct run run = {.radius = R};
    struct lifted_strip lifted = {.run = {.radius = R}};

    rule.sink = 0.5;
    for (int i = -4; i <= 4; i++)
        gouge_lift_contact(&run, &rule, vec(i, 0, 0.3 + 0.02 * i), vec(0, 0, 1));
    gouge_lift_run(&run, &rule, &lifted);
    ck_assert_uint_eq(lifted.report.lifted, 0);
    for (size_t i = 0; i < lifted.run.n; i++) {
        ck_assert_double_eq_tol(lifted.run.item[i].ball.z, R, 0.001);
        ck_assert_double_eq_tol(run_point_height(&lifted.run.item[i]), R, 1e-9);
    }
    lifted_strip_free(&lifted);
    lifted = (struct lifted_strip){.run = {.radius = R}};
    rule.sink = 0.1; /* nothing is known so near: they stay */
    gouge_lift_run(&run, &rule, &lifted);
    for (size_t i = 0; i < lifted.run.n; i++)
        ck_assert_double_gt(lifted.run.item[i].ball.z, R + 0.21);
    lifted_strip_free(&lifted);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

START_TEST(where_the_ball_does_not_fit_it_runs_on_the_envelope)
{
    struct vec3s groove = {0}; /* a V of 90 degrees: the ball touches both sides */
    for (double x = -6; x <= 6; x += 0.05)
        for (double y = -6; y <= 6; y += 0.05)
            *array_push(&groove) = vec(x, y, fabs(y));
    struct gouge_check *guard = gouge_new(groove, 1);
    struct gouge_lift_options rule = make_rule(guard, true);
    struct run run = {.radius = R};
    struct lifted_strip lifted = {.run = {.radius = R}};

    rule.sink = 0.4; /* contacts of a chord over the groove's bottom, or below it */
    for (int i = -4; i <= 4; i++)
        gouge_lift_contact(&run, &rule, vec(i, 0, 0.3 * sin(i)), vec(0, 0, 1));
    gouge_lift_run(&run, &rule, &lifted);
    for (size_t i = 0; i < lifted.run.n; i++)
        ck_assert_double_eq_tol(lifted.run.item[i].ball.z, R * sqrt(2), 0.001);
    lifted_strip_free(&lifted);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

/* Contacts in a row on a plane, their normals off to and fro across it: the balls stand as much
 * aside; they may be moved back, or have the normals' mean, and touch there. */
START_TEST(a_row_is_straight_though_its_normals_are_not)
{
    struct vec3s plane = {0};
    double aside[3] = {0};

    for (double x = -12; x < 12; x += 0.1)
        for (double y = -1; y < 1; y += 0.1)
            *array_push(&plane) = vec(x, y, 0);
    struct gouge_check *guard = gouge_new(plane, 1);
    for (int k = 0; k < 3; k++) {
        struct gouge_lift_options rule = make_rule(guard, true);
        struct run run = {.radius = R};
        struct lifted_strip lifted = {.run = {.radius = R}};
        rule.aside = k == 1 ? 0.08 : 0;
        rule.even = k == 2 ? 2 : 0;
        for (int i = -8; i <= 8; i++)
            gouge_lift_contact(&run, &rule, vec(i, 0, 0),
                               vec_unit(vec(0, i % 2 == 0 ? -0.01 : 0.01, 1)));
        gouge_lift_run(&run, &rule, &lifted);
        for (size_t i = 0; i < lifted.run.n; i++) {
            const struct run_point *p = &lifted.run.item[i];
            if (fabs(p->ball.x) < 6)
                aside[k] = fmax(aside[k], fabs(p->ball.y));
            ck_assert_double_lt(fabs(p->ball.z - R), 0.003);
            ck_assert_double_lt(gouge_depth(guard, p->ball, R), 2e-6);
        }
        lifted_strip_free(&lifted);
        array_free(&run);
    }
    ck_assert_double_gt(aside[0], 0.045);
    ck_assert_double_lt(aside[1], 0.008);
    ck_assert_double_lt(aside[2], 0.008);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gouge_lift");
    TCase *tests = tcase_create("gouge_lift");
    tcase_add_test(tests, a_point_stands_as_the_offset_says);
    tcase_add_test(tests, a_row_is_straight_though_its_normals_are_not);
    tcase_add_test(tests, without_a_guard_nothing_is_lifted);
    tcase_add_test(tests, a_ball_rolls_over_a_pin);
    tcase_add_test(tests, only_nodes_without_between);
    tcase_add_test(tests, a_tower_is_passed_over_without_a_touch);
    tcase_add_test(tests, a_speck_is_passed_by);
    tcase_add_test(tests, a_hollow_tighter_than_the_ball_is_spanned);
    tcase_add_test(tests, what_looks_down_is_touched_from_the_side);
    tcase_add_test(tests, points_are_where_the_ball_comes_down);
    tcase_add_test(tests, lines_follow_the_ball_and_are_clear);
    tcase_add_test(tests, a_contact_that_floats_is_let_down_until_the_ball_touches);
    tcase_add_test(tests, where_the_ball_does_not_fit_it_runs_on_the_envelope);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
