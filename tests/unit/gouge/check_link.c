/* link: a low arch over a floor, over a low wall, and not over a high one. */
#include "gouge/link.h"

#include <check.h>
#include <stdlib.h>

static const double R = 5;

/* A floor of points 0.5 mm apart with a wall of this height along x at y = 2. */
static struct gouge_check *floor_with_wall(double height)
{
    struct vec3s points = {0};
    for (int i = -20; i <= 20; i++) {
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(0.5 * i, 0.5 * k, 0);
        for (double z = 0; z <= height; z += 0.25)
            *array_push(&points) = vec(0.5 * i, 2, z);
    }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static struct run_point point_at(double y, double z)
{
    struct run_point p = {.ball = vec(0, y, z), .axis = vec(0, 0, 1), .normal = vec(0, 0, 1)};
    p.contact = vec(0, y, z - R);
    p.tip = p.contact;
    return p;
}

/* The low link from y = -4 to y = 8 where the ball stands on the floor or against the wall. */
static bool find_link(double wall, double limit, struct run *link)
{
    struct gouge_check *guard = floor_with_wall(wall);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = limit};
    bool found = link_low(&options, &from, &to, link);
    struct vec3 before = from.ball;
    for (size_t i = 0; found && i <= link->n; i++) {
        struct vec3 ball = i < link->n ? link->item[i].ball : to.ball;
        ck_assert_double_le(gouge_depth_along(guard, before, ball, R), 0.01);
        before = ball;
    }
    gouge_free(guard);
    return found;
}

START_TEST(over_a_floor_it_is_an_arch)
{
    struct run link = {.radius = R};
    double highest = 0;
    ck_assert(find_link(0, R, &link));
    for (size_t i = 0; i < link.n; i++) {
        highest = fmax(highest, link.item[i].ball.z);
        ck_assert_double_eq(vec_length(link.item[i].normal), 0);
    }
    ck_assert_double_eq_tol(highest, R + 1.2, 1e-9);
    array_free(&link);
}
END_TEST

START_TEST(over_a_low_wall_it_is_lifted)
{
    struct run link = {.radius = R};
    double highest = 0;
    ck_assert(find_link(3, R, &link));
    for (size_t i = 0; i < link.n; i++)
        highest = fmax(highest, link.item[i].ball.z);
    ck_assert_double_eq_tol(highest, R + 3, 0.05);
    array_free(&link);
}
END_TEST

START_TEST(no_low_link_over_a_high_wall)
{
    struct run link = {.radius = R};
    ck_assert(!find_link(9, R, &link));
    ck_assert_uint_eq(link.n, 0);
    ck_assert(!find_link(3, 0.5, &link));
    array_free(&link);
}
END_TEST

START_TEST(without_a_guard_it_is_straight)
{
    struct gouge_lift_options rule = {.offset = R};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    struct run link = {.radius = R};
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = R};
    ck_assert(link_low(&options, &from, &to, &link));
    ck_assert_uint_eq(link.n, 0);
}
END_TEST

START_TEST(a_retract_goes_up_the_axis)
{
    struct gouge_check *guard = floor_with_wall(9);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 20, .approach = 2};
    struct run_point p = point_at(-6, R);
    p.axis = vec(0, -0.6, 0.8);
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear);
    ck_assert_double_eq_tol(vec_distance(r.near, p.ball), 2, 1e-12);
    ck_assert_double_eq_tol(vec_angle(vec_sub(r.top, p.ball), p.axis), 0, 1e-9);
    ck_assert_double_eq_tol(r.top.z - R * p.axis.z, 20, 1e-9);
    gouge_free(guard);
}
END_TEST

START_TEST(a_retract_goes_straight_up_where_the_axis_leads_into_the_part)
{
    struct gouge_check *guard = floor_with_wall(30);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 40, .approach = 2};
    struct run_point p = point_at(-4, R);
    p.axis = vec(0, 0.6, 0.8);
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear);
    ck_assert_double_eq_tol(vec_angle(vec_sub(r.top, p.ball), vec(0, 0, 1)), 0, 1e-9);
    gouge_free(guard);
    /* in a slit nothing is clear */
    struct vec3s slit = {0};
    for (double z = 0; z < 30; z += 0.5)
        for (double x = -8; x <= 8; x += 0.5) {
            *array_push(&slit) = vec(x, 1, z + 6);
            *array_push(&slit) = vec(x, -9, z + 6);
        }
    guard = gouge_from_points(slit.item, slit.n);
    rule.guard = guard;
    p.ball = vec(0, -4, 0);
    p.axis = vec(0, 0.6, 0.8);
    rule.offset = R + 0.5;
    r = link_retract(&options, &p);
    ck_assert(!r.clear);
    array_free(&slit);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("link");
    TCase *tests = tcase_create("link");
    tcase_add_test(tests, over_a_floor_it_is_an_arch);
    tcase_add_test(tests, over_a_low_wall_it_is_lifted);
    tcase_add_test(tests, no_low_link_over_a_high_wall);
    tcase_add_test(tests, without_a_guard_it_is_straight);
    tcase_add_test(tests, a_retract_goes_up_the_axis);
    tcase_add_test(tests, a_retract_goes_straight_up_where_the_axis_leads_into_the_part);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
