/* smooth_normals: what flutters goes, what bends evenly stays, to the ends. */
#include <check.h>
#include <stdlib.h>

#include "gouge/smooth_normals.h"
#include "math/elementary.h"
#include "noisy.h"

enum { N = 300 };

/* A row along x on a cylinder of this radius, points unevenly apart, its normals nodding across the
 * row by so much, radians, in waves of 2 mm. */
static struct run row(double radius, double nod)
{
    struct run run = {.radius = 5};
    double x = 0;

    noisy_seed(7);
    for (int i = 0; i < N; i++) {
        double a = x / radius, b = nod * sin(PI * x);
        struct run_point p = {.contact = vec(radius * sin(a), 0, radius * cos(a))};
        p.normal = vec(sin(a) * cos(b), sin(b), cos(a) * cos(b));
        *array_push(&run) = p;
        x += 0.05 + 0.2 * noisy_uniform();
    }
    return run;
}

/* Of the points more than so many mm from both ends. */
static double most_across(const struct run *run, double from_ends)
{
    double most = 0;

    for (size_t i = 0; i < run->n; i++) {
        struct vec3 p = run->item[i].contact;
        if (fmin(vec_distance(p, run->item[0].contact), vec_distance(p, run->item[N - 1].contact)) >
            from_ends)
            most = fmax(most, fabs(run->item[i].normal.y));
    }
    return most;
}

/* Means over 2 mm to both sides are over two whole waves, where none that they are made of is over
 * less.  What is left is of the trapezoids between uneven points, h^3 / 12 times the second
 * derivative each: 0.0024 rms of 27 of them over 4 mm, here five times that. */
START_TEST(what_flutters_goes)
{
    struct run run = row(40, 0.5);

    ck_assert_double_gt(most_across(&run, 4), 0.4);
    smooth_normals(&run, 2);
    ck_assert_double_lt(most_across(&run, 4), 5 * 0.0024);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_eq_tol(vec_length(run.item[i].normal), 1, 1e-12);
    array_free(&run);
}
END_TEST

/* The mean of a circle's normals over as much to both sides is its normal in the middle; chords
 * between points a quarter of a millimetre apart are off it by 0.125 / 40 radians at most. */
START_TEST(what_bends_evenly_stays)
{
    struct run run = row(40, 0), was = row(40, 0);

    smooth_normals(&run, 2);
    for (size_t i = 0; i < run.n; i++)
        ck_assert_double_le(vec_angle(run.item[i].normal, was.item[i].normal), 0.125 / 40);
    ck_assert_double_lt(vec_angle(run.item[0].normal, was.item[0].normal), 1e-12);
    ck_assert_double_lt(vec_angle(run.item[N - 1].normal, was.item[N - 1].normal), 1e-12);
    array_free(&run);
    array_free(&was);
}
END_TEST

/* Over the edge of a box: the normals turn by a right angle over twice the length, evenly, and none
 * by so much that the ball would be behind its contact. */
START_TEST(an_edge_is_gone_round)
{
    struct run run = {.radius = 5};

    for (int i = 0; i <= 200; i++) {
        bool top = i < 100;
        struct run_point p = {.contact = top ? vec(i * 0.1 - 10, 0, 0) : vec(0, 0, 10 - i * 0.1),
                              .normal = top ? vec(0, 0, 1) : vec(1, 0, 0)};
        *array_push(&run) = p;
    }
    smooth_normals(&run, 2);
    for (size_t i = 1; i < run.n; i++) {
        struct vec3 was = i < 100 ? vec(0, 0, 1) : vec(1, 0, 0);
        ck_assert_double_ge(vec_dot(run.item[i].normal, was), 0.05);
        ck_assert_double_le(vec_angle(run.item[i - 1].normal, run.item[i].normal), 0.1);
    }
    ck_assert_double_eq_tol(run.item[55].normal.z, 1, 1e-12);
    ck_assert_double_eq_tol(run.item[145].normal.x, 1, 1e-12);
    array_free(&run);
}
END_TEST

START_TEST(few_points)
{
    struct run run = row(40, 0.5);

    run.n = 2;
    struct vec3 was = run.item[1].normal;
    smooth_normals(&run, 2);
    ck_assert_double_eq(vec_distance(run.item[1].normal, was), 0);
    run.n = N;
    array_free(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("smooth_normals");
    TCase *tests = tcase_create("smooth_normals");

    tcase_add_test(tests, what_flutters_goes);
    tcase_add_test(tests, what_bends_evenly_stays);
    tcase_add_test(tests, an_edge_is_gone_round);
    tcase_add_test(tests, few_points);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
