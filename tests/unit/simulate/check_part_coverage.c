/*
 * check_part_coverage - points cut, out of reach, left: a groove too narrow for the ball, whose
 * bottom it never touches; a well too narrow for the holder; a floor under a roof.
 */
#include <check.h>
#include <stdlib.h>

#include "simulate/part_coverage.h"

#define R 3.0
#define LIMIT 0.05

static const struct verify_kinematics upright = {.n = 0, .tool = {0, 0, 1}};

/* The class of the point nearest to p when `left` is left on it, and nothing on all others. */
static int class_behind(const struct vec3s *points, const struct vec3s *curtain, struct vec3 p,
                        double left, const struct tool_shape *tool,
                        const struct verify_kinematics *kinematics)
{
    struct vec3s axis = part_coverage_axes(kinematics);
    struct part_coverage_options options = {R,       LIMIT, LIMIT / 2, tool, &axis,
                                            curtain, false, false,     1};
    double *deviation = mem_alloc(points->n, sizeof *deviation);
    struct part_coverage coverage;
    size_t at = 0;
    for (size_t i = 0; i < points->n; i++)
        if (vec_distance(points->item[i], p) < vec_distance(points->item[at], p))
            at = i;
    deviation[at] = left;
    part_coverage_run(points->item, deviation, NULL, points->n, &options, &coverage);
    int class = coverage.of[at];
    ck_assert_uint_eq(coverage.sum[COVERAGE_CUT].points, points->n - (left > LIMIT));
    ck_assert_uint_eq(coverage.sum[class].at, at);
    part_coverage_free(&coverage);
    array_free(&axis);
    free(deviation);
    return class;
}

static int class_at(const struct vec3s *points, struct vec3 p, double left,
                    const struct tool_shape *tool, const struct verify_kinematics *kinematics)
{
    return class_behind(points, NULL, p, left, tool, kinematics);
}

/* z = 0 with a half round groove along y, 2 in radius: a ball of 3 stands on both its edges with
 * its centre sqrt(5) high, sqrt(5) - 1 over the bottom. */
static struct vec3s groove(void)
{
    struct vec3s points = {0};
    for (int k = -40; k <= 40; k++) {
        for (int i = -60; i <= 60; i++)
            if (abs(i) >= 8)
                *array_push(&points) = vec(0.25 * i, 0.25 * k, 0);
        for (int i = 1; i < 24; i++)
            *array_push(&points) = vec(2 * cos(PI * i / 24), 0.25 * k, -2 * sin(PI * i / 24));
    }
    return points;
}

START_TEST(where_the_ball_gets)
{
    struct vec3s points = groove();
    const struct tool_shape alone = {0};
    double best = sqrt(5) - 1; /* is left when the ball stands on both edges */
    struct vec3 bottom = vec(0, 0, -2), flat = vec(6, 1, 0);
    ck_assert_int_eq(class_at(&points, bottom, best + LIMIT - 0.01, &alone, &upright),
                     COVERAGE_OUT_OF_REACH);
    ck_assert_int_eq(class_at(&points, bottom, best + 1, &alone, &upright), COVERAGE_OUT_OF_REACH);
    ck_assert_int_eq(class_at(&points, bottom, LIMIT - 0.01, &alone, &upright), COVERAGE_CUT);
    ck_assert_int_eq(class_at(&points, flat, LIMIT + 0.001, &alone, &upright), COVERAGE_LEFT);
    ck_assert_int_eq(class_at(&points, flat, 50, &alone, &upright), COVERAGE_LEFT);
    array_free(&points);
}
END_TEST

/* A round well, 6 in radius and 20 deep, in a plane. */
static struct vec3s well(void)
{
    struct vec3s points = {0};
    for (int i = -60; i <= 60; i++)
        for (int k = -60; k <= 60; k++) {
            double r = hypot(0.5 * i, 0.5 * k);
            if (r > 6 || r < 5.7)
                *array_push(&points) = vec(0.5 * i, 0.5 * k, r < 6 ? -20 : 0);
        }
    for (int k = 0; k < 80; k++)
        for (int i = 0; i < 90; i++)
            *array_push(&points) = vec(6 * cos(PI * i / 45), 6 * sin(PI * i / 45), -20 + 0.25 * k);
    return points;
}

START_TEST(as_deep_as_the_holder_lets)
{
    struct vec3s points = well();
    const struct verify_kinematics table = verify_kinematics_trunnion('A', 1);
    struct tool_shape slim = {1, {{0, 30, R, R}}}, stout = {2, {{0, 12, R, R}, {12, 60, 12, 12}}};
    struct vec3 bottom = vec(0, 0, -20), high = vec(6, 0, -4), plane = vec(20, 3, 0);
    ck_assert_int_eq(class_at(&points, bottom, 1, &slim, &table), COVERAGE_LEFT);
    ck_assert_int_eq(class_at(&points, bottom, 1, &stout, &table), COVERAGE_OUT_OF_REACH);
    ck_assert_int_eq(class_at(&points, high, 1, &stout, &upright), COVERAGE_LEFT);
    ck_assert_int_eq(class_at(&points, plane, 1, &stout, &upright), COVERAGE_LEFT);
    array_free(&points);
}
END_TEST

/* A floor and a roof 30 over it that reaches from x = 0 to the right: upright the tool gets under
 * it nowhere, leaning it does, near the roof's edge. */
START_TEST(as_far_as_the_axes_turn)
{
    struct vec3s points = {0};
    const struct verify_kinematics table = verify_kinematics_trunnion('A', 1);
    struct tool_shape slim = {1, {{0, 12, R, R}}};
    for (int i = -60; i <= 60; i++)
        for (int k = -60; k <= 60; k++) {
            *array_push(&points) = vec(0.5 * i, 0.5 * k, 0);
            if (i >= 0)
                *array_push(&points) = vec(0.5 * i, 0.5 * k, 30);
        }
    struct vec3 in_front = vec(-10, 0, 0), under = vec(10, 0, 0);
    ck_assert_int_eq(class_at(&points, in_front, 1, &slim, &upright), COVERAGE_LEFT);
    ck_assert_int_eq(class_at(&points, under, 1, &slim, &upright), COVERAGE_OUT_OF_REACH);
    ck_assert_int_eq(class_at(&points, under, 1, &slim, &table), COVERAGE_LEFT);
    array_free(&points);
}
END_TEST

/* A floor up to x = 0 and a step 6 high beyond it, whose upright wall has points `apart`, or none.
 */
static struct vec3s step(double apart)
{
    struct vec3s points = {0};
    for (int i = -40; i <= 40; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.4 * i + 0.2, 0.4 * k, i < 0 ? 0 : 6);
    for (double y = -16.5; apart > 0 && y < 16; y += apart)
        for (double z = apart / 2; z < 6; z += apart)
            *array_push(&points) = vec(0, y, z);
    return points;
}

/* At the foot of the wall a ball would have to be in it: where it has many points no ball touches
 * the foot, where it has few or none only one that is under the step. */
START_TEST(past_a_wall_without_points)
{
    const struct tool_shape slim = {1, {{0, 12, R, R}}};
    const struct verify_kinematics table = verify_kinematics_trunnion('A', 1);
    const double apart[] = {0.4, 3, 0};
    for (int k = 0; k < 3; k++) {
        struct vec3s points = step(apart[k]);
        struct vec3 foot = vec(-2.2, 0, 0), rim = vec(0.2, 0, 6), out = vec(-4, 0, 0);
        int class = class_at(&points, foot, 1, &slim, &table);
        ck_assert_int_eq(class, k == 0 ? COVERAGE_OUT_OF_REACH : COVERAGE_KEPT_OFF);
        ck_assert_int_eq(class_at(&points, rim, 1, &slim, &table), COVERAGE_LEFT);
        ck_assert_int_eq(class_at(&points, out, 1, &slim, &table), COVERAGE_LEFT);
        array_free(&points);
    }
}
END_TEST

/* A chimney 20 high, open at its top, in a pit 5 wide, in which no ball of 3 goes down: its wall
 * is 8 in radius at the top, and leans by so much. */
static struct vec3s chimney(double lean)
{
    struct vec3s points = {0};
    for (int k = 0; k <= 50; k++)
        for (int i = 0; i < 180; i++) {
            double z = 0.4 * k, r = 8 + (20 - z) * tan(lean),
                   a = 2 * PI * (i + 0.5 * (k % 2)) / 180;
            *array_push(&points) = vec(r * cos(a), r * sin(a), z);
            r += 5 + z * tan(lean);
            *array_push(&points) = vec(r * cos(a), r * sin(a), z);
        }
    return points;
}

/* From above only its outer side was seen, if it leans: what a ball touches from within is not
 * what is left to cut.  Of an upright wall nobody knows which side it is. */
START_TEST(within_a_hollow_body_is_in_the_part)
{
    const struct tool_shape slim = {1, {{0, 30, R, R}}};
    const struct verify_kinematics table = verify_kinematics_trunnion('A', 1);
    for (int k = 0; k < 2; k++) {
        struct vec3s points = chimney(k ? RADIANS(6) : 0);
        double r = k ? 8 + 18 * tan(RADIANS(6)) : 8;
        int class = class_at(&points, vec(r, 0, 2), 1, &slim, &table);
        ck_assert_int_eq(class, k ? COVERAGE_KEPT_OFF : COVERAGE_LEFT);
        ck_assert_int_eq(class_at(&points, vec(8, 0, 20), 1, &slim, &table), COVERAGE_LEFT);
        array_free(&points);
    }
}
END_TEST

START_TEST(areas_and_threads)
{
    struct vec3s points = groove(), axis = part_coverage_axes(&upright);
    const struct tool_shape alone = {0};
    double *deviation = mem_alloc(points.n, sizeof *deviation), area = 0;
    for (size_t i = 0; i < points.n; i++)
        deviation[i] = points.item[i].y < 0 ? 0 : 0.5;
    struct part_coverage one, four;
    struct part_coverage_options options = {R,    LIMIT, LIMIT / 2, &alone, &axis,
                                            NULL, false, false,     1};
    part_coverage_run(points.item, deviation, NULL, points.n, &options, &one);
    options.threads = 4;
    part_coverage_run(points.item, deviation, NULL, points.n, &options, &four);
    for (size_t i = 0; i < points.n; i++)
        ck_assert_int_eq(one.of[i], four.of[i]);
    for (int k = 0; k < COVERAGE_CLASSES; k++)
        area += one.sum[k].area;
    /* 20 by 30 less the groove's width, and its half turn */
    ck_assert_double_eq_tol(area, 20.25 * (30.25 - 4 + 2 * PI), 0.1 * area);
    ck_assert_double_eq_tol(one.sum[COVERAGE_CUT].area, area / 2, 0.05 * area);
    ck_assert_uint_gt(one.sum[COVERAGE_OUT_OF_REACH].points, 0); /* the groove's bottom */
    ck_assert_double_eq(one.sum[COVERAGE_LEFT].worst, 0.5);
    part_coverage_free(&one);
    part_coverage_free(&four);
    array_free(&axis);
    array_free(&points);
    free(deviation);
}
END_TEST

/* What a curtain over a floor keeps the ball from is out of reach; what is 4 mm beside it is not,
 * and the points of the curtain are none of the part. */
START_TEST(behind_a_curtain)
{
    const struct tool_shape alone = {0};
    struct vec3s points = {0}, curtain = {0};
    for (int i = -60; i <= 60; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.25 * i, 0.25 * k, 0);
    for (int i = -8; i <= 8; i++)
        for (int k = -8; k <= 8; k++)
            *array_push(&curtain) = vec(0.25 * i, 0.25 * k, 2);
    ck_assert_int_eq(class_at(&points, vec(0, 0, 0), 1, &alone, &upright), COVERAGE_LEFT);
    ck_assert_int_eq(class_behind(&points, &curtain, vec(0, 0, 0), 1, &alone, &upright),
                     COVERAGE_OUT_OF_REACH);
    ck_assert_int_eq(class_behind(&points, &curtain, vec(6, 0, 0), 1, &alone, &upright),
                     COVERAGE_LEFT);
    array_free(&points);
    array_free(&curtain);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("part_coverage");
    TCase *tcase = tcase_create("coverage");
    tcase_add_test(tcase, where_the_ball_gets);
    tcase_add_test(tcase, as_deep_as_the_holder_lets);
    tcase_add_test(tcase, as_far_as_the_axes_turn);
    tcase_add_test(tcase, past_a_wall_without_points);
    tcase_add_test(tcase, within_a_hollow_body_is_in_the_part);
    tcase_add_test(tcase, areas_and_threads);
    tcase_add_test(tcase, behind_a_curtain);
    tcase_set_timeout(tcase, 60);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
