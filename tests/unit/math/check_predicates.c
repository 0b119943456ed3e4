/*
 * predicates: against the same determinants in whole numbers of 128 bits, for points on a lattice,
 * in degenerate places, and one last digit beside them.
 */
#include <check.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/predicates.h"
#include "seed.h"

typedef __int128 whole;

static uint64_t state = 88172645463325252u;

static int64_t random_below(int64_t n)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (int64_t)(state % (uint64_t)n);
}

static int sign_of(whole x)
{
    return (x > 0) - (x < 0);
}

struct lattice {
    int64_t x, y;
};

/* Places are whole numbers of a power of two, so that all differences are exact. */
static struct uv place(struct lattice p, double unit)
{
    return (struct uv){(double)p.x * unit, (double)p.y * unit};
}

static int orient_whole(struct lattice a, struct lattice b, struct lattice c)
{
    return sign_of((whole)(a.x - c.x) * (b.y - c.y) - (whole)(a.y - c.y) * (b.x - c.x));
}

static int circle_whole(const struct lattice p[3], struct lattice d)
{
    whole sum = 0;

    for (int i = 0; i < 3; i++) {
        struct lattice a = p[i], b = p[(i + 1) % 3], c = p[(i + 2) % 3];
        whole ax = a.x - d.x, ay = a.y - d.y;
        whole bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
        sum += (ax * ax + ay * ay) * (bx * cy - by * cx);
    }
    return sign_of(sum);
}

/* Thin triangles far from the origin: a, c = a + 3 (b - a) but for the last digit of a few. */
START_TEST(lines)
{
    int found[3] = {0, 0, 0};

    for (int turn = 0; turn < 200000; turn++) {
        int64_t far = (int64_t)1 << 50;
        struct lattice a = {far + random_below(1000), far + random_below(1000)};
        struct lattice b = {a.x + random_below(1 << 20), a.y + random_below(1 << 20)};
        struct lattice c = {a.x + 3 * (b.x - a.x) + random_below(3) - 1,
                            a.y + 3 * (b.y - a.y) + random_below(3) - 1};
        double unit = ldexp(1, (int)random_below(40) - 20);
        int sign = orient2d(place(a, unit), place(b, unit), place(c, unit));
        ck_assert_int_eq(sign, orient_whole(a, b, c));
        found[sign + 1]++;
    }
    ck_assert(found[0] > 1000 && found[1] > 1000 && found[2] > 1000);
}
END_TEST

/* Differences of 2^27 would overflow 128 bits in the fourth power: of 2^28 they do not. */
START_TEST(circles)
{
    int found[3] = {0, 0, 0};

    for (int turn = 0; turn < 100000; turn++) {
        int64_t x = ((int64_t)1 << 50) + random_below(1 << 20), y = random_below(1 << 20);
        int64_t r = random_below(1 << 24) + 5, s = random_below(1 << 24) + 5;
        /* the corners of a rectangle, whose circle goes through the fourth, one last digit off */
        struct lattice p[3] = {{x - r, y - s}, {x + r, y - s}, {x + r, y + s}};
        struct lattice d = {x - r + random_below(3) - 1, y + s + random_below(3) - 1};
        double unit = ldexp(1, (int)random_below(40) - 20);
        int sign =
            incircle(place(p[0], unit), place(p[1], unit), place(p[2], unit), place(d, unit));
        ck_assert_int_eq(sign, circle_whole(p, d));
        found[sign + 1]++;
    }
    ck_assert(found[0] > 1000 && found[1] > 1000 && found[2] > 1000);
}
END_TEST

/* With coordinates of very unlike size no difference is exact in a double: what is on a line or a
 * circle by symmetry is so whatever the digits. */
START_TEST(inexact_differences)
{
    for (int turn = 0; turn < 2000; turn++) {
        double x = 1.0 / (double)(random_below(1000) + 3),
               y = 1e10 / (double)(random_below(99) + 7);
        double r = 1e-7 / (double)(random_below(99) + 3);
        struct uv o = {0, 0}, p = {x, y}, q = {-x, -y}, near = {nextafter(x, 1), y};
        ck_assert_int_eq(orient2d(p, o, q), 0);
        ck_assert_int_eq(orient2d(o, near, p), 1); /* the line to `near` leans to the right */
        ck_assert_int_eq(orient2d(o, p, near), -1);
        struct uv a = {r, x}, b = {-r, x}, c = {-r, -x}, d = {r, -x}; /* by symmetry on a circle */
        ck_assert_int_eq(incircle(a, b, c, d), 0);
        ck_assert_int_eq(incircle(a, b, c, (struct uv){r, nextafter(-x, -1)}), -1);
        ck_assert_int_eq(incircle(a, b, c, (struct uv){nextafter(r, 0), -x}), 1);
    }
}
END_TEST

int main(void)
{
    state = seed_begin(state);
    Suite *suite = suite_create("predicates");
    TCase *tests = tcase_create("signs");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, lines);
    tcase_add_test(tests, circles);
    tcase_add_test(tests, inexact_differences);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
