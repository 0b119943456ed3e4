/*
 * trim_crossings: loops that cross themselves as often as they were drawn to, on a plane whose
 * parameters are its mm; what counts is known from areas and widths, and for polygons by chance
 * from each pair of sides.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/trim_crossings.h"
#include "nurbs/trim_loops.h"
#include "seed.h"

static struct patch flat; /* 0..1 in both parameters is 100 x 100 mm */
static struct uvs loop;

static void setup(void)
{
    flat = known_flat(vec(0, 0, 0), vec(100, 0, 0), vec(0, 100, 0), vec(100, 100, 0));
}

static void teardown(void)
{
    array_free(&loop);
    patch_free(&flat);
}

/* A loop through these corners, in mm. */
static void draw(size_t n, const double (*corner)[2])
{
    array_free(&loop);
    for (size_t i = 0; i < n; i++)
        *array_push(&loop) = (struct uv){corner[i][0] / 100, corner[i][1] / 100};
}

#define DRAW(...)                                       \
    do {                                                \
        static const double drawn[][2] = {__VA_ARGS__}; \
        draw(sizeof drawn / sizeof *drawn, drawn);      \
    } while (0)

static size_t crossings(double tolerance)
{
    return trim_crossings(&loop, &flat.surface, tolerance);
}

START_TEST(simple_loops)
{
    ck_assert_uint_eq(crossings(0.01), 0);
    DRAW({10, 10}, {90, 10}, {90, 90}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 0);
    /* a U whose legs run close beside each other, and one that comes back to touch its corner */
    DRAW({10, 10}, {90, 10}, {90, 90}, {51, 90}, {51, 20}, {49, 20}, {49, 90}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 0);
    DRAW({10, 10}, {50, 50}, {90, 10}, {90, 90}, {50, 50}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 0);
    /* along a seam beyond the place where it leaves it, and back, from either side */
    DRAW({30, 90}, {0, 80}, {0, 50}, {0, 20}, {0, 50}, {30, 40}, {60, 60});
    ck_assert_uint_eq(crossings(0.01), 0);
    DRAW({60, 60}, {30, 40}, {0, 50}, {0, 20}, {0, 50}, {0, 80}, {30, 90});
    ck_assert_uint_eq(crossings(0.01), 0);
}
END_TEST

/* Once as an eight, by sides and by a shared corner; as often as a ribbon is twisted. */
START_TEST(twisted_loops)
{
    DRAW({10, 10}, {90, 10}, {10, 90}, {90, 90});
    ck_assert_uint_eq(crossings(0.01), 1);
    DRAW({10, 10}, {50, 50}, {90, 90}, {90, 10}, {50, 50}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 1);
    for (int twists = 1; twists <= 6; twists++) {
        array_free(&loop);
        for (int i = 0; i <= twists; i++)
            *array_push(&loop) = (struct uv){0.05 + 0.1 * i, i % 2 ? 0.6 : 0.4};
        for (int i = twists; i >= 0; i--)
            *array_push(&loop) = (struct uv){0.05 + 0.1 * i, i % 2 ? 0.4 : 0.6};
        ck_assert_uint_eq(crossings(0.01), (size_t)twists);
    }
}
END_TEST

/* What is cut off counts from the tolerance on in its width, and from a thousandth of the rest. */
START_TEST(what_counts)
{
    /* a spike of 46.7 x 0.2 / 2 mm2 beyond the crossing: four times that by its length round is
     * 0.2, its base */
    DRAW({10, 10}, {90, 10}, {90, 10.2}, {20, 9.9}, {20, 1}, {10, 1});
    size_t wide = crossings(0.19), narrow = crossings(0.21);
    ck_assert_uint_eq(wide, 1);
    ck_assert_uint_eq(narrow, 0);
    /* a square of 80 x 80 with a curl at its corner of 3 x 3 / 2 (7e-4), and of 5 x 5 / 2 (2e-3) */
    DRAW({10, 10}, {93, 10}, {90, 7}, {90, 90}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 0);
    DRAW({10, 10}, {95, 10}, {90, 5}, {90, 90}, {10, 90});
    ck_assert_uint_eq(crossings(0.01), 1);
    ck_assert_uint_eq(crossings(5), 0);
}
END_TEST

/* By chance: each pair of sides that do not follow each other and have their ends on both sides of
 * one another crosses, where no part is so small. */
static double side_of(struct uv a, struct uv b, struct uv c)
{
    return a.u * (b.v - c.v) + b.u * (c.v - a.v) + c.u * (a.v - b.v);
}

static double chance(uint64_t *state)
{
    *state = *state * 6364136223846793005u + seed_step();
    return (double)(*state >> 11) * 0x1p-53;
}

START_TEST(polygons_by_chance)
{
    size_t seen = 0;
    uint64_t state = 7;
    for (int trial = 0; trial < 300; trial++) {
        size_t n = 5 + (size_t)trial % 5, expected = 0;
        bool sure = true;
        array_free(&loop);
        for (size_t i = 0; i < n; i++)
            *array_push(&loop) = (struct uv){chance(&state), chance(&state)};
        for (size_t i = 0; i < n; i++)
            for (size_t k = i + 2; k < n; k++) {
                struct uv a = loop.item[i], b = loop.item[(i + 1) % n];
                struct uv c = loop.item[k], d = loop.item[(k + 1) % n];
                if ((k + 1) % n == i || side_of(a, b, c) * side_of(a, b, d) > 0 ||
                    side_of(c, d, a) * side_of(c, d, b) > 0)
                    continue;
                expected++;
                /* its two parts */
                double t = side_of(c, d, a) / (side_of(c, d, a) - side_of(c, d, b)), one = 0;
                struct uv at = {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
                for (size_t m = i + 1; m < k; m++)
                    one += side_of(at, loop.item[m], loop.item[m + 1]) / 2;
                double other = uv_loop_area(&loop) - one;
                sure = sure && fmin(fabs(one), fabs(other)) > 2e-3 * fmax(fabs(one), fabs(other));
            }
        if (!sure)
            continue;
        ck_assert_uint_eq(crossings(1e-9), expected);
        seen += expected;
    }
    ck_assert_uint_gt(seen, 300);
}
END_TEST

/* Only what does not count is left out, wherever the loop begins and whichever way it runs: of the
 * loop the larger part stays. */
START_TEST(curls_dropped)
{
    static const double corner[5][2] = {{10, 10}, {93, 10}, {90, 7}, {90, 90}, {10, 90}};
    for (int way = 0; way < 10; way++) {
        array_free(&loop);
        for (int i = 0; i < 5; i++) {
            const double *c = corner[way < 5 ? (i + way) % 5 : (14 - i - way) % 5];
            *array_push(&loop) = (struct uv){c[0] / 100, c[1] / 100};
        }
        ck_assert(trim_crossings_drop(&flat.surface, 0.01, &loop));
        ck_assert_uint_eq(loop.n, 4);
        ck_assert_double_eq_tol(fabs(uv_loop_area(&loop)), 0.64, 1e-12);
        for (size_t i = 0; i < 4; i++) {
            struct uv p = loop.item[i];
            ck_assert_double_eq_tol(fabs(p.u - 0.5) + fabs(p.v - 0.5), 0.8, 1e-12);
        }
        ck_assert(!trim_crossings_drop(&flat.surface, 0.01, &loop));
        ck_assert_uint_eq(loop.n, 4);
    }
    DRAW({10, 10}, {95, 10}, {90, 5}, {90, 90}, {10, 90});
    ck_assert(!trim_crossings_drop(&flat.surface, 0.01, &loop));
    ck_assert_uint_eq(loop.n, 5);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_crossings");
    TCase *tests = tcase_create("trim_crossings");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, simple_loops);
    tcase_add_test(tests, twisted_loops);
    tcase_add_test(tests, what_counts);
    tcase_add_test(tests, polygons_by_chance);
    tcase_add_test(tests, curls_dropped);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
