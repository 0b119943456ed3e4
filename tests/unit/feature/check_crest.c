/* crest: edges over a rib or a groove get a point on it, others none. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "ribs.h"

static struct point_grid sorted(const struct vec3s *p, double spacing)
{
    struct point_grid scan;
    struct error error;
    ck_assert_int_eq(point_grid_make(p->item, p->n, spacing, 1, &scan, &error), 0);
    return scan;
}

/* Edges 0.6 mm long across the crest at several places; nearly half of the rib is off their
 * middle.  Without noise the crest is 0.02 high and `aside` for the rib is no quadric.  Points by
 * chance have holes: where the flanks that a fit along the rib is of have none, there is no crest
 * to be found, which is seen on 2 edges of 100; 4 of the same 11 are not by chance. */
static void crosses(double high, double noise)
{
    int missed = 0;
    struct vec3s p = rib_cloud(high, noise);
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2, .noise = noise};
    for (int i = -5; i <= 5; i++) {
        double y = 0.6 * i, x = -y * RIB_SIN / RIB_COS, part = 0.5 + 0.05 * i;
        struct vec3 a = rib_point(high, x - 0.6 * part, y);
        struct vec3 b = rib_point(high, x + 0.6 * (1 - part), y);
        struct crest c = crest_find(&cloud, a, b, vec(0, 0, 1));
        if (c.n == 0 || c.top < 0) {
            missed++;
            continue;
        }
        /* the neighbourhood is about the edge's own place, and the curve of the rib's flanks adds
         */
        ck_assert_double_le(fabs(rib_off(c.place[c.top])), rib_aside(noise));
        ck_assert_double_le(fabs(c.place[c.top].z - high), 0.02 + rib_fit_noise(noise));
        ck_assert_double_ge(vec_dot(c.normal[c.top], vec(0, 0, 1)),
                            cos(atan(0.36 + 6 * rib_slope_noise(noise))));
        for (int k = 0; k < c.n; k++)
            ck_assert_double_eq_tol(c.place[k].y, y, 0.05);
    }
    ck_assert_int_lt(missed, 4);
    point_grid_free(&scan);
    array_free(&p);
}

START_TEST(ribs)
{
    crosses(0.8, 0);
    crosses(0.8, 0.02);
}
END_TEST

START_TEST(grooves)
{
    crosses(-0.8, 0);
    crosses(-0.8, 0.02);
}
END_TEST

/* An edge five times as long as the rib is wide gets its feet too: points on the surface that leave
 * less than 0.15 mm between them. */
START_TEST(a_long_edge)
{
    struct vec3s p = rib_cloud(0.8, 0);
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2};
    struct vec3 a = rib_point(0.8, -2, 0.3), b = rib_point(0.8, 2, 0.3);
    struct crest c = crest_find(&cloud, a, b, vec(0, 0, 1));
    ck_assert_int_ge(c.n, 3);
    for (int k = 0; k <= c.n; k++) {
        struct vec3 from = k > 0 ? c.place[k - 1] : a, to = k < c.n ? c.place[k] : b;
        for (double s = 0; s <= 1; s += 0.1) {
            struct vec3 q = vec_mix(from, to, s);
            ck_assert_double_le(fabs(q.z - rib_point(0.8, q.x, q.y).z), 0.15);
        }
    }
    point_grid_free(&scan);
    array_free(&p);
}
END_TEST

/* Along the crest, where noise may pass for a bump but not leave the rib, beside it, and on a ball
 * of 5 mm radius. */
START_TEST(nothing_there)
{
    struct vec3s p = rib_cloud(0.8, 0.02), ball = {0};
    struct point_grid scan = sorted(&p, 0.2);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.2, .noise = 0.02};
    struct vec3 at = rib_point(0.8, 0, 0), on = rib_point(0.8, -0.6 * RIB_SIN, 0.6 * RIB_COS);
    struct crest along = crest_find(&cloud, at, on, vec(0, 0, 1));
    ck_assert_int_le(along.n, 1);
    for (int k = 0; k < along.n; k++)
        ck_assert_double_le(
            fabs(along.place[k].z - rib_point(0.8, along.place[k].x, along.place[k].y).z),
            0.02 + rib_fit_noise(0.02));
    ck_assert_int_eq(crest_find(&cloud, vec(2, 2, 0), vec(2.6, 2, 0), vec(0, 0, 1)).n, 0);
    point_grid_free(&scan);
    for (int i = 0; i < 2500; i++) {
        double x = 6 * uniform() - 3, y = 6 * uniform() - 3;
        *array_push(&ball) = vec(x, y, sqrt(25 - x * x - y * y));
    }
    scan = sorted(&ball, 0.12);
    cloud = (struct feature_cloud){.scan = &scan, .spacing = 0.12};
    ck_assert_int_eq(crest_find(&cloud, vec(-0.3, 0, 4.991), vec(0.3, 0, 4.991), vec(0, 0, 1)).n,
                     0);
    point_grid_free(&scan);
    array_free(&p);
    array_free(&ball);
}
END_TEST

/* Over the arch z^2 + x^2 = 9, whose points within `gap` of its top are missing. */
static struct crest over_arch(double gap)
{
    struct vec3s p = {0};
    for (int i = 0; i < 4000; i++) {
        double x = 5 * uniform() - 2.5, y = 6 * uniform() - 3;
        if (fabs(x) >= gap)
            *array_push(&p) = vec(x, y, sqrt(9 - x * x));
    }
    struct point_grid scan = sorted(&p, 0.1);
    struct feature_cloud cloud = {.scan = &scan, .spacing = 0.1};
    double x = 1.6, z = sqrt(9 - x * x);
    struct crest c = crest_find(&cloud, vec(-x, 0.3, z), vec(x, 0.3, z), vec(0, 0, 1));
    point_grid_free(&scan);
    array_free(&p);
    return c;
}

/* Where the scan has a gap nothing tells how high a crest is, and none is put there. */
START_TEST(nothing_over_a_gap)
{
    struct crest whole = over_arch(0), gap = over_arch(1.4);

    ck_assert_int_gt(whole.n, 0);
    for (int k = 0; k < whole.n; k++)
        ck_assert_double_eq_tol(hypot(whole.place[k].x, whole.place[k].z), 3, 0.05);
    for (int k = 0; k < gap.n; k++)
        ck_assert_double_ge(fabs(gap.place[k].x), 1.4 - 0.3);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("crest");
    TCase *tests = tcase_create("crest");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, ribs);
    tcase_add_test(tests, grooves);
    tcase_add_test(tests, a_long_edge);
    tcase_add_test(tests, nothing_there);
    tcase_add_test(tests, nothing_over_a_gap);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
