/* quadric: exact on quadrics, to the third order on spheres and tori, refused on lines. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "math/quadric.h"
#include "seed.h"

static uint64_t state = 5;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

enum { N = 40 };

/* On a paraboloid with known slopes and curvatures, wherever the origin is in the neighbourhood,
 * near zero or with UTM coordinates. */
START_TEST(exact_on_a_quadric)
{
    for (int round = 0; round < 50; round++) {
        struct vec3 p[N], base = {0, 0, 0};
        double c[6];
        if (round % 2)
            base = vec(500123, 4649776, 212);
        for (int i = 0; i < 6; i++)
            c[i] = 0.4 * (uniform() - 0.5);
        for (int i = 0; i < N; i++) {
            double x = 3 * uniform(), y = 3 * uniform();
            p[i] = vec(base.x + x, base.y + y,
                       base.z + c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y +
                           c[5] * y * y);
        }
        struct quadric q;
        ck_assert_int_eq(quadric_fit(p, N, base, vec(0, 0, 1), &q), 0);
        struct vec3 n = vec_unit(vec(-c[1], -c[2], 1));
        ck_assert_double_eq_tol(vec_distance(quadric_normal(&q), n), 0, 1e-8);
        ck_assert_double_eq_tol(quadric_distance(&q), fabs(c[0]) * n.z, 1e-8);
        /* principal curvatures by mean and Gauss curvature of a graph (Monge) */
        double g = 1 + c[1] * c[1] + c[2] * c[2];
        double gauss = (4 * c[3] * c[5] - c[4] * c[4]) / (g * g);
        double mean = ((1 + c[2] * c[2]) * c[3] - c[1] * c[2] * c[4] + (1 + c[1] * c[1]) * c[5]) /
                      (g * sqrt(g));
        ck_assert_double_eq_tol(quadric_curvature(&q), mean + sqrt(fmax(mean * mean - gauss, 0)),
                                1e-7);
    }
}
END_TEST

/* Inside of a sphere of radius R: hollow, curvature 1/R, the normal points at the centre. */
START_TEST(sphere)
{
    const double R = 20;
    for (int round = 0; round < 20; round++) {
        struct vec3 up = vec_unit(vec(uniform() - 0.5, uniform() - 0.5, 0.2 + uniform()));
        struct vec3 u = vec_perpendicular(up), v = vec_cross(up, u), p[N];
        for (int i = 0; i < N; i++) {
            struct vec3 to =
                vec_along(vec_along(up, 0.1 * (uniform() - 0.5), u), 0.1 * (uniform() - 0.5), v);
            p[i] = vec_scale(-R, vec_unit(to));
        }
        struct quadric q;
        ck_assert_int_eq(quadric_fit(p, N, vec_scale(-R, up), up, &q), 0);
        ck_assert_double_lt(vec_angle(quadric_normal(&q), up), 1e-4);
        ck_assert_double_lt(quadric_distance(&q), 1e-4);
        ck_assert_double_eq_tol(quadric_curvature(&q), 1 / R, 0.01 / R);
    }
}
END_TEST

/* Outside of a cylinder: nowhere hollow, the larger curvature is that along it, 0. */
START_TEST(cylinder)
{
    struct vec3 p[N];
    struct quadric q;
    for (int i = 0; i < N; i++) {
        double turn = 0.2 * (uniform() - 0.5);
        p[i] = vec(2 * uniform() - 1, 10 * sin(turn), 10 * cos(turn));
    }
    ck_assert_int_eq(quadric_fit(p, N, vec(0, 0, 10), vec(0, 0, 1), &q), 0);
    ck_assert_double_eq_tol(quadric_curvature(&q), 0, 1e-3);
    ck_assert_int_eq(quadric_fit(p, N, vec(0, 0, 10), vec(0, 0, -1), &q), 0);
    ck_assert_double_eq_tol(quadric_curvature(&q), 0.1, 1e-3); /* hollow from the other side */
}
END_TEST

static int fit_lines(int lines, double jitter)
{
    struct vec3 p[N];
    struct quadric q;
    for (int i = 0; i < N; i++)
        p[i] = vec(4 * uniform(), i % lines + jitter * uniform(), uniform());
    return quadric_fit(p, N, vec(2, 0, 0), vec(0, 0, 1), &q);
}

START_TEST(lines_carry_no_quadric)
{
    ck_assert_int_eq(fit_lines(1, 0), -1);
    ck_assert_int_eq(fit_lines(2, 0), -1);
    ck_assert_int_eq(fit_lines(1, 1e-2), -1); /* a line with jitter is a line */
    ck_assert_int_eq(fit_lines(2, 1e-2), -1);
    ck_assert_int_eq(fit_lines(3, 0), 0);
    struct vec3 one_place[N] = {{0, 0, 0}};
    struct quadric q;
    ck_assert_int_eq(quadric_fit(one_place, N, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
    ck_assert_int_eq(quadric_fit(one_place, 5, vec(0, 0, 0), vec(0, 0, 1), &q), -1);
}
END_TEST

/* A surface of the third degree, bent as much as it may be. */
static struct quadric bent(double much)
{
    struct vec3 w = vec_unit(vec(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5));
    struct quadric q = quadric_frame(vec(uniform(), uniform(), uniform()), w);
    for (int i = 0; i < 10; i++)
        q.c[i] = (i < 3 ? 2 : much) * (uniform() - 0.5);
    return q;
}

/* What is said without a closer look is what the closer look finds: points on both sides of a limit
 * that is near to where they are, on surfaces that bend much within it or little. */
START_TEST(surely_within_is_within)
{
    int said = 0, were = 0;
    for (int round = 0; round < 200000; round++) {
        struct quadric q = bent(pow(10, 6 * uniform() - 3));
        double height = 0.2 * (uniform() - 0.5), limit = fabs(height) * 2 * uniform();
        struct vec3 p = quadric_at(&q, 3 * (uniform() - 0.5), 3 * (uniform() - 0.5));
        p = vec_along(p, height, q.w);
        bool surely = quadric_surely_within(&q, p, limit);
        struct vec3 foot = quadric_nearest(&q, p), n = quadric_normal_at(&q, foot);
        bool is = vec_distance(p, foot) <= limit && fabs(vec_dot(n, vec_sub(p, foot))) <= limit;
        ck_assert_msg(is || !surely, "round %d", round);
        said += surely;
        were += is;
    }
    ck_assert_int_gt(said, were / 8); /* or it would be of no use */
}
END_TEST

/* Of many points at once distances and normals are what they are of each, to the bit: surfaces of
 * the second degree and of the third, even and odd numbers of points. */
START_TEST(all_are_as_each)
{
    for (int round = 0; round < 400; round++) {
        struct quadric q = bent(pow(10, 3 * uniform() - 2));
        struct vec3 p[9], normal[9];
        double off[9];
        size_t n = 1 + (size_t)round % 9;
        for (int i = 6; i < 10 && round % 2; i++)
            q.c[i] = 0;
        for (size_t k = 0; k < n; k++)
            p[k] = vec(3 * uniform(), 3 * uniform(), 3 * uniform());
        quadric_off_all(&q, p, n, off);
        quadric_normal_all(&q, p, n, normal);
        for (size_t k = 0; k < n; k++) {
            struct vec3 one = quadric_normal_at(&q, p[k]);
            ck_assert_double_eq(off[k], quadric_off(&q, p[k]));
            ck_assert_int_eq(vec_compare(&normal[k], &one), 0);
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("quadric");
    TCase *tests = tcase_create("quadric");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, exact_on_a_quadric);
    tcase_add_test(tests, sphere);
    tcase_add_test(tests, cylinder);
    tcase_add_test(tests, lines_carry_no_quadric);
    tcase_add_test(tests, surely_within_is_within);
    tcase_add_test(tests, all_are_as_each);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
