/* edge_hood: the neighbours of points on a grid are the nearest; on scan lines they are on many
 * lines, apart from each other. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

/* By brute force: how many points are nearer to the first than the last of them. */
static size_t nearer(const struct edge_trial *trial, const struct edge_hood *near)
{
    size_t n = 0;

    for (size_t k = 0; k < trial->grid.n; k++) {
        struct vec3 to = vec_sub(trial->grid.point[k], near->point[0]);
        n += vec_dot(to, to) < near->distance2[EDGE_NEAR - 1];
    }
    return n;
}

START_TEST(nearest)
{
    struct edge_trial trial;
    struct edge_hood near;

    edge_trial_make(&trial, edge_trial_roof, false, 0);
    for (size_t i = 0; i < trial.grid.n; i += 97) {
        edge_hood_find(&trial.work, i, &near);
        ck_assert_uint_eq(near.n, EDGE_NEAR);
        ck_assert_uint_eq(near.index[0], i);
        ck_assert_uint_lt(nearer(&trial, &near), EDGE_NEAR);
        for (size_t k = 0; k < near.n; k++)
            ck_assert_double_eq_tol(sqrt(near.distance2[k]),
                                    vec_distance(near.point[k], near.point[0]), 1e-12);
        /* about a place within, 40 points 0.5 mm apart on a slope of 45 degrees */
        if (hypot(near.point[0].x, near.point[0].y) < 6)
            ck_assert_double_eq_tol(near.spacing, 0.5 * sqrt(sqrt(2)), 0.06);
    }
    edge_trial_free(&trial);
}
END_TEST

/* How many of the lines, 0.8 mm apart in y, the neighbours are on. */
static int lines_of(const struct edge_hood *near)
{
    int first = 1000, last = -1000;

    for (size_t k = 0; k < near->n; k++) {
        int line = (int)floor(near->point[k].y / 0.8 + 0.5);
        first = line < first ? line : first;
        last = line > last ? line : last;
    }
    return last - first + 1;
}

START_TEST(on_lines)
{
    struct edge_trial trial;
    struct edge_hood near;

    edge_trial_make(&trial, edge_trial_roof, true, 0);
    trial.work.wide = _i == 1;
    for (size_t i = 0; i < trial.grid.n; i += 97) {
        struct vec3 p = trial.grid.point[i];
        if (hypot(p.x, p.y) > 6)
            continue;
        edge_hood_find(&trial.work, i, &near);
        ck_assert_uint_eq(near.n, EDGE_NEAR);
        ck_assert_int_ge(lines_of(&near), _i == 1 ? 5 : 4);
        for (size_t k = 0; k < near.n; k++)
            for (size_t j = 0; j < k; j++)
                ck_assert_double_ge(vec_distance(near.point[k], near.point[j]),
                                    _i == 1 ? 0.39 : 0.19);
    }
    edge_trial_free(&trial);
}
END_TEST

START_TEST(too_few)
{
    struct vec3 point[12];
    struct point_grid grid;
    struct edge_hood near;
    struct error error;

    for (int i = 0; i < 12; i++)
        point[i] = vec(i % 4, 2 * (i % 3), 0);
    ck_assert_int_eq(point_grid_make(point, 12, 1, 1, &grid, &error), 0);
    struct edge_points_options options = {.point_grid = &grid};
    struct edge_work work = {.options = &options};
    edge_hood_find(&work, 5, &near);
    ck_assert_uint_lt(near.n, EDGE_NEAR);
    point_grid_free(&grid);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_hood");
    TCase *tests = tcase_create("edge_hood");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, nearest);
    tcase_add_loop_test(tests, on_lines, 0, 2);
    tcase_add_test(tests, too_few);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
