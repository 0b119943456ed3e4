/* ridge_direction: the way a noisy rib runs is found from a bad guess, and how high it is. */
#include <check.h>
#include <stdlib.h>

#include "math/kdtree.h"
#include "ribs.h"
#include "math/ridge_direction.h"

enum { SOME = 48 };

/* Degrees from the way to the one found, about z. */
static double degrees_from(struct vec3 along, struct vec3 way)
{
    double turn = vec_dot(along, way) < 0 ? -1 : 1;
    return 180 / PI * asin(turn * vec_cross(along, way).z);
}

/* Of so many places: degrees off and their squares, squares of mm off the crest, mm about it. */
struct looks {
    double n, sum, squares, off, rms;
};

/* From a way 5 degrees beside the one that was found, to either side, one as good is found. */
static void followed(const struct vec3 *near, size_t n, struct vec3 at,
                     const struct ridge_direction *found)
{
    const struct vec3 up = {0, 0, 1}, side = vec_cross(up, found->way);
    for (int i = -1; i <= 1; i++) {
        double turn = i * PI / 36;
        struct vec3 way = vec_along(vec_scale(cos(turn), found->way), sin(turn), side);
        struct ridge_direction rib;
        ck_assert(ridge_direction_follow(near, n, at, up, way, SOME, &rib));
        ck_assert_double_le(rib.rms, found->rms * (1 + 1e-6));
    }
}

/* At nine places along the crest, from guesses 15 degrees to either side of its way. */
static void look_along(double noise, struct looks *looks)
{
    const struct vec3 along = {-RIB_SIN, RIB_COS, 0}, across = {RIB_COS, RIB_SIN, 0};
    struct vec3s p = rib_cloud(0.8, noise);
    struct kdtree *tree = kdtree_new(p.item, p.n);
    for (int i = -4; i <= 4; i++) {
        struct vec3 at = vec_along(vec(0, 0, 0.8), i * 0.7, along);
        double turn = (i % 2 ? -15 : 15) * PI / 180;
        struct vec3 guess = vec_along(vec_scale(cos(turn), along), sin(turn), across);
        size_t index[RIDGE_DIRECTION_LONGER * SOME];
        struct vec3 near[RIDGE_DIRECTION_LONGER * SOME];
        struct ridge_direction rib;
        size_t n = kdtree_nearest(tree, at, RIDGE_DIRECTION_LONGER * SOME, index, NULL);
        for (size_t k = 0; k < n; k++)
            near[k] = p.item[index[k]];
        ck_assert(ridge_direction_find(near, n, at, vec(0, 0, 1), guess, SOME, &rib));
        followed(near, n, at, &rib);
        double degrees = degrees_from(along, rib.way);
        looks->n++;
        looks->sum += degrees;
        looks->squares += degrees * degrees;
        looks->off += rib.q.c[0] * rib.q.c[0];
        looks->rms += rib.rms;
    }
    kdtree_free(tree);
    array_free(&p);
}

enum { CLOUDS = 24 };

/* Over many clouds: the way within `degrees` in the quadratic mean, and to neither side (four
 * deviations of the mean, where three places share a neighbourhood); the crest is where it is, but
 * for 0.015 that a quadric is too flat for it, and noise of which 4 / n of the variance is left at
 * the middle; the points are about it as the noise has them. */
static void look(double noise, double degrees)
{
    struct looks looks = {0};
    for (int i = 0; i < CLOUDS; i++)
        look_along(noise, &looks);
    ck_assert_double_le(sqrt(looks.squares / looks.n), degrees);
    ck_assert_double_le(fabs(looks.sum / looks.n), 4 * degrees / sqrt(looks.n / 3));
    ck_assert_double_le(sqrt(looks.off / looks.n), 0.015 + noise * sqrt(4.0 / SOME));
    ck_assert_double_le(looks.rms / looks.n, 0.01 + noise);
}

/* In the mean half as far off as the guesses: of directions 5 degrees apart one of the three about
 * the best, which that is by the random points about, is 2.5 + 5 off at most. */
START_TEST(way_of_a_rib)
{
    look(0, 7.5);
}
END_TEST

/* Noise hides the way of a rib that is no narrower than that, but in the mean it is nearer than the
 * guesses were. */
START_TEST(noisy_rib)
{
    look(0.02, 15);
}
END_TEST

START_TEST(too_few_points)
{
    const struct vec3 near[5] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    struct ridge_direction rib;
    ck_assert(!ridge_direction_find(near, 5, near[0], vec(0, 0, 1), vec(1, 0, 0), 5, &rib));
}
END_TEST

/* ---- which points a neighbourhood along a line has, against an exhaustive count */

enum { POINTS = 400, TAKEN = 40 };

/* As lengths count: along `way` a third of them. */
static double counted(struct vec3 p, struct vec3 at, struct vec3 way)
{
    struct vec3 off = vec_sub(p, at);
    double along = vec_dot(off, way);
    return hypot(vec_length(vec_along(off, -along, way)), along / 3);
}

START_TEST(taken)
{
    struct vec3 p[POINTS], found[TAKEN], at = vec(5, 5, 1), way = vec_unit(vec(2, -1, 0.5));
    double farthest = 0, last = 0;
    size_t nearer = 0;
    for (int i = 0; i < POINTS; i++)
        p[i] = vec(10 * uniform(), 10 * uniform(), 2 * uniform());
    ck_assert_uint_eq(neighbourhood_along(p, POINTS, at, way, 3, TAKEN, found), TAKEN);
    for (int i = 0; i < TAKEN; i++) {
        farthest = fmax(farthest, counted(found[i], at, way));
        last = fmax(last, vec_distance(found[i], at));
    }
    for (int i = 0; i < POINTS; i++)
        nearer += counted(p[i], at, way) <= farthest * (1 + 1e-12);
    ck_assert_uint_eq(nearer, TAKEN);
    ck_assert(vec_distance(found[TAKEN - 1], at) == last);
    ck_assert_uint_eq(neighbourhood_along(p, 7, at, way, 3, TAKEN, found), 7);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ridge_direction");
    TCase *tests = tcase_create("ridge_direction");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, way_of_a_rib);
    tcase_add_test(tests, noisy_rib);
    tcase_add_test(tests, too_few_points);
    tcase_add_test(tests, taken);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
