/* edge_along: the top of a wall narrower than its points are far apart gets a level surface, a
 * rounded ridge a quadric that is right across, a point beside the edge of a roof one along it. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

/* 0.7 mm wide: on a grid of 0.5 mm one or two points across. */
static double wall(double x, double y)
{
    return fabs(edge_trial_side(x, y)) < 0.35 ? 3 + 0.1 * x : 0;
}

/* Its crest has a radius of 0.8 mm. */
static double round_ridge(double x, double y)
{
    double d = edge_trial_side(x, y);
    return 10 - sqrt(d * d + 0.64);
}

START_TEST(top_of_a_wall)
{
    struct edge_trial trial;
    struct vec3 normal;
    size_t top = 0, known = 0;

    edge_trial_make(&trial, wall, _i == 1, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        if (p.z < 1 || hypot(p.x, p.y) > 8)
            continue;
        top++;
        edge_along_find(&trial.work, i);
        const struct edge_flank *flank = &trial.work.flank[i];
        known += flank->along;
        for (double side = -0.35; flank->along && side <= 0.35; side += 0.35) {
            struct vec3 q = vec(p.x, p.x / 4 + side * sqrt(17) / 4, 3 + 0.1 * p.x);
            /* level across instead of this slope, 0.1 / sqrt(17), 0.7 mm wide, and tilted by points
             * that may be off by 0.012 of their spacing */
            ck_assert_double_eq_tol(edge_flank_above(flank, q, &normal), 0,
                                    0.7 * 0.0243 + 2 * 0.012 * 0.5);
        }
    }
    ck_assert_uint_gt(top, 30);
    ck_assert_uint_gt(known, 4 * top / 5);
    edge_trial_free(&trial);
}
END_TEST

/* One scan line runs along the top of a wall 5 mm high: more of its points are near than a strip
 * takes. */
static double wall_on_a_line(double x, double y)
{
    return fabs(y + 0.4) < 0.3 ? 5 + 0.1 * x : 0;
}

START_TEST(top_with_many_points)
{
    struct edge_trial trial;
    struct vec3 normal;
    size_t top = 0;

    edge_trial_make(&trial, wall_on_a_line, true, 0);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        if (p.z < 1 || fabs(p.x) > 3)
            continue;
        top++;
        edge_along_find(&trial.work, i);
        ck_assert(trial.work.flank[i].along);
        for (double off = -0.3; off <= 0.3; off += 0.3)
            ck_assert_double_eq_tol(
                edge_flank_above(&trial.work.flank[i], vec_add(p, vec(0, off, 0)), &normal), 0,
                0.01);
    }
    ck_assert_uint_ge(top, 30);
    edge_trial_free(&trial);
}
END_TEST

START_TEST(rounded)
{
    struct edge_trial trial;
    struct vec3 normal;
    size_t n = 0, known = 0;

    edge_trial_make(&trial, round_ridge, false, 0);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double side = edge_trial_side(p.x, p.y);
        if (hypot(p.x, p.y) > 6 || fabs(side) > 0.3)
            continue;
        n++;
        edge_along_find(&trial.work, i);
        if (!trial.work.flank[i].along)
            continue;
        known++;
        for (double off = -0.25; off <= 0.25; off += 0.25) { /* half a spacing across */
            double x = p.x - off / sqrt(17), y = p.y + 4 * off / sqrt(17);
            struct vec3 q = vec(x, y, round_ridge(x, y));
            ck_assert_double_eq_tol(edge_flank_above(&trial.work.flank[i], q, &normal), 0, 0.01);
        }
    }
    ck_assert_uint_gt(n, 20);
    ck_assert_uint_gt(known, n / 2);
    edge_trial_free(&trial);
}
END_TEST

START_TEST(no_other_side)
{
    struct edge_trial trial;

    edge_trial_make(&trial, edge_trial_roof, _i == 1, 0);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        if (hypot(p.x, p.y) > 8 || fabs(edge_trial_side(p.x, p.y)) > 0.5)
            continue;
        edge_along_find(&trial.work, i);
        for (double far = -0.4; far <= 0.4 && trial.work.flank[i].along; far += 0.4) {
            struct vec3 q = vec(p.x + far, p.y + far / 4, p.z), normal;
            ck_assert_double_eq_tol(edge_flank_above(&trial.work.flank[i], q, &normal), 0, 0.02);
        }
    }
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_along");
    TCase *tests = tcase_create("edge_along");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, top_of_a_wall, 0, 2);
    tcase_add_test(tests, top_with_many_points);
    tcase_add_test(tests, rounded);
    tcase_add_loop_test(tests, no_other_side, 0, 2);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
