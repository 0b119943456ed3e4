/* near_lists: every list is what the grid itself finds, to the bit; with too few points, too many,
 * or more asked for than it keeps, they are looked for. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/near_lists.h"
#include "seed.h"

static uint64_t state = 7;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* A sheet; with `raster` many of its points are equally near. */
static struct point_grid sheet_of(size_t n, bool raster)
{
    struct vec3 *point = mem_alloc(n, sizeof *point);
    struct point_grid grid;
    struct error error;
    double side = sqrt((double)n);

    for (size_t i = 0; i < n; i++) {
        point[i] = vec(side * uniform(), side * uniform(), 0.2 * uniform());
        if (raster)
            point[i] = vec(floor(point[i].x), floor(point[i].y), 0);
    }
    ck_assert_int_eq(point_grid_make(point, n, 1, 1, &grid, &error), 0);
    return grid;
}

static void check_lists(const struct near_lists *lists, const struct point_grid *grid)
{
    static const size_t asked[] = {1, 7, 32, NEAR_LIST, NEAR_LIST + 1, 160};

    for (size_t i = 0; i < grid->n; i += 1 + grid->n / 500)
        for (size_t a = 0; a < sizeof asked / sizeof *asked; a++) {
            uint32_t index[160], told[160];
            double found[160], far[160];
            size_t n = point_grid_nearest(grid, grid->point[i], asked[a], index, found);
            ck_assert_uint_eq(near_lists_nearest(lists, grid, i, asked[a], told, far), n);
            ck_assert_mem_eq(index, told, n * sizeof *index);
            ck_assert_mem_eq(found, far, n * sizeof *found);
        }
}

START_TEST(lists_are_what_the_grid_finds)
{
    static const size_t count[] = {NEAR_LIST - 1, NEAR_LIST, 3000, NEAR_LISTS_MOST + 1};

    for (size_t c = 0; c < sizeof count / sizeof *count; c++)
        for (int raster = 0; raster < 2; raster++) {
            struct point_grid grid = sheet_of(count[c], raster);
            struct near_lists lists = near_lists_of(&grid, 1 + raster);
            ck_assert_int_eq(lists.index != NULL, c == 1 || c == 2);
            check_lists(&lists, &grid);
            near_lists_free(&lists);
            check_lists(&lists, &grid);
            check_lists(NULL, &grid);
            free(grid.point);
            point_grid_free(&grid);
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("near_lists");
    TCase *tests = tcase_create("near_lists");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, lists_are_what_the_grid_finds);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
