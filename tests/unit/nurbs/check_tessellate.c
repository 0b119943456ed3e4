/*
 * tessellate: vertices on spheres and tori with their normals and curvatures, areas, the error that
 * is told against that of many places, threads that change nothing, a tolerance out of reach.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include <string.h>

#include "known.h"
#include "nurbs/tessellate.h"

static double off_torus(struct vec3 p)
{
    return fabs(hypot(hypot(p.x, p.y) - 20, p.z) - 5);
}

static double off_sphere(struct vec3 p)
{
    return fabs(vec_length(p) - 10);
}

/* The farthest of 91 places of each triangle; *area is that of all of them. */
static double farthest(const struct sheet *s, double (*off)(struct vec3), double *area)
{
    enum { N = 12 };
    double most = 0;
    *area = 0;
    for (size_t f = 0; f < s->face.n; f++) {
        const int *v = s->face.item[f].v;
        struct vec3 p = s->point.item[v[0]], a = vec_sub(s->point.item[v[1]], p);
        struct vec3 b = vec_sub(s->point.item[v[2]], p), cross = vec_cross(a, b);
        *area += vec_length(cross) / 2;
        ck_assert_double_ge(vec_dot(cross, s->normal.item[v[0]]), -1e-9);
        for (int i = 0; i <= N; i++)
            for (int k = 0; i + k <= N; k++) {
                double x = (double)i / N, y = (double)k / N;
                most = fmax(most, off(vec_along(vec_along(p, x, a), y, b)));
            }
    }
    return most;
}

START_TEST(within_the_tolerance)
{
    static const double tolerance[] = {0.5, 0.05, 0.008};
    for (int k = 0; k < 6; k++) {
        bool torus = k % 2 == 1;
        struct patch p = torus ? known_torus(20, 5) : known_sphere(10);
        double e = tolerance[k / 2], area, want = torus ? 4 * PI * PI * 100 : 4 * PI * 100;
        struct sheet s;
        tessellate(&p, (struct tessellation){0, e, 1}, &s);
        double most = farthest(&s, torus ? off_torus : off_sphere, &area);
        ck_assert_double_le(most, s.error * (1 + 1e-9) + 1e-12);
        ck_assert_double_le(s.error, e);
        ck_assert_double_gt(s.error, e / 3);
        ck_assert_double_lt(fabs(area - want), want * e / 2);
        sheet_free(&s);
        patch_free(&p);
    }
}
END_TEST

START_TEST(exact_vertices)
{
    struct patch p = known_torus(20, 5);
    struct sheet s;
    tessellate(&p, (struct tessellation){23, 0.01, 1}, &s);
    for (size_t i = 0; i < s.at.n; i++) {
        struct vec3 q = s.point.item[i], ring = vec_scale(20, vec_unit(vec(q.x, q.y, 0)));
        struct vec3 normal = vec_scale(0.2, vec_sub(q, ring));
        double across = (hypot(q.x, q.y) - 20) / 5 / hypot(q.x, q.y);
        ck_assert_double_lt(off_torus(q), 1e-12);
        ck_assert_double_lt(vec_distance(s.normal.item[i], normal), 1e-11);
        ck_assert_double_lt(fabs(s.k2.item[i] + 0.2), 1e-10); /* humped: 1/5 round the pipe */
        ck_assert_double_lt(fabs(s.k1.item[i] + across), 1e-10);
    }
    sheet_free(&s);
    patch_free(&p);
}
END_TEST

START_TEST(threads_change_nothing)
{
    struct patch p = known_sphere(10);
    struct sheet a, b;
    tessellate(&p, (struct tessellation){0, 0.02, 1}, &a);
    tessellate(&p, (struct tessellation){0, 0.02, 5}, &b);
    ck_assert_uint_eq(a.at.n, b.at.n);
    ck_assert_uint_eq(a.face.n, b.face.n);
    ck_assert_int_eq(memcmp(a.point.item, b.point.item, a.at.n * sizeof *a.point.item), 0);
    ck_assert_int_eq(memcmp(a.normal.item, b.normal.item, a.at.n * sizeof *a.normal.item), 0);
    ck_assert_int_eq(memcmp(a.face.item, b.face.item, a.face.n * sizeof *a.face.item), 0);
    ck_assert_double_eq(a.error, b.error);
    sheet_free(&a);
    sheet_free(&b);
    patch_free(&p);
}
END_TEST

START_TEST(out_of_reach)
{
    struct patch p = known_sphere(10);
    struct sheet s;
    tessellate(&p, (struct tessellation){0, 1e-9, 1}, &s);
    ck_assert(s.too_fine);
    sheet_free(&s);
    patch_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("tessellate");
    TCase *tests = tcase_create("tessellate");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, within_the_tolerance);
    tcase_add_test(tests, exact_vertices);
    tcase_add_test(tests, threads_change_nothing);
    tcase_add_test(tests, out_of_reach);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
