/* lin_grid: planes are met exactly, curved surfaces with the square of the spacing; holes stay. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "meshing/lin_grid.h"
#include "seed.h"

enum { SIDE = 60 };

static double noise_of(unsigned *state)
{
    *state = *state * 1664525u + seed_step_32();
    return (*state >> 8) / 16777216.0;
}

static double plane(double x, double y)
{
    return 3 + 0.4 * x - 0.7 * y;
}

static double wave(double x, double y)
{
    return 2 * sin(x / 6) * cos(y / 7);
}

/* SIDE x SIDE points about 0.5 mm apart, off their places by up to `off` mm; none where `hole`. */
static struct vec3s scatter(double (*z)(double, double), double off, bool hole)
{
    unsigned state = 7;
    struct vec3s cloud = {0};

    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = 0.5 * (i % SIDE) + off * noise_of(&state);
        double y = 0.5 * (i / SIDE) + off * noise_of(&state);
        if (!hole || hypot(x - 15, y - 15) > 5)
            *array_push(&cloud) = vec(x, y, z(x, y));
    }
    return cloud;
}

/* The largest error of the nodes that are so far within the cloud's border, mm; how many have no
 * height. */
static double worst_within(double far, const struct vec3s *cloud, double direction, double spacing,
                           double (*z)(double, double), size_t *none)
{
    struct plan_extent f = plan_extent_of(cloud->item, cloud->n, direction);
    struct lin_grid_options how = {spacing, 0.5, 3, 1};
    struct lin_grid grid;
    struct error error;
    double worst = 0;

    ck_assert_int_eq(lin_grid_make(&f, cloud->item, cloud->n, &how, &grid, &error), 0);
    *none = 0;
    for (size_t i = 0; i < grid.columns * grid.rows; i++) {
        struct vec3 p = lin_grid_node(&grid, i % grid.columns, i / grid.columns);
        bool within = fmin(p.x, p.y) >= far && fmax(p.x, p.y) <= 0.5 * (SIDE - 1) - far;
        if (isnan(p.z))
            ++*none;
        else if (within || far == 0)
            worst = fmax(worst, fabs(p.z - z(p.x, p.y)));
    }
    lin_grid_free(&grid);
    return worst;
}

static double worst_of(const struct vec3s *cloud, double direction, double spacing,
                       double (*z)(double, double), size_t *none)
{
    return worst_within(0, cloud, direction, spacing, z, none);
}

/* 8 mm high beside the border. */
static double wall(double x, double y)
{
    return fmin(8, fmax(0, 20 * (fmax(fabs(x - 15), fabs(y - 15)) - 14.2)));
}

START_TEST(plane_is_met)
{
    struct vec3s cloud = scatter(plane, 0.4, false);
    size_t none;
    double worst = worst_of(&cloud, 0, 1, plane, &none);

    ck_assert_uint_eq(none, 0); /* the border too, by extrapolation */
    ck_assert_double_lt(worst, 1e-12);
    worst = worst_of(&cloud, 30, 1, plane, &none);
    ck_assert_uint_gt(none, 0); /* the corners of the box are empty */
    ck_assert_double_lt(worst, 1e-12);
    array_free(&cloud);
}
END_TEST

START_TEST(wave_is_met)
{
    struct vec3s regular = scatter(wave, 0, false), uneven = scatter(wave, 0.4, false);
    size_t none;
    double h = 0.5, bend = 2.0 / 36;

    /* h^2/8 of each second derivative along and between; the nodes fall between the points */
    ck_assert_double_lt(worst_of(&regular, 0, 0.73, wave, &none), h * h / 4 * bend);
    ck_assert_double_gt(worst_of(&regular, 0, 0.73, wave, &none), h * h / 40 * bend);
    /* within the border, beyond which lines go on, the same of the widest gap that is bridged */
    double wide = 3;
    ck_assert_double_lt(worst_within(1.5, &uneven, 0, 0.73, wave, &none), wide * wide / 4 * bend);
    array_free(&regular);
    array_free(&uneven);
}
END_TEST

START_TEST(hole_stays_open)
{
    struct vec3s cloud = scatter(plane, 0.4, true);
    size_t none;
    double worst = worst_of(&cloud, 0, 1, plane, &none);

    ck_assert_double_lt(worst, 1e-12);
    ck_assert_uint_ge(none, 40); /* of the 50 nodes in a disc of radius 4, with a rim of 1 */
    ck_assert_uint_le(none, 79); /* of radius 5 */
    array_free(&cloud);
}
END_TEST

/* Rows that end amid a wall do not go on along it: no node is over or under all points. */
START_TEST(a_wall_does_not_go_on)
{
    struct vec3s cloud = scatter(wall, 0.4, false);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 30);
    struct lin_grid_options how = {1, 0.5, 3, 1.5};
    struct lin_grid grid;
    struct error error;
    size_t high = 0;

    ck_assert_int_eq(lin_grid_make(&f, cloud.item, cloud.n, &how, &grid, &error), 0);
    for (size_t i = 0; i < grid.columns * grid.rows; i++) {
        ck_assert(!(grid.z[i] < -4) && !(grid.z[i] > 8 + 4)); /* 1.5 mm at 70 degrees: 4 */
        high += grid.z[i] > 7.9;
    }
    ck_assert_uint_ge(high, 20);
    lin_grid_free(&grid);
    array_free(&cloud);
}
END_TEST

START_TEST(too_fine)
{
    struct vec3s cloud = scatter(plane, 0.4, false);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    struct lin_grid_options how = {0.001, 0.5, 3, 1};
    struct lin_grid grid;
    struct error error;

    ck_assert_int_eq(lin_grid_make(&f, cloud.item, cloud.n, &how, &grid, &error), -1);
    ck_assert(strstr(error.text, "expected a wider spacing") != NULL);
    array_free(&cloud);
}
END_TEST

/* Points 0.5 mm apart over 29.5 x 23 mm, far from the origin: the fewest lines that are no further
 * apart than is asked, borders included, so that 23 mm have 24 and 29.5 mm 31. */
START_TEST(as_many_lines_as_the_spacing_asks)
{
    struct vec3s cloud = {0};
    struct lin_grid_options how = {1, 0.5, 3, 1};
    struct lin_grid grid;
    struct error error;

    for (int i = 0; i < 60; i++)
        for (int k = 0; k < 47; k++)
            *array_push(&cloud) = vec(100 + 0.5 * i, 200 + 0.5 * k, 7);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_int_eq(lin_grid_make(&f, cloud.item, cloud.n, &how, &grid, &error), 0);
    ck_assert_uint_eq(grid.columns, 31);
    ck_assert_uint_eq(grid.rows, 24);
    struct vec3 first = lin_grid_node(&grid, 0, 0), last = lin_grid_node(&grid, 30, 23);
    ck_assert_double_lt(vec_distance(first, vec(100, 200, 7)), 1e-9);
    ck_assert_double_lt(vec_distance(last, vec(129.5, 223, 7)), 1e-9);
    lin_grid_free(&grid);
    how.spacing = 0.001;
    ck_assert_int_eq(lin_grid_make(&f, cloud.item, cloud.n, &how, &grid, &error), -1);
    ck_assert_ptr_nonnull(
        strstr(error.text, "spacing 0.001 mm over 29.5 x 23 mm has 6.79e+08 nodes"));
    array_free(&cloud);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lin_grid");
    TCase *tcase = tcase_create("grid");
    tcase_add_test(tcase, plane_is_met);
    tcase_add_test(tcase, wave_is_met);
    tcase_add_test(tcase, hole_stays_open);
    tcase_add_test(tcase, a_wall_does_not_go_on);
    tcase_add_test(tcase, too_fine);
    tcase_add_test(tcase, as_many_lines_as_the_spacing_asks);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
