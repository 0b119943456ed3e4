/* edge_foot: over the feet of a high wall that was not seen places hang between rim and floor, none
 * over the floor elsewhere, and none over a slope or a low step. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

static double high; /* mm */

static double mesa(double x, double y)
{
    return edge_trial_side(x, y) > 0.07 ? high : 0;
}

static double ramp(double x, double y)
{
    return fmax(0, fmin(high, 2 * edge_trial_side(x, y)));
}

static struct vec3s feet_of(double (*height)(double x, double y), double sigma)
{
    struct edge_trial trial;
    struct vec3s to = {0};

    edge_trial_make(&trial, height, false, sigma);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_foot_add(&trial.work, i, &to);
    edge_trial_free(&trial);
    return to;
}

/* Beside the rim, amid its height, some are no farther than so many mm. */
static void check_beside_rim(const struct vec3s *to, double most)
{
    for (double x = -6; x <= 6; x += 0.2) {
        struct vec3 amid = vec(x, x / 4 + 0.07, high / 2);
        double least = HUGE_VAL;
        for (size_t k = 0; k < to->n; k++)
            least = fmin(least, vec_distance(amid, to->item[k]));
        ck_assert_double_le(least, most);
    }
}

START_TEST(wall_over_feet)
{
    high = 6; /* twelve spacings */
    struct vec3s to = feet_of(mesa, 0);

    for (size_t k = 0; k < to.n; k++) {
        double side = edge_trial_side(to.item[k].x, to.item[k].y);
        ck_assert(to.item[k].z > 0 && to.item[k].z < high);
        ck_assert(side < 0.07 && side > -EDGE_REACH * 0.5);
    }
    check_beside_rim(&to, 0.5); /* as the next points of the floor are */
    array_free(&to);
}
END_TEST

/* A wall between two levels is one under noise, too, however low against what it must be where
 * heights spread: a ramp as steep has none. */
START_TEST(low_wall_under_noise)
{
    high = 2;
    struct vec3s to = feet_of(mesa, 0.01);

    check_beside_rim(&to, 1.2); /* a foot far from its rim is none of a wall so low */
    array_free(&to);
    to = feet_of(ramp, 0.01);
    ck_assert_uint_eq(to.n, 0);
    array_free(&to);
}
END_TEST

START_TEST(none_over_others)
{
    high = 2; /* four spacings: below the least */
    struct vec3s to = feet_of(_i ? mesa : edge_trial_roof, 0);

    ck_assert_uint_eq(to.n, 0);
    array_free(&to);
}
END_TEST

/* A slope of 83 degrees on lines 0.2 mm apart, of which half a mm in the middle was not seen. */
static struct vec3s steep_lines(void)
{
    struct vec3s scan = {0};

    for (int k = -15; k <= 15; k++)
        for (int j = -40; j <= 40; j++) {
            double x = 0.05 * j + 0.004 * (k % 3);
            if (x < 0 || x > 0.5)
                *array_push(&scan) = vec(x, 0.2 * k, 8 * x);
        }
    return scan;
}

/* Its own points tell where it is: no wall hangs off it. */
START_TEST(none_off_a_steep_slope)
{
    struct edge_trial trial;
    struct vec3s to = {0};

    edge_trial_of(&trial, steep_lines(), 0.2, 0);
    for (size_t i = 0; i < trial.grid.n; i++)
        if (fabs(trial.grid.point[i].y) < 2 && trial.grid.point[i].x > -1)
            edge_foot_add(&trial.work, i, &to);
    ck_assert_uint_eq(to.n, 0);
    array_free(&to);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_foot");
    TCase *tests = tcase_create("edge_foot");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, wall_over_feet);
    tcase_add_test(tests, low_wall_under_noise);
    tcase_add_test(tests, none_off_a_steep_slope);
    tcase_add_loop_test(tests, none_over_others, 0, 2);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
