/* net_corners: heights and slopes at the nodes of a net, of points on a surface of the third
 * degree, which a fit of that degree has exactly; beyond the points the planes of the nodes
 * beside. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "stage/net_corners.h"

static struct vec3s points;

/* z = 3 + 0.2 x - 0.3 y + 0.02 x^2 - 0.01 x y + 0.001 y^3 */
static struct vec3 on(double x, double y)
{
    return vec(x, y, 3 + 0.2 * x - 0.3 * y + 0.02 * x * x - 0.01 * x * y + 0.001 * y * y * y);
}

static double slope_x(double x, double y)
{
    return 0.2 + 0.04 * x - 0.01 * y;
}

static double slope_y(double x, double y)
{
    return -0.3 - 0.01 * x + 0.003 * y * y;
}

/* 0 <= x <= 20, 0 <= y <= 15 in steps of 1, not quite in rows. */
static void setup(void)
{
    for (int j = 0; j <= 15; j++)
        for (int i = 0; i <= 20; i++)
            *array_push(&points) = on(i + 0.1 * (j % 3), j + 0.13 * (i % 4));
}

static void teardown(void)
{
    array_free(&points);
}

START_TEST(on_a_cubic)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        struct net_corners c = net_corners_new(points.item, points.n, 1, noisy ? 0.005 : 0.003);
        ck_assert_uint_eq(c.neighbours, noisy ? 80 : 30);
        struct net_patches net = net_patches_new(5, 4);
        net.x = 1, net.y = 0.5, net.dx = 4.5, net.dy = 4.7;
        net_corners_find(&c, &net, 1 + noisy);
        for (size_t k = 0; k < 20; k++) {
            double x = 1 + 4.5 * (double)(k % 5), y = 0.5 + 4.7 * (double)(k / 5);
            ck_assert_double_eq_tol(net.z[k], on(x, y).z, 1e-8);
            ck_assert_double_eq_tol(net.zx[k], slope_x(x, y), 1e-7);
            ck_assert_double_eq_tol(net.zy[k], slope_y(x, y), 1e-7);
        }
        net_patches_free(&net);
        net_corners_free(&c);
    }
}
END_TEST

/* Columns at 14, 18 (known), 22.5 and 27 (more than two spacings off): the planes go on. */
START_TEST(beyond)
{
    struct net_corners c = net_corners_new(points.item, points.n, 1, 0);
    struct net_patches net = net_patches_new(4, 3);
    for (size_t i = 0; i < points.n; i++)
        points.item[i].z = 5 + 0.25 * points.item[i].x - 0.5 * points.item[i].y;
    net.x = 14, net.y = 2, net.dx = 4.5, net.dy = 6;
    net_corners_find(&c, &net, 1);
    for (size_t k = 0; k < 12; k++) {
        double x = 14 + 4.5 * (double)(k % 4), y = 2 + 6 * (double)(k / 4);
        ck_assert_double_eq_tol(net.z[k], 5 + 0.25 * x - 0.5 * y, 1e-8);
        ck_assert_double_eq_tol(net.zx[k], 0.25, 1e-8);
        ck_assert_double_eq_tol(net.zy[k], -0.5, 1e-8);
    }
    /* on a bent surface: each the mean of the planes of its three neighbours, or two at a corner */
    for (size_t i = 0; i < points.n; i++)
        points.item[i] = on(points.item[i].x, points.item[i].y);
    net_corners_find(&c, &net, 1);
    double z = 0, zx = 0;
    for (int j = 0; j < 3; j++) {
        double y = 2 + 6 * j;
        z += on(18.5, y).z + 4.5 * slope_x(18.5, y) + (8 - y) * slope_y(18.5, y);
        zx += slope_x(18.5, y);
    }
    ck_assert_double_eq_tol(net.z[4 + 2], z / 3, 1e-6);
    ck_assert_double_eq_tol(net.zx[4 + 2], zx / 3, 1e-6);
    z = 0;
    for (int j = 0; j < 2; j++) {
        double y = 2 + 6 * j;
        z += on(18.5, y).z + 4.5 * slope_x(18.5, y) + (2 - y) * slope_y(18.5, y);
    }
    ck_assert_double_eq_tol(net.z[2], z / 2, 1e-6);
    net_patches_free(&net);
    net_corners_free(&c);
}
END_TEST

/* Rows at -4 (unknown), 2 and 8, columns at 2 and 8: at the first row and at both ends of it all
 * neighbours that are known count, those straight beside it too. */
START_TEST(beyond_other_sides)
{
    struct net_corners c = net_corners_new(points.item, points.n, 1, 0);
    struct net_patches net = net_patches_new(2, 3);
    net.x = 2, net.y = -4, net.dx = 6, net.dy = 6;
    net_corners_find(&c, &net, 1);
    for (size_t k = 0; k < 2; k++) {
        double z = 0, zx = 0, zy = 0, x = 2 + 6 * (double)k;
        for (int i = 0; i < 2; i++) {
            double at = 2 + 6 * i;
            z += on(at, 2).z + (x - at) * slope_x(at, 2) - 6 * slope_y(at, 2);
            zx += slope_x(at, 2);
            zy += slope_y(at, 2);
        }
        ck_assert_double_eq_tol(net.z[k], z / 2, 1e-6);
        ck_assert_double_eq_tol(net.zx[k], zx / 2, 1e-6);
        ck_assert_double_eq_tol(net.zy[k], zy / 2, 1e-6);
    }
    net_patches_free(&net);
    net_corners_free(&c);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("net_corners");
    TCase *tests = tcase_create("net_corners");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, on_a_cubic);
    tcase_add_test(tests, beyond);
    tcase_add_test(tests, beyond_other_sides);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
