/*
 * polyline, against the nearest distance by brute force over dense samples, on chains near to each
 * other where both must agree; and on chains that come back to themselves, where only the branch
 * counts.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "curve/polyline.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static double nearest(struct polyline b, struct vec3 q)
{
    double best = INFINITY;

    for (size_t j = 0; j + 1 < b.n; j++) {
        struct vec3 d = vec_sub(b.point[j + 1], b.point[j]);
        double l2 = vec_dot(d, d), t = l2 > 0 ? vec_dot(vec_sub(q, b.point[j]), d) / l2 : 0;
        struct vec3 foot = vec_along(b.point[j], fmin(1, fmax(0, t)), d);
        best = fmin(best, vec_distance(q, foot));
    }
    return best;
}

static double brute_force(struct polyline a, struct polyline b)
{
    enum { SAMPLES = 200 };
    double worst = 0;

    for (size_t i = 0; i + 1 < a.n; i++)
        for (int k = 0; k <= SAMPLES; k++)
            worst =
                fmax(worst, nearest(b, vec_mix(a.point[i], a.point[i + 1], (double)k / SAMPLES)));
    return worst;
}

/* Along an arch, at places of its own, off by up to `noise`. */
static struct polyline random_chain(struct vec3 *point, size_t n, double noise)
{
    for (size_t i = 0; i < n; i++) {
        double s = ((double)i + (i > 0 && i + 1 < n ? 0.8 * chance() - 0.4 : 0)) / (double)(n - 1);
        double x = noise * chance(), y = noise * chance();
        point[i] = vec(20 * s + x, 10 * sin(3 * s) + y, 5 * s * s + noise * chance());
    }
    return (struct polyline){n, point};
}

START_TEST(as_by_brute_force)
{
    struct vec3 p[60], q[60];

    seed = 11;
    for (int turn = 0; turn < 100; turn++) {
        struct polyline a = random_chain(p, 8 + (size_t)(50 * chance()), 0.2);
        struct polyline b = random_chain(q, 8 + (size_t)(50 * chance()), 0.2);
        double truth = brute_force(a, b);
        double got = polyline_distance(a, b, INFINITY, 1e-4, NULL);

        ck_assert_double_ge(got, truth - 1e-12);
        ck_assert_double_le(got, truth + 0.01); /* the samples are up to 0.1 mm apart */
    }
}
END_TEST

/* The largest distance is inside a piece of a, over a vertex of b: 1 at (1, 0). */
START_TEST(between_vertices)
{
    const struct vec3 p[] = {{0, 0, 0}, {2, 0, 0}}, q[] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
    struct polyline a = {2, p}, b = {3, q};

    ck_assert_double_eq_tol(polyline_distance(a, b, INFINITY, 1e-7, NULL), sqrt(0.5), 2e-7);
    ck_assert_double_eq_tol(polyline_distance(b, a, INFINITY, 1e-7, NULL), 1, 1e-12);
}
END_TEST

START_TEST(stops_at_the_limit)
{
    const struct vec3 p[] = {{0, 0, 0}, {1, 1, 0}, {2, 50, 0}, {3, 0, 0}};
    const struct vec3 q[] = {{0, 0, 0}, {3, 0, 0}};
    double got =
        polyline_distance((struct polyline){4, p}, (struct polyline){2, q}, 0.5, 1e-6, NULL);

    ck_assert_double_gt(got, 0.5);
    ck_assert_double_le(got, 1);
}
END_TEST

/* A spiral of 60 turns, 0.05 mm apart: place x, 0 to 1. */
static struct vec3 spiral(double x)
{
    double angle = 120 * PI * x, r = 2 + 0.05 * 60 * x;

    return vec(r * cos(angle), r * sin(angle), 0);
}

static double other_place(double x)
{
    return x + 0.2 * x * (x - 1);
}

/* 6,000 points of it against 6,000 others: the walk is not lost to the neighbouring turn. */
START_TEST(a_spiral_is_followed)
{
    enum { N = 6000 };
    struct vec3 *p = malloc(2 * N * sizeof *p), *q = p + N;
    struct foot *foot = malloc(N * sizeof *foot);

    for (int i = 0; i < N; i++) {
        p[i] = spiral((double)i / (N - 1));
        q[i] = spiral(other_place((double)i / (N - 1)));
    }
    struct polyline a = {N, p}, b = {N, q};
    double got = polyline_distance(a, b, INFINITY, 1e-5, foot);
    ck_assert_double_lt(got, 0.01); /* sagitta of a chord of b: 5 mm, 1.2 x 0.063 rad: 0.0036 */
    for (int i = 0; i < N; i++) {
        double place = other_place(((double)foot[i].segment + foot[i].t) / (N - 1));
        ck_assert_double_eq_tol(place * (N - 1), i, 0.1);
    }
    free(foot);
    free(p);
}
END_TEST

START_TEST(repeated_and_single_points)
{
    const struct vec3 p[] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const struct vec3 q[] = {{0, 0, 0}, {2, 0, 0}};

    ck_assert(polyline_distance((struct polyline){6, p}, (struct polyline){2, q}, 1, 1e-6, NULL) ==
              0);
    ck_assert(polyline_distance((struct polyline){2, q}, (struct polyline){6, p}, 1, 1e-6, NULL) ==
              0);
    ck_assert(polyline_distance((struct polyline){2, q}, (struct polyline){1, q}, 9, 1e-6, NULL) ==
              2);
    ck_assert(polyline_distance((struct polyline){1, q}, (struct polyline){2, q}, 9, 1e-6, NULL) ==
              0);
}
END_TEST

/* A walk in one spot, and the same with each of its points many times. */
static struct vec3 *in_one_spot(size_t n, size_t times)
{
    struct vec3 *point = malloc(n * times * sizeof *point);

    seed = 17;
    for (size_t i = 0; i < n * times; i++)
        point[i] = i % times ? point[i - 1] : vec(chance(), chance(), chance());
    return point;
}

/* Where all pieces are near boxes are made, and they find what the walk along the pieces does: of
 * several as near, in the walk's order. */
START_TEST(boxes_find_what_a_walk_finds)
{
    enum { N = 400, TIMES = 3 };
    const double everywhere = 1e6;
    struct vec3 *point = in_one_spot(N, TIMES);
    struct polyline b = {N * TIMES, point};
    struct polyline_feet feet = polyline_feet_on(b);

    for (int i = 0; i < 200; i++) {
        struct foot from = {(size_t)(chance() * (double)(b.n - 1)), chance(), 0};
        struct vec3 q =
            i % 2 ? vec(chance(), chance(), chance()) : point[(size_t)(chance() * (double)b.n)];
        struct polyline_feet alone = polyline_feet_on(b);
        struct foot walked = polyline_foot(&alone, from, everywhere, q);
        struct foot found = polyline_foot(&feet, from, everywhere, q);
        ck_assert_double_eq(found.distance, walked.distance);
        ck_assert_uint_eq(found.segment, walked.segment);
        ck_assert_double_eq(found.t, walked.t);
        ck_assert_double_eq_tol(found.distance, nearest(b, q), 1e-12);
        polyline_feet_free(&alone);
    }
    ck_assert_ptr_nonnull(feet.boxes);
    polyline_feet_free(&feet);
    free(point);
}
END_TEST

/* No further than the foot can have moved, onwards and back. */
START_TEST(boxes_keep_to_the_reach)
{
    enum { N = 4000 };
    struct vec3 *point = malloc(N * sizeof *point);
    struct polyline b = {N, point};
    struct polyline_feet feet = polyline_feet_on(b);

    for (size_t i = 0; i < N; i++) /* there and back, 0.1 mm aside */
        point[i] = vec((double)(i < N / 2 ? i : N - i) / 1000, i < N / 2 ? 0 : 0.1, 0);
    for (int i = 0; i < 100; i++) {
        struct vec3 q = vec(0.6, 0.09, 0);
        struct foot near = polyline_foot(&feet, (struct foot){590, 0, 0.01}, 0.01, q);
        struct foot back = polyline_foot(&feet, (struct foot){3390, 0, 0.01}, 0.01, q);
        struct foot far = polyline_foot(&feet, (struct foot){590, 0, 0.01}, 10, q);
        ck_assert_double_eq_tol(near.distance, 0.09, 1e-9);
        ck_assert_double_eq_tol(back.distance, 0.01, 1e-9);
        ck_assert_double_eq_tol(far.distance, 0.01, 1e-9);
    }
    ck_assert_ptr_nonnull(feet.boxes);
    polyline_feet_free(&feet);
    free(point);
}
END_TEST

/* 300,000 vertices in one place: a walk along them for each of 30,000 points would take minutes. */
START_TEST(a_stay_is_gone_past_at_once)
{
    enum { N = 300000, FIRST = 10 };
    struct vec3 *point = malloc(N * sizeof *point);
    struct polyline b = {N, point};
    struct stays stays = {0};

    for (size_t i = 0; i < N; i++)
        point[i] = i < FIRST       ? vec((double)i, 0, 0)
                   : i < N - FIRST ? vec(FIRST, 0, 0)
                                   : vec(FIRST, -(double)i, 0);
    polyline_find_stays(b, &stays);
    ck_assert_uint_eq(stays.n, 1);
    ck_assert_uint_eq(stays.item[0].first, FIRST);
    ck_assert_uint_eq(stays.item[0].last, N - FIRST - 1);
    ck_assert_uint_eq(polyline_stay_end(&stays, FIRST + 5), N - FIRST - 1);
    ck_assert_uint_eq(polyline_stay_end(&stays, 3), 3);
    for (size_t i = 0; i < 30000; i++) {
        size_t segment = FIRST + 5 * i;
        double off = polyline_descend(b, &stays, vec(FIRST - 2.5, 0.5, 0), &segment);
        ck_assert_double_eq_tol(off, 0.5, 1e-12);
        ck_assert_uint_eq(segment, FIRST - 3);
    }
    array_free(&stays);
    free(point);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("polyline");
    TCase *tests = tcase_create("polyline");

    tcase_add_test(tests, as_by_brute_force);
    tcase_add_test(tests, between_vertices);
    tcase_add_test(tests, stops_at_the_limit);
    tcase_add_test(tests, a_spiral_is_followed);
    tcase_add_test(tests, repeated_and_single_points);
    tcase_add_test(tests, boxes_find_what_a_walk_finds);
    tcase_add_test(tests, boxes_keep_to_the_reach);
    tcase_add_test(tests, a_stay_is_gone_past_at_once);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
