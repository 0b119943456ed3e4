/* delaunay_order: every point once, rounds eight times as large each, near to the last one within a
 * round, the same whatever the points are multiplied by. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "chains.h"
#include "meshing/delaunay_order.h"

enum { N = 40000 };

static struct uv at[N];

static void scatter(double x, double y, double wide, double high)
{
    seed = 77;
    for (int i = 0; i < N; i++)
        at[i] = (struct uv){x + wide * chance(), y + high * chance()};
}

static double step(int a, int b)
{
    return hypot(at[a].u - at[b].u, at[a].v - at[b].v);
}

START_TEST(each_once_and_near_the_last)
{
    static char seen[N];
    scatter(-3, 100, 1, 1);
    int *order = delaunay_order(at, N), n = 0;
    double sum = 0;
    memset(seen, 0, sizeof seen);
    for (int i = 0; i < N; i++) {
        ck_assert_int_ge(order[i], 0);
        ck_assert_int_lt(order[i], N);
        ck_assert_int_eq(seen[order[i]]++, 0);
    }
    /* the last round has seven eighths of all; the curve goes through cells side by side: of points
     * by chance the mean step is that from one to the next of as many cells, sqrt(1 / n) or so */
    for (int i = N / 8 + 400; i + 1 < N; i++, n++)
        sum += step(order[i], order[i + 1]);
    ck_assert_double_lt(sum / n, 1.2 / sqrt(7. / 8 * N));
    /* the rounds before it are spread over all: on each side of a line through the middle as many,
     * within five deviations */
    int some = N / 64, low = 0;
    for (int i = 0; i < some; i++)
        low += at[order[i]].u < -2.5;
    ck_assert_double_le(fabs(low - some / 2.), 5 * sqrt(some) / 2);
    free(order);
}
END_TEST

START_TEST(of_any_size)
{
    scatter(0, 0, 1, 0.25);
    int *order = delaunay_order(at, N);
    for (int i = 0; i < N; i++)
        at[i] = (struct uv){1024 * at[i].u, 1024 * at[i].v};
    int *same = delaunay_order(at, N);
    ck_assert_mem_eq(order, same, N * sizeof *order);
    free(order);
    free(same);
}
END_TEST

/* All in one place, on a line, one, none. */
START_TEST(degenerate)
{
    for (int k = 0; k < 2; k++) {
        long sum = 0;
        for (int i = 0; i < 1000; i++)
            at[i] = (struct uv){5, k * i};
        int *order = delaunay_order(at, 1000);
        for (int i = 0; i < 1000; i++)
            sum += order[i];
        ck_assert_int_eq(sum, 999 * 1000 / 2);
        free(order);
    }
    int *one = delaunay_order(at, 1);
    ck_assert_int_eq(*one, 0);
    free(one);
    free(delaunay_order(at, 0));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("delaunay_order");
    TCase *tests = tcase_create("delaunay_order");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, each_once_and_near_the_last);
    tcase_add_test(tests, of_any_size);
    tcase_add_test(tests, degenerate);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
