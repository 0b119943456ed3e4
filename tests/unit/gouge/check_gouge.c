/* gouge against a search through all points one by one, and curved facets against a sphere. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "gouge/gouge.h"
#include "gouge/guard_mesh.h"
#include "seed.h"

static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static struct vec3 direction(void)
{
    struct vec3 v = vec(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return vec_length(v) > 0.1 ? vec_unit(v) : vec(0, 0, 1);
}

enum { POINTS = 300 };

static struct vec3 cloud[POINTS];

/* A rough sheet, 20 x 20 mm, 4 mm thick. */
static struct gouge_check *make_guard(void)
{
    for (int i = 0; i < POINTS; i++)
        cloud[i] = vec(uniform(-10, 10), uniform(-10, 10), uniform(-2, 2));
    return gouge_from_points(cloud, POINTS);
}

static double depth(struct vec3 c, double radius)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < POINTS; i++)
        nearest = fmin(nearest, vec_distance(c, cloud[i]));
    return radius - nearest;
}

START_TEST(depth_is_that_of_the_nearest_point)
{
    struct gouge_check *guard = make_guard();
    for (int i = 0; i < 200; i++) {
        struct vec3 c = vec(uniform(-15, 15), uniform(-15, 15), uniform(-8, 8));
        ck_assert_double_eq_tol(gouge_depth(guard, c, 3), depth(c, 3), 1e-12);
    }
    gouge_free(guard);
}
END_TEST

START_TEST(depth_along_is_the_deepest_of_the_way)
{
    struct gouge_check *guard = make_guard();
    for (int i = 0; i < 100; i++) {
        struct vec3 a = vec(uniform(-15, 15), uniform(-15, 15), uniform(-8, 8));
        struct vec3 b = vec_along(a, uniform(0, 12), direction());
        double deepest = -HUGE_VAL;
        for (int k = 0; k <= 1000; k++)
            deepest = fmax(deepest, depth(vec_mix(a, b, k / 1000.0), 3));
        double found = gouge_depth_along(guard, a, b, 3);
        if (deepest > 0) {
            ck_assert_double_ge(found, deepest - 1e-12);
            /* one that was looked at is within half a step of the deepest place */
            double off = 3 - found, half = vec_distance(a, b) / 2000;
            ck_assert_double_le(found, deepest + hypot(off, half) - off + 1e-9);
        } else {
            ck_assert_double_le(found, 1e-4);
        }
    }
    gouge_free(guard);
}
END_TEST

START_TEST(lift_is_the_smallest_that_is_clear)
{
    struct gouge_check *guard = make_guard();
    for (int i = 0; i < 200; i++) {
        struct vec3 c = vec(uniform(-10, 10), uniform(-10, 10), uniform(-4, 4));
        struct vec3 up = direction();
        double lift = gouge_least_lift(guard, c, up, 2.5, 50, NULL);
        ck_assert_double_ge(lift, 0);
        ck_assert_double_le(depth(vec_along(c, lift, up), 2.5), 1.1e-6);
        for (int k = 0; lift > 0 && k < 500; k++)
            ck_assert_double_gt(depth(vec_along(c, lift * k / 500, up), 2.5), -1e-9);
        if (lift > 0.1)
            ck_assert_double_eq(gouge_least_lift(guard, c, up, 2.5, 0.99 * lift, NULL), -1);
    }
    gouge_free(guard);
}
END_TEST

START_TEST(rise_is_the_last_place_that_is_not_clear)
{
    struct gouge_check *guard = make_guard();
    for (int i = 0; i < 200; i++) {
        struct vec3 c = vec(uniform(-10, 10), uniform(-10, 10), uniform(-12, 4));
        struct vec3 up = direction();
        double highest = 0;
        for (int k = 0; k < POINTS; k++) {
            struct vec3 d = vec_sub(cloud[k], c);
            double along = vec_dot(d, up), across = vec_length(vec_reject(d, up));
            if (across < 2.5)
                highest = fmax(highest, along + sqrt(2.5 * 2.5 - across * across));
        }
        double rise = gouge_rise(guard, c, up, 2.5);
        ck_assert_double_eq_tol(rise, highest, 1e-2);
        ck_assert_double_ge(rise, gouge_least_lift(guard, c, up, 2.5, HUGE_VAL, NULL) - 1e-9);
        ck_assert(gouge_open(guard, vec_along(c, rise, up), up, 2.5, 1e-5));
        if (rise > 0.1)
            ck_assert(!gouge_open(guard, vec_along(c, rise - 0.1, up), up, 2.5, 1e-5));
        double lift = gouge_least_lift(guard, c, up, 2.5, HUGE_VAL, NULL);
        struct vec3 clear = vec_along(c, lift, up), z = vec(0, 0, 1);
        ck_assert_int_eq(gouge_free_above(guard, clear, 2.49),
                         gouge_open(guard, clear, z, 2.5, 0.01));
    }
    gouge_free(guard);
}
END_TEST

START_TEST(holders_are_clear_where_no_point_is_nearer)
{
    struct gouge_check *guard = make_guard();
    struct holder holder = {.n = 1, .part = {{2, 4, 6}}};
    struct kdtree_touch met = {.n = 0};
    int clear = 0;
    for (int i = 0; i < 400; i++) {
        struct vec3 c = vec(uniform(-10, 10), uniform(-10, 10), uniform(-4, 14));
        struct vec3 axis = direction();
        double least = uniform(-1, 1), nearest = HUGE_VAL;
        for (int k = 0; k < POINTS; k++)
            nearest = fmin(nearest, holder_distance(&holder, c, axis, cloud[k]));
        ck_assert_double_eq(gouge_holder(guard, &holder, c, axis, 99), fmin(nearest, 99));
        ck_assert_int_eq(gouge_holder_clear(guard, &holder, c, axis, least, NULL),
                         nearest >= least);
        ck_assert_int_eq(gouge_holder_clear(guard, &holder, c, axis, least, &met),
                         nearest >= least);
        clear += nearest >= least;
    }
    ck_assert(clear > 50 && clear < 350);
    gouge_free(guard);
}
END_TEST

static struct gouge_check *guard_of_mesh(const struct mesh *mesh, double spacing)
{
    struct vec3s points = {0};
    const struct guard_mesh_options how = {spacing, HUGE_VAL, GUARD_CURVED, 1};
    guard_points_of_mesh(mesh, NULL, &how, &points);
    return gouge_new(points, 1);
}

/* One facet of a sphere around the origin seen from above: its top, or hollow its bottom. */
static struct gouge_check *facet_on_sphere(double radius, double side, double sign, double spacing)
{
    struct mesh mesh = {0};
    double r = side / sqrt(3), z = sqrt(radius * radius - r * r);

    for (int i = 0; i < 3; i++) {
        double angle = 2 * PI * i / 3;
        struct vec3 p = vec(r * cos(angle), r * sin(angle), sign * z);
        *array_push(&mesh.vertex) = p;
        *array_push(&mesh.normal) = vec_scale(sign / radius, p);
    }
    *array_push(&mesh.face) = (struct face){{0, 1, 2}};
    struct gouge_check *guard = guard_of_mesh(&mesh, spacing);
    mesh_free(&mesh);
    return guard;
}

START_TEST(curved_facets_keep_to_a_sphere)
{
    /* Distance of the guard from points on the sphere: nowhere more than half a raster step and
     * what the curved facet leaves the sphere, 0.001 mm, where the flat one leaves it by 0.17. */
    for (double sign = -1; sign <= 1; sign += 2) {
        struct gouge_check *guard = facet_on_sphere(16, 4, sign, 0.05);
        for (int i = 0; i < 50; i++) {
            double s = uniform(0, 0.9), angle = uniform(0, 2 * PI);
            struct vec3 p = vec(s * cos(angle), s * sin(angle), sign * sqrt(256 - s * s));
            ck_assert_double_lt(gouge_distance(guard, p, HUGE_VAL), 0.05);
            double off = gouge_distance(guard, vec_along(p, 2, vec_scale(sign / 16, p)), HUGE_VAL);
            ck_assert_double_eq_tol(off, 2, 0.002);
        }
        gouge_free(guard);
    }
}
END_TEST

START_TEST(facet_over_a_step_is_flat)
{
    struct mesh mesh = {0};
    *array_push(&mesh.vertex) = vec(0, 0, 0);
    *array_push(&mesh.vertex) = vec(4, 0, 8);
    *array_push(&mesh.vertex) = vec(0, 4, 0);
    for (int i = 0; i < 3; i++)
        *array_push(&mesh.normal) = vec(0, 0, 1);
    *array_push(&mesh.face) = (struct face){{0, 1, 2}};
    struct gouge_check *guard = guard_of_mesh(&mesh, 0.1);
    struct vec3 normal = vec_unit(mesh_face_cross(&mesh, 0));
    struct vec3 inner = vec(1, 1, 2);
    for (double h = 1; h < 4; h++) {
        struct vec3 p = vec_along(inner, h, normal);
        ck_assert_double_eq_tol(gouge_distance(guard, p, HUGE_VAL), h, 0.01);
        ck_assert_double_eq(gouge_distance(guard, p, h / 2), h / 2);
    }
    ck_assert_double_eq(gouge_top(guard), 8);
    gouge_free(guard);
    mesh_free(&mesh);
}
END_TEST

START_TEST(clear_along_is_what_the_depth_along_says)
{
    struct gouge_check *guard = make_guard();
    int clear = 0;
    for (int i = 0; i < 400; i++) {
        struct vec3 a = vec(uniform(-15, 15), uniform(-15, 15), uniform(-8, 12));
        struct vec3 b = vec_along(a, uniform(0, 12), i % 3 ? direction() : vec(0, 0, 1));
        double depth = uniform(0.01, 1);
        bool said = gouge_clear_along(guard, a, b, 3, depth);
        ck_assert_int_eq(said, gouge_depth_along(guard, a, b, 3) <= depth);
        clear += said;
    }
    ck_assert_int_gt(clear, 50);
    ck_assert_int_lt(clear, 350);
    gouge_free(guard);
}
END_TEST

/* The nearest that a holder comes is found pose by pose, and of ways that come within a step of
 * what is asked nothing is said. */
START_TEST(holders_are_clear_on_their_way)
{
    struct gouge_check *guard = make_guard();
    struct holder holder = {.n = 2, .part = {{2, 2, 6}, {4, 5, 9}}};
    struct kdtree_touch met = {.n = 0};
    int clear = 0, sure = 0;
    for (int i = 0; i < 300; i++) {
        struct vec3 a = vec(uniform(-10, 10), uniform(-10, 10), uniform(-4, 14));
        struct vec3 b = vec_along(a, uniform(0, 6), direction()), axis = direction();
        double least = uniform(-1, 1), nearest = HUGE_VAL;
        for (int k = 0; k <= 600; k++)
            nearest =
                fmin(nearest, gouge_holder(guard, &holder, vec_mix(a, b, k / 600.0), axis, 99));
        bool said = gouge_holder_clear_along(guard, &holder, a, b, axis, least, &met);
        if (fabs(nearest - least) > GOUGE_STEP)
            ck_assert_int_eq(said, nearest >= least);
        sure += fabs(nearest - least) > GOUGE_STEP;
        clear += said;
    }
    ck_assert_int_gt(sure, 250);
    ck_assert(clear > 30 && clear < 270);
    gouge_free(guard);
}
END_TEST

/* What was in the way before is told first and changes no answer. */
START_TEST(open_anyhow_by_what_was_in_the_way)
{
    struct gouge_check *guard = make_guard();
    struct gouge_ways ways = {.normal = {.n = 0}};
    int open = 0;
    for (int i = 0; i < 400; i++) {
        struct vec3 c = vec(uniform(-9, 9), uniform(-9, 9), uniform(-9, 6)), normal = direction();
        bool said = gouge_open_anyhow(guard, c, normal, 2.5, 0.1, &ways);
        ck_assert_int_eq(said, gouge_open_anyhow(guard, c, normal, 2.5, 0.1, NULL));
        open += said;
    }
    ck_assert_int_gt(open, 40);
    ck_assert_int_lt(open, 360);
    gouge_free(guard);
}
END_TEST

START_TEST(without_points_all_is_clear)
{
    struct gouge_check *guard = gouge_from_points(NULL, 0);
    ck_assert_double_eq(gouge_least_lift(guard, vec(0, 0, 0), vec(0, 0, 1), 5, 10, NULL), 0);
    ck_assert_double_eq(gouge_rise(guard, vec(0, 0, 0), vec(0, 0, 1), 5), 0);
    ck_assert_double_lt(gouge_depth(guard, vec(0, 0, 0), 5), 0);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gouge");
    TCase *tests = tcase_create("gouge");
    tcase_add_test(tests, depth_is_that_of_the_nearest_point);
    tcase_add_test(tests, depth_along_is_the_deepest_of_the_way);
    tcase_add_test(tests, lift_is_the_smallest_that_is_clear);
    tcase_add_test(tests, rise_is_the_last_place_that_is_not_clear);
    tcase_add_test(tests, holders_are_clear_where_no_point_is_nearer);
    tcase_add_test(tests, curved_facets_keep_to_a_sphere);
    tcase_add_test(tests, facet_over_a_step_is_flat);
    tcase_add_test(tests, clear_along_is_what_the_depth_along_says);
    tcase_add_test(tests, holders_are_clear_on_their_way);
    tcase_add_test(tests, open_anyhow_by_what_was_in_the_way);
    tcase_add_test(tests, without_points_all_is_clear);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
