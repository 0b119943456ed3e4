/* rough_place: vegetation is one; a plane, the foot of a wall, the border of a wood, a place with
 * too few points and one where each cell has a point far off are none. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/rough_place.h"
#include "noisy.h"

enum { SIDE = 40 };

static const double SPACING = 0.5, SIGMA = 0.01;

/* Height over a place. */
static double plane(double x, double y)
{
    return 0.7 * x - 0.4 * y + SIGMA * noisy_normal();
}

static double wood(double x, double y)
{
    return plane(x, y) + 5 * noisy_uniform();
}

static double border(double x, double y)
{
    return x < 0 ? plane(x, y) : wood(x, y);
}

static double wall(double x, double y)
{
    return plane(x, y) + (x < 0 ? 0 : 6);
}

static const struct {
    double (*height)(double x, double y);
    bool rough;
} grounds[] = {{plane, false}, {wood, true}, {border, false}, {wall, false}};

START_TEST(of_four_grounds)
{
    struct vec3s cloud = {0};
    struct point_grid grid;
    struct error error;

    noisy_seed(7);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = SPACING * (i % SIDE - SIDE / 2 + noisy_uniform());
        double y = SPACING * (i / SIDE - SIDE / 2 + noisy_uniform());
        *array_push(&cloud) = vec(x, y, grounds[_i].height(x, y));
    }
    ck_assert_int_eq(point_grid_make(cloud.item, cloud.n, SPACING, 1, &grid, &error), 0);
    for (double y = -8; y <= 8; y += 1.3)
        ck_assert_int_eq(rough_place(&grid, vec(0, y, 0), 10 * SIGMA), grounds[_i].rough);
    ck_assert_int_eq(rough_place(&grid, vec(8, 8, 0), 10 * SIGMA),
                     grounds[_i].rough || grounds[_i].height == border);
    ck_assert(!rough_place(&grid, vec(8, 8, 0), 100));
    point_grid_free(&grid);
    array_free(&cloud);
}
END_TEST

/* Dense points of the plane, of which one in each cell is far off. */
START_TEST(one_point_far_off_in_each_cell)
{
    struct vec3s cloud = {0};
    struct point_grid grid;
    struct error error;

    noisy_seed(11);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = 0.2 * (i % SIDE + noisy_uniform()), y = 0.2 * (i / SIDE + noisy_uniform());
        *array_push(&cloud) = vec(x, y, plane(x, y));
    }
    ck_assert_int_eq(point_grid_make(cloud.item, cloud.n, 0.2, 1, &grid, &error), 0);
    for (size_t cell = 0; cell < grid.rows * grid.columns; cell++)
        if (grid.first[cell + 1] > grid.first[cell])
            grid.point[grid.first[cell] + cell % (grid.first[cell + 1] - grid.first[cell])].z += 2;
    for (double y = 0.5; y < 8; y += 0.7)
        for (double x = 0.1; x < 8; x += 0.9)
            ck_assert(!rough_place(&grid, vec(x, y, 0), 10 * SIGMA));
    point_grid_free(&grid);
    array_free(&cloud);
}
END_TEST

START_TEST(few_points_tell_nothing)
{
    struct vec3 point[5] = {{0, 0, 0}, {1, 0, 3}, {0, 1, 9}, {1, 1, -7}, {0.5, 0.5, 20}};
    struct point_grid grid;
    struct error error;

    ck_assert_int_eq(point_grid_make(point, 5, 1, 1, &grid, &error), 0);
    ck_assert(!rough_place(&grid, vec(0.5, 0.5, 0), 0.1));
    point_grid_free(&grid);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("rough_place");
    TCase *tests = tcase_create("rough_place");

    tcase_add_loop_test(tests, of_four_grounds, 0, sizeof grounds / sizeof *grounds);
    tcase_add_test(tests, one_point_far_off_in_each_cell);
    tcase_add_test(tests, few_points_tell_nothing);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
