/* sheets: two scans over each other are found, and how far they are apart; one surface, with noise,
 * with a step or with a crease, is no two. */
#include <check.h>
#include <stdlib.h>

#include "cloud/sheets.h"
#include "noisy.h"

enum { POINTS = 6000 };
static const double SIGMA = 0.01; /* mm */

static double dome(double x, double y)
{
    return 20 - x * x / 120 - y * y / 90;
}

static double with_step(double x, double y)
{
    return dome(x, y) + (x > 30 ? 0.3 : 0);
}

static double with_crease(double x, double y)
{
    return y > 20 ? 0.6 * (y - 20) : 0.002 * x * x;
}

static double bent(double x, double y)
{
    return 4 * sin(x / 6) * cos(y / 7);
}

static struct sheets look(struct vec3s *scan, int threads)
{
    struct point_grid grid;
    struct error error;
    ck_assert_int_eq(point_grid_make(scan->item, scan->n, 0.8, 1, &grid, &error), 0);
    struct sheets sheets = sheets_find(&grid, NULL, threads);
    point_grid_free(&grid);
    return sheets;
}

static struct vec3s cloud(double (*height)(double, double), double apart, unsigned seed)
{
    struct vec3s scan = {0};
    noisy_seed(seed);
    noisy_scan(&scan, height, POINTS, NOISY_RANDOM, SIGMA);
    size_t first = scan.n;
    if (apart > 0)
        noisy_scan(&scan, height, POINTS, NOISY_RANDOM, SIGMA);
    for (size_t i = first; i < scan.n; i++)
        scan.item[i].z += apart;
    return scan;
}

START_TEST(one_surface)
{
    double (*const shape[])(double, double) = {dome, with_step, with_crease, bent};
    for (size_t i = 0; i < sizeof shape / sizeof *shape; i++) {
        struct vec3s scan = cloud(shape[i], 0, (unsigned)i + 1);
        struct sheets sheets = look(&scan, 1);
        ck_assert_uint_gt(sheets.looked, 1000);
        ck_assert_msg(sheets.places == 0 && sheets.distance == 0, "shape %zu: %zu places, %g mm", i,
                      sheets.places, sheets.distance);
        array_free(&scan);
    }
}
END_TEST

/* Measured along the normal, which the dome turns by up to 50 degrees: seldom more than the shift
 * along z, and of the level places just that.  The mean of 24 points of a group is within 0.01 /
 * sqrt(24) of it, the difference of two within 0.003; 5 of these. */
START_TEST(two_sheets)
{
    static const double apart[] = {0.1, 0.3};
    for (int i = 0; i < 2; i++) {
        struct vec3s scan = cloud(dome, apart[i], 7);
        struct sheets sheets = look(&scan, 1), again = look(&scan, 3);
        ck_assert_uint_gt(sheets.places, sheets.looked / 2);
        ck_assert_double_lt(sheets.distance, apart[i] + 0.015);
        ck_assert_double_gt(sheets.distance, apart[i] * 0.6);
        ck_assert_double_ge(sheets.widest, sheets.distance);
        ck_assert(again.places == sheets.places && again.distance == sheets.distance &&
                  again.at.x == sheets.at.x);
        array_free(&scan);
    }
}
END_TEST

static double level(double x, double y)
{
    (void)x;
    (void)y;
    return 0;
}

/* A surface through both sheets would make their distance a tenth smaller. */
START_TEST(the_distance_of_level_sheets)
{
    struct vec3s scan = cloud(level, 0.2, 5);
    struct sheets sheets = look(&scan, 1);
    ck_assert_double_eq_tol(sheets.distance, 0.2, 0.005);
    array_free(&scan);
}
END_TEST

/* Where only a part of the scan is there twice, the places are of that part. */
START_TEST(a_part)
{
    struct vec3s scan = cloud(dome, 0.2, 3);
    size_t kept = 0;
    for (size_t i = 0; i < scan.n; i++)
        if (i < POINTS || scan.item[i].x < 20)
            scan.item[kept++] = scan.item[i];
    scan.n = kept;
    struct sheets sheets = look(&scan, 1);
    ck_assert_uint_gt(sheets.places, 100);
    ck_assert_double_lt(sheets.at.x, 24); /* a neighbourhood beyond the border of the second */
    array_free(&scan);
}
END_TEST

/* Ribs 0.8 mm wide, on which there are one or two rows of points. */
static double ribs(double x, double y)
{
    double u = 0.9 * x + 0.44 * y;
    return fabs(u - 12 * floor(u / 12 + 0.5)) < 0.4 ? 0.8 : 0;
}

START_TEST(no_ribs)
{
    struct vec3s scan = {0};
    noisy_seed(4);
    noisy_scan(&scan, ribs, 17000, NOISY_GRID, 0.005);
    struct sheets sheets = look(&scan, 1);
    ck_assert_uint_le(sheets.places, sheets.looked / 100);
    array_free(&scan);
}
END_TEST

/* The foot of a step on a lattice: columns of points lie above and below a quadric in turn. */
START_TEST(no_columns)
{
    struct vec3s scan = {0};
    for (int j = 0; j <= 40; j++)
        for (int i = 0; i <= 60; i++) {
            double x = -6 + 0.2 * i;
            *array_push(&scan) = vec(x, -4 + 0.2 * j, 8 / (1 + exp(-6 * (x - 3))));
        }
    struct sheets sheets = look(&scan, 1);
    ck_assert_msg(sheets.places == 0, "%zu places, %g mm", sheets.places, sheets.widest);
    array_free(&scan);
}
END_TEST

/* Lines of two scans in turn are two sheets all the same. */
START_TEST(lines_in_turn)
{
    struct vec3s scan = {0};
    for (int j = 0; j <= 60; j++)
        for (int i = 0; i <= 60; i++)
            *array_push(&scan) = vec(0.2 * i, 0.2 * j, dome(0.2 * i, 0.2 * j) + (j % 2 ? 0.05 : 0));
    struct sheets sheets = look(&scan, 1);
    ck_assert_uint_gt(sheets.places, sheets.looked / 2);
    array_free(&scan);
}
END_TEST

START_TEST(few)
{
    struct vec3s scan = {0};
    for (int i = 0; i < 12; i++)
        *array_push(&scan) = vec(i % 4, i / 4, i % 2);
    struct sheets sheets = look(&scan, 1);
    ck_assert(sheets.places == 0 && sheets.looked == 12);
    array_free(&scan);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sheets");
    TCase *tests = tcase_create("sheets");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, one_surface);
    tcase_add_test(tests, two_sheets);
    tcase_add_test(tests, the_distance_of_level_sheets);
    tcase_add_test(tests, a_part);
    tcase_add_test(tests, no_ribs);
    tcase_add_test(tests, no_columns);
    tcase_add_test(tests, lines_in_turn);
    tcase_add_test(tests, few);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
