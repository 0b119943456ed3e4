/* cloud_spool: points come back bit by bit and in order, as often as asked, whatever their digits;
 * a file that cannot be written holds none. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/cloud/cloud_spool.h"
#include "scratch.h"
#include "seed.h"

static struct vec3s points, seen;
static uint64_t state;

static void teardown(void)
{
    array_free(&points);
    array_free(&seen);
}

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* As text with so many decimals has it, about `middle`. */
static double decimal(double middle, int places)
{
    char text[64];
    snprintf(text, sizeof text, "%.*f", places, middle + 200 * (uniform() - 0.5));
    return strtod(text, NULL);
}

static void add_decimals(size_t n, double middle, int places)
{
    for (size_t i = 0; i < n; i++) {
        double x = decimal(middle, places), y = decimal(-middle, places);
        *array_push(&points) = vec(x, y, decimal(0, places));
    }
}

static void see(void *context, const struct vec3 *point, size_t n)
{
    (void)context;
    for (size_t i = 0; i < n; i++)
        *array_push(&seen) = point[i];
}

/* Adds all points in blocks of different sizes, and looks at them twice. */
static void comes_back(void)
{
    struct cloud_spool *spool = cloud_spool_new();
    ck_assert_ptr_nonnull(spool);
    for (size_t i = 0, n = 1; i < points.n; i += n, n = 1 + n * 7 % 9973)
        cloud_spool_add(spool, points.item + i, n < points.n - i ? n : points.n - i);
    cloud_spool_end(spool);
    ck_assert(cloud_spool_holds(spool));
    for (int look = 0; look < 2; look++) {
        seen.n = 0;
        ck_assert(cloud_spool_look(spool, see, NULL));
        ck_assert_uint_eq(seen.n, points.n);
        ck_assert(points.n == 0 ||
                  memcmp(seen.item, points.item, points.n * sizeof *points.item) == 0);
    }
    cloud_spool_free(spool);
    points.n = 0;
}

START_TEST(decimals)
{
    comes_back(); /* none */
    for (int places = 0; places <= 12; places++) {
        add_decimals(20000, 0, places);
        comes_back();
        add_decimals(300, 5e6, places); /* as maps have them */
        comes_back();
    }
}
END_TEST

START_TEST(no_decimals)
{
    for (int i = 0; i < 20000; i++)
        *array_push(&points) = vec(uniform() / 3, 1e6 * uniform(), (float)uniform());
    comes_back();
    for (int i = -300; i < 300; i++)
        *array_push(&points) = vec(pow(10, i), -pow(10, -i), 5e-324 * i);
    comes_back();
}
END_TEST

/* Among decimals one place more, one number too far away, one zero with a sign. */
START_TEST(odd_ones)
{
    const double odd[] = {
        0.00001, 1e12, -0.0, 1.0 / 3, 1e300, 4503599627370497.5, 2251799813685248.25};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++)
        for (int at = 0; at < 3; at++) {
            add_decimals(5000, 10, 3);
            points.item[4321].x = at == 0 ? odd[i] : points.item[4321].x;
            points.item[4321].y = at == 1 ? odd[i] : points.item[4321].y;
            points.item[4321].z = at == 2 ? odd[i] : points.item[4321].z;
            comes_back();
        }
}
END_TEST

/* There is no room from the beginning, or amid it. */
START_TEST(no_room)
{
    add_decimals(50000, 0, 3);
    for (size_t before = 0; before < points.n; before += 15000) {
        struct cloud_spool *spool = cloud_spool_new();
        cloud_spool_add(spool, points.item, before);
        scratch_no_room();
        cloud_spool_add(spool, points.item + before, points.n - before);
        cloud_spool_end(spool);
        scratch_room();
        ck_assert(!cloud_spool_holds(spool));
        ck_assert(!cloud_spool_look(spool, see, NULL));
        cloud_spool_free(spool);
    }
    ck_assert(!cloud_spool_holds(NULL));
    cloud_spool_add(NULL, points.item, points.n);
    cloud_spool_end(NULL);
    cloud_spool_free(NULL);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_spool");
    TCase *tests = tcase_create("cloud_spool");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, decimals);
    tcase_add_test(tests, no_decimals);
    tcase_add_test(tests, odd_ones);
    tcase_add_test(tests, no_room);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
