/*
 * nurbs, against the Cox - de Boor recursion with long doubles and difference quotients, and
 * against surfaces that are known: a sphere (points, normals, curvatures, poles), a cylinder in a
 * quarter, a paraboloid.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/nurbs.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* N_{i,p}(u) by its definition; the last span holds its right end too. */
static long double recursion(const struct nurbs_axis *a, size_t i, int p, double u)
{
    const double *knot = a->knot;
    if (p == 0) {
        double end = knot[a->poles];
        if (u == end)
            return knot[i] < end && knot[i + 1] == end ? 1 : 0;
        return knot[i] <= u && u < knot[i + 1] ? 1 : 0;
    }
    long double left = (long double)knot[i + (size_t)p] - knot[i];
    long double right = (long double)knot[i + (size_t)p + 1] - knot[i + 1], value = 0;
    if (left > 0)
        value += ((long double)u - knot[i]) / left * recursion(a, i, p - 1, u);
    if (right > 0)
        value += (knot[i + (size_t)p + 1] - (long double)u) / right * recursion(a, i + 1, p - 1, u);
    return value;
}

static struct vec3 by_definition(const struct nurbs *s, struct uv at)
{
    long double sum[4] = {0, 0, 0, 0};
    for (size_t j = 0; j < s->v.poles; j++)
        for (size_t i = 0; i < s->u.poles; i++) {
            const struct nurbs_pole *p = &s->pole[j * s->u.poles + i];
            long double n =
                recursion(&s->u, i, s->u.degree, at.u) * recursion(&s->v, j, s->v.degree, at.v);
            sum[0] += n * p->wx;
            sum[1] += n * p->wy;
            sum[2] += n * p->wz;
            sum[3] += n * p->w;
        }
    return vec((double)(sum[0] / sum[3]), (double)(sum[1] / sum[3]), (double)(sum[2] / sum[3]));
}

/* Knots neither clamped nor simple. */
static struct nurbs_axis random_axis(int degree, size_t poles)
{
    struct nurbs_axis a = {.degree = degree, .poles = poles};
    struct error error;
    size_t knots = poles + (size_t)degree + 1;
    double t = 10 * chance() - 5;
    a.knot = mem_alloc(knots, sizeof *a.knot);
    for (size_t i = 0; i < knots; i++) {
        a.knot[i] = t;
        t += degree > 1 && i % 2 && chance() < 0.4 ? 0 : 0.1 + chance();
    }
    a.from = a.knot[degree] + 0.1 * chance() * (a.knot[poles] - a.knot[degree]);
    a.to = a.knot[poles];
    ck_assert_msg(nurbs_axis_check(&a, "u", &error) == 0, "%s", error.text);
    return a;
}

static struct nurbs random_surface(int p, int q)
{
    struct nurbs s = {.u = random_axis(p, (size_t)p + 2 + (size_t)(5 * chance())),
                      .v = random_axis(q, (size_t)q + 2 + (size_t)(5 * chance()))};
    size_t n = s.u.poles * s.v.poles;
    s.pole = mem_alloc(n, sizeof *s.pole);
    for (size_t i = 0; i < n; i++) {
        double w = 0.2 + 3 * chance();
        double x = (double)(i % s.u.poles) + chance() / 2,
               y = (double)(i / s.u.poles) + chance() / 2;
        s.pole[i] = (struct nurbs_pole){w * x, w * y, w * 3 * chance(), w};
    }
    return s;
}

static struct uv place_of(const struct nurbs *s, double u, double v)
{
    return (struct uv){s->u.from + u * (s->u.to - s->u.from),
                       s->v.from + v * (s->v.to - s->v.from)};
}

START_TEST(points_by_definition)
{
    seed = 1;
    for (int turn = 0; turn < 60; turn++) {
        struct nurbs s = random_surface(1 + turn % 7, 1 + turn % 4);
        for (int i = 0; i < 20; i++) {
            struct uv at = i == 0 ? (struct uv){s.u.to, s.v.to} : place_of(&s, chance(), chance());
            ck_assert_double_lt(vec_distance(nurbs_point(&s, at), by_definition(&s, at)), 1e-12);
        }
        nurbs_free(&s);
    }
}
END_TEST

/* First and second derivatives by central differences of the points and of the first ones. */
START_TEST(derivatives_by_differences)
{
    seed = 2;
    for (int turn = 0; turn < 40; turn++) {
        struct nurbs s = random_surface(3 + turn % 4, 3 + turn % 3);
        struct uv at = place_of(&s, 0.1 + 0.8 * chance(), 0.1 + 0.8 * chance());
        struct vec3 d[3][3], e[3][3], f[3][3];
        double h = 1e-5;
        bool near_knot = false;
        for (size_t i = 0; i < s.u.poles + (size_t)s.u.degree + 1; i++)
            near_knot = near_knot || fabs(s.u.knot[i] - at.u) < 2 * h;
        for (size_t i = 0; i < s.v.poles + (size_t)s.v.degree + 1; i++)
            near_knot = near_knot || fabs(s.v.knot[i] - at.v) < 2 * h;
        nurbs_derivatives(&s, at, 2, d);
        for (int k = 0; k < 2 && !near_knot; k++) {
            struct uv low = at, high = at;
            *(k ? &low.v : &low.u) -= h;
            *(k ? &high.v : &high.u) += h;
            nurbs_derivatives(&s, low, 1, e);
            nurbs_derivatives(&s, high, 1, f);
            struct vec3 first = vec_scale(1 / (2 * h), vec_sub(f[0][0], e[0][0]));
            struct vec3 uu = vec_scale(1 / (2 * h), vec_sub(f[1][0], e[1][0]));
            struct vec3 vv = vec_scale(1 / (2 * h), vec_sub(f[0][1], e[0][1]));
            double size = vec_length(d[2][0]) + vec_length(d[1][1]) + vec_length(d[0][2]);
            ck_assert_double_lt(vec_distance(first, d[k ? 0 : 1][k ? 1 : 0]), 1e-6 * (1 + size));
            ck_assert_double_lt(vec_distance(uu, k ? d[1][1] : d[2][0]), 1e-5 * (1 + size));
            ck_assert_double_lt(vec_distance(vv, k ? d[0][2] : d[1][1]), 1e-5 * (1 + size));
        }
        nurbs_free(&s);
    }
}
END_TEST

/* Radius 10 about the origin: circle of nine poles times half circle of five. */
static struct nurbs sphere(void)
{
    static const double circle[9][2] = {{1, 0},   {1, 1},  {0, 1},  {-1, 1}, {-1, 0},
                                        {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    static const double half[5][2] = {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}};
    static const double u[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                        v[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    struct nurbs s = {.u = {.degree = 2, .poles = 9, .from = 0, .to = 4},
                      .v = {.degree = 2, .poles = 5, .from = 0, .to = 2}};
    s.u.knot = mem_alloc(12, sizeof *s.u.knot);
    s.v.knot = mem_alloc(8, sizeof *s.v.knot);
    s.pole = mem_alloc(45, sizeof *s.pole);
    for (size_t i = 0; i < 12; i++)
        s.u.knot[i] = u[i];
    for (size_t i = 0; i < 8; i++)
        s.v.knot[i] = v[i];
    for (size_t i = 0; i < 45; i++) {
        size_t a = i % 9, b = i / 9;
        double w = (a % 2 ? sqrt(0.5) : 1) * (b % 2 ? sqrt(0.5) : 1);
        s.pole[i] = (struct nurbs_pole){10 * w * circle[a][0] * half[b][0],
                                        10 * w * circle[a][1] * half[b][0], 10 * w * half[b][1], w};
    }
    return s;
}

START_TEST(a_sphere)
{
    struct nurbs s = sphere();
    for (int i = 0; i <= 40; i++)
        for (int k = 0; k <= 40; k++) {
            struct nurbs_place p = nurbs_place(&s, place_of(&s, i / 40.0, k / 40.0));
            ck_assert_double_lt(fabs(vec_length(p.point) - 10), 1e-13);
            ck_assert_double_lt(vec_distance(p.normal, vec_scale(0.1, p.point)), 1e-9);
            ck_assert_double_lt(fabs(p.k1 + 0.1) + fabs(p.k2 + 0.1), 1e-6);
        }
    ck_assert_uint_eq(nurbs_axis_breaks(&s.u, NULL, 0), 3);
    ck_assert_uint_eq(nurbs_axis_breaks(&s.v, NULL, 0), 1);
    nurbs_free(&s);
}
END_TEST

/* z = a x^2 + b y^2 as one patch of degree 2 over -1..1. */
START_TEST(a_paraboloid)
{
    seed = 3;
    for (int turn = 0; turn < 50; turn++) {
        double a = chance() - 0.3, b = chance() - 0.3;
        struct nurbs s = {.u = {.degree = 2, .poles = 3, .from = 0, .to = 1},
                          .v = {.degree = 2, .poles = 3, .from = 0, .to = 1}};
        s.u.knot = mem_alloc(6, sizeof *s.u.knot);
        s.v.knot = mem_alloc(6, sizeof *s.v.knot);
        s.pole = mem_alloc(9, sizeof *s.pole);
        for (size_t i = 0; i < 6; i++)
            s.u.knot[i] = s.v.knot[i] = i < 3 ? 0 : 1;
        for (int i = 0; i < 9; i++) {
            int x = i % 3 - 1, y = i / 3 - 1; /* the square of the middle pole is -1 */
            s.pole[i] = (struct nurbs_pole){x, y, a * (x ? 1 : -1) + b * (y ? 1 : -1), 1};
        }
        struct uv at = {chance(), chance()};
        struct nurbs_place p = nurbs_place(&s, at);
        double x = 2 * at.u - 1, y = 2 * at.v - 1, fx = 2 * a * x, fy = 2 * b * y;
        double w = 1 + fx * fx + fy * fy;
        double mean = ((1 + fy * fy) * 2 * a + (1 + fx * fx) * 2 * b) / (2 * w * sqrt(w));
        double gauss = 4 * a * b / (w * w);
        ck_assert_double_lt(vec_distance(p.point, vec(x, y, a * x * x + b * y * y)), 1e-14);
        ck_assert_double_lt(vec_distance(p.normal, vec_unit(vec(-fx, -fy, 1))), 1e-14);
        ck_assert_double_lt(fabs((p.k1 + p.k2) / 2 - mean), 1e-13);
        ck_assert_double_lt(fabs(p.k1 * p.k2 - gauss), 1e-13);
        ck_assert(p.k1 >= p.k2);
        struct vec3 q = vec_along(p.point, 0.01 * chance(), p.normal);
        struct uv near = {fmin(at.u + 0.05, 1), fmax(at.v - 0.05, 0)};
        struct uv foot = nurbs_foot(&s, q, near);
        ck_assert_double_lt(fabs(foot.u - at.u) + fabs(foot.v - at.v), 1e-9);
        nurbs_free(&s);
    }
}
END_TEST

/* All of one edge in one point, where the cross product vanishes: a cone's normal there is the
 * limit along its side; a flat fan's is that of its plane. */
START_TEST(degenerate_edges)
{
    struct nurbs s = {.u = {.degree = 1, .poles = 2, .from = 0, .to = 1},
                      .v = {.degree = 1, .poles = 2, .from = 0, .to = 1}};
    double knot[4] = {0, 0, 1, 1};
    struct nurbs_pole fan[4] = {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
    struct nurbs_pole dot[4] = {{1, 2, 3, 1}, {1, 2, 3, 1}, {1, 2, 3, 1}, {1, 2, 3, 1}};
    s.u.knot = s.v.knot = knot;
    s.pole = fan;
    for (int i = 0; i <= 8; i++) {
        struct nurbs_place p = nurbs_place(&s, (struct uv){i / 8.0, 0});
        ck_assert_double_lt(fabs(fabs(p.normal.z) - 1), 1e-12);
        struct nurbs_place q = nurbs_place(&s, (struct uv){i / 8.0, 0.5});
        ck_assert_double_lt(vec_distance(p.normal, q.normal), 1e-12);
    }
    s.pole = dot;
    struct nurbs_place p = nurbs_place(&s, (struct uv){0.3, 0.3});
    ck_assert(vec_length(p.normal) == 0 && p.k1 == 0 && p.k2 == 0);
}
END_TEST

START_TEST(bad_axes)
{
    struct error error;
    double fall[6] = {0, 0, 1, 0.5, 2, 2}, none[4] = {1, 1, 1, 1}, good[4] = {0, 0, 1, 1};
    struct nurbs_axis a = {.degree = 2, .poles = 3, .knot = fall, .from = 0, .to = 1};
    ck_assert_int_eq(nurbs_axis_check(&a, "u", &error), -1);
    a = (struct nurbs_axis){.degree = 1, .poles = 2, .knot = none, .from = 0, .to = 1};
    ck_assert_int_eq(nurbs_axis_check(&a, "u", &error), -1);
    a = (struct nurbs_axis){.degree = 1, .poles = 2, .knot = good, .from = 0.5, .to = 0.5};
    ck_assert_int_eq(nurbs_axis_check(&a, "u", &error), -1);
    a.from = -3;
    a.to = 7;
    ck_assert_int_eq(nurbs_axis_check(&a, "u", &error), 0);
    ck_assert(a.from == 0 && a.to == 1);
    a.degree = NURBS_DEGREE_MAX + 1;
    ck_assert_int_eq(nurbs_axis_check(&a, "u", &error), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("nurbs");
    TCase *tests = tcase_create("nurbs");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, points_by_definition);
    tcase_add_test(tests, derivatives_by_differences);
    tcase_add_test(tests, a_sphere);
    tcase_add_test(tests, a_paraboloid);
    tcase_add_test(tests, degenerate_edges);
    tcase_add_test(tests, bad_axes);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
