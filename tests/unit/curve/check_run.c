/* Tests of run.h against circles, where tangents and the reference curve are known. */
#include "curve/run.h"

#include <check.h>
#include <stdlib.h>
#include "seed.h"

static struct run_point pose(struct vec3 ball, struct vec3 axis, double radius)
{
    return (struct run_point){
        .tip = vec_along(ball, -radius, axis), .ball = ball, .axis = axis, .given = true};
}

/* A ball of radius 8 inside a cylinder of radius 20 (its axis is y): the centre goes round on
 * radius 12, the tool axis leans by 0.2 against the normal, the tip is on a circle too. */
static struct run in_cylinder(size_t n, double step)
{
    struct run run = {.radius = 8};
    for (size_t i = 0; i < n; i++) {
        double u = step * (double)i;
        struct vec3 axis = vec(-sin(u) * cos(0.2), sin(0.2), cos(u) * cos(0.2));
        struct run_point p = pose(vec(12 * sin(u), 0, -12 * cos(u)), axis, 8);
        p.normal = vec(-sin(u), 0, cos(u));
        p.contact = vec(20 * sin(u), 0, -20 * cos(u));
        *array_push(&run) = p;
    }
    return run;
}

START_TEST(tangents_of_a_circle_are_exact)
{
    struct run run = in_cylinder(9, 0.3);
    struct vec3 t[9];
    run_tangents(&run, false, t);
    for (size_t i = 0; i < run.n; i++) {
        double u = 0.3 * (double)i;
        ck_assert_double_lt(vec_distance(t[i], vec(cos(u), 0, sin(u))), 1e-12);
    }
    array_free(&run);
}
END_TEST

START_TEST(forward_tangents_are_those_of_the_paper)
{
    struct run run = in_cylinder(5, 0.3);
    run.item[1].normal = vec(0.6, 0.64, 0.48);
    struct vec3 t[5];
    run_tangents(&run, true, t);
    for (size_t i = 0; i < run.n; i++) {
        size_t j = i + 1 < run.n ? i : i - 1;
        struct vec3 chord = vec_sub(run.item[j + 1].ball, run.item[j].ball);
        struct vec3 n = run.item[i].normal;
        struct vec3 v = vec_cross(chord, n);
        ck_assert_double_lt(vec_distance(t[i], vec_unit(vec_cross(n, v))), 1e-12);
    }
    array_free(&run);
}
END_TEST

START_TEST(a_lifted_centre_keeps_its_slope)
{
    struct run run = {.radius = 8};
    for (int i = 0; i < 5; i++) {
        struct run_point p = pose(vec(i, 0, 8 + 0.1 * i), vec(0, 0, 1), 8);
        p.contact = vec(i, 0, 0);
        p.normal = vec(0, 0, 1);
        *array_push(&run) = p;
    }
    struct vec3 t[5], slope = vec_unit(vec(1, 0, 0.1));
    run_tangents(&run, false, t);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_lt(vec_distance(t[i], slope), 2e-3);
    array_free(&run);
}
END_TEST

/* A centre that comes down a flank or off an edge onto a floor, in short steps and at once in a
 * long one: x and height of the ball, of R 3, with its normal's x and how far it is off its
 * contact. */
static double deepest_below(const double way[][4], size_t n, double floor)
{
    struct run run = {.radius = 3};
    double deepest = 0;
    for (size_t i = 0; i < n; i++) {
        struct run_point p = pose(vec(way[i][0], 0, way[i][1]), vec(0, 0, 1), 3);
        p.normal = vec(way[i][2], 0, sqrt(1 - way[i][2] * way[i][2]));
        p.contact = vec_along(p.ball, -way[i][3], p.normal);
        *array_push(&run) = p;
    }
    struct run dense = {.radius = 3};
    run_densify(&run, 1e-4, &dense);
    for (size_t i = 0; i < dense.n; i++)
        deepest = fmax(deepest, floor - dense.item[i].ball.z);
    array_free(&run);
    array_free(&dense);
    return deepest;
}

START_TEST(beside_an_inner_edge_the_way_stays_on_its_chords)
{
    static const double flank[][4] = {{-9.0140, 12.9545, -0.978, 3}, {-9.2297, 11.9399, -0.978, 3},
                                      {-9.4219, 11.0358, -0.978, 3}, {-9.4548, 11, 0, 3},
                                      {-10.6514, 11, 0, 3},          {-11.848, 11, 0, 3}};
    static const double edge[][4] = {{-1.1951, 8.3020, 0, 3.30205},
                                     {-1.0722, 8.1807, 0, 3.18065},
                                     {-0.9440, 8.0648, 0, 3.06479},
                                     {-0.7916, 8.0010, 0, 3.00098},
                                     {0.2410, 8, 0, 3},
                                     {0.7575, 8, 0, 3}};
    static const double turned[][4] = {{17.0009, 9.0155, 0.096, 3.13132},
                                       {17.1669, 9, 0, 3},
                                       {17.9926, 9, 0, 3},
                                       {18.3632, 9, 0, 3}};
    ck_assert_double_lt(deepest_below(flank, 6, 11), 0.01);
    ck_assert_double_lt(deepest_below(edge, 6, 8), 0.011);
    ck_assert_double_lt(deepest_below(turned, 4, 9), 0.01);
}
END_TEST

/* Nothing guards the run: ball centres, of R 3, with their normals and how far they are off their
 * contacts; the farthest that its smooth curve is off the lines between them. */
static double farthest_astray(const double way[][7], size_t n)
{
    struct run run = {.radius = 3, .edges = true}, dense = {.radius = 3};
    double farthest = 0;
    for (size_t i = 0; i < n; i++) {
        struct run_point p = pose(vec(way[i][0], way[i][1], way[i][2]), vec(0, 0, 1), 3);
        p.normal = vec_unit(vec(way[i][3], way[i][4], way[i][5]));
        p.contact = vec_along(p.ball, -way[i][6], p.normal);
        *array_push(&run) = p;
    }
    run_densify(&run, 1e-4, &dense);
    for (size_t i = 0; i < dense.n; i++) {
        double near = HUGE_VAL;
        for (size_t k = 0; k + 1 < run.n; k++)
            near = fmin(near, vec_segment_distance(run.item[k].ball, run.item[k + 1].ball,
                                                   dense.item[i].ball));
        farthest = fmax(farthest, near);
    }
    array_free(&run);
    array_free(&dense);
    return farthest;
}

/* Down the flank of a pocket onto its floor, a turn of 53 degrees; along a cylinder and away over
 * another; off the edge between two cylinders onto one of them, a turn of 7 degrees. */
START_TEST(an_edge_that_nothing_guards_is_not_rounded)
{
    static const double pocket[][7] = {{6.5929, 1.4972, 4.6593, -0.745, 0, 0.667, 3},
                                       {5.9035, 1.4972, 3.8898, -0.745, 0, 0.667, 3},
                                       {5.2140, 1.4972, 3.1205, -0.745, 0, 0.667, 3},
                                       {4.7360, 1.4972, 2.5971, 0.087, 0, 0.996, 3},
                                       {3.7087, 1.4972, 2.6870, 0.087, 0, 0.996, 3},
                                       {2.6813, 1.4972, 2.7769, 0.087, 0, 0.996, 3}};
    static const double away[][7] = {{8.1917, -3.7573, 5.5087, 0.909, -0.417, 0, 3.0122},
                                     {8.1926, -3.7577, 4.3170, 0.909, -0.417, 0, 3.0132},
                                     {8.1933, -3.7581, 3.3020, 0.909, -0.417, 0, 3.0141},
                                     {8.4597, -3.8798, 3.1210, 0.909, -0.417, 0, 3.3070},
                                     {8.8571, -4.0614, 2.8436, 0.909, -0.417, 0, 3.7438},
                                     {9.2489, -4.2402, 2.5607, 0.909, -0.417, 0, 4.1746}};
    static const double knee[][7] = {{3.4236, 9.3202, 5.2874, -0.12934, 0.92588, 0.35499, 3.0609},
                                     {3.7268, 9.2798, 5.3814, -0.12928, 0.92586, 0.35507, 3.0209},
                                     {3.8815, 9.2606, 5.4290, -0.12925, 0.92584, 0.35512, 3},
                                     {6.3594, 9.2596, 6.3335, -0.12925, 0.92584, 0.35512, 3},
                                     {8.8372, 9.2586, 7.2379, -0.12925, 0.92584, 0.35512, 3}};
    ck_assert_double_lt(farthest_astray(pocket, 6), 0.01);
    ck_assert_double_lt(farthest_astray(away, 6), 0.01);
    ck_assert_double_lt(farthest_astray(knee, 5), 0.01);
}
END_TEST

/* Points far apart on a circle, unevenly, are its points and no corners. */
START_TEST(a_bend_that_nothing_guards_is_no_edge)
{
    static const double at[] = {0, 0.6, 1, 1.8, 2.5, 2.9};
    struct run run = {.radius = 3, .edges = true}, dense = {.radius = 3};
    struct sizes corner = {0};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++)
        *array_push(&run) = pose(vec(10 * cos(at[i]), 10 * sin(at[i]), 0), vec(0, 0, 1), 3);
    run_corners(&run, &corner);
    run_densify(&run, 1e-3, &dense);
    ck_assert_uint_eq(corner.n, 0);
    for (size_t i = 0; i < dense.n; i++)
        ck_assert_double_lt(fabs(vec_length(dense.item[i].ball) - 10), 0.02);
    array_free(&run);
    array_free(&dense);
    array_free(&corner);
}
END_TEST

START_TEST(repeated_points_and_no_length_are_no_trouble)
{
    struct run run = {.radius = 2};
    for (int i = 0; i < 4; i++)
        *array_push(&run) = pose(vec(1, 2, 3), vec(0, 0, 1), 2);
    struct vec3 t[6];
    run_tangents(&run, false, t);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_eq(vec_length(t[i]), 0);
    *array_push(&run) = pose(vec(2, 2, 3), vec(0, 0, 1), 2);
    *array_push(&run) = pose(vec(2, 2, 3), vec(0, 0, 1), 2);
    for (int forward = 0; forward < 2; forward++) {
        run_tangents(&run, forward, t);
        for (size_t i = 0; i < run.n; i++)
            ck_assert_double_lt(vec_distance(t[i], vec(1, 0, 0)), 1e-12);
    }
    struct run dense = {.radius = 2};
    ck_assert_double_lt(run_densify(&run, 0.001, &dense), 1e-12);
    ck_assert_uint_eq(dense.n, run.n);
    array_free(&run);
    array_free(&dense);
}
END_TEST

START_TEST(the_reference_of_a_circle_stays_on_it)
{
    struct run run = in_cylinder(7, 0.35), dense = {.radius = 8}, again = {.radius = 8};
    double off = run_densify(&run, 1e-4, &dense);
    size_t given = 0;
    for (size_t i = 0; i < dense.n; i++) {
        const struct run_point *p = &dense.item[i];
        given += p->given;
        ck_assert_double_lt(fabs(hypot(p->ball.x, p->ball.z) - 12), 1e-4);
        ck_assert_double_lt(fabs(hypot(p->tip.x, p->tip.z) - (12 + 8 * cos(0.2))), 5e-3);
        ck_assert_double_lt(fabs(vec_length(p->axis) - 1), 1e-12);
        ck_assert_double_lt(vec_distance(p->tip, vec_along(p->ball, -8, p->axis)), 1e-12);
        ck_assert_double_lt(fabs(hypot(p->contact.x, p->contact.z) - 20), 1e-3);
    }
    ck_assert_uint_eq(given, run.n);
    ck_assert_uint_gt(dense.n, 10 * run.n);
    /* the tip's straight lines stand off its circle by the sagitta */
    ck_assert_double_lt(fabs(off - (12 + 8 * cos(0.2)) * (1 - cos(0.175))), 5e-3);

    ck_assert_double_lt(run_densify(&dense, 2e-4, &again), 2e-4);
    ck_assert_uint_eq(again.n, dense.n);
    array_free(&run);
    array_free(&dense);
    array_free(&again);
}
END_TEST

START_TEST(corners_stay_corners)
{
    struct run run = {.radius = 1}, dense = {.radius = 1};
    struct vec3 at[] = {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {10, 5, 0}, {10, 10, 0}};
    for (size_t i = 0; i < 5; i++)
        *array_push(&run) = pose(at[i], vec(0, 0, 1), 1);
    struct sizes corner = {0};
    run_corners(&run, &corner);
    ck_assert_uint_eq(corner.n, 1);
    ck_assert_uint_eq(corner.item[0], 2);
    ck_assert_double_lt(run_densify(&run, 0.01, &dense), 1e-12);
    ck_assert_uint_eq(dense.n, 5);
    array_free(&run);
    array_free(&dense);
    array_free(&corner);
}
END_TEST

/* A line that stays a line, between two bends of 30 degrees: nothing is put into it, and what is
 * before and after leaves and joins it along it. */
START_TEST(a_straight_line_stays_one)
{
    const double c = cos(PI / 6), s = sin(PI / 6);
    struct vec3 at[] = {{-2 * c, 0, 2 * s}, {-c, 0, s},    {0, 0, 0},
                        {3, 0, 0},          {3 + c, 0, s}, {3 + 2 * c, 0, 2 * s}};
    struct run run = {.radius = 4}, dense = {.radius = 4};
    for (size_t i = 0; i < 6; i++) {
        struct run_point p = pose(at[i], vec(0, 0, 1), 4);
        p.straight = i == 2;
        *array_push(&run) = p;
    }
    ck_assert_double_gt(run_densify(&run, 1e-6, &dense), 0.01);
    size_t from = 0;
    while (vec_distance(dense.item[from].ball, at[2]) > 0)
        from++;
    ck_assert_double_eq(vec_distance(dense.item[from + 1].ball, at[3]), 0);
    for (size_t side = 0; side < 2; side++) {
        size_t i = from + 2 * side;
        struct vec3 way = vec_sub(dense.item[i].ball, dense.item[i - 1].ball);
        ck_assert_double_lt(vec_angle(way, vec(1, 0, 0)), RADIANS(2));
    }
    for (size_t i = 0; i < dense.n; i++) {
        double x = dense.item[i].ball.x;
        ck_assert(x <= 0 || x >= 3 || dense.item[i].ball.z == 0);
    }
    array_free(&run);
    array_free(&dense);
}
END_TEST

START_TEST(an_axis_that_turns_in_place_goes_on_the_great_circle)
{
    struct run run = {.radius = 5}, dense = {.radius = 5};
    *array_push(&run) = pose(vec(0, 0, 0), vec(0, 0, 1), 5);
    *array_push(&run) = pose(vec(0, 0, 0), vec(0, 1, 0), 5);
    double off = run_densify(&run, 1e-3, &dense);
    ck_assert_double_lt(fabs(off - 5 * (1 - cos(PI / 4))), 1e-9);
    ck_assert_uint_gt(dense.n, 10);
    for (size_t i = 0; i < dense.n; i++)
        ck_assert_double_lt(fabs(vec_length(dense.item[i].tip) - 5), 1e-12);
    array_free(&run);
    array_free(&dense);
}
END_TEST

/* Axes 90 degrees apart go over on the great circle, evenly, whatever the centres do. */
START_TEST(axes_far_apart_go_on_the_great_circle)
{
    struct run run = {.radius = 4}, dense = {.radius = 4};
    *array_push(&run) = pose(vec(0, 0, 0), vec(0, 0, 1), 4);
    *array_push(&run) = pose(vec(1, 0, 0), vec(0, 1, 0), 4);
    run_densify(&run, 1e-3, &dense);
    ck_assert_uint_gt(dense.n, 10);
    for (size_t i = 0; i < dense.n; i++) {
        double turn = (double)i / (double)(dense.n - 1) * PI / 2;
        ck_assert_double_eq_tol(vec_angle(run.item[0].axis, dense.item[i].axis), turn, 1e-12);
        ck_assert_double_lt(fabs(dense.item[i].axis.x), 1e-12);
    }
    array_free(&run);
    array_free(&dense);
}
END_TEST

/* Off the part the axis turns in one block, where the tip stays or goes on, and turns back in the
 * next: the tip is on its line all the way, and the centre the radius above it. */
START_TEST(a_swing_leaves_the_tip_on_its_line)
{
    const double radius = 4, turn = RADIANS(((const double[]){90, 30, 8})[_i]);
    struct run run = {.radius = radius}, dense = {.radius = radius};

    for (int i = 0; i < 12; i++) {
        struct vec3 axis = i == 6 ? vec(sin(turn), 0, cos(turn)) : vec(0, 0, 1);
        struct vec3 tip = vec(0.5 * (i > 5 ? i - 1 : i), 0, 10);
        *array_push(&run) = pose(vec_along(tip, radius, axis), axis, radius);
    }
    run_densify(&run, 0.001, &dense);
    ck_assert_uint_gt(dense.n, run.n + 3);
    for (size_t i = 0; i < dense.n; i++) {
        struct run_point p = dense.item[i];
        ck_assert_double_lt(hypot(p.tip.y, p.tip.z - 10), 1e-12);
        ck_assert_double_eq_tol(vec_distance(p.tip, p.ball), radius, 1e-12);
    }
    array_free(&run);
    array_free(&dense);
}
END_TEST

START_TEST(any_input_gives_finite_numbers)
{
    unsigned seed = 12345;
    for (size_t round = 0; round < 300; round++) {
        struct run run = {.radius = 3}, dense = {.radius = 3};
        size_t n = 1 + round % 9;
        for (size_t i = 0; i < n; i++) {
            int v[6];
            for (int k = 0; k < 6; k++) {
                seed = seed * 1664525u + seed_step_32();
                v[k] = (int)(seed >> 28) % 4 - 1;
            }
            struct vec3 axis = vec_unit(vec(v[3], v[4], v[5]));
            if (vec_length(axis) < 0.5)
                axis = vec(0, 0, 1);
            *array_push(&run) = pose(vec(v[0], v[1], v[2]), axis, 3);
        }
        ck_assert(isfinite(run_densify(&run, 0.01, &dense)));
        ck_assert_uint_ge(dense.n, run.n);
        for (size_t i = 0; i < dense.n; i++)
            ck_assert(isfinite(vec_length(dense.item[i].tip)) &&
                      isfinite(vec_length(dense.item[i].ball)));
        array_free(&run);
        array_free(&dense);
    }
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("run");
    tcase_add_test(t, tangents_of_a_circle_are_exact);
    tcase_add_test(t, forward_tangents_are_those_of_the_paper);
    tcase_add_test(t, a_lifted_centre_keeps_its_slope);
    tcase_add_test(t, beside_an_inner_edge_the_way_stays_on_its_chords);
    tcase_add_test(t, an_edge_that_nothing_guards_is_not_rounded);
    tcase_add_test(t, a_bend_that_nothing_guards_is_no_edge);
    tcase_add_test(t, repeated_points_and_no_length_are_no_trouble);
    tcase_add_test(t, the_reference_of_a_circle_stays_on_it);
    tcase_add_test(t, corners_stay_corners);
    tcase_add_test(t, a_straight_line_stays_one);
    tcase_add_test(t, an_axis_that_turns_in_place_goes_on_the_great_circle);
    tcase_add_test(t, axes_far_apart_go_on_the_great_circle);
    tcase_add_loop_test(t, a_swing_leaves_the_tip_on_its_line, 0, 3);
    tcase_add_test(t, any_input_gives_finite_numbers);
    Suite *s = suite_create("run");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
