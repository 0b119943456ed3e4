/*
 * construct: conics and surfaces against their equations, splines against their polynomials, curves
 * refined against themselves.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"
#include "nurbs/construct.h"
#include "seed.h"

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static struct transform random_place(void)
{
    struct vec3 at = {uniform(-50, 50), uniform(-50, 50), uniform(-50, 50)};
    struct vec3 z = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    return construct_place(at, z, vec(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
}

/* Back to the coordinates of the place, whose axes are perpendicular unit vectors. */
static struct vec3 local(const struct transform *t, struct vec3 p)
{
    struct vec3 d = vec_sub(p, vec(t->m[0][3], t->m[1][3], t->m[2][3]));
    return vec(t->m[0][0] * d.x + t->m[1][0] * d.y + t->m[2][0] * d.z,
               t->m[0][1] * d.x + t->m[1][1] * d.y + t->m[2][1] * d.z,
               t->m[0][2] * d.x + t->m[1][2] * d.y + t->m[2][2] * d.z);
}

static double part(const struct nurbs_axis *a, int i, int n)
{
    return a->from + (a->to - a->from) * i / n;
}

START_TEST(conics)
{
    for (int turn = 0; turn < 40; turn++) {
        struct transform t = random_place();
        double a = uniform(1, 20), b = uniform(1, 20), from = uniform(-6, 6);
        double to = from + (turn == 0 ? 2 * PI : uniform(0.01, 2 * PI));
        struct nurbs_curve e = construct_ellipse(&t, a, b, from, to);
        struct nurbs_curve h = construct_hyperbola(&t, a, b, -1, uniform(-0.5, 2));
        struct nurbs_curve p = construct_parabola(&t, a, -1, uniform(-0.5, 2));
        for (int i = 0; i <= 100; i++) {
            struct vec3 q = local(&t, nurbs_curve_point(&e, part(&e.t, i, 100)));
            ck_assert_double_lt(fabs(hypot(q.x / a, q.y / b) - 1) + fabs(q.z), 1e-12);
            q = local(&t, nurbs_curve_point(&h, part(&h.t, i, 100)));
            ck_assert_double_lt(fabs(q.x * q.x / a / a - q.y * q.y / b / b - 1), 1e-11);
            q = local(&t, nurbs_curve_point(&p, part(&p.t, i, 100)));
            ck_assert_double_lt(fabs(q.x - q.y * q.y / 4 / a), 1e-11);
        }
        struct vec3 q = local(&t, nurbs_curve_point(&e, from));
        ck_assert_double_lt(hypot(q.x - a * cos(from), q.y - b * sin(from)), 1e-11);
        q = local(&t, nurbs_curve_point(&e, to));
        ck_assert_double_lt(hypot(q.x - a * cos(to), q.y - b * sin(to)), 1e-11);
        nurbs_curve_free(&e);
        nurbs_curve_free(&h);
        nurbs_curve_free(&p);
    }
}
END_TEST

/* A cylinder, a cone, a sphere and a torus: distance to the axis, and the normal outwards. */
START_TEST(turned_and_extruded)
{
    struct transform t = construct_place(vec(1, 2, 3), vec(0, 0, 1), vec(1, 0, 0));
    struct transform side = construct_place(vec(1, 2, 3), vec(0, -1, 0), vec(1, 0, 0));
    struct transform tube = construct_place(vec(21, 2, 3), vec(0, -1, 0), vec(1, 0, 0));
    struct nurbs_curve c[3] = {construct_ellipse(&t, 10, 10, 0, 2 * PI),
                               construct_ellipse(&side, 10, 10, -PI / 2, PI / 2),
                               construct_ellipse(&tube, 5, 5, 0, 2 * PI)};
    struct nurbs s[3] = {
        construct_extrusion(&c[0], vec(0, 0, 7)),
        construct_revolution(&c[1], vec(1, 2, 3), vec(0, 0, 1), 0, 2 * PI),
        construct_revolution(&c[2], vec(1, 2, 3), vec(0, 0, 1), 0, 2 * PI),
    };
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i <= 40; i++)
            for (int j = 1; j < 40; j++) {
                struct uv at = {part(&s[k].u, i, 40), part(&s[k].v, j, 40)};
                struct nurbs_place p = nurbs_place(&s[k], at);
                struct vec3 q = local(&t, p.point), axis = vec_unit(vec(q.x, q.y, 0));
                struct vec3 middle = k == 0   ? vec(0, 0, q.z)
                                     : k == 1 ? vec(0, 0, 0)
                                              : vec_scale(20, axis);
                ck_assert_double_lt(fabs(vec_distance(q, middle) - (k == 2 ? 5 : 10)), 1e-12);
                ck_assert_double_gt(vec_dot(p.normal, vec_sub(q, middle)), 0);
            }
        nurbs_free(&s[k]);
        nurbs_curve_free(&c[k]);
    }
}
END_TEST

static struct nurbs_curve random_curve(int degree, size_t n)
{
    struct nurbs_curve c = {.t = {.degree = degree, .poles = n}};
    size_t knots = n + (size_t)degree + 1;
    c.t.knot = mem_alloc(knots, sizeof *c.t.knot);
    for (size_t i = 1; i < knots; i++)
        c.t.knot[i] = c.t.knot[i - 1] + (i % 3 == 0 && degree > 1 ? 0 : uniform(0.2, 1));
    c.t.from = c.t.knot[degree] + 0.1;
    c.t.to = c.t.knot[n] - 0.1;
    c.pole = mem_alloc(n, sizeof *c.pole);
    for (size_t i = 0; i < n; i++) {
        double w = uniform(0.5, 2);
        c.pole[i] = (struct nurbs_pole){w * uniform(-9, 9), w * uniform(-9, 9), w * 3, w};
    }
    return c;
}

START_TEST(refined_curves_are_the_same)
{
    for (int turn = 0; turn < 60; turn++) {
        int degree = 1 + turn % 5;
        struct nurbs_curve c = random_curve(degree, (size_t)degree + 2 + (size_t)turn % 20);
        double middle = (c.t.from + c.t.to) / 2, foot = part(&c.t, 1 + turn % 99, 100);
        struct nurbs_curve r = construct_refined(&c, degree + turn % 3, &middle, 1);
        for (int i = 0; i <= 100; i++) {
            double t = part(&c.t, i, 100);
            ck_assert_double_lt(vec_distance(nurbs_curve_point(&c, t), nurbs_curve_point(&r, t)),
                                1e-10);
        }
        struct vec3 q = nurbs_curve_point(&c, foot);
        ck_assert_double_lt(vec_distance(nurbs_curve_point(&c, nurbs_curve_foot(&c, q)), q), 1e-9);
        nurbs_curve_reverse(&r);
        for (int i = 0; i <= 100; i++)
            ck_assert_double_lt(vec_distance(nurbs_curve_point(&c, part(&c.t, i, 100)),
                                             nurbs_curve_point(&r, part(&r.t, 100 - i, 100))),
                                1e-10);
        nurbs_curve_free(&c);
        nurbs_curve_free(&r);
    }
}
END_TEST

/* Beside a corner, of which the other side comes near to the point as well. */
START_TEST(foot_beside_a_corner)
{
    for (int turn = 0; turn < 2000; turn++) {
        struct nurbs_curve c = random_curve(1, 3 + (size_t)turn % 9);
        double t = uniform(c.t.from, c.t.to);
        struct vec3 q = nurbs_curve_point(&c, t);
        ck_assert_double_lt(vec_distance(nurbs_curve_point(&c, nurbs_curve_foot(&c, q)), q), 1e-7);
        nurbs_curve_free(&c);
    }
}
END_TEST

START_TEST(ruled)
{
    for (int turn = 0; turn < 30; turn++) {
        struct nurbs_curve a = random_curve(1 + turn % 4, 8),
                           b = random_curve(3, 5 + (size_t)turn % 7);
        struct nurbs s = construct_ruled(&a, &b);
        for (int i = 0; i <= 50; i++) {
            struct vec3 p = nurbs_curve_point(&a, part(&a.t, i, 50));
            struct vec3 q = nurbs_curve_point(&b, part(&b.t, i, 50));
            ck_assert_double_lt(vec_distance(nurbs_point(&s, (struct uv){i / 50.0, 0}), p), 1e-9);
            ck_assert_double_lt(vec_distance(nurbs_point(&s, (struct uv){i / 50.0, 1}), q), 1e-9);
            struct vec3 m = nurbs_point(&s, (struct uv){i / 50.0, 0.3});
            ck_assert_double_lt(vec_segment_distance(p, q, m), 1e-9);
        }
        nurbs_free(&s);
        nurbs_curve_free(&a);
        nurbs_curve_free(&b);
    }
}
END_TEST

START_TEST(splines)
{
    double at[4] = {0, 1.5, 2, 4}, other[3] = {-1, 1, 4}, d[48 * 6];
    for (int i = 0; i < 48 * 6; i++)
        d[i] = uniform(-1, 1);
    struct nurbs s = construct_spline_surface(at, 3, other, 2, d);
    /* In the middle of the last segment, which is not shared with a neighbour. */
    double t = 1, v = 1.5, sum = 0;
    for (int q = 3; q >= 0; q--) {
        const double *p = d + 48 * 5 + 4 * q;
        sum = sum * v + p[0] + p[1] * t + p[2] * t * t + p[3] * t * t * t;
    }
    ck_assert_double_lt(fabs(nurbs_point(&s, (struct uv){3, 2.5}).x - sum), 1e-11);
    nurbs_free(&s);
}
END_TEST

/* A straight line is in the spline space of every degree, up to the highest there is. */
START_TEST(interpolation_of_every_degree)
{
    for (int degree = 1; degree <= NURBS_DEGREE_MAX; degree++)
        for (size_t spans = 1; spans <= 4; spans++) {
            struct nurbs_axis axis = {.degree = degree, .poles = (size_t)degree + spans, .to = 1};
            size_t knots = axis.poles + (size_t)degree + 1;
            struct vec3 *value = mem_alloc(axis.poles, sizeof *value);
            axis.knot = mem_alloc(knots, sizeof *axis.knot);
            for (size_t k = 0; k < knots; k++)
                axis.knot[k] = k <= (size_t)degree ? 0
                               : k >= axis.poles   ? 1
                                                   : (double)(k - (size_t)degree) / (double)spans;
            for (size_t i = 0; i < axis.poles; i++) {
                double t = construct_greville(&axis, i);
                value[i] = vec(3 * t - 1, 2, -t);
            }
            struct nurbs_pole *pole = construct_interpolation(&axis, value);
            /* the condition of the basis is about the degree times 2 to its power (de Boor) */
            double rounding = 1e-14 * degree * pow(2, degree);
            for (size_t i = 0; i < axis.poles; i++)
                ck_assert_double_lt(vec_distance(vec(pole[i].wx, pole[i].wy, pole[i].wz), value[i]),
                                    rounding);
            free(pole);
            free(axis.knot);
            free(value);
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("construct");
    TCase *tests = tcase_create("construct");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, conics);
    tcase_add_test(tests, turned_and_extruded);
    tcase_add_test(tests, refined_curves_are_the_same);
    tcase_add_test(tests, foot_beside_a_corner);
    tcase_add_test(tests, ruled);
    tcase_add_test(tests, splines);
    tcase_add_test(tests, interpolation_of_every_degree);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
