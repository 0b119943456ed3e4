/* edge_cliff: the floor of a mesa goes on to the points below its wall, and the wall down to them;
 * a roof has no cliff, nor has noise, nor have hills. */
#include <check.h>
#include <stdlib.h>

#include "cloud/plan_star.h"
#include "edge_trial.h"
#include "noisy.h"

static const double HIGH = 3;

static double mesa(double x, double y)
{
    return edge_trial_side(x, y) > 0.07 ? HIGH : 0;
}

START_TEST(mesa_goes_on)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};

    edge_trial_make(&trial, mesa, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i];
        double side = edge_trial_side(p.x, p.y), width = edge_cliff_add(&trial.work, i, &edge, &to);
        ck_assert(width == 0 || (p.z > HIGH / 2 && side < EDGE_REACH * 0.5));
        ck_assert(width == 0 ||
                  (width >= side && width <= side + 1)); /* the floor is seen so near */
    }
    ck_assert_uint_gt(to.n, 100);
    size_t wall = 0;
    for (size_t k = 0; k < to.n; k++) {
        struct vec3 p = to.item[k];
        double side = edge_trial_side(p.x, p.y);
        bool flat = fabs(p.z - HIGH) < 1e-6;
        ck_assert(flat || (p.z > 0 && p.z < HIGH));
        wall += !flat;
        ck_assert_double_ge(side, -0.8); /* the next points of the floor are no further */
    }
    ck_assert_uint_gt(wall, 100);
    /* none of the places of the top all along the rim is 0.3 mm off */
    for (double x = -6; x <= 6; x += 0.2) {
        struct vec3 rim = vec(x, x / 4 + 0.07, HIGH);
        double least = HUGE_VAL;
        for (size_t k = 0; k < to.n; k++)
            least = fmin(least, vec_distance(rim, to.item[k]));
        ck_assert_double_le(least, 0.3);
    }
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* Where the path asks for places far closer than points are, too: none of the places between the
 * points of the top and those of the floor is far off. */
START_TEST(mesa_goes_on_as_far)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};

    edge_trial_make(&trial, mesa, false, 0);
    trial.options.along = 0.04;
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    for (double x = -2; x <= 2; x += 0.05) {
        struct vec3 rim = vec(x, x / 4 + 0.07, HIGH);
        double least = HUGE_VAL;
        for (size_t k = 0; k < to.n; k++)
            least = fmin(least, vec_distance(rim, to.item[k]));
        ck_assert_double_le(least, 0.06);
    }
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* A mesa with its wall in any direction, the rows of its floor begin so far before those of its
 * top. */
static const double GAP = 1.3;

static struct vec3s scan_of_gap(double turn)
{
    const double spacing = 0.5;
    struct vec3s scan = {0};

    for (int j = -15; j < 15; j++)
        for (int i = -15; i <= 15; i++) {
            double x = spacing * i, y = spacing * j + (j < 0 ? spacing : GAP);
            *array_push(&scan) =
                vec(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), j < 0 ? HIGH : 0);
        }
    return scan;
}

/* The upper side of a nut, its points anywhere. */
static double hexagon(double x, double y)
{
    double far = 0;

    for (int k = 0; k < 3; k++)
        far = fmax(far, fabs(x * cos(PI / 3 * k) + y * sin(PI / 3 * k)));
    return far < 6.5 ? HIGH : 0;
}

/* How far from the middle, that way, places are that are no lower and no higher. */
static double farthest(const struct vec3s *to, double turn, double low, double high)
{
    const double beside = 0.08;
    double far = 0;

    for (size_t k = 0; k < to->n; k++) {
        struct vec3 p = to->item[k];
        if (p.z > low && p.z < high && fabs(p.x * sin(turn) - p.y * cos(turn)) < beside)
            far = fmax(far, p.x * cos(turn) + p.y * sin(turn));
    }
    return far;
}

/* Walls hang from all of the rim as far as it goes on, not only before each point of the floor: all
 * but everywhere. */
START_TEST(walls_from_all_of_the_rim)
{
    const double high[2] = {HIGH - 1e-6, HIGH + 1e-6}, amid[2] = {HIGH / 2 - 0.2, HIGH / 2 + 0.2};
    struct edge_trial trial;
    struct vec3s scan = {0}, to = {0}, edge = {0};
    int bare = 0;

    noisy_seed(5 + (unsigned)_i);
    for (int i = 0; i < 1600; i++) {
        double x = 20 * (noisy_uniform() - 0.5), y = 20 * (noisy_uniform() - 0.5);
        *array_push(&scan) = vec(x, y, hexagon(x, y));
    }
    edge_trial_of(&trial, scan, 0.5, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    for (double turn = 0; turn < 2 * PI; turn += 0.01)
        bare +=
            farthest(&to, turn, amid[0], amid[1]) < farthest(&to, turn, high[0], high[1]) - 0.15;
    ck_assert_int_le(bare, 12); /* of 628; before each point of the floor alone: 300 and more */
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* A wall is somewhere between the points of the top and those of the floor: none of its places is
 * amid three points of the floor, seen from above. */
START_TEST(none_over_the_floor)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};
    size_t over = 0;

    edge_trial_make(&trial, mesa, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    for (size_t k = 0; k < to.n; k++) {
        size_t corner[3];
        if (hypot(to.item[k].x, to.item[k].y) > 8 || /* at the border corners stand out */
            !plan_star_over(&trial.grid, to.item[k], EDGE_REACH * 0.5, corner))
            continue;
        double high = 0;
        for (int c = 0; c < 3; c++)
            high = fmax(high, trial.grid.point[corner[c]].z);
        over += high < HIGH / 2;
    }
    ck_assert_uint_gt(to.n, 100);
    ck_assert_uint_eq(over, 0);
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* Whichever way, no place is farther from one of the flank than the middle of a triangle of these,
 * 0.65 * 0.2 mm wide, is from its corners, as far as triangles fit in. */
START_TEST(goes_on_all_ways)
{
    const double wide = 0.65 * 0.2, y = GAP - wide / sqrt(3);
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};
    double turn = PI / 6 * _i;

    edge_trial_of(&trial, scan_of_gap(turn), 0.5, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    for (double x = -4; x <= 4; x += 0.03) {
        struct vec3 p = vec(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), HIGH);
        double least = HUGE_VAL;
        for (size_t k = 0; k < to.n; k++)
            least = fmin(least, vec_distance(p, to.item[k]));
        ck_assert_double_le(least, wide / sqrt(3) + 1e-6);
    }
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* A step down to a floor, or a slope of 24 degrees, from y = 0.07. */
static double low_step(double x, double y)
{
    (void)x;
    return y < 0.07 ? 0.4 : 0;
}

static double low_slope(double x, double y)
{
    (void)x;
    return 0.4 - 0.45 * fmax(y - 0.07, 0);
}

/* Where no surface is known of the points below, these tell of a floor if they are as low wherever
 * they are; but not of a slope. */
START_TEST(floor_without_a_surface)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};

    edge_trial_make(&trial, _i ? low_slope : low_step, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        if (trial.grid.point[i].y > 0.07) {
            trial.work.flank[i].valid = false;
            trial.work.flank[i].rough = true;
        }
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    ck_assert(_i ? to.n == 0 : to.n > 0);
    for (double x = -6; _i == 0 && x <= 6; x += 0.2) {
        double least = HUGE_VAL;
        for (size_t k = 0; k < to.n; k++)
            least = fmin(least, vec_distance(vec(x, 0.07, 0.4), to.item[k]));
        ck_assert_double_le(least, 0.2);
    }
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

START_TEST(roof_has_none)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};

    edge_trial_make(&trial, edge_trial_roof, _i == 1, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        ck_assert_double_eq(edge_cliff_add(&trial.work, i, &edge, &to), 0);
    ck_assert_uint_eq(to.n, 0);
    edge_trial_free(&trial);
}
END_TEST

static double level(double x, double y)
{
    return 0.1 * x - 0.05 * y;
}

/* Two points of a noisy scan all but one over the other, so many sigmas apart: by noise alone, or
 * down a hole. */
START_TEST(noise_is_none)
{
    const double sigma = 0.02, beside = 0.04, apart = _i ? 9 : 6;
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};
    size_t high = 0, low, found = 0;

    edge_trial_make(&trial, level, false, sigma);
    while (hypot(trial.grid.point[high].x, trial.grid.point[high].y) > 0.6)
        high++;
    low = high + 1; /* of the same cell */
    struct vec3 p = trial.grid.point[high];
    p.z = level(p.x, p.y);
    trial.grid.point[high] = p;
    trial.grid.point[low] = vec(p.x + beside, p.y, level(p.x + beside, p.y) - apart * sigma);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        found += edge_cliff_add(&trial.work, i, &edge, &to) > 0;
    ck_assert((found > 0) == (_i == 1));
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* Hills no steeper than 60 degrees, as wide as few points are apart. */
static double hills(double x, double y)
{
    return 0.7 * sin(1.9 * x + 0.4 * y) * cos(1.6 * y - 0.3 * x) +
           0.25 * sin(4.1 * x + 1.2 * y) * sin(3.7 * y - 0.9 * x);
}

/* The ways down from short flanks were scanned: no wall stands there. */
START_TEST(hills_have_none)
{
    struct edge_trial trial;
    struct vec3s to = {0}, edge = {0};

    edge_trial_make(&trial, hills, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++)
        edge_cliff_add(&trial.work, i, &edge, &to);
    ck_assert_uint_eq(to.n, 0);
    array_free(&to);
    array_free(&edge);
    edge_trial_free(&trial);
}
END_TEST

/* A tip of 33 degrees, its top rising along x: ahead of it the flank goes on rising. */
static double tip(double x, double y)
{
    return x < -0.1 && fabs(y) < -0.3 * x ? 4 + 0.3 * x : -3;
}

START_TEST(corner_goes_on_along_its_flank)
{
    struct edge_trial trial;
    size_t corners = 0;

    edge_trial_make(&trial, tip, false, 0);
    edge_flanks_find(&trial.work);
    for (size_t i = 0; i < trial.grid.n; i++) {
        struct vec3 p = trial.grid.point[i], ahead;
        if (p.z < 0 || p.x < -8)
            continue;
        double depth = edge_cliff_corner(&trial.work, i, &ahead);
        if (depth <= 0)
            continue;
        corners++;
        ck_assert_double_gt(p.x, -2);
        ck_assert_double_eq_tol(hypot(ahead.x, ahead.y), 1, 1e-12);
        ck_assert_double_gt(ahead.x, 0.5);
        ck_assert_double_eq_tol(ahead.z, 0.3 * ahead.x, 1e-6);
        ck_assert_double_le(depth, 2);
    }
    ck_assert_uint_ge(corners, 1);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_cliff");
    TCase *tests = tcase_create("edge_cliff");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, mesa_goes_on);
    tcase_add_test(tests, mesa_goes_on_as_far);
    tcase_add_test(tests, none_over_the_floor);
    tcase_add_loop_test(tests, walls_from_all_of_the_rim, 0, 4);
    tcase_add_loop_test(tests, goes_on_all_ways, 0, 12);
    tcase_add_loop_test(tests, floor_without_a_surface, 0, 2);
    tcase_add_loop_test(tests, roof_has_none, 0, 2);
    tcase_add_loop_test(tests, noise_is_none, 0, 2);
    tcase_add_test(tests, hills_have_none);
    tcase_add_test(tests, corner_goes_on_along_its_flank);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
