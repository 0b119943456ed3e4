/* sphere_grid: unit directions all round, and the four about a direction are about it. */
#include <check.h>
#include <stdlib.h>

#include "math/sphere_grid.h"
#include "noisy.h"

START_TEST(all_round)
{
    struct sphere_grid g = sphere_grid_new(vec_unit(vec(0.2, -0.5, 0.8)));
    struct vec3 sum = vec(0, 0, 0);
    double weight = 0;
    ck_assert_double_eq_tol(vec_dot(vec_cross(g.x, g.y), g.pole), 1, 1e-12);
    ck_assert_int_eq(g.start[SPHERE_GRID_RINGS], g.n);
    for (int ring = 0; ring < SPHERE_GRID_RINGS; ring++) {
        double lean = (ring + 0.5) * PI / SPHERE_GRID_RINGS;
        for (int k = g.start[ring]; k < g.start[ring + 1]; k++) {
            double share = sin(lean) / (g.start[ring + 1] - g.start[ring]);
            ck_assert_double_eq_tol(vec_length(g.at[k]), 1, 1e-12);
            ck_assert_double_eq_tol(vec_angle(g.at[k], g.pole), lean, 1e-9);
            sum = vec_along(sum, share, g.at[k]);
            weight += share;
        }
    }
    ck_assert_double_le(vec_length(sum), 1e-9 * weight);
    sphere_grid_free(&g);
}
END_TEST

/* The two rings about the equator stand on it, the others where they were. */
START_TEST(level)
{
    struct sphere_grid g = sphere_grid_new(vec_unit(vec(0.2, -0.5, 0.8)));
    sphere_grid_level(&g);
    for (int ring = 0; ring < SPHERE_GRID_RINGS; ring++) {
        double lean = (ring + 0.5) * PI / SPHERE_GRID_RINGS;
        bool beside = fabs(lean - PI / 2) < SPHERE_GRID_STEP;
        for (int k = g.start[ring]; k < g.start[ring + 1]; k++) {
            ck_assert_double_eq_tol(vec_length(g.at[k]), 1, 1e-12);
            ck_assert_double_eq_tol(vec_angle(g.at[k], g.pole), beside ? PI / 2 : lean, 1e-9);
        }
    }
    for (int k = 0; k < 100; k++) { /* of each direction there, all four corners are there */
        struct vec3 a = vec_along(vec_scale(cos(k), g.x), sin(k), g.y);
        int corner[4];
        sphere_grid_corners(&g, a, corner);
        for (int i = 0; i < 4; i++)
            ck_assert_double_le(vec_distance(g.at[corner[i]], a), SPHERE_GRID_STEP + 1e-9);
        ck_assert_double_eq_tol(vec_dot(g.at[corner[0]], g.pole), 0, 1e-12);
        ck_assert_double_eq_tol(vec_dot(g.at[corner[3]], g.pole), 0, 1e-12);
    }
    sphere_grid_free(&g);
}
END_TEST

/* A cell is a step high and, where there are more than the least in a ring, a step wide: its
 * corners are no farther than its diagonal. */
/* Evenly: every direction is near to one of them, and no two are near to each other. */
START_TEST(spiral)
{
    enum { N = 400 };
    const double apart = sqrt(4 * PI / N); /* the side of the square that one has to itself */
    struct vec3 at[N];
    for (int k = 0; k < N; k++) {
        at[k] = sphere_spiral(k, 1 - (2 * k + 1.0) / N);
        ck_assert_double_eq_tol(vec_length(at[k]), 1, 1e-12);
        ck_assert_double_eq_tol(at[k].z, 1 - (2 * k + 1.0) / N, 1e-15);
        for (int j = 0; j < k; j++)
            ck_assert_double_gt(vec_distance(at[j], at[k]), 0.8 * apart);
    }
    for (int i = 0; i < 200; i++) {
        double z = 2 * noisy_uniform() - 1, turn = 2 * PI * noisy_uniform(), least = HUGE_VAL;
        struct vec3 d = vec(sqrt(1 - z * z) * cos(turn), sqrt(1 - z * z) * sin(turn), z);
        for (int k = 0; k < N; k++)
            least = fmin(least, vec_distance(d, at[k]));
        ck_assert_double_lt(least, apart);
    }
}
END_TEST

START_TEST(corners)
{
    struct sphere_grid g = sphere_grid_new(vec(0, 0, 1));
    noisy_seed(3);
    for (int i = 0; i < 2000; i++) {
        double z = 2 * noisy_uniform() - 1, t = 2 * PI * noisy_uniform(), s = sqrt(1 - z * z);
        struct vec3 a = vec(s * cos(t), s * sin(t), z);
        double lean = vec_angle(a, g.pole), low = PI, high = 0;
        int corner[4];
        sphere_grid_corners(&g, a, corner);
        for (int k = 0; k < 4; k++) {
            double at = vec_angle(g.at[corner[k]], g.pole);
            low = fmin(low, at);
            high = fmax(high, at);
            ck_assert_double_le(vec_angle(a, g.at[corner[k]]), 1.05 * sqrt(2) * SPHERE_GRID_STEP);
        }
        if (lean > SPHERE_GRID_STEP && lean < PI - SPHERE_GRID_STEP) {
            ck_assert_double_le(low, lean + 1e-9);
            ck_assert_double_ge(high, lean - 1e-9);
        }
    }
    /* on a direction of the grid that is one of its corners */
    for (int k = 0; k < g.n; k++) {
        int corner[4];
        double nearest = PI;
        sphere_grid_corners(&g, g.at[k], corner);
        for (int c = 0; c < 4; c++)
            nearest = fmin(nearest, vec_angle(g.at[corner[c]], g.at[k]));
        ck_assert_double_le(nearest, 1e-7);
    }
    sphere_grid_free(&g);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sphere_grid");
    TCase *tests = tcase_create("sphere_grid");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, all_round);
    tcase_add_test(tests, level);
    tcase_add_test(tests, spiral);
    tcase_add_test(tests, corners);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
