/* holes: facets beside, over and across holes of known width. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/holes.h"
#include "seed.h"

static uint64_t state = 11;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* Points every 0.25 mm over 40 x 40 mm, without a round hole in the middle. */
static struct vec3s plate(double hole)
{
    struct vec3s p = {0};
    for (double x = 0; x <= 40; x += 0.25)
        for (double y = 0; y <= 40; y += 0.25)
            if (hypot(x - 20, y - 20) > hole / 2)
                *array_push(&p) = vec(x, y, 0);
    return p;
}

static bool bridged(double hole, double gap, struct vec3 a, struct vec3 b, struct vec3 c)
{
    struct vec3s p = plate(hole);
    struct holes h;
    struct error error;
    ck_assert_int_eq(holes_find(p.item, p.n, gap, gap / 2, &h, &error), 0);
    bool is = holes_bridged(&h, a, b, c);
    ck_assert_int_eq(holes_bridged(&h, b, c, a), is);
    holes_free(&h);
    array_free(&p);
    return is;
}

START_TEST(over_a_hole)
{
    struct vec3 a = {14, 15, 0}, b = {26, 15, 0}, c = {20, 28, 0};
    ck_assert(bridged(6, 3, a, b, c));
    ck_assert(bridged(4, 3, a, b, c));
    ck_assert(!bridged(2.2, 3, a, b, c));
    ck_assert(!bridged(0, 3, a, b, c));
}
END_TEST

START_TEST(thin_facet_across_a_hole)
{
    struct vec3 a = {16, 20, 0}, b = {24, 20, 0}, c = {20, 19.99, 0};
    ck_assert(bridged(7, 3, a, b, c));
    ck_assert(!bridged(2.2, 3, a, b, c));
}
END_TEST

START_TEST(beside_a_hole)
{
    struct vec3 a = {4, 4, 0}, b = {14, 5, 0}, c = {8, 14, 0};
    ck_assert(!bridged(10, 2, a, b, c));
}
END_TEST

/* Over a round hole's rim, facets that reach this far into it. */
static bool reaches(double hole, double gap, double rim, double depth)
{
    struct vec3s p = plate(hole);
    struct holes h;
    struct error error;
    double y = 20 - hole / 2;
    ck_assert_int_eq(holes_find(p.item, p.n, gap, rim, &h, &error), 0);
    bool is = holes_bridged(&h, vec(18, y - 2, 0), vec(22, y - 2, 0), vec(20, y + depth, 0));
    holes_free(&h);
    array_free(&p);
    return is;
}

START_TEST(rims)
{
    for (int wide = 0; wide < 2; wide++) {
        double hole = wide ? 12 : 4.5;
        ck_assert(!reaches(hole, 3, 0.6, 0.2)); /* points are 0.25 mm apart */
        ck_assert(!reaches(hole, 3, 1.5, 0.9));
        ck_assert(reaches(hole, 3, 0.6, 1.3));
        ck_assert(reaches(hole, 3, 1.5, 2.2));
    }
    ck_assert(!reaches(2, 3, 0.4, 1)); /* no hole by its width */
}
END_TEST

static struct vec3 any_near(const struct vec3 *point, int n, struct vec3 a)
{
    for (;;) {
        struct vec3 p = point[(int)(uniform() * n)];
        if (vec_distance(p, a) < 9)
            return p;
    }
}

/* The rule against the largest empty disc found point by point, outside the doubtful sixth. */
START_TEST(same_as_point_by_point)
{
    enum { N = 150, FACETS = 400 };
    struct vec3 point[N];
    struct holes h;
    struct error error;
    const double gap = 5;
    int some = 0, none = 0;
    for (int i = 0; i < N; i++)
        point[i] = vec(30 * uniform(), 30 * uniform(), 0);
    ck_assert_int_eq(holes_find(point, N, gap, gap / 2, &h, &error), 0);
    for (int f = 0; f < FACETS; f++) {
        struct vec3 a = point[(int)(uniform() * N)], b = any_near(point, N, a);
        struct vec3 c = any_near(point, N, a);
        double widest = 0;
        for (int i = 0; i <= 40; i++)
            for (int j = 0; i + j <= 40; j++) {
                double x = a.x + (i * (b.x - a.x) + j * (c.x - a.x)) / 40;
                double y = a.y + (i * (b.y - a.y) + j * (c.y - a.y)) / 40;
                double near = INFINITY;
                for (int k = 0; k < N; k++)
                    near = fmin(near, hypot(point[k].x - x, point[k].y - y));
                widest = fmax(widest, 2 * near);
            }
        bool is = holes_bridged(&h, a, b, c);
        if (widest < gap * 2 / 3) {
            none++;
            ck_assert(!is);
        }
        some += is;
        if (widest > gap * 4 / 3)
            ck_assert(is);
    }
    ck_assert_int_gt(none, 10);
    ck_assert_int_gt(some, 10);
    holes_free(&h);
}
END_TEST

START_TEST(gap_far_too_small)
{
    struct vec3 p[3] = {{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}};
    struct holes h;
    struct error error;
    ck_assert_int_eq(holes_find(p, 3, 1e-3, 5e-4, &h, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "gap of 0.001 mm is too small"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("holes");
    TCase *tests = tcase_create("holes");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, over_a_hole);
    tcase_add_test(tests, thin_facet_across_a_hole);
    tcase_add_test(tests, beside_a_hole);
    tcase_add_test(tests, rims);
    tcase_add_test(tests, same_as_point_by_point);
    tcase_add_test(tests, gap_far_too_small);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
