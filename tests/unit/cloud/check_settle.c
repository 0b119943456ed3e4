/* check_settle - points of a noisy bowl come nearer to it, without noise they stay, and so do those
 * of a step that no quadric explains. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/settle.h"
#include "math/elementary.h"
#include "seed.h"

enum { SIDE = 40 };
static const double SIGMA = 0.02, APART = 0.4;

static uint64_t state = 5;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

static double gauss(double sigma)
{
    double u = uniform() + 1e-12;
    return sigma * sqrt(-2 * log(u)) * cos(2 * PI * uniform());
}

static double bowl(double x, double y)
{
    return 0.02 * x * x - 0.01 * y * y + 0.005 * x * y;
}

static double step(double x, double y)
{
    (void)y;
    return x < 0 ? 0 : 1;
}

/* Sorts the points, which it keeps. */
static struct point_grid grid_of(double (*height)(double, double), double sigma)
{
    struct vec3s points = {0};
    struct point_grid grid;
    struct error error;
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++) {
            double x = APART * (i - SIDE / 2 + uniform() - 0.5),
                   y = APART * (k - SIDE / 2 + uniform() - 0.5);
            *array_push(&points) = vec(x, y, height(x, y) + gauss(sigma));
        }
    ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &grid, &error), 0);
    return grid;
}

START_TEST(nearer_to_a_smooth_surface)
{
    struct point_grid noisy = grid_of(bowl, SIGMA), exact = grid_of(bowl, 0);
    double before = 0, after = 0, moved = 0;
    for (size_t i = 0; i < noisy.n; i++) {
        struct vec3 p = noisy.point[i], q = settle_point(&noisy, SIGMA, p);
        before += (p.z - bowl(p.x, p.y)) * (p.z - bowl(p.x, p.y));
        after += (q.z - bowl(q.x, q.y)) * (q.z - bowl(q.x, q.y));
        p = exact.point[i];
        moved = fmax(moved, vec_distance(settle_point(&exact, SIGMA, p), p));
    }
    ck_assert_double_lt(sqrt(after), 0.6 * sqrt(before));
    ck_assert_double_lt(moved, 0.001); /* a quadric of another frame */
    free(noisy.point);
    free(exact.point);
    point_grid_free(&noisy);
    point_grid_free(&exact);
}
END_TEST

START_TEST(a_step_stays)
{
    struct point_grid grid = grid_of(step, 0);
    double moved = 0;
    for (size_t i = 0; i < grid.n; i++)
        moved = fmax(moved, vec_distance(settle_point(&grid, SIGMA, grid.point[i]), grid.point[i]));
    ck_assert_double_lt(moved, 3 * SIGMA);
    free(grid.point);
    point_grid_free(&grid);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("settle");
    TCase *tcase = tcase_create("settle");
    tcase_add_test(tcase, nearer_to_a_smooth_surface);
    tcase_add_test(tcase, a_step_stays);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
