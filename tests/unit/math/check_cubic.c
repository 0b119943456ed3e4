/* cubic: cubics found again, whatever the frame; variances against many fits; what carries none. */
#include <check.h>
#include <stdlib.h>

#include "math/cubic.h"
#include "noisy.h"

enum { N = 150 };

static struct vec3 point[N];

/* Points of w = 1 + 0.2 u - 0.3 v + 0.1 u^2 + ... in the frame of `up`, the farthest last. */
static void make_points(struct vec3 up, double sigma)
{
    struct vec3 right = vec_perpendicular(up), ahead = vec_cross(up, right);
    noisy_seed(11);
    for (int i = 0; i < N; i++) {
        double u = 3 * noisy_uniform() - 1, v = 2 * noisy_uniform() - 1;
        if (i == N - 1)
            u = 2.5, v = 1.5;
        double w = 1 + 0.2 * u - 0.3 * v + 0.1 * u * u - 0.05 * u * v + 0.2 * v * v +
                   0.03 * u * u * u - 0.02 * u * u * v + 0.01 * u * v * v + 0.04 * v * v * v;
        w += sigma * noisy_normal();
        point[i] = vec_along(vec_along(vec_scale(u, right), v, ahead), w, up);
    }
}

START_TEST(found_again)
{
    const double truth[] = {1, 0.2, -0.3, 0.1, -0.05, 0.2, 0.03, -0.02, 0.01, 0.04};
    const struct vec3 up[] = {{0, 0, 1}, {0.6, 0, 0.8}, {0, -1, 0}};
    struct quadric q;
    make_points(up[_i], 0);
    ck_assert_int_eq(cubic_fit(point, NULL, N, vec(0, 0, 0), up[_i], &q), 0);
    for (int k = 0; k < 10; k++)
        ck_assert_double_eq_tol(q.c[k], truth[k], 1e-9);
    for (int k = 0; k < N; k++)
        ck_assert_double_eq_tol(quadric_off(&q, point[k]), 0, 1e-9);
}
END_TEST

START_TEST(weights)
{
    double weight[N];
    struct quadric q;
    make_points(vec(0, 0, 1), 0);
    for (int k = 0; k < N; k++) {
        weight[k] = k % 4 == 0 ? 0 : 0.5;
        if (k % 4 == 0)
            point[k].z += 7;
    }
    ck_assert_int_eq(cubic_fit(point, weight, N, vec(0, 0, 0), vec(0, 0, 1), &q), 0);
    ck_assert_double_eq_tol(q.c[0], 1, 1e-9);
    ck_assert_double_eq_tol(q.c[9], 0.04, 1e-9);
}
END_TEST

/* Both fits say of themselves how uncertain they are: as many fits to new noise scatter. */
START_TEST(variances)
{
    enum { FITS = 3000 };
    double sum2 = 0, slope2 = 0;
    struct quadric q, exact;
    make_points(vec(0, 0, 1), 0);
    struct vec3 origin = vec(0.3, -0.4, 1), up = vec(0, 0, 1);
    int (*fit)(const struct vec3 *, const double *, size_t, struct vec3, struct vec3,
               struct quadric *) = _i == 0 ? quadric_fit_weighted : cubic_fit;
    ck_assert_int_eq(fit(point, NULL, N, origin, up, &exact), 0);
    for (int i = 0; i < FITS; i++) {
        struct vec3 noisy[N];
        for (int k = 0; k < N; k++)
            noisy[k] = vec_along(point[k], noisy_normal(), up);
        fit(noisy, NULL, N, origin, up, &q);
        sum2 += pow(q.c[0] - exact.c[0], 2) / FITS;
        slope2 += (pow(q.c[1] - exact.c[1], 2) + pow(q.c[2] - exact.c[2], 2)) / FITS;
    }
    ck_assert_double_eq_tol(sum2 / exact.variance, 1, 0.1);
    ck_assert_double_eq_tol(slope2 / exact.tilt, 1, 0.1);
}
END_TEST

/* Slopes are linear in heights: the variance of one is the sum of the squares of what each point by
 * itself, 1 mm higher, adds to it.  On points that lie far more one way than across it, one that is
 * no axis of the frame; the surface turned over says the same. */
START_TEST(variance_of_slopes_one_way)
{
    const struct vec3 origin = vec(0.3, -0.4, 1), up = vec(0, 0, 1);
    int (*fit)(const struct vec3 *, const double *, size_t, struct vec3, struct vec3,
               struct quadric *) = _i == 0 ? quadric_fit_weighted : cubic_fit;
    struct quadric q, flat;
    struct vec3 added[N];

    make_points(up, 0);
    for (int k = 0; k < N; k++) {
        double u = point[k].x, v = 0.6 * point[k].y;
        point[k] = vec(0.8 * u - 0.6 * v, 0.6 * u + 0.8 * v, 0);
    }
    ck_assert_int_eq(fit(point, NULL, N, origin, up, &flat), 0);
    for (int k = 0; k < N; k++) {
        point[k].z = 1;
        ck_assert_int_eq(fit(point, NULL, N, origin, up, &q), 0);
        added[k] = vec_add(vec_scale(q.c[1] - flat.c[1], q.u), vec_scale(q.c[2] - flat.c[2], q.v));
        point[k].z = 0;
    }
    struct quadric over; /* fitted from below */
    ck_assert_int_eq(fit(point, NULL, N, origin, vec_scale(-1, up), &over), 0);
    quadric_face_up(&over);
    for (double turn = 0; turn < 3; turn += 0.3) {
        struct vec3 way = vec(cos(turn), sin(turn), 0);
        double sum2 = 0;
        for (int k = 0; k < N; k++)
            sum2 += pow(vec_dot(way, added[k]), 2);
        ck_assert_double_eq_tol(quadric_tilt_along(&flat, way) / sum2, 1, 1e-9);
        ck_assert_double_eq_tol(quadric_tilt_along(&flat, vec_scale(-3, way)) / sum2, 1, 1e-9);
        ck_assert_double_eq_tol(quadric_tilt_along(&over, way) / sum2, 1, 1e-9);
    }
    ck_assert_double_eq(quadric_tilt_along(&flat, vec(0, 0, 0)), 0);
}
END_TEST

START_TEST(none)
{
    struct quadric q;
    make_points(vec(0, 0, 1), 0);
    ck_assert_int_eq(cubic_fit(point, NULL, 9, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
    ck_assert_int_eq(cubic_fit(point, NULL, 0, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
    for (int k = 0; k < N; k++) /* on three lines */
        point[k].y = k % 3;
    ck_assert_int_eq(cubic_fit(point, NULL, N, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
}
END_TEST

/* Three scan lines that are not quite straight, in any direction: v (v - 1) (v + 1) is nothing on
 * them and anything between. */
START_TEST(three_lines)
{
    double turn = 0.3 * _i + 0.1;
    struct quadric q;

    noisy_seed(21 + (unsigned)_i);
    for (int k = 0; k < 24; k++) {
        double u = (k / 3 - 3.5) * 0.25, v = k % 3 - 1 + 1e-3 * noisy_normal();
        point[k] = vec(u * cos(turn) - v * sin(turn), u * sin(turn) + v * cos(turn),
                       1e-4 * noisy_normal());
    }
    ck_assert_int_eq(cubic_fit(point, NULL, 24, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cubic");
    TCase *tests = tcase_create("cubic");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, found_again, 0, 3);
    tcase_add_test(tests, weights);
    tcase_add_loop_test(tests, variances, 0, 2);
    tcase_add_loop_test(tests, variance_of_slopes_one_way, 0, 2);
    tcase_add_test(tests, none);
    tcase_add_loop_test(tests, three_lines, 0, 5);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
