/* approximate: a curve given by a function is met within its tolerance, with its kinks; offsets of
 * spheres, cylinders and a bent surface are where geometry says. */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"
#include "nurbs/approximate.h"
#include "nurbs/construct.h"

static struct vec3 helix(const void *context, double t)
{
    const double *pitch = context;
    return vec(10 * cos(t), 10 * sin(t), *pitch * t);
}

/* Straight to 1, round a quarter of a circle after it: its tangent turns at once there. */
static struct vec3 kinked(const void *context, double t)
{
    (void)context;
    return t <= 1 ? vec(t, 0, 0) : vec(1 + sin(t - 1), 0, 1 - cos(t - 1) + (t - 1));
}

static double largest_error(approximate_curve_fn *f, const void *context,
                            const struct nurbs_curve *c, double from, double to)
{
    double most = 0;
    for (int i = 0; i <= 2000; i++) {
        double t = from + (to - from) * i / 2000;
        most = fmax(most, vec_distance(f(context, t), nurbs_curve_point(c, t)));
    }
    return most;
}

/* Not more than twice what was asked (the middles are looked at, the largest error is beside
 * them), and what is said is what is there. */
START_TEST(curves)
{
    static const double ends[] = {0, 5}, pitch = 0.7;
    double poles = 0;
    for (double tolerance = 1e-3; tolerance > 1e-8; tolerance /= 10) {
        double said;
        struct nurbs_curve c = approximate_curve(helix, &pitch, ends, 1, tolerance, &said);
        double most = largest_error(helix, &pitch, &c, 0, 5);
        ck_assert_double_le(most, 2 * tolerance);
        ck_assert_double_le(said, tolerance);
        ck_assert_double_le(most, 2 * said);
        ck_assert_double_ge((double)c.t.poles, poles);
        poles = (double)c.t.poles;
        nurbs_curve_free(&c);
    }
    ck_assert_double_lt(poles, 600); /* of order 4: 3 / 1e-9^(1/4) for this curve */
}
END_TEST

START_TEST(kinks)
{
    static const double at[] = {0, 1, 2.5};
    double said;
    struct nurbs_curve c = approximate_curve(kinked, NULL, at, 2, 1e-7, &said);
    ck_assert_double_le(largest_error(kinked, NULL, &c, 0, 2.5), 2e-7);
    ck_assert_uint_lt(c.t.poles, 300);
    nurbs_curve_free(&c);
}
END_TEST

/* A kink that is not said takes all the knots that there may be, and the error says so. */
START_TEST(unsaid_kink)
{
    static const double at[] = {0, 2.6};
    double said;
    struct nurbs_curve c = approximate_curve(kinked, NULL, at, 1, 1e-9, &said);
    ck_assert_double_gt(said, 1e-9);
    ck_assert_uint_le(c.t.poles, APPROXIMATE_MOST + 3);
    ck_assert_double_lt(largest_error(kinked, NULL, &c, 0, 2.6), 1e-3);
    nurbs_curve_free(&c);
}
END_TEST

/* Up and down again: a polygon of 3,000 sides. */
static struct vec3 zigzag(const void *context, double t)
{
    (void)context;
    return vec(t, 0, fabs(t - 2 * floor(t / 2 + 0.5)));
}

/* More kinks than there may be spans: each is met all the same. */
START_TEST(many_kinks)
{
    enum { SIDES = 3000 };
    double *at = mem_alloc(SIDES + 1, sizeof *at), said;
    for (int i = 0; i <= SIDES; i++)
        at[i] = i;
    struct nurbs_curve c = approximate_curve(zigzag, NULL, at, SIDES, 1e-9, &said);
    ck_assert_double_le(said, 1e-9);
    ck_assert_double_le(largest_error(zigzag, NULL, &c, 0, SIDES), 1e-9);
    nurbs_curve_free(&c);
    free(at);
}
END_TEST

static struct nurbs ball(double radius)
{
    struct transform place = construct_place(vec(0, 0, 0), vec(0, -1, 0), vec(1, 0, 0));
    struct nurbs_curve meridian = construct_ellipse(&place, radius, radius, -1.2, 1.3);
    struct nurbs s = construct_revolution(&meridian, vec(0, 0, 0), vec(0, 0, 1), 0.2, 4);
    nurbs_curve_free(&meridian);
    return s;
}

/* Every place of the offset is `distance` from the place of the surface, along its normal. */
static double offset_error(const struct nurbs *s, const struct nurbs *offset, double distance)
{
    double most = 0;
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++) {
            struct uv at = {s->u.from + (s->u.to - s->u.from) * i / 40,
                            s->v.from + (s->v.to - s->v.from) * j / 40};
            struct nurbs_place p = nurbs_place(s, at);
            struct vec3 want = vec_along(p.point, distance, p.normal);
            most = fmax(most, vec_distance(want, nurbs_point(offset, at)));
        }
    return most;
}

START_TEST(offset_of_a_ball)
{
    for (int inward = 0; inward < 2; inward++) {
        double distance = inward ? -3 : 2;
        struct nurbs s = ball(10), offset = approximate_offset(&s, distance, NULL);
        struct vec3 p = nurbs_place(&s, (struct uv){1, 0}).normal,
                    at = nurbs_point(&s, (struct uv){1, 0});
        double radius = 10 + (vec_dot(p, at) > 0 ? distance : -distance);
        ck_assert_double_le(offset_error(&s, &offset, distance), 20 * 1e-8);
        for (int i = 0; i < 50; i++) {
            struct uv uv = {0.2 + 0.07 * i, -1.2 + 0.05 * i};
            ck_assert_double_le(fabs(vec_length(nurbs_point(&offset, uv)) - radius), 2e-7);
        }
        nurbs_free(&s);
        nurbs_free(&offset);
    }
}
END_TEST

START_TEST(offset_of_a_bent_surface)
{
    static const double u[] = {0, 1, 2}, v[] = {0, 1};
    double c[2 * 48] = {0};
    for (int patch = 0; patch < 2; patch++) {
        double *x = c + 48 * patch, *y = x + 16, *z = y + 16, s = patch;
        x[0] = 10 * s, x[1] = 10; /* x = 10 u, y = 10 v, z = u^2 + u v */
        y[4] = 10;
        z[0] = s * s, z[1] = 2 * s, z[2] = 1, z[4] = s, z[5] = 1;
    }
    struct nurbs s = construct_spline_surface(u, 2, v, 1, c),
                 offset = approximate_offset(&s, 1.5, NULL);
    struct vec3 at = nurbs_point(&s, (struct uv){1.5, 0.5});
    ck_assert_double_le(vec_distance(at, vec(15, 5, 1.5 * 1.5 + 1.5 * 0.5)), 1e-12);
    ck_assert_double_le(offset_error(&s, &offset, 1.5), 1e-6);
    nurbs_free(&s);
    nurbs_free(&offset);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("approximate");
    TCase *tests = tcase_create("approximate");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, curves);
    tcase_add_test(tests, kinks);
    tcase_add_test(tests, unsaid_kink);
    tcase_add_test(tests, many_kinks);
    tcase_add_test(tests, offset_of_a_ball);
    tcase_add_test(tests, offset_of_a_bent_surface);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
