/* point_grid_nearest: nearest points against going through all of them. */
#include <check.h>

#include "grid_points.h"

static double distance2(struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(a, b);
    return vec_dot(d, d);
}

/* The k-th nearest by counting: no more than k stand before it, and it belongs to them. */
static void check_nearest(struct vec3 q, size_t k)
{
    uint32_t index[N];
    double found[N];
    size_t n = point_grid_nearest(&point_grid, q, k, index, found);
    ck_assert_uint_eq(n, k < N ? k : N);
    for (size_t i = 0; i < n; i++) {
        size_t before = 0;
        ck_assert(found[i] == distance2(point[index[i]], q));
        for (uint32_t j = 0; j < N; j++) {
            double d2 = distance2(point[j], q);
            before += d2 < found[i] || (d2 <= found[i] && j < index[i]);
        }
        ck_assert_uint_eq(before, i);
    }
}

START_TEST(nearest)
{
    make_points(_i);
    for (int i = 0; i < 12; i++)
        check_nearest(point[(size_t)(uniform() * N)], 1 + (size_t)i * 5);
    check_nearest(vec(-50, 20, 3), 7); /* from outside */
    check_nearest(vec(100, 90, -30), 20);
    check_nearest(vec(30, 20, 500), 3);
    check_nearest(vec(30, 20, 0), 2 * N);
    check_nearest(vec(30, 20, 40), 300);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("point_grid_nearest");
    TCase *tests = tcase_create("point_grid_nearest");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, free_all);
    tcase_add_loop_test(tests, nearest, 0, 7);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
