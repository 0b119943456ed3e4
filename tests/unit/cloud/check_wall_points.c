/* wall_points: the points of an upright wall, found; none on a slope; order kept. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>

#include "rough.h"
#include "cloud/wall_points.h"

/* Two levels 6 mm apart and the wall between them at x = 20; spacing about 0.4 mm. */
static struct vec3s step(double noise)
{
    struct vec3s p = {0};
    rectangle(&p, 2500, vec(0, 0, 0), vec(20, 0, 0), vec(0, 20, 0), noise);
    rectangle(&p, 750, vec(20, 0, 0), vec(0, 20, 0), vec(0, 0, 6), noise);
    rectangle(&p, 2500, vec(20, 0, 6), vec(20, 0, 0), vec(0, 20, 0), noise);
    return p;
}

START_TEST(a_step)
{
    for (int round = 0; round < 2; round++) {
        double noise = round ? 0.02 : 0;
        struct vec3s p = step(noise);
        size_t flat = wall_points_part(p.item, p.n, 0.4, 1), missed = 0;
        for (size_t i = 0; i < p.n; i++) {
            bool wall = p.item[i].z > 0.1 && p.item[i].z < 5.9;
            if (i >= flat) /* of the levels none but beside it */
                ck_assert_double_le(fabs(p.item[i].x - 20), 0.6);
            else
                missed += wall;
        }
        ck_assert_uint_gt(p.n - flat, 620);
        ck_assert_uint_le(missed, 75);
        array_free(&p);
    }
}
END_TEST

START_TEST(same_for_any_threads)
{
    struct vec3s p = step(0.02), q = {0};
    for (size_t i = 0; i < p.n; i++)
        *array_push(&q) = p.item[i];
    size_t flat = wall_points_part(p.item, p.n, 0.4, 1);
    ck_assert_uint_eq(wall_points_part(q.item, q.n, 0.4, 3), flat);
    for (size_t i = 0; i < p.n; i++)
        ck_assert(vec_distance(p.item[i], q.item[i]) == 0);
    array_free(&p);
    array_free(&q);
}
END_TEST

START_TEST(none_on_a_slope)
{
    struct vec3s p = {0}; /* 68 degrees */
    rectangle(&p, 5000, vec(0, 0, 0), vec(10, 0, 25), vec(0, 20, 0), 0.02);
    struct vec3 first = p.item[0], last = p.item[p.n - 1];
    ck_assert_uint_eq(wall_points_part(p.item, p.n, 0.2, 1), p.n);
    ck_assert(vec_distance(first, p.item[0]) == 0 && vec_distance(last, p.item[p.n - 1]) == 0);
    ck_assert_uint_eq(wall_points_part(p.item, 0, 0.2, 1), 0);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("wall_points");
    TCase *tests = tcase_create("wall_points");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_step);
    tcase_add_test(tests, same_for_any_threads);
    tcase_add_test(tests, none_on_a_slope);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
