/* rim_points: beyond the rim of a scan its surface goes on, so that no ball comes from beside into
 * a flank too steep to be seen; and a ball that touches the scan is let be. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/rim_points.h"
#include "math/kdtree.h"
#include "noisy.h"
#include "seed.h"

#define BALL 3.0

static size_t beyond(struct vec3s *scan, double spacing, double noise, struct vec3s *to)
{
    const struct rim_points_options options = {
        .pitch = 0.2, .gap = BALL / 4, .radius = BALL, .noise = noise, .threads = 2};
    struct point_grid grid;
    struct error error;

    ck_assert_int_eq(point_grid_make(scan->item, scan->n, spacing, 1, &grid, &error), 0);
    size_t rim = rim_points(&grid, &options, to);
    point_grid_free(&grid);
    return rim;
}

static struct vec3 on_dome(double radius, double turn, double slope)
{
    return vec(radius * sin(slope) * cos(turn), radius * sin(slope) * sin(turn),
               radius * cos(slope));
}

/* A dome of radius 20, seen down to 78 degrees, its points anywhere.  What is told of a place by
 * noise and by places a pitch apart: 0.03. */
START_TEST(steep_flank)
{
    const double radius = 20, sigma = 0.005, seen = RADIANS(78), deep = 0.5;
    struct vec3s scan = {0}, place = {0};

    noisy_seed((unsigned)(seed_step() >> 33));
    for (int i = 0; i < 14000; i++) {
        double z = 1 - noisy_uniform() * (1 - cos(seen));
        *array_push(&scan) =
            on_dome(radius + sigma * noisy_normal(), 2 * PI * noisy_uniform(), acos(z));
    }
    ck_assert_uint_gt(beyond(&scan, 0.33, sigma, &place), 100);
    struct kdtree *tree = kdtree_new(place.item, place.n);
    for (int k = 0; k < 500; k++) {
        size_t at;
        double distance2, turn = 2 * PI * noisy_uniform();
        kdtree_nearest(tree, on_dome(radius + BALL, turn, seen * noisy_uniform()), 1, &at,
                       &distance2);
        ck_assert_double_ge(sqrt(distance2), BALL - 0.03);
        kdtree_nearest(tree, on_dome(radius + BALL - deep, turn, RADIANS(88)), 1, &at, &distance2);
        ck_assert_double_lt(sqrt(distance2), BALL);
    }
    kdtree_free(tree);
    array_free(&scan);
    array_free(&place);
}
END_TEST

/* A sheet on a grid, with a hole in it, that goes down along x by `slope`. */
static size_t beyond_sheet(double slope, double step, struct vec3s *place)
{
    enum { WIDE = 40, HOLE = 10 };
    struct vec3s scan = {0};

    for (int y = 0; y < WIDE; y++)
        for (int x = 0; x < WIDE; x++)
            if (abs(x - WIDE / 2) >= HOLE || abs(y - WIDE / 2) >= HOLE)
                *array_push(&scan) = vec(step * x, step * y, 1 - slope * step * x);
    size_t rim = beyond(&scan, step, 0, place);
    array_free(&scan);
    ck_assert_uint_ge(rim, 4 * (WIDE - 1));
    ck_assert_uint_le(rim, 4 * (WIDE - 1) + 4 * (2 * HOLE + 1));
    return rim;
}

/* A level sheet was cut off there: it goes on nowhere; one that goes down, down and aside from its
 * rims, as a plane, and not up. */
START_TEST(sheet)
{
    const double step = 0.5, slope = 1;
    struct vec3s place = {0};

    beyond_sheet(0, step, &place);
    ck_assert_uint_eq(place.n, 0);
    beyond_sheet(slope, step, &place);
    ck_assert_uint_gt(place.n, 40);
    for (size_t i = 0; i < place.n; i++) {
        ck_assert_double_eq_tol(place.item[i].z, 1 - slope * place.item[i].x, 1e-9);
        ck_assert_double_ge(place.item[i].x, 0);
    }
    array_free(&place);
}
END_TEST

/* A crest as narrow as points are apart, that rises to its tip: what is beyond the last points is
 * guarded as far as it may go on. */
START_TEST(tip)
{
    const double spacing = 0.3, rise = 0.5;
    struct vec3s scan = {0}, place = {0};

    const double side[] = {0, 0.15, -0.15, 0.3, -0.3};
    for (int x = 0; x < 20; x++)
        for (int k = 0; k < 5; k++)
            *array_push(&scan) =
                vec(-spacing * x - fabs(side[k]), side[k], rise * -spacing * x - 2 * fabs(side[k]));
    ck_assert_uint_gt(beyond(&scan, spacing, 0, &place), 20);
    struct kdtree *tree = kdtree_new(place.item, place.n);
    for (double x = 0.1; x < 0.25; x += 0.05) {
        size_t at;
        double distance2;
        kdtree_nearest(tree, vec(x, 0, rise * x), 1, &at, &distance2);
        ck_assert_double_lt(sqrt(distance2), 0.15);
    }
    kdtree_free(tree);
    array_free(&scan);
    array_free(&place);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rim_points");
    TCase *tests = tcase_create("rim_points");

    tcase_add_test(tests, steep_flank);
    tcase_add_test(tests, sheet);
    tcase_add_test(tests, tip);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
