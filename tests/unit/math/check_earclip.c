/* earclip: random stars, and combs with corners in one line: n - 2 triangles, none turned over, of
 * the polygon's area together. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/earclip.h"
#include "math/vec.h"
#include "seed.h"

static uint64_t seed;

static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static double area_of(struct uv a, struct uv b, struct uv c)
{
    return ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u)) / 2;
}

static void check_polygon(const struct uv *at, size_t n)
{
    struct faces face = {0};
    int corner[200];
    double whole = 0, sum = 0;
    for (size_t i = 0; i < n; i++) {
        corner[i] = 1000 + (int)i;
        whole += area_of((struct uv){0, 0}, at[i], at[(i + 1) % n]);
    }
    earclip(at, corner, n, &face);
    ck_assert_uint_eq(face.n, n - 2);
    for (size_t i = 0; i < face.n; i++) {
        const int *v = face.item[i].v;
        double a = area_of(at[v[0] - 1000], at[v[1] - 1000], at[v[2] - 1000]);
        ck_assert_double_gt(a, -1e-12);
        sum += a;
    }
    ck_assert_double_lt(fabs(sum - whole), 1e-10);
    array_free(&face);
}

START_TEST(stars)
{
    seed = 5;
    for (int turn = 0; turn < 500; turn++) {
        struct uv at[200];
        size_t n = 3 + (size_t)(150 * chance());
        for (size_t i = 0; i < n; i++) {
            double a = 2 * PI * (double)i / (double)n, r = 0.1 + chance();
            at[i].u = r * cos(a);
            at[i].v = r * sin(a);
        }
        check_polygon(at, n);
    }
}
END_TEST

START_TEST(combs)
{
    for (int teeth = 1; teeth < 20; teeth++) {
        struct uv at[200];
        size_t n = 0;
        for (int i = 0; i <= 2 * teeth; i++)
            at[n++] = (struct uv){i, 0};
        for (int i = 2 * teeth; i >= 0; i--)
            at[n++] = (struct uv){i, i % 2 ? 1 : 5};
        check_polygon(at, n);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("earclip");
    TCase *tests = tcase_create("earclip");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, stars);
    tcase_add_test(tests, combs);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
