/* height_pyramid against a search through all points one by one. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/height_pyramid.h"
#include "seed.h"

enum { POINTS = 2000, WAYS = 300 };

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

/* The highest of the points whose x and y are within `radius` of the box around the way. */
static double highest(const struct vec3 *p, struct vec3 a, struct vec3 b, double radius)
{
    double top = -INFINITY;
    for (int i = 0; i < POINTS; i++)
        if (p[i].x >= fmin(a.x, b.x) - radius && p[i].x <= fmax(a.x, b.x) + radius &&
            p[i].y >= fmin(a.y, b.y) - radius && p[i].y <= fmax(a.y, b.y) + radius)
            top = fmax(top, p[i].z);
    return top;
}

START_TEST(nothing_near_a_way_is_higher)
{
    static struct vec3 point[POINTS];
    size_t told = 0;
    for (int i = 0; i < POINTS; i++)
        point[i] = vec(uniform(-20, 30), uniform(5, 40), uniform(-3, 3));
    struct height_pyramid pyramid = height_pyramid_over(point, POINTS);
    for (int i = 0; i < WAYS; i++) {
        double radius = uniform(0.1, 4);
        struct vec3 a = vec(uniform(-19, 29), uniform(6, 39), uniform(-5, 5));
        struct vec3 b = vec(a.x + uniform(-9, 9), a.y + uniform(-9, 9), a.z);
        double top = height_pyramid_top(&pyramid, a, b, radius);
        ck_assert_double_ge(top, highest(point, a, b, radius));
        /* one cell further, no more: cells are no wider than a quarter of what is looked at */
        double wide = fmax(fabs(a.x - b.x), fabs(a.y - b.y)) + 2 * radius;
        double cell = fmax(pyramid.dx, wide / 4);
        ck_assert(isinf(top) || top <= highest(point, a, b, radius + 1.01 * cell));
        told += !isinf(top);
    }
    ck_assert_uint_gt(told, WAYS / 2);
    height_pyramid_free(&pyramid);
}
END_TEST

START_TEST(points_may_stand_in_a_line_or_be_one_or_none)
{
    struct vec3 line[3] = {{0, 5, 1}, {0, 7, 4}, {0, 9, 2}};
    struct height_pyramid none = height_pyramid_over(NULL, 0), one = height_pyramid_over(line, 1),
                          all = height_pyramid_over(line, 3);
    ck_assert_double_eq(height_pyramid_top(&none, vec(0, 0, 0), vec(1, 0, 0), 1), -INFINITY);
    ck_assert_double_eq(height_pyramid_top(&one, vec(0, 0, 0), vec(1, 0, 0), 1), 1);
    ck_assert_double_eq(height_pyramid_top(&all, vec(0, 7, 0), vec(0, 7, 9), 1), 4);
    height_pyramid_free(&none);
    height_pyramid_free(&one);
    height_pyramid_free(&all);
}
END_TEST

struct nearest {
    const struct vec3 *point;
    const struct height_pyramid *pyramid;
    struct vec3 from;
    double distance;
    size_t looked;
};

static double bound(void *context, struct vec3 middle, struct vec3 half)
{
    const struct nearest *n = context;
    return vec_distance(n->from, middle) - vec_length(half);
}

static double visit(void *context, struct height_cell cell)
{
    struct nearest *n = context;
    for (int i = 0; i < POINTS; i++) {
        struct height_cell at = height_pyramid_cell(n->pyramid, n->point[i]);
        if (at.column == cell.column && at.row == cell.row)
            n->distance = fmin(n->distance, vec_distance(n->from, n->point[i]));
    }
    n->looked++;
    return n->distance;
}

START_TEST(the_nearest_is_found_in_few_cells)
{
    static struct vec3 point[POINTS];
    for (int i = 0; i < POINTS; i++)
        point[i] = vec(uniform(-20, 30), uniform(5, 40), uniform(-3, 3));
    struct height_pyramid pyramid = height_pyramid_over(point, POINTS);
    size_t cells = (size_t)pyramid.level[0].columns * (size_t)pyramid.level[0].rows, looked = 0;
    for (int i = 0; i < WAYS; i++) {
        struct nearest n = {point, &pyramid, vec(uniform(-25, 35), uniform(0, 45), uniform(-9, 9)),
                            HUGE_VAL, 0};
        struct height_search search = {bound, visit, &n, HUGE_VAL, -HUGE_VAL};
        height_pyramid_search(&pyramid, &search);
        double want = HUGE_VAL;
        for (int k = 0; k < POINTS; k++)
            want = fmin(want, vec_distance(n.from, point[k]));
        ck_assert_double_eq(search.nearest, want);
        looked += n.looked;
    }
    ck_assert_uint_lt(looked, WAYS * cells / 4);
    height_pyramid_free(&pyramid);
}
END_TEST

/* Cells set one by one, up and down again, as those of a stock that is cut. */
START_TEST(a_cell_may_be_set_again)
{
    struct height_pyramid p = height_pyramid_new(0, 0, 1, 2, 5, 3);
    height_pyramid_set(&p, (struct height_cell){4, 2}, (struct height_range){-1, 7});
    height_pyramid_set(&p, (struct height_cell){0, 0}, (struct height_range){2, 3});
    const struct height_range *top = p.level[p.levels - 1].cell;
    ck_assert_double_eq(top->low, -1);
    ck_assert_double_eq(top->high, 7);
    height_pyramid_set(&p, (struct height_cell){4, 2}, (struct height_range){1, 2.5});
    ck_assert_double_eq(top->low, 1);
    ck_assert_double_eq(top->high, 3);
    struct height_cell at = height_pyramid_cell(&p, vec(4.5, 9, 0));
    ck_assert_int_eq(at.column, 4);
    ck_assert_int_eq(at.row, 2);
    height_pyramid_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("height_pyramid");
    TCase *test = tcase_create("height_pyramid");
    tcase_add_test(test, nothing_near_a_way_is_higher);
    tcase_add_test(test, points_may_stand_in_a_line_or_be_one_or_none);
    tcase_add_test(test, the_nearest_is_found_in_few_cells);
    tcase_add_test(test, a_cell_may_be_set_again);
    suite_add_tcase(suite, test);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
