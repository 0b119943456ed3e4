/* raster - what is nearest wins; area by cells; what hides what. */
#include <check.h>
#include <stdlib.h>

#include "plot/raster.h"

static size_t filled(const struct raster *r, size_t owner)
{
    size_t n = 0;
    for (size_t i = 0; i < r->columns * r->rows; i++)
        n += !isinf(r->depth[i]) && r->owner[i] == owner;
    return n;
}

START_TEST(triangle_covers_its_area)
{
    struct raster r = raster_new(0, 0, 10, 10, 0.05);
    raster_triangle(&r, vec(1, 1, 0), vec(9, 2, 0), vec(4, 8, 0), 7);
    double area = 0.5 * ((9 - 1) * (8 - 1) - (2 - 1) * (4 - 1));
    ck_assert_double_eq_tol((double)filled(&r, 7) * 0.05 * 0.05, area, 0.1);
    raster_free(&r);
}
END_TEST

START_TEST(disc_covers_its_area)
{
    struct raster r = raster_new(0, 0, 10, 10, 0.05);
    raster_disc(&r, vec(5, 5, 1), 3, 2);
    ck_assert_double_eq_tol((double)filled(&r, 2) * 0.05 * 0.05, PI * 9, 0.15);
    raster_free(&r);
}
END_TEST

START_TEST(nearest_wins_whatever_the_order)
{
    for (int turn = 0; turn < 2; turn++) {
        struct raster r = raster_new(0, 0, 4, 4, 0.5);
        for (int k = 0; k < 2; k++) {
            double z = (k == turn) ? 5 : 1;
            raster_triangle(&r, vec(-9, -9, z), vec(20, -9, z), vec(-9, 20, z), k == turn ? 5 : 1);
        }
        ck_assert_uint_eq(filled(&r, 5), 64);
        ck_assert(raster_visible(&r, vec(1, 1, 5), 0));
        ck_assert(!raster_visible(&r, vec(1, 1, 4.8), 0.1));
        ck_assert(raster_visible(&r, vec(1, 1, 4.8), 0.3));
        ck_assert(raster_hides(&r, vec(1, 1, 1), vec(3, 1, 1), vec(1, 3, 1), 0.1));
        ck_assert(!raster_hides(&r, vec(1, 1, 6), vec(3, 1, 6), vec(1, 3, 6), 0.1));
        raster_free(&r);
    }
}
END_TEST

START_TEST(depth_goes_over_evenly)
{
    struct raster r = raster_new(0, 0, 8, 8, 1);
    raster_triangle(&r, vec(0, 0, 0), vec(16, 0, 16), vec(0, 16, 32), 1);
    /* z = x + 2 y in the middles */
    ck_assert_double_eq_tol(r.depth[raster_cell(&r, 2.5, 3.5)], 2.5 + 7, 1e-12);
    raster_free(&r);
}
END_TEST

START_TEST(points_are_counted_once_a_cell)
{
    struct raster r = raster_new(0, 0, 2, 2, 1);
    ck_assert(raster_point(&r, vec(0.2, 0.2, 0), 1));
    ck_assert(!raster_point(&r, vec(0.8, 0.8, 3), 2));
    ck_assert_uint_eq(r.owner[0], 2);
    ck_assert(!raster_point(&r, vec(-5, -5, 1), 3)); /* outside: the rim */
    ck_assert(raster_point(&r, vec(9, 9, 1), 4));
    ck_assert_uint_eq(r.owner[3], 4);
    raster_free(&r);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("raster");
    TCase *tests = tcase_create("raster");
    tcase_add_test(tests, triangle_covers_its_area);
    tcase_add_test(tests, disc_covers_its_area);
    tcase_add_test(tests, nearest_wins_whatever_the_order);
    tcase_add_test(tests, depth_goes_over_evenly);
    tcase_add_test(tests, points_are_counted_once_a_cell);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
