/* smooth_aside: short waves go, as far as they may; long ones stay, and what is smooth. */
#include <check.h>
#include <stdlib.h>

#include "gouge/smooth_aside.h"
#include "math/elementary.h"
#include "noisy.h"

enum { N = 400 };

static const double LENGTH = 2.5;
static struct vec3 point[N], side[N];
static double move[N];

/* A row along x on a cylinder of radius 40 that wanders sideways, along y, by waves of these; the
 * points are unevenly apart. */
static void make(double short_by, double long_by)
{
    double x = 0;

    noisy_seed(4);
    for (int i = 0; i < N; i++) {
        double y = short_by * sin(2 * PI * x / 2) + long_by * sin(2 * PI * x / 60);
        point[i] = vec(40 * sin(x / 40), y, 40 * cos(x / 40));
        side[i] = vec(0, 1, 0);
        x += 0.05 + 0.2 * noisy_uniform();
    }
}

static double most_aside(int from, int to, double long_by)
{
    double most = 0;

    for (int i = from; i < to; i++) {
        double x = 40 * atan2(point[i].x, point[i].z);
        most = fmax(most, fabs(point[i].y + move[i] - long_by * sin(2 * PI * x / 60)));
    }
    return most;
}

START_TEST(short_waves_go_and_long_ones_stay)
{
    make(0.03, 1);
    smooth_aside(point, side, LENGTH, 0.1, N, move);
    ck_assert_double_eq(move[0], 0);
    ck_assert_double_eq(move[N - 1], 0);
    ck_assert_double_lt(most_aside(40, N - 40, 1), 0.009);
}
END_TEST

START_TEST(no_move_is_larger_than_it_may_be)
{
    double most = 0;

    make(0.2, 0);
    smooth_aside(point, side, LENGTH, 0.05, N, move);
    for (int i = 0; i < N; i++)
        most = fmax(most, fabs(move[i]));
    ck_assert_double_le(most, 0.05);
    ck_assert_double_gt(most, 0.03);
}
END_TEST

START_TEST(what_has_no_side_stays)
{
    make(0.03, 0);
    for (int i = 100; i < 120; i++)
        side[i] = vec(0, 0, 0);
    smooth_aside(point, side, LENGTH, 0.1, N, move);
    for (int i = 100; i < 120; i++)
        ck_assert_double_eq(move[i], 0);
    smooth_aside(point, side, LENGTH, 0.1, 3, move); /* nothing to bend */
    ck_assert_double_eq(move[1], 0);
    smooth_aside(point, side, LENGTH, 0, N, move);
    ck_assert_double_eq(move[50], 0);
}
END_TEST

START_TEST(twice_in_one_place)
{
    make(0.03, 0);
    point[50] = point[51];
    smooth_aside(point, side, LENGTH, 0.1, N, move);
    for (int i = 0; i < N; i++)
        ck_assert(fabs(move[i]) <= 0.1);
}
END_TEST

/* From its other end a row is the same one. */
START_TEST(from_either_end)
{
    static struct vec3 back[N];
    static double other[N];

    make(0.03, 1);
    for (int i = 0; i < N; i++)
        back[i] = point[N - 1 - i];
    smooth_aside(point, side, LENGTH, 0.1, N, move);
    smooth_aside(back, side, LENGTH, 0.1, N, other);
    ck_assert_double_gt(fabs(move[1]), 1e-6);
    ck_assert_double_gt(fabs(move[N - 2]), 1e-6);
    for (int i = 0; i < N; i++)
        ck_assert_double_lt(fabs(move[i] - other[N - 1 - i]), 1e-6);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("smooth_aside");
    TCase *tests = tcase_create("smooth_aside");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, short_waves_go_and_long_ones_stay);
    tcase_add_test(tests, no_move_is_larger_than_it_may_be);
    tcase_add_test(tests, what_has_no_side_stays);
    tcase_add_test(tests, twice_in_one_place);
    tcase_add_test(tests, from_either_end);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
