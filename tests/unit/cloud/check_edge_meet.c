/* edge_meet: places lie on the ridge of a roof, all along it, at the tip of a pyramid, and down to
 * its foot on a floor; in a valley there are none. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"

static double tip(double x, double y)
{
    return 10 - fmax(fabs(x - 0.13), fabs(y + 0.21));
}

static double on_floor(double x, double y)
{
    return fmax(0, tip(x, y) - 5);
}

/* Sides that make 172 degrees. */
static double blunt(double x, double y)
{
    return 10 - 0.07 * fabs(edge_trial_side(x, y));
}

static double valley(double x, double y)
{
    return -edge_trial_roof(x, y);
}

/* All places of edges of a scan, whose trial is freed. */
static struct vec3s places_of(struct edge_trial *trial)
{
    struct edge_hood near;
    struct vec3s to = {0};

    edge_flanks_find(&trial->work);
    for (size_t i = 0; i < trial->grid.n; i++) {
        if (!trial->work.flank[i].valid)
            continue;
        edge_hood_find(&trial->work, i, &near);
        edge_meet_add(&trial->work, &near, i, &to);
    }
    edge_trial_free(trial);
    return to;
}

/* Those of a shape, on a grid. */
static struct vec3s places(double (*height)(double, double), bool lines)
{
    struct edge_trial trial;

    edge_trial_make(&trial, height, lines, 0);
    return places_of(&trial);
}

static double nearest(const struct vec3s *to, struct vec3 p)
{
    double least = HUGE_VAL;

    for (size_t k = 0; k < to->n; k++)
        least = fmin(least, vec_distance(to->item[k], p));
    return least;
}

/* Places are at the height of the ridge, and all along it. */
static void check_ridge(const struct vec3s *to)
{
    for (size_t k = 0; k < to->n; k++)
        ck_assert_double_eq_tol(to->item[k].z, 10, 1e-6);
    for (double x = -7; x <= 7; x += 0.1)
        ck_assert_double_le(nearest(to, vec(x, x / 4, 10)), 0.2);
}

START_TEST(ridge)
{
    struct vec3s to = places(edge_trial_roof, _i == 1);

    check_ridge(&to);
    for (size_t k = 0; k < to.n; k++)
        ck_assert_double_eq_tol(edge_trial_side(to.item[k].x, to.item[k].y), 0, 1e-6);
    array_free(&to);
}
END_TEST

/* Without points nearer than a millimetre and a bit about a place of the edge, seen from above. */
static struct vec3s places_about_gap(double (*height)(double, double), struct vec3 middle)
{
    const double step = 0.5, gap = 1.1;
    struct edge_trial trial;
    struct vec3s scan = {0};

    for (double y = -10; y < 10; y += step)
        for (double x = -10; x < 10; x += step)
            if (hypot(x - middle.x, y - middle.y) > gap)
                *array_push(&scan) = vec(x, y, height(x, y));
    edge_trial_of(&trial, scan, step, 0);
    return places_of(&trial);
}

START_TEST(through_a_gap)
{
    struct vec3s to = places_about_gap(edge_trial_roof, vec(0, 0, 10));

    check_ridge(&to);
    array_free(&to);
}
END_TEST

START_TEST(to_a_tip_in_a_gap)
{
    struct vec3s to = places_about_gap(tip, vec(0.13, -0.21, 10));

    ck_assert_double_le(nearest(&to, vec(0.13, -0.21, 10)), 0.2 / 3);
    for (size_t k = 0; k < to.n; k++)
        ck_assert_double_le(to.item[k].z, tip(to.item[k].x, to.item[k].y) + 1e-6);
    array_free(&to);
}
END_TEST

START_TEST(blunt_ridge)
{
    struct vec3s to = places(blunt, false);

    check_ridge(&to);
    array_free(&to);
}
END_TEST

/* The foremost points of a side are taken for points of surfaces that run across the ridge, below
 * it: none of these is a side which the ridge ends at, for the points are on the other one, too. */
START_TEST(no_false_end)
{
    struct edge_trial trial;
    struct edge_hood near;
    struct vec3s to = {0};

    edge_trial_make(&trial, edge_trial_roof, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double side = edge_trial_side(p.x, p.y);
        if (side > 0 && side < 0.5 && fabs(p.x) < 4)
            trial.work.flank[i].q = quadric_frame(p, vec_unit(vec(p.x < 0 ? 1 : -1, 0.25, 0.3)));
    }
    for (size_t i = 0; i < trial.grid.n; i++) {
        edge_hood_find(&trial.work, i, &near);
        if (trial.work.flank[i].valid)
            edge_meet_add(&trial.work, &near, i, &to);
    }
    for (double x = -3; x <= 3; x += 0.1)
        ck_assert_double_le(nearest(&to, vec(x, x / 4, 10)), 0.2);
    array_free(&to);
    edge_trial_free(&trial);
}
END_TEST

START_TEST(tip_of_pyramid)
{
    struct vec3s to = places(tip, false);

    ck_assert_double_le(nearest(&to, vec(0.13, -0.21, 10)), 1e-6);
    for (size_t k = 0; k < to.n; k++)
        ck_assert_double_le(to.item[k].z, tip(to.item[k].x, to.item[k].y) + 1e-6);
    array_free(&to);
}
END_TEST

START_TEST(down_to_the_foot)
{
    struct vec3s to = places(on_floor, false);

    for (double d = 0.5; d <= 4.7; d += 0.1)
        for (int k = 0; k < 4; k++) {
            struct vec3 at = vec(0.13 + (k % 2 ? d : -d), (k / 2 ? d : -d) - 0.21, 5 - d);
            ck_assert_double_le(nearest(&to, at), 0.2);
        }
    for (size_t k = 0; k < to.n; k++)
        ck_assert_double_le(to.item[k].z, on_floor(to.item[k].x, to.item[k].y) + 1e-6);
    array_free(&to);
}
END_TEST

START_TEST(none_in_a_valley)
{
    struct vec3s to = places(valley, false);

    ck_assert_uint_eq(to.n, 0);
    array_free(&to);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_meet");
    TCase *tests = tcase_create("edge_meet");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, ridge, 0, 2);
    tcase_add_test(tests, through_a_gap);
    tcase_add_test(tests, to_a_tip_in_a_gap);
    tcase_add_test(tests, blunt_ridge);
    tcase_add_test(tests, no_false_end);
    tcase_add_test(tests, tip_of_pyramid);
    tcase_add_test(tests, down_to_the_foot);
    tcase_add_test(tests, none_in_a_valley);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
