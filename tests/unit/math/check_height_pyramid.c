/* height_pyramid against a search through all points one by one. */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/height_pyramid.h"

enum { POINTS = 2000, WAYS = 300 };

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
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
    struct height_pyramid height_pyramid = height_pyramid_over(point, POINTS);
    for (int i = 0; i < WAYS; i++) {
        double radius = uniform(0.1, 4);
        struct vec3 a = vec(uniform(-19, 29), uniform(6, 39), uniform(-5, 5));
        struct vec3 b = vec(a.x + uniform(-9, 9), a.y + uniform(-9, 9), a.z);
        double top = height_pyramid_top(&height_pyramid, a, b, radius);
        ck_assert_double_ge(top, highest(point, a, b, radius));
        /* one cell further, no more: cells are no wider than a quarter of what is looked at */
        double wide = fmax(fabs(a.x - b.x), fabs(a.y - b.y)) + 2 * radius;
        double cell = fmax(height_pyramid.cell, wide / 4);
        ck_assert(isinf(top) || top <= highest(point, a, b, radius + 1.01 * cell));
        told += !isinf(top);
    }
    ck_assert_uint_gt(told, WAYS / 2);
    height_pyramid_free(&height_pyramid);
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

int main(void)
{
    Suite *suite = suite_create("roofs");
    TCase *test = tcase_create("roofs");
    tcase_add_test(test, nothing_near_a_way_is_higher);
    tcase_add_test(test, points_may_stand_in_a_line_or_be_one_or_none);
    suite_add_tcase(suite, test);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
