/* edge_slope: on a foot that a scanned slope comes down to no unseen wall stands, nor behind one
 * that is before it. */
#include <check.h>
#include <stdlib.h>

#include "cloud/edge_steps.h"

enum { SIDE = 12 };

/* Points a spacing of 1 apart on a surface; returns how many. */
static size_t scan(double (*height)(double, double), struct vec3 *point)
{
    size_t n = 0;

    for (int i = -SIDE / 2; i < SIDE / 2; i++)
        for (int k = -SIDE / 2; k < SIDE / 2; k++) {
            double x = i + 0.3 * sin(7 * k), y = k + 0.3 * cos(5 * i);
            point[n++] = vec(x, y, height(x, y));
        }
    return n;
}

/* Asked of n points a spacing of 1 apart. */
static bool ask(bool (*seen)(const struct point_grid *, struct vec3, double),
                const struct vec3 *point, size_t n, struct vec3 foot, double top)
{
    struct vec3 copy[SIDE * SIDE]; /* it is put in order */
    struct point_grid grid;
    struct error error;

    for (size_t k = 0; k < n; k++)
        copy[k] = point[k];
    ck_assert_int_eq(point_grid_make(copy, n, 1, 1, &grid, &error), 0);
    bool result = seen(&grid, foot, top);
    point_grid_free(&grid);
    return result;
}

static bool slope_seen(const struct vec3 *point, size_t n, struct vec3 foot, double top)
{
    return ask(edge_slope_seen, point, n, foot, top);
}

static bool slope_climbs(const struct vec3 *point, size_t n, struct vec3 foot, double top)
{
    return ask(edge_slope_climbs, point, n, foot, top);
}

/* 8 high beyond x = 0.6. */
static double step(double x, double y)
{
    (void)y;
    return x > 0.6 ? 8 : 0;
}

/* The same, but risen to there by 60 degrees. */
static double slope(double x, double y)
{
    (void)y;
    return fmin(fmax(1.7 * (x - 0.6), 0), 8);
}

/* Of the points of `height` lower than 1 within 1.5 of the wall: how many are feet. */
static void count_feet(double (*height)(double, double), size_t *feet, size_t *asked)
{
    struct vec3 point[SIDE * SIDE];
    size_t n = scan(height, point);

    *feet = *asked = 0;
    for (size_t k = 0; k < n; k++) {
        if (point[k].z > 1 || point[k].x < -0.9 || point[k].x > 0.6 || fabs(point[k].y) > 3)
            continue;
        ++*asked;
        *feet += !slope_seen(point, n, point[k], 8);
    }
}

START_TEST(step_has_feet)
{
    size_t feet, asked;

    count_feet(step, &feet, &asked);
    ck_assert_uint_ge(asked, 5);
    ck_assert_uint_ge(2 * feet, asked); /* others have one before them */
}
END_TEST

START_TEST(slope_has_none)
{
    size_t feet, asked;

    count_feet(slope, &feet, &asked);
    ck_assert_uint_ge(asked, 5);
    ck_assert_uint_eq(feet, 0);
}
END_TEST

START_TEST(low_step_is_none)
{
    const struct vec3 about[] = {{0, 0, 0}, {0.5, 0, 0.9}, {1, 0, 1.2}, {0.7, 0.7, 1.5}};

    ck_assert(slope_seen(about, 4, about[0], 1.6));
    ck_assert(slope_seen(about, 1, about[0], 0.9));
}
END_TEST

START_TEST(fine_steps_climb)
{
    const struct vec3 about[] = {{0, 0, 0}, {0.5, 0, 0.2}, {1, 0, 0.4}, {0.7, 0.7, 0.8}};

    ck_assert(slope_climbs(about, 4, about[0], 0.6));
    ck_assert(!slope_climbs(about, 4, about[0], 1));
    ck_assert(slope_seen(about, 4, about[0], 1));
}
END_TEST

/* What is above it lies all round: a roof over it, no wall beside. */
START_TEST(roof_over_it_has_none)
{
    const struct vec3 about[] = {{0, 0, 0}, {1, 0, 9}, {-1, 0, 9}, {0, 1, 9}, {0, -1, 9}};

    ck_assert(slope_seen(about, 5, about[0], 9));
    ck_assert(!slope_seen(about, 2, about[0], 9));
}
END_TEST

/* A point as low is before it, on the way to the wall. */
START_TEST(behind_a_foot_is_none)
{
    const struct vec3 about[] = {{0, 0, 0}, {1, 0, 0.1}, {2, 0.1, 9}, {2, -0.1, 9}};

    ck_assert(slope_seen(about, 4, about[0], 9));
    ck_assert(!slope_seen(about, 4, about[1], 9));
}
END_TEST

/* Eight times as high as wide, but for a gap that 4 mm of height are missing in; level below it
 * from there on. */
static size_t scan_steep(double level, struct vec3 *point)
{
    size_t n = 0;

    for (int k = -4; k <= 4; k++)
        for (double x = -2; x <= 2; x += 0.1)
            if (x < 0 || x > 0.5)
                point[n++] = vec(x, 0.3 * k, fmax(8 * x, level));
    return n;
}

static bool goes_on(struct vec3 *point, size_t n, struct vec3 foot, struct vec3 rim)
{
    struct point_grid grid;
    struct error error;

    ck_assert_int_eq(point_grid_make(point, n, 1, 1, &grid, &error), 0);
    bool result = edge_slope_goes_on(&grid, foot, rim);
    point_grid_free(&grid);
    return result;
}

/* A wall that stands on what is level, on points of its own, or right over the foot is none. */
START_TEST(one_slope_goes_on)
{
    struct vec3 point[400], foot = vec(-0.1, 0, -0.8), rim = vec(0.6, 0, 4.8);

    ck_assert(goes_on(point, scan_steep(-20, point), foot, rim));
    ck_assert(!goes_on(point, scan_steep(-0.8, point), foot, rim));
    ck_assert(!goes_on(point, scan_steep(-20, point), foot, vec(-0.01, 0, 4.8)));
    size_t n = scan_steep(-20, point);
    for (size_t k = 0; k < n; k++)
        point[k].x = fmax(point[k].x, -0.1);
    ck_assert(!goes_on(point, n, foot, rim));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_slope");
    TCase *tests = tcase_create("edge_slope");

    tcase_add_test(tests, step_has_feet);
    tcase_add_test(tests, slope_has_none);
    tcase_add_test(tests, low_step_is_none);
    tcase_add_test(tests, fine_steps_climb);
    tcase_add_test(tests, roof_over_it_has_none);
    tcase_add_test(tests, behind_a_foot_is_none);
    tcase_add_test(tests, one_slope_goes_on);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
