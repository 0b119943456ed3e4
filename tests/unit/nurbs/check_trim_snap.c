/* lattice: lines are even and rise, places odd and on the side of each line that they are on. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "nurbs/trim_snap.h"

static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

START_TEST(sides)
{
    for (int turn = 0; turn < 50; turn++) {
        struct doubles line = {0};
        double from = uniform(-1e6, 1e6), width = uniform(1e-3, 1e6), x = 0;
        while (x < 1) {
            *array_push(&line) = from + x * width;
            x += uniform(0.001, 0.2);
        }
        *array_push(&line) = from + width;
        struct trim_lattice a = trim_snap_new(&line);
        ck_assert_uint_eq(a.n, line.n);
        for (size_t i = 0; i < a.n; i++) {
            ck_assert_int_eq(a.line[i] % 2, 0);
            ck_assert(i == 0 || a.line[i] > a.line[i - 1]);
        }
        for (int i = 0; i < 400; i++) {
            double place = from + uniform(0.0005, 0.9995) * width;
            size_t below = 0;
            double near = width;
            for (size_t k = 0; k < line.n; k++) {
                below += line.item[k] < place;
                near = fmin(near, fabs(line.item[k] - place));
            }
            int64_t at = trim_snap_place(&a, place, 1);
            ck_assert_int_eq(at & 1, 1);
            if (near > 1e-7 * width)
                ck_assert_uint_eq(trim_snap_below(&a, at), below);
        }
        trim_snap_free(&a);
        array_free(&line);
    }
}
END_TEST

START_TEST(on_a_line)
{
    double lines[] = {2, 3, 5};
    struct doubles line = {.n = 3, .item = lines};
    struct trim_lattice a = trim_snap_new(&line);
    for (int k = -1; k <= 1; k++) { /* on it and within rounding */
        double off = k * 1e-8;
        ck_assert_int_eq(trim_snap_place(&a, 3 + off, 1), a.line[1] + 1);
        ck_assert_int_eq(trim_snap_place(&a, 3 + off, -1), a.line[1] - 1);
        ck_assert_int_eq(trim_snap_place(&a, 2 + off, 1), a.line[0] - 1);
        ck_assert_int_eq(trim_snap_place(&a, 5 + off, -1), a.line[2] + 1);
    }
    trim_snap_free(&a);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lattice");
    TCase *tests = tcase_create("lattice");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, sides);
    tcase_add_test(tests, on_a_line);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
