/* tool_axis: against the formula of the design and against plain geometry. */
#include <check.h>
#include <stdint.h>

#include "curve/tool_axis.h"
#include "seed.h"

static uint64_t state = 3;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

/* Normals of a height field, up to about 60 degrees off z. */
static struct vec3 normal(void)
{
    return vec_unit(vec(uniform(-1, 1), uniform(-1, 1), 1));
}

static struct tool_axis_feed feed_at(double angle, double sign)
{
    return (struct tool_axis_feed){.along = vec(cos(angle), sin(angle), 0),
                                   .side = vec(-sign * sin(angle), sign * cos(angle), 0)};
}

START_TEST(tilt_is_the_angle_off_the_normal_across_the_feed)
{
    for (int i = 0; i < 100; i++) {
        double tilt = RADIANS(uniform(-60, 60));
        struct tool_axis_options rule = {.kind = AXIS_LEAN, .tilt = tilt};
        struct tool_axis_feed feed = feed_at(uniform(0, 6), i % 2 ? 1 : -1);
        struct vec3 n = normal(), a = tool_axis_at(&rule, &feed, vec(0, 0, 0), n);
        struct vec3 t = vec_unit(vec_reject(feed.along, n));
        ck_assert_double_eq_tol(vec_length(a), 1, 1e-12);
        ck_assert_double_eq_tol(vec_dot(a, n), cos(tilt), 1e-12);
        ck_assert_double_eq_tol(vec_dot(a, t), 0, 1e-12);
        /* Positive: towards the next row. */
        ck_assert_double_ge(vec_dot(vec_reject(a, n), feed.side) * tilt, 0);
    }
}
END_TEST

START_TEST(lean_is_the_formula_of_the_design)
{
    for (int i = 0; i < 100; i++) {
        double theta = uniform(0.01, 1), psi = uniform(0.01, 1.5);
        struct tool_axis_options rule = {.kind = AXIS_LEAN,
                                         .tilt = atan(tan(theta) * sin(psi)),
                                         .lead = atan(tan(theta) * cos(psi))};
        struct tool_axis_feed feed = feed_at(uniform(0, 6), 1);
        struct vec3 n = normal(), t = vec_unit(vec_reject(feed.along, n));
        struct vec3 b = vec_cross(n, t);
        struct vec3 lean = vec_add(vec_scale(cos(psi), t), vec_scale(sin(psi), b));
        struct vec3 want = vec_along(vec_scale(cos(theta), n), sin(theta), lean);
        ck_assert_double_lt(vec_distance(tool_axis_at(&rule, &feed, vec(0, 0, 0), n), want), 1e-12);
    }
}
END_TEST

START_TEST(tool_leans_to_the_same_side_on_the_way_back)
{
    struct tool_axis_options tilt = {.kind = AXIS_LEAN, .tilt = 0.3};
    struct tool_axis_options lead = {.kind = AXIS_LEAN, .lead = 0.3};
    for (int i = 0; i < 50; i++) {
        struct tool_axis_feed zig = feed_at(uniform(0, 6), i % 2 ? 1 : -1), zag = zig;
        struct vec3 n = normal(), o = vec(0, 0, 0);
        zag.along = vec_scale(-1, zig.along);
        ck_assert_double_lt(
            vec_distance(tool_axis_at(&tilt, &zig, o, n), tool_axis_at(&tilt, &zag, o, n)), 1e-12);
        /* With a lead it leans the way it feeds: mirrored about the normal. */
        struct vec3 there = tool_axis_at(&lead, &zig, o, n), back = tool_axis_at(&lead, &zag, o, n);
        ck_assert_double_gt(vec_dot(there, zig.along), vec_dot(back, zig.along));
        ck_assert_double_lt(vec_length(vec_cross(vec_add(there, back), n)), 1e-12);
    }
}
END_TEST

/* In a plane of any slope the feed is that of the curve itself: in the plane and on the surface. */
START_TEST(lead_and_tilt_of_a_run_in_a_plane)
{
    for (int i = 0; i < 100; i++) {
        double lead = uniform(0.1, 0.6), tilt = uniform(0.1, 0.6);
        struct tool_axis_options rule = {.kind = AXIS_LEAN, .lead = lead, .tilt = tilt};
        struct vec3 side = vec_unit(vec(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
        struct vec3 n = normal(), o = vec(0, 0, 0);
        double sign = i % 2 ? 1 : -1;
        struct tool_axis_feed feed = {.along = vec(1, 0, 0), .side = side};
        feed.plane = vec_scale(sign, side);
        struct vec3 t = vec_unit(vec_cross(feed.plane, n)), a = tool_axis_at(&rule, &feed, o, n);
        ck_assert_double_eq_tol(vec_dot(t, side), 0, 1e-12);
        ck_assert_double_eq_tol(vec_dot(a, t) / vec_dot(a, n), tan(lead), 1e-12);
        struct vec3 across = vec_unit(vec_reject(side, n));
        ck_assert_double_eq_tol(vec_dot(a, across) / vec_dot(a, n), tan(tilt), 1e-12);
    }
}
END_TEST

START_TEST(axis_goes_through_points_and_circles)
{
    struct tool_axis_feed feed = feed_at(0, 1);
    struct tool_axis_options to = {.kind = AXIS_TO_POINT, .point = vec(1, 2, 300)};
    struct tool_axis_options from = {.kind = AXIS_FROM_POINT, .point = vec(1, 2, -300)};
    struct tool_axis_options circle = {
        .kind = AXIS_CIRCLE, .point = vec(5, 0, 200), .direction = vec(0, 0, 1), .radius = 40};
    for (int i = 0; i < 50; i++) {
        struct vec3 c = vec(uniform(-50, 50), uniform(-50, 50), uniform(0, 20)), n = normal();
        struct vec3 a = tool_axis_at(&to, &feed, c, n);
        ck_assert_double_lt(vec_distance(vec_along(c, vec_distance(c, to.point), a), to.point),
                            1e-9);
        a = tool_axis_at(&from, &feed, c, n);
        ck_assert_double_lt(vec_distance(vec_along(c, -vec_distance(c, from.point), a), from.point),
                            1e-9);

        a = tool_axis_at(&circle, &feed, c, n);
        double best = HUGE_VAL;
        for (int k = 0; k < 3600; k++) {
            double u = k * PI / 1800;
            best = fmin(best, vec_distance(c, vec(5 + 40 * cos(u), 40 * sin(u), 200)));
        }
        struct vec3 hit = vec_along(c, (200 - c.z) / a.z, a);
        ck_assert_double_eq_tol(hypot(hit.x - 5, hit.y), 40, 1e-9);
        ck_assert_double_eq_tol(vec_distance(c, hit), best, 1e-3);
    }
}
END_TEST

START_TEST(axis_has_length_one_where_nothing_tells_it)
{
    struct tool_axis_feed feed = feed_at(0, 1);
    struct tool_axis_options to = {.kind = AXIS_TO_POINT, .point = vec(1, 2, 3)};
    struct tool_axis_options circle = {
        .kind = AXIS_CIRCLE, .point = vec(1, 2, 3), .direction = vec(0, 0, 1), .radius = 4};
    struct tool_axis_options tilt = {.kind = AXIS_LEAN, .tilt = 0.2};
    struct vec3 at = vec(1, 2, 3);
    ck_assert_double_eq(tool_axis_at(&to, &feed, at, vec(0, 0, 1)).z, 1);
    ck_assert_double_eq_tol(vec_length(tool_axis_at(&circle, &feed, at, vec(0, 0, 1))), 1, 1e-12);
    /* A wall that faces the feed: up it. */
    struct vec3 a = tool_axis_at(&tilt, &feed, at, vec(-1, 0, 0));
    ck_assert_double_lt(vec_distance(a, vec(-cos(0.2), sin(0.2), 0)), 1e-12);
}
END_TEST

/* Of all axes of the circle within its travel none is nearer, whatever way it lies; there and back
 * at the ends, and along the pole the one at 0. */
START_TEST(nearest_on_the_circle_of_a_machine)
{
    const double travel[][2] = {{-0.3, 0.5}, {-2, 2}, {1, 4}, {-1e3, 1e3}};
    const struct vec3 pole[] = {{1, 0, 0}, {0, -1, 0}, {0.6, 0.8, 0}};

    for (int i = 0; i < 12; i++) {
        struct axis_circle c = {pole[i % 3], vec(0, 0, 1), travel[i / 3][0], travel[i / 3][1]};
        for (int k = 0; k < 200; k++) {
            double z = sin(k), turn = 7.1 * k, r = sqrt(1 - z * z), nearest = HUGE_VAL;
            struct vec3 a = vec(r * cos(turn), r * sin(turn), z);
            struct vec3 got = axis_circle_nearest(&c, a);
            for (int n = 0; n <= 4000; n++) {
                double q = c.min + n / 4000.0 * fmin(c.max - c.min, 2 * PI);
                nearest = fmin(nearest, vec_distance(vec_turn(c.zero, c.pole, q), a));
            }
            ck_assert_double_eq_tol(vec_length(got), 1, 1e-12);
            ck_assert_double_eq_tol(vec_dot(got, c.pole), 0, 1e-12);
            ck_assert_double_le(vec_distance(got, a), nearest + 1e-9);
            ck_assert_double_ge(vec_distance(got, a), nearest - 2e-3);
        }
        if (c.min < 0)
            ck_assert_double_lt(vec_distance(axis_circle_nearest(&c, c.pole), c.zero), 1e-12);
    }
    struct vec3 any = vec_unit(vec(1, 2, 3));
    ck_assert_double_eq(
        vec_distance(axis_circle_nearest(&(struct axis_circle){.min = 0}, any), any), 0);
    struct tool_axis_options rule = {
        .kind = AXIS_LEAN, .tilt = 0.3, .circle = {vec(1, 0, 0), vec(0, 0, 1), -2, 2}};
    struct tool_axis_feed feed = feed_at(PI / 4, 1);
    ck_assert_double_eq(tool_axis_at(&rule, &feed, vec(0, 0, 0), vec(0, 0, 1)).x, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("tool_axis");
    TCase *tests = tcase_create("tool_axis");
    tcase_add_test(tests, tilt_is_the_angle_off_the_normal_across_the_feed);
    tcase_add_test(tests, lean_is_the_formula_of_the_design);
    tcase_add_test(tests, tool_leans_to_the_same_side_on_the_way_back);
    tcase_add_test(tests, lead_and_tilt_of_a_run_in_a_plane);
    tcase_add_test(tests, axis_goes_through_points_and_circles);
    tcase_add_test(tests, axis_has_length_one_where_nothing_tells_it);
    tcase_add_test(tests, nearest_on_the_circle_of_a_machine);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
