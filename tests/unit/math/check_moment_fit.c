/* moment_fit: cubics found again, near the origin of coordinates and far from it; the quadric, the
 * spreads and the variances as fits to the same points have them; which of the two is taken. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/cubic.h"
#include "math/moment_fit.h"
#include "noisy.h"

enum { SIDE = 40, SIX = 6, TEN = 10 };

static const double SPACING = 0.5;
static struct vec3s cloud;

/* Points SPACING apart, not on a raster, about (x, y): z = slope x + bend x^2 + twist x y^2. */
static struct vec3 on(struct vec3 at, double x, double y, double slope, double bend, double twist)
{
    return vec(at.x + x, at.y + y, at.z + slope * x + bend * x * x + twist * x * y * y);
}

static struct point_grid make_cloud(struct vec3 at, double slope, double bend, double twist,
                                    double sigma)
{
    struct point_grid grid;
    struct error error;

    noisy_seed(5);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = SPACING * (i % SIDE - SIDE / 2 + 0.8 * noisy_uniform());
        double y = SPACING * (i / SIDE - SIDE / 2 + 0.8 * noisy_uniform());
        struct vec3 p = on(at, x, y, slope, bend, twist);
        p.z += sigma * noisy_normal();
        *array_push(&cloud) = p;
    }
    ck_assert_int_eq(point_grid_make(cloud.item, cloud.n, SPACING, 1, &grid, &error), 0);
    return grid;
}

static void drop_cloud(struct point_grid *grid)
{
    point_grid_free(grid);
    array_free(&cloud);
}

/* UTM coordinates have no digits to lose. */
static const struct vec3 places[] = {{0, 0, 0}, {500000, 4000000, 300}};

START_TEST(cubic_found_again)
{
    struct point_grid grid = make_cloud(places[_i], 0.1, 0.05, 0.03, 0);
    struct moment_fit fit;

    ck_assert_int_eq(moment_fit_ball(&grid, places[_i], vec(0, 0, 1), 2, &fit), 0);
    ck_assert_double_eq_tol(fit.cubic.c[0], 0, 1e-8);
    ck_assert_double_lt(fit.cubic_spread, 1e-8);
    ck_assert_double_gt(fit.quadric_spread, 1e-3);
    ck_assert_ptr_eq(moment_fit_better(&fit), &fit.cubic);
    struct vec3 normal = quadric_normal(&fit.cubic), truth = vec_unit(vec(-0.1, 0, 1));
    ck_assert_double_lt(vec_distance(normal, truth), 1e-8);
    drop_cloud(&grid);
}
END_TEST

START_TEST(steep_gets_a_frame_of_its_own)
{
    struct point_grid grid = make_cloud(places[0], 1.5, 0, 0, 0);
    struct moment_fit fit;

    ck_assert_int_eq(moment_fit_ball(&grid, places[0], vec(0, 0, 1), 2, &fit), 0);
    struct vec3 truth = vec_unit(vec(-1.5, 0, 1));
    ck_assert_double_lt(vec_distance(fit.quadric.w, truth), 1e-9);
    ck_assert_double_lt(vec_distance(quadric_normal(&fit.quadric), truth), 1e-9);
    drop_cloud(&grid);
}
END_TEST

/* The points in the ball, farthest last. */
static size_t in_ball(const struct point_grid *grid, double radius, struct vec3 *point)
{
    uint32_t index[MOMENT_FIT_MOST];
    double distance2[MOMENT_FIT_MOST];
    size_t n = point_grid_nearest(grid, vec(0, 0, 0), MOMENT_FIT_MOST, index, distance2), in = 0;

    for (size_t i = 0; i < n && distance2[i] <= radius * radius; i++)
        point[in++] = grid->point[index[i]];
    return in;
}

START_TEST(as_fits_to_the_same_points)
{
    const double radius = 2;
    struct point_grid grid = make_cloud(places[0], 0.05, 0.05, 0.02, 0.01);
    struct vec3 point[MOMENT_FIT_MOST];
    struct moment_fit fit;
    struct quadric quadric, cubic;
    size_t n = in_ball(&grid, radius, point);

    ck_assert_int_eq(moment_fit_ball(&grid, vec(0, 0, 0), vec(0, 0, 1), radius, &fit), 0);
    ck_assert_int_eq(quadric_fit(point, n, vec(0, 0, 0), vec(0, 0, 1), &quadric), 0);
    ck_assert_int_eq(cubic_fit(point, NULL, n, vec(0, 0, 0), vec(0, 0, 1), &cubic), 0);
    ck_assert_uint_eq(fit.n, n);
    for (int k = 0; k < TEN; k++) {
        ck_assert_double_eq_tol(fit.quadric.c[k], quadric.c[k], 1e-10);
        ck_assert_double_eq_tol(fit.cubic.c[k], cubic.c[k], 1e-10);
    }
    ck_assert_double_eq_tol(fit.quadric.variance, quadric.variance, 1e-10);
    ck_assert_double_eq_tol(fit.quadric.tilt, quadric.tilt, 1e-10);
    ck_assert_double_eq_tol(fit.cubic.variance, cubic.variance, 1e-10);
    ck_assert_double_eq_tol(fit.cubic.tilt, cubic.tilt, 1e-10);
    for (double turn = 0; turn < 3; turn += 0.4) {
        struct vec3 way = vec(cos(turn), sin(turn), 0);
        double of_quadric = quadric_tilt_along(&quadric, way);
        double of_cubic = quadric_tilt_along(&cubic, way);
        ck_assert_double_eq_tol(quadric_tilt_along(&fit.quadric, way), of_quadric, 1e-10);
        ck_assert_double_eq_tol(quadric_tilt_along(&fit.cubic, way), of_cubic, 1e-10);
    }
    /* that of the distances from the surface, along its normal: a hundredth less */
    ck_assert_double_eq_tol(fit.quadric_spread, quadric_spread(&quadric, point, n, SIX), 3e-4);
    ck_assert_double_eq_tol(fit.cubic_spread, quadric_spread(&cubic, point, n, TEN), 3e-4);
    drop_cloud(&grid);
}
END_TEST

/* At places that share few points; where noise alone speaks for a cubic it is taken rarely: where
 * the sum of two squares is four times its mean, exp(-4) = 0.018 of the places.  More than five of
 * 25 are by chance in 6 of a million. */
START_TEST(noise_is_no_cubic)
{
    struct point_grid grid = make_cloud(places[0], 0.05, 0.05, 0, 0.02);
    int quadrics = 0;

    for (int k = 0; k < 25; k++) {
        double x = 3.4 * (k % 5 - 2), y = 3.4 * (k / 5 - 2);
        struct moment_fit fit;
        ck_assert_int_eq(
            moment_fit_ball(&grid, on(places[0], x, y, 0.05, 0.05, 0), vec(0, 0, 1), 2, &fit), 0);
        quadrics += moment_fit_better(&fit) == &fit.quadric;
        /* of so many points, less ten terms; within five deviations of such an estimate */
        double sure = 5 / sqrt(2 * (double)(fit.n - TEN));
        ck_assert_double_eq_tol(fit.cubic_spread, 0.02, 0.02 * sure);
    }
    drop_cloud(&grid);
    ck_assert_int_ge(quadrics, 20);
}
END_TEST

START_TEST(none)
{
    struct point_grid grid = make_cloud(places[0], 0, 0, 0, 0);
    struct moment_fit fit;

    ck_assert_int_eq(moment_fit_ball(&grid, places[0], vec(0, 0, 1), 1, &fit), -1);  /* too few */
    ck_assert_int_eq(moment_fit_ball(&grid, places[0], vec(0, 0, 1), 11, &fit), -1); /* too many */
    ck_assert_int_eq(moment_fit_ball(&grid, vec(13, 0, 0), vec(0, 0, 1), 2, &fit), -1); /* beside */
    drop_cloud(&grid);
    for (int i = 0; i < 60; i++) /* two lines */
        *array_push(&cloud) = vec(i % 2, 0.05 * i - 1.5, 0);
    struct error error;
    ck_assert_int_eq(point_grid_make(cloud.item, cloud.n, 0.3, 1, &grid, &error), 0);
    ck_assert_int_eq(moment_fit_ball(&grid, vec(0.5, 0, 0), vec(0, 0, 1), 2, &fit), -1);
    drop_cloud(&grid);
}
END_TEST

START_TEST(lean_tells_a_border)
{
    struct point_grid grid = make_cloud(places[0], 0, 0, 0, 0);
    struct moment_fit fit;

    ck_assert_int_eq(moment_fit_ball(&grid, places[0], vec(0, 0, 1), 2, &fit), 0);
    ck_assert_double_lt(fit.lean, 0.15);
    ck_assert_int_eq(moment_fit_ball(&grid, vec(-10, 0, 0), vec(0, 0, 1), 2, &fit), 0);
    ck_assert_double_eq_tol(fit.lean, 0.42, 0.1);
    drop_cloud(&grid);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("moment_fit");
    TCase *tests = tcase_create("moment_fit");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, cubic_found_again, 0, 2);
    tcase_add_test(tests, steep_gets_a_frame_of_its_own);
    tcase_add_test(tests, as_fits_to_the_same_points);
    tcase_add_test(tests, noise_is_no_cubic);
    tcase_add_test(tests, none);
    tcase_add_test(tests, lean_tells_a_border);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
