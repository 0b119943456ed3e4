/*
 * net_patches: patches meet their corners with the slopes given; Ferguson's have no twist there;
 * curves of the second degree, and what is a product of two, come back as they are by Bezier's;
 * neighbours have common tangent planes.
 */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "nurbs/net_patches.h"

enum { W = 7, H = 5 };

static double height(double x, double y)
{
    return 2 + 0.1 * x * x - 0.2 * y * y + 0.3 * x * y + x;
}

/* Over 12 x 12 mm from (-3, 1) on. */
static struct net_patches net_of(double (*z)(double, double))
{
    struct net_patches net = net_patches_new(W, H);

    net.x = -3;
    net.y = 1;
    net.dx = 2;
    net.dy = 3;
    for (size_t j = 0; j < H; j++)
        for (size_t i = 0; i < W; i++)
            net.z[j * W + i] = z(net.x + net.dx * (double)i, net.y + net.dy * (double)j);
    return net;
}

static double wave(double x, double y)
{
    return sin(x / 2) * cos(y / 3);
}

static double worst_of(const struct nurbs *s, double (*z)(double, double))
{
    double worst = 0;

    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++) {
            struct uv at = {-3 + 0.3 * i, 1 + 0.3 * j};
            struct vec3 p = nurbs_point(s, at);
            ck_assert_double_eq_tol(p.x, at.u, 1e-12);
            ck_assert_double_eq_tol(p.y, at.v, 1e-12);
            worst = fmax(worst, fabs(p.z - z(at.u, at.v)));
        }
    return worst;
}

START_TEST(bezier_of_second_degree)
{
    struct net_patches net = net_of(height);
    net_patches_bezier(&net);
    struct nurbs s = net_patches_surface(&net);

    ck_assert_uint_eq(s.u.poles, 2 * W);
    ck_assert_uint_eq(s.v.poles, 2 * H);
    ck_assert_double_lt(worst_of(&s, height), 1e-12);
    nurbs_free(&s);
    net_patches_free(&net);
}
END_TEST

/* Slopes as given at each corner; the mixed derivative there is zero, though the surface has one:
 * what that costs is the known flat spot. */
START_TEST(ferguson_corners)
{
    struct net_patches net = net_of(height);
    for (size_t k = 0; k < W * H; k++) {
        double x = -3 + 2 * (double)(k % W), y = 1 + 3 * (double)(k / W);
        net.zx[k] = 0.2 * x + 0.3 * y + 1;
        net.zy[k] = -0.4 * y + 0.3 * x;
        net.zxy[k] = 5; /* to be put to zero */
    }
    net_patches_ferguson(&net);
    struct nurbs s = net_patches_surface(&net);
    for (size_t k = 0; k < W * H; k++) {
        struct uv at = {-3 + 2 * (double)(k % W), 1 + 3 * (double)(k / W)};
        struct vec3 d[3][3];
        nurbs_derivatives(&s, at, 2, d);
        ck_assert_double_eq_tol(d[0][0].z, net.z[k], 1e-12);
        ck_assert_double_eq_tol(d[1][0].z, net.zx[k], 1e-12);
        ck_assert_double_eq_tol(d[0][1].z, net.zy[k], 1e-12);
        ck_assert_double_eq_tol(d[1][1].z, 0, 1e-12);
    }
    double worst = worst_of(&s, height);
    ck_assert_double_gt(worst, 0.01);
    ck_assert_double_lt(worst, 0.2);
    nurbs_free(&s);
    net_patches_free(&net);
}
END_TEST

START_TEST(tangent_planes_agree)
{
    struct net_patches net = net_of(wave);
    net_patches_bezier(&net);
    struct nurbs s = net_patches_surface(&net);

    for (int j = 0; j <= 30; j++)
        for (int i = 1; i + 1 < W; i++) {
            double x = -3 + 2 * i, y = 1 + 0.4 * j, h = 1e-7;
            struct nurbs_place before = nurbs_place(&s, (struct uv){x - h, y});
            struct nurbs_place after = nurbs_place(&s, (struct uv){x + h, y});
            ck_assert_double_lt(vec_distance(before.normal, after.normal), 1e-6);
        }
    ck_assert_double_lt(worst_of(&s, wave), 0.1);
    nurbs_free(&s);
    net_patches_free(&net);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("net_patches");
    TCase *tests = tcase_create("patches");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, bezier_of_second_degree);
    tcase_add_test(tests, ferguson_corners);
    tcase_add_test(tests, tangent_planes_agree);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
