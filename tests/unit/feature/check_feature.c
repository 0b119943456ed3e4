/* feature: creases of known planes, walls of known places, nothing on smooth surfaces. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "rough.h"

static struct feature_cloud cloud_of(const struct vec3s *p, size_t flat, double noise)
{
    static struct point_grid scan; /* one cloud at a time */
    struct error error;
    ck_assert_int_eq(point_grid_make(p->item, flat, 0.4, 1, &scan, &error), 0);
    return (struct feature_cloud){&scan,
                                  p->n > flat ? kdtree_new(p->item + flat, p->n - flat) : NULL,
                                  p->item + flat, 0.4, noise};
}

static void free_cloud(struct feature_cloud *c)
{
    point_grid_free((struct point_grid *)c->scan);
    if (c->walls)
        kdtree_free((struct kdtree *)c->walls);
}

/* How far the ridge of two planes with half of 72 noisy points each may be off: at the straight
 * side of a half disc a plane's height has 1 / 36 (1 + 0.18 / 0.07) of the noise's variance, and
 * where two of slope m meet is off by half their sum in height, and by half their difference over m
 * aside; five deviations. */
static double ridge_noise(double m, double sigma)
{
    return 5 * sigma * sqrt(1 + m * m) * sqrt(0.1) * sqrt((1 + 1 / (m * m)) / 2);
}

/* Looks for it at four places; returns at how many it was found. */
static int look_for_ridge(double m, double noise, double close, double turn)
{
    int found = 0;
    struct vec3s p = {0};
    rectangle(&p, 700, vec(0, 0, 5), vec(-10, 0, -10 * m), vec(0, 10, 0), noise);
    rectangle(&p, 700, vec(0, 0, 5), vec(10, 0, -10 * m), vec(0, 10, 0), noise);
    struct feature_cloud c = cloud_of(&p, p.n, noise);
    for (double x = 0.3; x < 1; x += 0.2) {
        struct vec3 a = vec(-x, 5, 5 - m * x), b = vec(1.2 - x, 5.3, 5 - m * (1.2 - x));
        struct feature f = feature_crease(&c, a, b, vec_unit(vec(-m * x / 2, 0, 1)),
                                          vec_unit(vec(m * (1.2 - x) / 2, 0, 1)));
        if (f.kind != FEATURE_CREASE)
            continue;
        ck_assert_double_le(hypot(f.place[0].x, f.place[0].z - 5), close);
        ck_assert_double_le(vec_distance(f.normal[0], vec_unit(vec(-m, 0, 1))), turn);
        ck_assert_double_le(vec_distance(f.normal[1], vec_unit(vec(m, 0, 1))), turn);
        ck_assert_double_ge(fabs(f.along.y), 0.99);
        found++;
    }
    free_cloud(&c);
    array_free(&p);
    return found;
}

/* Roofs along y of this slope, and valleys: the place is on the ridge, the normals are those of the
 * planes, though the vertices' own are those of one smooth surface over both.  In noise one of
 * twenty may look bent: each of three tests refuses what is 2.5 deviations off.  The four places of
 * a cloud share their points, so that of its 8 clouds 0.4 are refused, 0.6 deviation: 3 at most. */
START_TEST(roofs_and_valleys)
{
    static const double slope[] = {0.2, 0.5, -0.5, 1.2, -1};
    const double sigma = 0.02, tilt = sigma / (sqrt(36) * 0.265 * 1.8);
    for (int i = 0; i < 5; i++) {
        int found = 0;
        ck_assert_int_eq(look_for_ridge(slope[i], 0, 1e-6, 1e-6), 4);
        for (int k = 0; k < 8; k++)
            found += look_for_ridge(slope[i], sigma, ridge_noise(slope[i], sigma), 5 * tilt * 1.6);
        ck_assert_int_ge(found, 4 * (8 - 3));
    }
}
END_TEST

/* A wall 6 mm high; without points on it there is none. */
START_TEST(walls)
{
    for (int i = 0; i < 3; i++) {
        double noise = i == 1 ? 0.02 : 0, close = i == 1 ? 0.05 : 1e-6;
        struct vec3s p = {0};
        rectangle(&p, 700, vec(0, 0, 0), vec(-10, 0, 0), vec(0, 10, 0), noise);
        rectangle(&p, 700, vec(0, 0, 6), vec(10, 0, 0), vec(0, 10, 0), noise);
        size_t flat = p.n;
        rectangle(&p, i == 2 ? 0 : 400, vec(0, 0, 0), vec(0, 10, 0), vec(0, 0, 6), noise);
        struct feature_cloud c = cloud_of(&p, flat, noise);
        for (double x = 0.2; x < 1.2; x += 0.3) {
            struct feature f = feature_wall(&c, vec(1.2 - x, 5, 6), vec(-x, 5.4, 0));
            ck_assert_int_eq(f.kind, i == 2 ? FEATURE_NONE : FEATURE_WALL);
            if (i == 2)
                continue;
            ck_assert_double_le(hypot(f.place[0].x, f.place[0].z - 6), close);
            ck_assert_double_le(hypot(f.place[1].x, f.place[1].z), close);
            ck_assert_double_lt(f.wall.x, -0.9);
            ck_assert_double_ge(f.normal[0].z, 0.99);
        }
        free_cloud(&c);
        array_free(&p);
    }
}
END_TEST

/* Points of a wall in columns lie on a plane to the last digit: here one turned by 12 degrees. */
START_TEST(wall_of_columns)
{
    const double lean = 0.21255656167002213; /* tan 12 degrees */
    struct vec3s p = {0};
    for (int i = 0; i < 84; i++)
        for (int k = 0; k < 21; k++) {
            double y = i * 0.476 - 20;
            *array_push(&p) = vec(-10 + k * 0.47 - lean * y, y, 0);
            *array_push(&p) = vec(0.5 + k * 0.47 - lean * y, y, 6);
        }
    size_t flat = p.n;
    for (int i = 0; i < 84; i++)
        for (int k = 0; k < 13; k++)
            *array_push(&p) = vec(-lean * (i * 0.476 - 20), i * 0.476 - 20, k * 0.5);
    struct feature_cloud c = cloud_of(&p, flat, 0);
    for (int i = 0; i < 30; i++) {
        double y = i - 15.3;
        struct feature f =
            feature_wall(&c, vec(0.8 - lean * y, y, 6), vec(-0.8 - lean * y, y + 0.2, 0));
        ck_assert_int_eq(f.kind, FEATURE_WALL);
        ck_assert_double_le(fabs(f.place[0].x + lean * f.place[0].y), 1e-9);
    }
    free_cloud(&c);
    array_free(&p);
}
END_TEST

/* A sphere of 5 mm, its spacing 0.4: no crease between vertices 16 degrees apart, and no wall on
 * its steep flank. */
START_TEST(nothing_on_a_sphere)
{
    struct vec3s p = {0};
    for (int i = 0; i < 1000; i++) {
        double z = uniform(), a = 2 * PI * uniform(), r = sqrt(1 - z * z);
        *array_push(&p) = vec(5 * r * cos(a), 5 * r * sin(a), 5 * z);
    }
    struct feature_cloud c = cloud_of(&p, p.n, 0);
    for (int i = 0; i < 60; i++) {
        double z = 0.2 + 0.7 * uniform(), a = 2 * PI * uniform(), r = sqrt(1 - z * z);
        struct vec3 n = vec(r * cos(a), r * sin(a), z);
        struct vec3 m = vec_turn(n, vec_perpendicular(n), RADIANS(16));
        struct vec3 low = vec_unit(vec(n.x, n.y, fmax(n.z - 0.3, 0.05)));
        ck_assert_int_eq(feature_crease(&c, vec_scale(5, n), vec_scale(5, m), n, m).kind,
                         FEATURE_NONE);
        ck_assert_int_eq(feature_wall(&c, vec_scale(5, n), vec_scale(5, low)).kind, FEATURE_NONE);
    }
    free_cloud(&c);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature");
    TCase *tests = tcase_create("feature");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, roofs_and_valleys);
    tcase_add_test(tests, walls);
    tcase_add_test(tests, wall_of_columns);
    tcase_add_test(tests, nothing_on_a_sphere);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
