/* way over a floor, over a low wall, and not over a high one. */
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

/* The way from y = -4 to y = 8 where the ball stands on the floor or against the wall. */
static bool find_way(double wall, double limit, struct run *way)
{
    struct gouge_check *guard = floor_with_wall(wall);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    bool found = link_low(&from, &to, &rule, limit, way);
    struct vec3 before = from.ball;
    for (size_t i = 0; found && i <= way->n; i++) {
        struct vec3 ball = i < way->n ? way->item[i].ball : to.ball;
        ck_assert_double_le(gouge_depth_along(guard, before, ball, R), 0.01);
        before = ball;
    }
    gouge_free(guard);
    return found;
}

START_TEST(over_a_floor_it_is_an_arch)
{
    struct run way = {.radius = R};
    double highest = 0;
    ck_assert(find_way(0, R, &way));
    for (size_t i = 0; i < way.n; i++) {
        highest = fmax(highest, way.item[i].ball.z);
        ck_assert_double_eq(vec_length(way.item[i].normal), 0);
    }
    ck_assert_double_eq_tol(highest, R + 1.2, 1e-9);
    array_free(&way);
}
END_TEST

START_TEST(over_a_low_wall_it_is_lifted)
{
    struct run way = {.radius = R};
    double highest = 0;
    ck_assert(find_way(3, R, &way));
    for (size_t i = 0; i < way.n; i++)
        highest = fmax(highest, way.item[i].ball.z);
    ck_assert_double_eq_tol(highest, R + 3, 0.05);
    array_free(&way);
}
END_TEST

START_TEST(a_high_wall_is_no_way)
{
    struct run way = {.radius = R};
    ck_assert(!find_way(9, R, &way));
    ck_assert_uint_eq(way.n, 0);
    ck_assert(!find_way(3, 0.5, &way));
    array_free(&way);
}
END_TEST

START_TEST(without_a_guard_it_is_straight)
{
    struct gouge_lift_options rule = {.offset = R};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    struct run way = {.radius = R};
    ck_assert(link_low(&from, &to, &rule, R, &way));
    ck_assert_uint_eq(way.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("way");
    TCase *tests = tcase_create("way");
    tcase_add_test(tests, over_a_floor_it_is_an_arch);
    tcase_add_test(tests, over_a_low_wall_it_is_lifted);
    tcase_add_test(tests, a_high_wall_is_no_way);
    tcase_add_test(tests, without_a_guard_it_is_straight);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
