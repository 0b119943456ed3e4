/*
 * check_tool_shape - the tool above its ball: distances known by hand, against the nearest of many
 * places, and against the formulas that guard paths.
 */
#include <check.h>
#include <stdlib.h>

#include "gouge/holder.h"
#include "simulate/tool_shape.h"
#include "seed.h"

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + seed_step_32();
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

/* A shaft of 3, on it a cone from 10 to 25, on it a cylinder. */
static struct tool_shape stack(void)
{
    struct tool_shape shape = {0};
    ck_assert(tool_shape_add(&shape, (struct tool_span){60, 120, 25, 25}));
    ck_assert(tool_shape_add(&shape, (struct tool_span){0, 40, 3, 3}));
    ck_assert(tool_shape_add(&shape, (struct tool_span){40, 60, 10, 25}));
    return shape;
}

START_TEST(distances_known_by_hand)
{
    struct vec3 c = vec(1, 2, 3), up = vec(0, 0, 1);
    struct tool_shape shape = stack();
    static const struct {
        double r, h, distance;
    } at[] = {
        {0, -2, 2},    {2, -1, 1},   {5, 20, 2},  {1, 20, -2},     {0, 0.5, -0.5},
        {3, 39, 0},    {6, 39, 1},   {30, 90, 5}, {0, 125, 5},     {28, 124, 5},
        {10, 70, -15}, {0, 119, -1}, {6, 40, 0},  {16.8, 47.4, 1},
    };
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct vec3 p = vec_add(c, vec(0.6 * at[i].r, -0.8 * at[i].r, at[i].h));
        double d = tool_shape_distance(&shape, c, up, p);
        ck_assert_msg(fabs(d - at[i].distance) < 1e-9, "%zu: %.12f", i, d);
    }
    ck_assert_double_eq_tol(tool_shape_reach(&shape), hypot(25, 120), 1e-12);
    ck_assert_double_eq(tool_shape_widest(&shape), 25);
    ck_assert_double_eq(tool_shape_distance(&(struct tool_shape){0}, c, up, c), HUGE_VAL);
}
END_TEST

/* Parts at one height: the larger radius counts, a cone is cut where it comes out of a cylinder. */
START_TEST(the_larger_radius_counts)
{
    struct tool_shape shape = {0};
    tool_shape_add(&shape, (struct tool_span){0, 20, 5, 5});
    tool_shape_add(&shape, (struct tool_span){0, 60, 3, 3});
    tool_shape_add(&shape, (struct tool_span){10, 30, 0, 10});
    ck_assert_int_eq(shape.n, 4); /* 0-20 the cylinder, to 30 the cone, to 60 the shank */
    for (double h = 0.5; h < 60; h++) {
        double want = h < 20 ? 5 : h < 30 ? (h - 10) / 2 : 3;
        ck_assert_double_eq_tol(tool_shape_radius(&shape, h), want, 1e-12);
    }
    struct vec3 c = vec(0, 0, 0), up = vec(0, 0, 1);
    ck_assert_double_eq_tol(tool_shape_distance(&shape, c, up, vec(7, 0, 8)), 2, 1e-12);
    ck_assert_double_eq_tol(tool_shape_distance(&shape, c, up, vec(0, 4, 50)), 1, 1e-12);
    ck_assert_double_eq_tol(tool_shape_distance(&shape, c, up, vec(1, 0, 20)), -4, 1e-12);
}
END_TEST

/* Two cones that cross at a height of 8, where both have a radius of 6; either first. */
START_TEST(cones_that_cross)
{
    const struct tool_span wide_below = {0, 20, 10, 0}, wide_above = {0, 20, 2, 12};
    for (int first = 0; first < 2; first++) {
        struct tool_shape shape = {0};
        ck_assert(tool_shape_add(&shape, first ? wide_below : wide_above));
        ck_assert(tool_shape_add(&shape, first ? wide_above : wide_below));
        ck_assert_int_eq(shape.n, 2);
        for (double h = 0.25; h < 20; h += 0.5)
            ck_assert_double_eq_tol(tool_shape_radius(&shape, h), fmax(10 - h / 2, 2 + h / 2),
                                    1e-12);
    }
}
END_TEST

/* The same stacks by the formulas of gouge/holder.h, which are others: outside and inside alike. */
START_TEST(as_what_guards_the_path_has_it)
{
    static const struct holder guard = {3, {{3, 3, 40}, {10, 25, 20}, {25, 25, 60}}};
    struct tool_shape shape = stack();
    unsigned state = 7;
    for (int trial = 0; trial < 20000; trial++) {
        struct vec3 axis = vec_unit(vec(random_in(&state, -1, 1), random_in(&state, -1, 1), 1));
        struct vec3 c =
            vec(random_in(&state, -9, 9), random_in(&state, -9, 9), random_in(&state, -9, 9));
        struct vec3 p = vec(random_in(&state, -90, 90), random_in(&state, -90, 90),
                            random_in(&state, -40, 150));
        ck_assert_double_eq_tol(tool_shape_distance(&shape, c, axis, p),
                                holder_distance(&guard, c, axis, p), 1e-9);
    }
}
END_TEST

START_TEST(bounds_hold)
{
    struct tool_shape shape = stack();
    struct vec3 axis = vec_unit(vec(0.3, -0.2, 0.9)), c = vec(0, 0, 0), half = vec(6, 4, 9);
    unsigned state = 3;
    for (int trial = 0; trial < 20000; trial++) {
        struct vec3 middle = vec(random_in(&state, -60, 60), random_in(&state, -60, 60),
                                 random_in(&state, -30, 140));
        struct vec3 p = vec_add(middle, vec(random_in(&state, -6, 6), random_in(&state, -4, 4),
                                            random_in(&state, -9, 9)));
        ck_assert(tool_shape_bound(&shape, c, axis, middle, half) <=
                  tool_shape_distance(&shape, c, axis, p) + 1e-9);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("tool_shape");
    TCase *tcase = tcase_create("tool_shape");
    tcase_add_test(tcase, distances_known_by_hand);
    tcase_add_test(tcase, the_larger_radius_counts);
    tcase_add_test(tcase, cones_that_cross);
    tcase_add_test(tcase, as_what_guards_the_path_has_it);
    tcase_add_test(tcase, bounds_hold);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
