/* scallop against cusps found by themselves: where two balls that touch a known surface meet. */
#include <check.h>
#include <stdlib.h>

#include "toolpath/scallop.h"
#include "shapes.h"

/* Height of the cusp between balls of radius R that touch a circle of curvature k at two points a
 * chord s apart; k = 0 a straight line.  By bisection over the height above the middle. */
static double cusp(double R, double k, double s)
{
    double low = 0, high = R;

    for (int i = 0; i < 100; i++) {
        double h = (low + high) / 2;
        double half = k == 0 ? 0 : asin(k * s / 2), d;
        if (k == 0) {
            d = hypot(s / 2, R - h);
        } else {
            double rho = 1 / k; /* centres at rho + R, the cusp's tip at rho + h */
            d = hypot((rho + R) * sin(half), (rho + R) * cos(half) - (rho + h));
        }
        if (d > R)
            low = h;
        else
            high = h;
    }
    return low;
}

START_TEST(steps_leave_the_cusp_that_was_asked_for)
{
    static const double curvature[] = {0, 0.02, 0.1, 0.5, -0.02, -0.1};

    for (int i = 0; i < 6; i++) {
        for (double h = 0.0001; h < 0.2; h *= 3) {
            double k = curvature[i], R = 8, s = scallop_step(h, R, k);
            double first_order = sqrt(8 * h * R / (1 + R * k));
            ck_assert_double_eq_tol(cusp(R, k, s), h, 1e-6 * h + 1e-9);
            ck_assert_double_eq_tol(s / first_order, 1, 2 * h * (fabs(k) + 1 / R));
            if (k >= 0)
                ck_assert_double_le(s, first_order);
        }
    }
}
END_TEST

/* A cusp higher than a hollow that the ball hardly fits has room for: the distance was 0, and
 * planes were put there without end. */
START_TEST(no_distance_is_none)
{
    for (double k = -0.3; k < 2; k += 0.01) {
        double before = 0;
        for (double h = 0.01; h < 12; h *= 1.3) {
            double step = scallop_step(h, 5, k);
            ck_assert_double_ge(step, 0.9 * before); /* hardly less for higher cusps */
            before = step;
        }
    }
    ck_assert_double_eq_tol(scallop_step(1, 5, -0.19), 2 / 0.19, 1e-12); /* the diameter */
}
END_TEST

START_TEST(equal_distances_from_border_to_border)
{
    struct doubles height = {0};

    scallop_equal(3, 47, 2, &height);
    ck_assert_uint_eq(height.n, 23);
    ck_assert_double_eq(height.item[0], 3);
    ck_assert_double_eq_tol(height.item[22], 46.98, 1e-12);
    for (size_t i = 0; i + 1 < height.n; i++)
        ck_assert_double_eq_tol(height.item[i + 1] - height.item[i], 43.98 / 22, 1e-12);
    height.n = 0;
    scallop_equal(3, 3, 2, &height);
    ck_assert_uint_eq(height.n, 1);
    height.n = 0;
    scallop_equal(0, 0.5, 2, &height);
    ck_assert_uint_eq(height.n, 2);
    array_free(&height);
}
END_TEST

static struct scallop_report heights_of(const struct mesh *mesh, struct vec3 normal, double low,
                                        double high, double h, double radius,
                                        struct doubles *height)
{
    struct scallop_options options = {.normal = normal, .h = h, .radius = radius};

    return scallop_heights(mesh, &options, low, high, height);
}

/* Worst cusp over a cylinder of radius 30 between neighbouring planes y = height. */
START_TEST(cusps_on_a_cylinder)
{
    struct mesh mesh = shape_grid(shape_cylinder, -10, -22, 10, 22, 10, 80);
    double h = 0.01, R = 6, worst = 0, least = 1;
    struct doubles height = {0};
    struct scallop_report report = heights_of(&mesh, vec(0, 1, 0), -22, 22, h, R, &height);

    ck_assert_uint_eq(report.steep, 0);
    ck_assert_double_eq(height.item[0], -22);
    for (size_t i = 0; i + 1 < height.n; i++) {
        double a = asin(height.item[i] / 30), b = asin(height.item[i + 1] / 30);
        double c = cusp(R, 1 / 30.0, 60 * sin((b - a) / 2));
        worst = fmax(worst, c);
        if (i + 2 < height.n)
            least = fmin(least, c);
    }
    ck_assert_double_le(worst, 1.01 * h);
    ck_assert_double_ge(least, 0.8 * h);
    ck_assert_double_lt(height.item[height.n - 1], 22);
    ck_assert_double_gt(height.item[height.n - 1], 21.9);
    /* Across the cylinder's axis it is straight: planes are further apart, and equal. */
    height.n = 0;
    report = heights_of(&mesh, vec(1, 0, 0), -10, 10, h, R, &height);
    ck_assert_double_eq_tol(report.widest, sqrt(8 * h * R), 0.01);
    array_free(&height);
    mesh_free(&mesh);
}
END_TEST

/* A hollow lets planes be further apart, a hump nearer: the same cylinder seen from below. */
START_TEST(a_hollow_has_fewer_planes)
{
    struct mesh mesh = shape_grid(shape_cylinder, -10, -10, 10, 10, 10, 40);
    struct doubles hump = {0}, hollow = {0};

    heights_of(&mesh, vec(0, 1, 0), -10, 10, 0.01, 6, &hump);
    for (size_t f = 0; f < mesh.face.n; f++) {
        int v = mesh.face.item[f].v[1];
        mesh.face.item[f].v[1] = mesh.face.item[f].v[2];
        mesh.face.item[f].v[2] = v;
    }
    for (size_t v = 0; v < mesh.normal.n; v++)
        mesh.normal.item[v] = vec_scale(-1, mesh.normal.item[v]);
    heights_of(&mesh, vec(0, 1, 0), -10, 10, 0.01, 6, &hollow);
    /* sqrt((1 + 6/30) / (1 - 6/30)) = 1.22 */
    ck_assert_double_eq_tol((double)hump.n / (double)hollow.n, 1.22, 0.06);
    array_free(&hump);
    array_free(&hollow);
    mesh_free(&mesh);
}
END_TEST

/* Four facets of a cube's 12 stand along the planes: for the others planes may be far apart. */
START_TEST(a_share_of_the_area_may_have_higher_cusps)
{
    struct mesh mesh = shape_cube(10);
    struct doubles all = {0}, most = {0}, some = {0};
    struct scallop_options options = {.normal = vec(0, 1, 0), .h = 0.01, .radius = 4};

    mesh_normals_facet(&mesh);
    scallop_heights(&mesh, &options, 0, 10, &all);
    options.steepest = 0.5; /* two times as near as on the level, no nearer */
    scallop_heights(&mesh, &options, 0, 10, &most);
    options.beyond = 0.5;
    scallop_heights(&mesh, &options, 0, 10, &some);
    ck_assert_double_le((double)most.n, 2.1 * 10 / scallop_step(0.01, 4, 0));
    ck_assert_uint_gt(all.n, some.n);
    ck_assert_uint_le(some.n, most.n);
    ck_assert_double_ge((double)some.n, 10 / scallop_step(0.01, 4, 0));
    array_free(&all);
    array_free(&most);
    array_free(&some);
    mesh_free(&mesh);
}
END_TEST

START_TEST(a_wall_along_the_planes_is_told)
{
    struct mesh mesh = shape_cube(10);
    struct doubles height = {0};

    mesh_normals_facet(&mesh);
    struct scallop_report report = heights_of(&mesh, vec(0, 1, 0), 0, 10, 0.01, 4, &height);
    ck_assert_uint_eq(report.steep, 4);
    ck_assert_double_eq(fabs(report.steep_at.y - 5), 5);
    ck_assert_uint_lt(height.n, 1000);
    array_free(&height);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("scallop");
    TCase *tests = tcase_create("scallop");
    tcase_add_test(tests, steps_leave_the_cusp_that_was_asked_for);
    tcase_add_test(tests, no_distance_is_none);
    tcase_add_test(tests, equal_distances_from_border_to_border);
    tcase_add_test(tests, cusps_on_a_cylinder);
    tcase_add_test(tests, a_hollow_has_fewer_planes);
    tcase_add_test(tests, a_share_of_the_area_may_have_higher_cusps);
    tcase_add_test(tests, a_wall_along_the_planes_is_told);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
