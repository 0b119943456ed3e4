/* cloud_surface: a quadric is met exactly and a wave within the error, by each kind of surface and
 * in any direction of u; the border is that of the points, with its holes. */
#include "stage/cloud_surface.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/elementary.h"

static struct vec3s points;
static struct cloud_surface result;
static struct error error;
static double (*height)(double x, double y);

static double quadric(double x, double y)
{
    return 0.02 * x * x - 0.01 * x * y + 0.03 * y * y + 0.2 * x - 0.1 * y + 4;
}

static double wave(double x, double y)
{
    return 2 * sin(x / 3) * cos(y / 4);
}

static void teardown(void)
{
    array_free(&points);
    patches_free(&result.patches);
}

/* 20 x 15 mm, a point each 0.5, without those of a square hole of this half width about (10, 8). */
static void scan(double (*of)(double x, double y), double hole)
{
    height = of;
    for (int j = 0; j <= 30; j++)
        for (int i = 0; i <= 40; i++) {
            double x = 0.5 * i, y = 0.5 * j;
            if (fabs(x - 10) >= hole || fabs(y - 8) >= hole)
                *array_push(&points) = vec(x, y, of(x, y));
        }
}

static struct cloud_surface_options usual(enum cloud_surface_kind kind)
{
    return (struct cloud_surface_options){
        .kind = kind, .error = 0.01, .mean = 0.5, .gap = 3, .threads = 1};
}

static void make(const struct cloud_surface_options *options)
{
    patches_free(&result.patches);
    ck_assert_msg(cloud_surface_make(options, &points, &result, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(result.patches.n, 1);
}

/* How far the surface is off the truth at most, along z, over all of its parameters. */
static double off(void)
{
    const struct nurbs *s = &result.patches.item[0].surface;
    double worst = 0;
    double u0 = s->u.from, u1 = s->u.to, v0 = s->v.from, v1 = s->v.to;
    for (int i = 0; i <= 60; i++)
        for (int k = 0; k <= 60; k++) {
            struct vec3 d[3][3];
            nurbs_derivatives(s, (struct uv){u0 + (u1 - u0) * i / 60, v0 + (v1 - v0) * k / 60}, 1,
                              d);
            struct vec3 p = d[0][0];
            if (p.x >= -1e-9 && p.x <= 20 && p.y >= -1e-9 && p.y <= 15) /* where points are */
                worst = fmax(worst, fabs(p.z - height(p.x, p.y)));
        }
    return worst;
}

/* At a point of the scan, the worst of them, no more than this. */
static void measured(double most)
{
    ck_assert_double_ge(result.worst, result.rms);
    ck_assert_double_ge(result.rms, 0);
    ck_assert_double_le(result.worst, most);
    ck_assert_double_eq_tol(result.at.z, height(result.at.x, result.at.y), 1e-9);
}

START_TEST(a_quadric_is_met)
{
    scan(quadric, 0);
    for (int kind = CLOUD_SURFACE_BSPLINE; kind <= CLOUD_SURFACE_BEZIER; kind++)
        for (int turn = 0; turn < 2; turn++) {
            struct cloud_surface_options options = usual((enum cloud_surface_kind)kind);
            options.direction = turn ? 90 : 0;
            /* Ferguson's patches have no twist: without that of c x y, which is c dx dy, a patch is
             * off by c dx dy g(u) g(v), g(t) = t (1 - t) (1 - 2 t), of which the most is 1 / 6 by
             * the root of 3; the first net has 3 x 2 patches */
            double twist = kind == CLOUD_SURFACE_FERGUSON ? 0.01 * (20.0 / 3) * 7.5 / 108 : 0;
            make(&options);
            measured(twist + 1e-9);
            ck_assert_double_ge(result.worst, 0.9 * twist);
            ck_assert_double_le(off(), twist + 1e-9);
            ck_assert_double_ge(off(), 0.98 * twist);
        }
}
END_TEST

START_TEST(a_wave_is_met_within_the_error)
{
    scan(wave, 0);
    for (int kind = CLOUD_SURFACE_BSPLINE; kind <= CLOUD_SURFACE_BEZIER; kind++)
        for (double e = 0.05; e > 0.009; e *= 0.3) {
            struct cloud_surface_options options = usual((enum cloud_surface_kind)kind);
            options.error = e;
            make(&options);
            measured(e);
            ck_assert_double_le(off(), 2 * e);
            ck_assert_double_ge(off(), result.worst - 1e-9);
        }
}
END_TEST

/* A net that is asked for: patches of 5 mm on 20 x 15, cubic; a Bezier net keeps its corners. */
START_TEST(a_net_as_asked)
{
    scan(quadric, 0);
    struct cloud_surface_options options = usual(CLOUD_SURFACE_FERGUSON);
    options.spacing = 5;
    make(&options);
    ck_assert_double_eq(result.spacing, 5);
    ck_assert_uint_eq(result.fits, 1);
    /* 4 x 3 patches, each side of a patch three knots apart at least: joined C1 */
    const struct nurbs *s = &result.patches.item[0].surface;
    ck_assert_int_eq(s->u.degree, 3);
    ck_assert_uint_ge(s->u.poles, 2 * 5);
    ck_assert_uint_ge(s->v.poles, 2 * 4);
    ck_assert_uint_le(s->u.poles, 3 * 4U + 1);
    ck_assert_uint_le(s->v.poles, 3 * 3U + 1);
    options.spacing = 0.001;
    patches_free(&result.patches);
    ck_assert_int_eq(cloud_surface_make(&options, &points, &result, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "0.001"));
}
END_TEST

/* Area inside all loops, by the signs of their turns. */
static double trimmed_area(double *whole)
{
    double sum = 0;
    const struct patch *patch = &result.patches.item[0];
    *whole = 0;
    for (size_t k = 0; k < patch->loop.n; k++) {
        double area = 0;
        for (size_t i = 0; i < patch->loop.item[k].n; i++) {
            const struct nurbs_curve *c = &patch->loop.item[k].item[i];
            struct vec3 a = nurbs_curve_point(c, c->t.from), b = nurbs_curve_point(c, c->t.to);
            area += (a.x * b.y - a.y * b.x) / 2;
        }
        sum += area;
        *whole = fmax(*whole, fabs(area));
    }
    return sum;
}

START_TEST(borders)
{
    struct cloud_surface_options options = usual(CLOUD_SURFACE_BSPLINE);
    scan(quadric, 0);
    make(&options);
    ck_assert_uint_eq(result.patches.item[0].loop.n, 0); /* all of the rectangle */
    ck_assert_uint_eq(result.holes, 0);
    array_free(&points);
    scan(quadric, 3);
    options.untrimmed = true;
    make(&options);
    ck_assert_uint_eq(result.patches.item[0].loop.n, 0);
    options.untrimmed = false;
    make(&options);
    ck_assert_uint_eq(result.holes, 1);
    ck_assert_uint_eq(result.patches.item[0].loop.n, 2);
    double whole, area = fabs(trimmed_area(&whole));
    ck_assert_double_eq_tol(whole, 20 * 15, 1e-9);
    /* the hole is 6 x 6, its border smoothed by up to half a spacing; it turns the other way */
    ck_assert_double_ge(area, 20 * 15 - 6.5 * 6.5);
    ck_assert_double_le(area, 20 * 15 - 5.5 * 5.5);
}
END_TEST

START_TEST(no_surface)
{
    struct cloud_surface_options options = usual(CLOUD_SURFACE_BSPLINE);
    for (int i = 0; i < 9; i++)
        *array_push(&points) = vec(i, 2 * i, 0);
    ck_assert_int_eq(cloud_surface_make(&options, &points, &result, &error), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_surface");
    TCase *tests = tcase_create("cloud_surface");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, a_quadric_is_met);
    tcase_add_test(tests, a_wave_is_met_within_the_error);
    tcase_add_test(tests, a_net_as_asked);
    tcase_add_test(tests, borders);
    tcase_add_test(tests, no_surface);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
