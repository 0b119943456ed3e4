/* plan_extent: boxes of turned clouds, clouds that are none, spacings that are known. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/plan_extent.h"
#include "seed.h"

static uint64_t state = 7;
static struct vec3s cloud;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

static void add(double x, double y, double z)
{
    *array_push(&cloud) = vec(x, y, z);
}

START_TEST(box)
{
    add(1, 2, 0);
    add(-3, 5, 9);
    add(4, -1, 2);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert(f.xmin == -3 && f.xmax == 4 && f.ymin == -1 && f.ymax == 5);
    f = plan_extent_of(cloud.item, cloud.n, 90); /* rows along y: x' = y, y' = -x */
    ck_assert(f.xmin == -1 && f.xmax == 5 && f.ymin == -4 && f.ymax == 3);
    f = plan_extent_of(cloud.item, cloud.n, 30);
    struct vec3 p = plan_extent_turn(&f, vec(cos(PI / 6), sin(PI / 6), 4));
    ck_assert_double_eq_tol(p.x, 1, 1e-15);
    ck_assert_double_eq_tol(p.y, 0, 1e-15);
    ck_assert(p.z == 4);
}
END_TEST

static void expect_refused(const char *words)
{
    struct error error;
    ck_assert_int_eq(plan_extent_check(cloud.item, cloud.n, &error), -1);
    ck_assert_msg(strstr(error.text, words) != NULL, "`%s` without `%s`", error.text, words);
}

START_TEST(no_surface)
{
    struct error error;
    expect_refused("no points");
    add(1, 2, 3);
    expect_refused("1 point,");
    add(1, 2, 4);
    expect_refused("2 points");
    add(1, 2, 5);
    expect_refused("in one place");
    for (int i = 0; i < 50; i++)
        add(1 + 0.1 * i, 2 + 0.3 * i, uniform());
    expect_refused("on one line");
    array_free(&cloud);
    for (int i = 0; i < 50; i++)
        add(uniform(), uniform(), uniform());
    ck_assert_int_eq(plan_extent_check(cloud.item, cloud.n, &error), 0);
    add(-1e6, 1e6, 0);
    expect_refused("an outlier far off");
    array_free(&cloud);
    for (int i = 0; i < 50; i++)
        add(10 * i, 20 * i, 0);
    add(1, 2.001, 0);
    expect_refused("on one line");
    add(1, 2.1, 0);
    ck_assert_int_eq(plan_extent_check(cloud.item, cloud.n, &error), 0);
}
END_TEST

START_TEST(spacing_of_a_regular_grid)
{
    for (int i = 0; i < 60; i++)
        for (int j = 0; j < 40; j++)
            add(0.5 * i + 4e6, 0.5 * j - 5e5, 0);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_double_eq_tol(plan_extent_spacing(&f, cloud.item, cloud.n), 0.5, 0.02);
}
END_TEST

/* Stripes four steps apart: a cell of step x 4 step for each point, twice the step. */
START_TEST(spacing_of_laser_lines)
{
    for (int i = 0; i < 400; i++)
        for (int j = 0; j < 60; j++)
            add(0.25 * i, 1.0 * j, 0);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_double_eq_tol(plan_extent_spacing(&f, cloud.item, cloud.n), 0.5, 0.02);
}
END_TEST

/* An L whose box is mostly empty, and one far outlier: the empty parts do not count. */
START_TEST(spacing_where_points_are)
{
    for (int i = 0; i < 20000; i++) {
        add(200 * uniform(), 10 * uniform(), 0);
        add(10 * uniform(), 10 + 200 * uniform(), 0);
    }
    double truth = sqrt(4000.0 / 40000);
    struct plan_extent f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_double_eq_tol(plan_extent_spacing(&f, cloud.item, cloud.n), truth, 0.1 * truth);
    add(9e8, -9e8, 0);
    f = plan_extent_of(cloud.item, cloud.n, 0);
    ck_assert_double_eq_tol(plan_extent_spacing(&f, cloud.item, cloud.n), truth, 0.3 * truth);
}
END_TEST

static void empty_cloud(void)
{
    array_free(&cloud);
}

int main(void)
{
    Suite *suite = suite_create("plan_extent");
    TCase *tests = tcase_create("plan_extent");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, empty_cloud, empty_cloud);
    tcase_add_test(tests, box);
    tcase_add_test(tests, no_surface);
    tcase_add_test(tests, spacing_of_a_regular_grid);
    tcase_add_test(tests, spacing_of_laser_lines);
    tcase_add_test(tests, spacing_where_points_are);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
