/* plan_star: facets about points of a scan are Delaunay's, each told of once; the one that a place
 * is over is found. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/plan_star.h"
#include "math/predicates.h"
#include "noisy.h"

enum { POINTS = 900 };
#define SPACING 0.5
#define HALF 7.5

static struct vec3 point[POINTS];

/* Points anywhere, every other one of which is high up. */
static struct point_grid scan_of(unsigned seed)
{
    struct point_grid grid;
    struct error error;

    noisy_seed(seed);
    for (int i = 0; i < POINTS; i++)
        point[i] =
            vec(HALF * (2 * noisy_uniform() - 1), HALF * (2 * noisy_uniform() - 1), i % 2 ? 9 : 0);
    ck_assert_int_eq(point_grid_make(point, POINTS, SPACING, 1, &grid, &error), 0);
    return grid;
}

static struct uv plan(struct vec3 p)
{
    return (struct uv){p.x, p.y};
}

/* Counter-clockwise, with no point in its circle. */
static void assert_delaunay(const struct point_grid *grid, const size_t corner[3])
{
    struct uv a = plan(grid->point[corner[0]]), b = plan(grid->point[corner[1]]),
              c = plan(grid->point[corner[2]]);

    ck_assert(orient2d(a, b, c) > 0);
    for (size_t k = 0; k < grid->n; k++)
        ck_assert(!(incircle(a, b, c, plan(grid->point[k])) > 0));
}

struct told {
    const struct point_grid *grid;
    double area;
    int facets;
};

static void tell(void *context, const struct plan_about *about, const size_t corner[3],
                 struct plan_about *other)
{
    struct told *told = context;
    struct vec3 a = told->grid->point[corner[0]], b = told->grid->point[corner[1]],
                c = told->grid->point[corner[2]];

    (void)about, (void)other;
    assert_delaunay(told->grid, corner);
    told->area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    told->facets++;
}

/* They cover nearly all of the square, and no part of it twice. */
START_TEST(each_facet_once)
{
    struct point_grid grid = scan_of(3);
    const struct plan_star_options options = {4 * SPACING, SPACING, 2 * SPACING, 1};
    struct told told = {&grid, 0, 0};

    plan_star_facets(&grid, &options, tell, &told);
    ck_assert_int_lt(told.facets, 2 * POINTS);
    ck_assert_double_lt(told.area, 4 * HALF * HALF);
    ck_assert_double_gt(told.area, 0.9 * 4 * HALF * HALF);
    point_grid_free(&grid);
}
END_TEST

START_TEST(facet_under_a_place)
{
    struct point_grid grid = scan_of(4);
    int found = 0;

    for (int i = 0; i < 500; i++) {
        struct vec3 p =
            vec((HALF - 1) * (2 * noisy_uniform() - 1), (HALF - 1) * (2 * noisy_uniform() - 1), 5);
        size_t corner[3];
        if (!plan_star_over(&grid, p, 4 * SPACING, corner))
            continue;
        found++;
        assert_delaunay(&grid, corner);
        for (int k = 0; k < 3; k++)
            ck_assert(!(orient2d(plan(grid.point[corner[k]]), plan(grid.point[corner[(k + 1) % 3]]),
                                 plan(p)) < 0));
    }
    ck_assert_int_gt(found, 480);
    size_t corner[3];
    ck_assert(!plan_star_over(&grid, vec(3 * HALF, 0, 0), 4 * SPACING, corner));
    point_grid_free(&grid);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("plan_star");
    TCase *tcase = tcase_create("facets");
    tcase_add_test(tcase, each_facet_once);
    tcase_add_test(tcase, facet_under_a_place);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
