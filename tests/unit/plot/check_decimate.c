/* decimate - nothing strays by more than the tolerance, few points stay, ends and turns stay. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "plot/decimate.h"
#include "seed.h"

/* Distance of p from the chain. */
static double off(const struct vec3s *chain, struct vec3 p)
{
    double least = INFINITY;
    for (size_t i = 0; i + 1 < chain->n; i++) {
        struct vec3 a = chain->item[i], d = vec_sub(chain->item[i + 1], a);
        double l = vec_dot(d, d), s = l > 0 ? vec_dot(vec_sub(p, a), d) / l : 0;
        least = fmin(least, vec_distance(p, vec_along(a, fmin(fmax(s, 0), 1), d)));
    }
    return least;
}

static size_t thinned(const struct vec3 *p, size_t n, double tolerance)
{
    struct vec3s out = {0};
    decimate_chain(p, n, tolerance, &out);
    ck_assert_double_eq(vec_distance(out.item[0], p[0]), 0);
    ck_assert_double_eq(vec_distance(out.item[out.n - 1], p[n - 1]), 0);
    for (size_t i = 0; i < n; i++)
        ck_assert_double_le(off(&out, p[i]), 2 * tolerance + 1e-12);
    size_t kept = out.n;
    array_free(&out);
    return kept;
}

START_TEST(a_circle_needs_few)
{
    enum { N = 20000 };
    static struct vec3 p[N];
    for (int i = 0; i < N; i++)
        p[i] = vec(100 * cos(2 * PI * i / N), 100 * sin(2 * PI * i / N), 0);
    ck_assert_uint_lt(thinned(p, N, 0.1), 110); /* of the best, by the sagitta: 70 */
}
END_TEST

START_TEST(a_straight_line_needs_two)
{
    struct vec3 p[1000];
    for (int i = 0; i < 1000; i++)
        p[i] = vec(i * 0.01, i * 0.02, 0);
    ck_assert_uint_eq(thinned(p, 1000, 0.05), 2);
}
END_TEST

START_TEST(a_way_there_and_back_keeps_its_turn)
{
    struct vec3 p[201];
    for (int i = 0; i <= 200; i++)
        p[i] = vec(i <= 100 ? i : 200 - i, 0, 0);
    ck_assert_uint_ge(thinned(p, 201, 0.1), 3);
}
END_TEST

START_TEST(random_walks_keep_the_tolerance)
{
    unsigned long long seed = 7;
    for (int run = 0; run < 50; run++) {
        struct vec3 p[400];
        struct vec3 at = vec(0, 0, 0);
        for (int i = 0; i < 400; i++) {
            seed = seed * 6364136223846793005ULL + seed_step();
            double x = (double)(seed >> 40) / (1 << 24) - 0.5;
            seed = seed * 6364136223846793005ULL + seed_step();
            double y = (double)(seed >> 40) / (1 << 24) - 0.4;
            p[i] = at = vec_add(at, vec(x, y, 0));
        }
        thinned(p, 400, 0.1 + 0.02 * run);
    }
}
END_TEST

START_TEST(short_chains)
{
    struct vec3s out = {0};
    decimate_chain(NULL, 0, 1, &out);
    ck_assert_uint_eq(out.n, 0);
    struct vec3 p[2] = {{1, 1, 0}, {1, 1, 0}};
    decimate_chain(p, 1, 1, &out);
    ck_assert_uint_eq(out.n, 1);
    decimate_chain(p, 2, 1, &out);
    ck_assert_uint_eq(out.n, 3);
    array_free(&out);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("decimate");
    TCase *tests = tcase_create("decimate");
    tcase_add_test(tests, a_circle_needs_few);
    tcase_add_test(tests, a_straight_line_needs_two);
    tcase_add_test(tests, a_way_there_and_back_keeps_its_turn);
    tcase_add_test(tests, random_walks_keep_the_tolerance);
    tcase_add_test(tests, short_chains);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
