/* kdtree against a search one by one, on random points, lattices (many ties) and duplicates. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/kdtree.h"
#include "seed.h"

static uint64_t state = 1;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* kind 0: in a box; 1: a thin sheet; 2: on a lattice; 3: all in one place; 4: on a line */
static struct vec3 make_point(int kind)
{
    switch (kind) {
    case 0:
        return vec(uniform(), 3 * uniform(), 10 * uniform());
    case 1:
        return vec(100 * uniform(), 70 * uniform(), 0.01 * uniform());
    case 2:
        return vec(floor(8 * uniform()), floor(8 * uniform()), floor(2 * uniform()));
    case 3:
        return vec(5, 6, 7);
    default:
        return vec(1, 1000 * uniform(), 2);
    }
}

struct hit {
    double d2;
    size_t index;
};

static int by_distance(const void *pa, const void *pb)
{
    const struct hit *a = pa, *b = pb;

    if (a->d2 != b->d2)
        return a->d2 < b->d2 ? -1 : 1;
    return a->index < b->index ? -1 : a->index > b->index;
}

static int by_index(const void *pa, const void *pb)
{
    const size_t *a = pa, *b = pb;

    return *a < *b ? -1 : *a > *b;
}

enum { MOST = 700, KINDS = 5 };

static void compare(int kind, size_t n, size_t k)
{
    struct vec3 point[MOST];
    struct hit all[MOST];
    size_t index[MOST];
    double distance2[MOST];
    struct sizes found = {0};

    for (size_t i = 0; i < n; i++)
        point[i] = make_point(kind);
    array_reserve(&found, n);
    struct kdtree *tree = kdtree_new(point, n);
    for (int query = 0; query < 20; query++) {
        struct vec3 q = query % 2 ? make_point(kind) : make_point(0);
        for (size_t i = 0; i < n; i++) {
            struct vec3 d = vec_sub(point[i], q);
            all[i] = (struct hit){vec_dot(d, d), i};
        }
        qsort(all, n, sizeof *all, by_distance); // cppcheck-suppress uninitvar
        size_t got = kdtree_nearest(tree, q, k, index, distance2);
        ck_assert_uint_eq(got, k < n ? k : n);
        for (size_t i = 0; i < got; i++) {
            ck_assert_uint_eq(index[i], all[i].index);
            ck_assert(distance2[i] == all[i].d2);
        }
        ck_assert_uint_eq(kdtree_nearest(tree, q, k, index, NULL), got);
        for (size_t i = 0; i < got; i++)
            ck_assert_uint_eq(index[i], all[i].index);

        double radius = kind == 2 ? 2 : sqrt(all[(n - 1) / 3].d2);
        size_t want = 0;
        while (want < n && all[want].d2 <= radius * radius)
            want++;
        found.n = 0;
        kdtree_within(tree, q, radius, &found);
        ck_assert_uint_eq(found.n, want);
        qsort(found.item, found.n, sizeof *found.item, by_index);
        for (size_t i = 0; i < want; i++)
            ck_assert_ptr_nonnull(
                bsearch(&all[i].index, found.item, found.n, sizeof *found.item, by_index));
    }
    array_free(&found);
    kdtree_free(tree);
}

START_TEST(same_as_one_by_one)
{
    static const size_t sizes[] = {1, 2, 3, 12, 13, 25, 26, 100, 333, MOST};

    for (int kind = 0; kind < KINDS; kind++) {
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            compare(kind, sizes[i], 1);
            compare(kind, sizes[i], 40);
            compare(kind, sizes[i], 300);
        }
    }
}
END_TEST

/* To straight ways: the smallest of the distances to each point, found by fine steps along. */
START_TEST(segments_as_one_by_one)
{
    enum { N = 700, STEPS = 400 };
    struct vec3 point[N];

    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < N; i++)
            point[i] = make_point(kind);
        struct kdtree *tree = kdtree_new(point, N);
        struct kdtree_touch met = {.n = 0};
        for (int query = 0; query < 60; query++) {
            struct vec3 a = make_point(0), b = query % 3 ? make_point(0) : a;
            double step = vec_distance(a, b) / STEPS, nearest = HUGE_VAL;
            for (int i = 0; i < N; i++)
                for (int k = 0; k <= STEPS; k++)
                    nearest = fmin(nearest, vec_distance(point[i], vec_mix(a, b, k / 400.0)));
            size_t at = N;
            double found = kdtree_nearest_segment(tree, a, b, 1e9, &at);
            ck_assert_uint_lt(at, N);
            ck_assert_double_le(found, nearest + 1e-12);
            ck_assert_double_ge(found, nearest - step);
            size_t none = N;
            ck_assert(kdtree_nearest_segment(tree, a, b, found / 2, &none) == found / 2);
            ck_assert(none == N || found == 0);
            ck_assert(kdtree_nearest_segment(tree, a, b, found * 1.01 + 1e-9, &none) == found);
            ck_assert(kdtree_nearest_among(point, N, a, b, 1e9) == found); /* the same digits */
            double within = found * 1.01 + 1e-9;
            ck_assert(kdtree_any_beside(tree, a, b, within));
            ck_assert(kdtree_find_beside(tree, a, b, within, &met));
            ck_assert(kdtree_nearest_among(met.p, met.n, a, b, 1e9) < within);
            ck_assert(!kdtree_find_beside(tree, a, b, found * (1 - 1e-9), &met));
            ck_assert(kdtree_nearest_among(point, N, a, b, found / 2) == found / 2);
        }
        kdtree_free(tree);
    }
}
END_TEST

/* The end of the stretch of a ball's way up that points keep it from, from its start on and in all:
 * from the stretches of all points, sorted. */
static void stretches(const struct vec3 *point, size_t n, struct vec3 c, struct vec3 up,
                      double radius, double *first, double *last)
{
    bool more = true;

    *first = *last = 0;
    while (more) {
        more = false;
        for (size_t i = 0; i < n; i++) {
            struct vec3 d = vec_sub(point[i], c);
            double along = vec_dot(d, up), across = vec_length(vec_reject(d, up));
            double half = across < radius ? sqrt(radius * radius - across * across) : 0;
            if (along - half < *first - 1e-9 && along + half > *first + 1e-9) {
                *first = along + half;
                more = true;
            }
            *last = fmax(*last, half > 0 ? along + half : 0);
        }
    }
}

START_TEST(balls_leave_as_one_by_one)
{
    enum { N = 400 };
    struct vec3 point[N];
    int raised = 0;

    for (int kind = 0; kind < KINDS; kind++) {
        for (int i = 0; i < N; i++)
            point[i] = make_point(kind);
        struct kdtree *tree = kdtree_new(point, N);
        for (int query = 0; query < 200; query++) {
            struct vec3 c = make_point(query % 2 ? kind : 0), up = vec(0, 0, 1);
            double radius = 0.05 + 2 * uniform(), first, last;
            if (query % 3 == 0)
                up = vec_unit(vec(uniform() - 0.5, uniform() - 0.5, uniform()));
            stretches(point, N, c, up, radius, &first, &last);
            ck_assert_double_eq_tol(kdtree_leave(tree, c, up, radius, 1e9, NULL), first, 1e-3);
            ck_assert_double_eq_tol(kdtree_rise(tree, c, up, radius), last, 1e-2);
            if (first > 1e-2) {
                double half = kdtree_leave(tree, c, up, radius, first / 2, NULL);
                ck_assert_double_gt(half, first / 2);
            }
            /* The same whatever is tried first, and the ball touches what it left last. */
            struct kdtree_touch touch = {2, {point[query], point[2 * query]}};
            ck_assert_double_le(kdtree_leave_these(&touch, c, up, radius), first + 1e-3);
            double h = kdtree_leave(tree, c, up, radius, 1e9, &touch);
            ck_assert_double_eq_tol(h, first, 1e-3);
            ck_assert_uint_eq(touch.n, h > 0);
            if (touch.n > 0)
                ck_assert_double_eq_tol(vec_distance(touch.p[0], vec_along(c, h, up)), radius,
                                        1e-9);
            bool any = false;
            for (int i = 0; i < N; i++)
                any =
                    any || (point[i].z > c.z && hypot(point[i].x - c.x, point[i].y - c.y) < radius);
            ck_assert_int_eq(kdtree_any_above(tree, c, radius), any);
            raised += first > 0.01 && last > first + 0.01;
        }
        kdtree_free(tree);
    }
    ck_assert_int_gt(raised, 15);
}
END_TEST

START_TEST(sorted_input)
{
    enum { N = 500 };
    struct vec3 point[N];
    size_t index;

    for (int i = 0; i < N; i++)
        point[i] = vec(i, 0, 0);
    struct kdtree *tree = kdtree_new(point, N);
    for (int i = 0; i < N; i++) {
        ck_assert_uint_eq(kdtree_nearest(tree, vec(i + 0.5, 1, 1), 1, &index, NULL), 1);
        ck_assert_uint_eq(index, (size_t)i); /* i and i + 1 are as near: the smaller index */
    }
    kdtree_free(tree);
}
END_TEST

START_TEST(threads_build_the_same_tree)
{
    enum { MANY = 130000 };
    struct vec3 *point = malloc(MANY * sizeof *point);
    struct sizes one = {0}, two = {0};
    for (size_t i = 0; i < MANY; i++)
        point[i] = make_point(1);
    struct kdtree *alone = kdtree_new(point, MANY), *shared = kdtree_new_by(point, MANY, 3);
    kdtree_within(alone, vec(50, 30, 0), 20, &one);
    kdtree_within(shared, vec(50, 30, 0), 20, &two);
    ck_assert_uint_gt(one.n, 10000);
    ck_assert_uint_eq(one.n, two.n);
    for (size_t i = 0; i < one.n; i++) /* in the same order */
        ck_assert_uint_eq(one.item[i], two.item[i]);
    array_free(&one);
    array_free(&two);
    kdtree_free(alone);
    kdtree_free(shared);
    free(point);
}
END_TEST

START_TEST(nothing_to_find)
{
    struct sizes found = {0};
    size_t index;
    struct kdtree *tree = kdtree_new(NULL, 0);

    ck_assert_uint_eq(kdtree_nearest(tree, vec(0, 0, 0), 3, &index, NULL), 0);
    kdtree_within(tree, vec(0, 0, 0), 5, &found);
    ck_assert_uint_eq(found.n, 0);
    kdtree_free(tree);
    kdtree_free(NULL);
}
END_TEST

/* An order in which the middle of the first, the middle and the last is always the second smallest
 * (Musser, Introspective sorting and selection algorithms, 1997): not the square of the time. */
START_TEST(an_order_made_to_be_slow)
{
    enum { HALF = 500000 };
    struct vec3 *point = calloc(2 * HALF, sizeof *point);
    for (size_t i = 1; i <= HALF; i++) {
        point[i - 1].x = i % 2 ? (double)i : (double)(HALF + i - 1);
        point[HALF + i - 1].x = 2 * (double)i;
    }
    struct kdtree *tree = kdtree_new(point, 2 * HALF);
    ck_assert_ptr_nonnull(tree);
    kdtree_free(tree);
    free(point);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("kdtree");
    TCase *tests = tcase_create("kdtree");
    SRunner *runner = srunner_create(suite);

    tcase_add_test(tests, same_as_one_by_one);
    tcase_add_test(tests, segments_as_one_by_one);
    tcase_add_test(tests, balls_leave_as_one_by_one);
    tcase_add_test(tests, sorted_input);
    tcase_add_test(tests, an_order_made_to_be_slow);
    tcase_add_test(tests, threads_build_the_same_tree);
    tcase_add_test(tests, nothing_to_find);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
