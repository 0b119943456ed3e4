/*
 * lift_place: the axis and the tip of a centre that was put somewhere, and whether the ball stays
 * clear between two places, by the distance of a point from a straight line.
 */
#include <check.h>

#include "gouge/gouge.h"
#include "gouge/lift_place.h"
#include "math/elementary.h"
#include "seed.h"

enum { RADIUS = 4 };

static double part(void)
{
    static uint64_t state = 20;
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* The tool stands on the normal: the tip is a radius below the centre, whatever it was before. */
START_TEST(tip_below_the_centre)
{
    struct gouge_lift_options rule = {.offset = RADIUS, .axis = {.kind = AXIS_LEAN}};
    struct run_point p = {.normal = vec(0.6, 0, 0.8), .axis = vec(0, 0, 1), .tip = vec(9, 9, 9)};
    lift_place(&p, vec(1, 2, 3), &rule, RADIUS);
    ck_assert_double_lt(vec_distance(p.ball, vec(1, 2, 3)), 1e-15);
    ck_assert_double_lt(vec_distance(p.axis, p.normal), 1e-12);
    ck_assert_double_lt(vec_distance(p.tip, vec(1 - 2.4, 2, 3 - 3.2)), 1e-12);
}
END_TEST

/* A surface that faces down is touched by a level tool, unless it faces down so far that the ball
 * would not touch it beside its shank; without a guard, or where the axis does not lean with the
 * surface, the axis is what the rule says. */
START_TEST(level_where_the_surface_faces_down)
{
    struct gouge_check *guard = gouge_new((struct vec3s){0}, 1);
    for (int down = -10; down <= 89; down++) {
        double d = RADIANS(down);
        struct gouge_lift_options rule = {
            .guard = guard, .offset = RADIUS, .axis = {.kind = AXIS_LEAN}};
        struct run_point p = {.normal = vec(0.6 * cos(d), 0.8 * cos(d), -sin(d))}, q = p;
        bool turned = down > 0 && down < 80;
        struct vec3 want = turned ? vec(0.6, 0.8, 0) : p.normal;
        if (down == 80) /* to the last digit */
            continue;
        lift_place_along(&p, vec(1, 2, 3), &rule, RADIUS);
        ck_assert_double_lt(vec_distance(p.axis, want), 1e-12);
        ck_assert_double_lt(vec_distance(p.tip, vec_along(vec(1, 2, 3), -RADIUS, want)), 1e-12);
        rule.guard = NULL;
        lift_place_along(&q, vec(1, 2, 3), &rule, RADIUS);
        ck_assert_double_lt(vec_distance(q.axis, q.normal), 1e-12);
        rule.guard = guard;
        rule.axis = (struct tool_axis_options){.kind = AXIS_FIXED, .direction = p.normal};
        lift_place_along(&q, vec(1, 2, 3), &rule, RADIUS);
        ck_assert_double_lt(vec_distance(q.axis, q.normal), 1e-12);
    }
    gouge_free(guard);
}
END_TEST

/* Two centres at the offset from a point: between them the ball is as deep as the sagitta, however
 * that is known. */
START_TEST(clear_between_two_places)
{
    struct gouge_lift_options rule = {.offset = RADIUS, .tolerance = 0.01};
    int clear = 0, deep = 0;
    for (int k = 0; k < 2000; k++) {
        struct vec3 at = vec(20 * part(), 20 * part(), 20 * part());
        struct vec3s points = {0};
        *array_push(&points) = at;
        struct gouge_check *guard = gouge_new(points, 1);
        struct vec3 u = vec_unit(vec(part() - 0.5, part() - 0.5, part() - 0.5));
        struct vec3 v = vec_unit(vec_cross(u, vec(part(), part(), 1)));
        double half = part() / RADIUS, c = cos(half), s = sin(half);
        struct run_point a = {.ball = vec_along(vec_along(at, RADIUS * c, u), RADIUS * s, v)};
        struct run_point b = {.ball = vec_along(vec_along(at, RADIUS * c, u), -RADIUS * s, v)};
        double depth = RADIUS * (1 - c), may = GOUGE_SAFE * rule.tolerance;
        rule.guard = guard;
        if (fabs(depth - may) > 2e-5) {
            ck_assert_int_eq(lift_line_clear(&a, &b, &rule), depth < may);
            clear += depth < may;
            deep += depth > may;
        }
        rule.guard = NULL;
        ck_assert(lift_line_clear(&a, &b, &rule));
        gouge_free(guard);
    }
    ck_assert_int_gt(clear, 100);
    ck_assert_int_gt(deep, 100);
}
END_TEST

/* What is clear may be a hundredth of a micrometre deep: the ball is not let deeper for it. */
START_TEST(as_deep_as_it_may)
{
    struct gouge_lift_options rule = {.offset = RADIUS, .tolerance = 0.01};
    double may = GOUGE_SAFE * rule.tolerance, r = RADIUS - 0.9e-5;
    for (int k = 1; k <= 20; k++)
        for (int side = -1; side <= 1; side += 2) {
            double c = (RADIUS - may - side * 0.2e-5 * k) / r, s = sqrt(1 - c * c);
            struct vec3s points = {0};
            *array_push(&points) = vec(0, 0, 0);
            struct gouge_check *guard = gouge_new(points, 1);
            struct run_point a = {.ball = vec(r * s, 0, r * c)},
                             b = {.ball = vec(-r * s, 0, r * c)};
            rule.guard = guard;
            ck_assert_int_eq(lift_line_clear(&a, &b, &rule), side < 0);
            gouge_free(guard);
        }
}
END_TEST

/* A long way beside a point and one through it. */
START_TEST(clear_on_a_long_way)
{
    struct gouge_lift_options rule = {.offset = RADIUS, .tolerance = 0.01};
    for (int k = -40; k <= 40; k++) {
        double height = RADIUS + 0.0005 * k;
        struct vec3s points = {0};
        *array_push(&points) = vec(3, 0, 0);
        struct gouge_check *guard = gouge_new(points, 1);
        struct run_point a = {.ball = vec(-30, 0, height)}, b = {.ball = vec(30, 0, height)};
        rule.guard = guard;
        if (k != -15)
            ck_assert_int_eq(lift_line_clear(&a, &b, &rule), k > -15);
        gouge_free(guard);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lift_place");
    TCase *tests = tcase_create("lift_place");
    tcase_add_test(tests, tip_below_the_centre);
    tcase_add_test(tests, level_where_the_surface_faces_down);
    tcase_add_test(tests, clear_between_two_places);
    tcase_add_test(tests, as_deep_as_it_may);
    tcase_add_test(tests, clear_on_a_long_way);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
