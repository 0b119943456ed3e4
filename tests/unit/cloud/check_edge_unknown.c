/* edge_unknown: the crest of a blade with one or two points across is told, and how far it may go
 * on; and so are the upright edges at the end of a fin, a rib narrower than the points are apart,
 * and the corners of a post; a roof, whose sides are known, an even scan, a mesa, whose wall is
 * guarded, and a single point that is astray are not.  What is told is guarded as far. */
#include <check.h>
#include <stdlib.h>

#include "edge_trial.h"
#include "noisy.h"

/* A ring of a blade 1.4 mm wide at its foot. */
static const double RADIUS = 6, HIGH = 3;

static double ring(double x, double y)
{
    return fmax(0, HIGH - HIGH / 0.7 * fabs(hypot(x - 0.13, y + 0.07) - RADIUS));
}

/* It stands alone, turned, and ends: 1.6 mm thick at its foot, 0.4 at its top. */
static double fin(double x, double y)
{
    double u = 0.97 * x + 0.24 * y - 0.31, v = 0.97 * y - 0.24 * x + 0.17;
    return fmax(0, fmin(5, fmin(5 - (fabs(u) - 0.2) * 8, 5 - (fabs(v) - 6) * 4)));
}

static double rib(double x, double y)
{
    return fabs(0.97 * x + 0.24 * y - 0.31) < 0.16 ? 0.8 : 0;
}

/* A post, three-cornered: 50 and 65 degrees. */
static double post(double x, double y)
{
    double u = 0.97 * x + 0.24 * y - 0.31, v = 0.97 * y - 0.24 * x + 0.17;
    return u > -3 && fabs(v) < 0.4663 * (3 - u) ? HIGH : 0;
}

/* The same, lower, on a slope, its top as steep. */
static double post_on_slope(double x, double y)
{
    return 0.35 * x + 0.1 * y + 0.6 * post(x, y);
}

/* So high that no neighbour of a point of its top is at its foot. */
static double high_post(double x, double y)
{
    return 4 * post(x, y);
}

/* Of corners of 90 degrees. */
static double block_on_slope(double x, double y)
{
    double u = 0.97 * x + 0.24 * y - 0.31, v = 0.97 * y - 0.24 * x + 0.17;
    return 0.35 * x + 0.1 * y + (fmax(fabs(u), fabs(v)) < 4 ? 1.8 : 0);
}

static double mesa(double x, double y)
{
    return edge_trial_side(x, y) > 0.07 ? HIGH : 0;
}

static double even(double x, double y)
{
    return (x * x - y * y) / 60;
}

/* The top of a cone, rounded by 1.4 mm. */
static double round_cone(double x, double y)
{
    return 6 - 1.4 * sqrt(x * x + y * y + 4);
}

/* One point of the grid stands out. */
static double astray(double x, double y)
{
    return fabs(x - 1) < 0.1 && fabs(y - 1) < 0.1 ? 1 : even(x, y);
}

/* What is told of a scan of the shape. */
static struct edge_gaps told(double (*height)(double, double), bool lines, double sigma)
{
    struct edge_trial trial;
    struct edge_gaps gaps;
    struct vec3s to = {0};

    edge_trial_make(&trial, height, lines, sigma);
    edge_points(&trial.options, &to, &gaps);
    array_free(&to);
    edge_trial_free(&trial);
    return gaps;
}

START_TEST(thin_ring)
{
    struct edge_gaps gaps = told(ring, _i, 0);
    struct vec3 at = gaps.unknown_at;

    ck_assert_uint_ge(gaps.unknown, 2);
    ck_assert_double_le(fabs(hypot(at.x - 0.13, at.y + 0.07) - RADIUS), 0.7);
    /* no further than the side goes on until it is over the next point on the other side */
    ck_assert_double_ge(gaps.depth, HIGH - at.z);
}
END_TEST

/* Some point that is told is within 1.5 mm of the edge's end as seen from above. */
START_TEST(ends_and_corners)
{
    static const struct {
        double (*height)(double, double);
        double u, v; /* half of what it measures */
    } of[] = {{fin, 0.5, 6.5}, {rib, 0.16, 12}, {post, 3, 2.8}};
    struct edge_gaps gaps = told(of[_i / 2].height, _i % 2, 0);
    double x = gaps.unknown_at.x, y = gaps.unknown_at.y;
    double u = fabs(0.97 * x + 0.24 * y - 0.31), v = fabs(0.97 * y - 0.24 * x + 0.17);

    ck_assert_uint_gt(gaps.unknown, 0);
    ck_assert_double_gt(gaps.depth, 0);
    ck_assert_double_le(fabs(u - of[_i / 2].u), 1.5);
    ck_assert(v <= of[_i / 2].v + 1.5);
}
END_TEST

/* A corner of 50 degrees is a spur, on a slope, too, where the foot up from it is little lower; a
 * square one is none. */
START_TEST(spurs)
{
    ck_assert_uint_gt(told(post, _i, 0).spurs, 0);
    ck_assert_uint_gt(told(post_on_slope, _i, 0).spurs, 0);
    ck_assert_uint_gt(told(high_post, _i, 0).spurs, 0);
    ck_assert_uint_eq(told(block_on_slope, _i, 0).spurs, 0);
}
END_TEST

/* Points of a ring are one feature each two spacings about, those of a post's corners one each. */
START_TEST(features)
{
    struct edge_gaps on_ring = told(ring, _i, 0), of_post = told(post, _i, 0);

    ck_assert_uint_gt(on_ring.features, 0);
    ck_assert_uint_lt(2 * on_ring.features, on_ring.unknown);
    ck_assert_uint_ge(of_post.features, 1);
    ck_assert_uint_le(of_post.features, 3);
}
END_TEST

/* Lowest place of a ball of 2.5 mm straight above (x, y) that is clear of all points. */
static double rests(const struct vec3s *point, double x, double y)
{
    const double radius = 2.5;
    double low = -HUGE_VAL;

    for (size_t i = 0; i < point->n; i++) {
        struct vec3 p = point->item[i];
        double off2 = (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
        if (off2 < radius * radius)
            low = fmax(low, p.z + sqrt(radius * radius - off2) - radius);
    }
    return low;
}

/* A ball along a rib narrower than the points are apart stays on top of it, which by the points
 * alone it would not. */
START_TEST(rib_is_guarded)
{
    struct edge_trial trial;
    struct edge_gaps gaps;
    struct vec3s all = {0};
    double deepest = 0, bare = 0;

    edge_trial_make(&trial, rib, false, 0);
    for (size_t i = 0; i < trial.grid.n; i++)
        *array_push(&all) = trial.grid.point[i];
    for (double v = -7; v <= 7; v += 0.1)
        bare = fmax(bare, 0.8 - rests(&all, 0.97 * 0.31 - 0.24 * v, 0.24 * 0.31 + 0.97 * v));
    edge_points(&trial.options, &all, &gaps);
    for (double v = -7; v <= 7; v += 0.1)
        deepest = fmax(deepest, 0.8 - rests(&all, 0.97 * 0.31 - 0.24 * v, 0.24 * 0.31 + 0.97 * v));
    ck_assert_double_gt(bare, 0.03);
    ck_assert_double_le(deepest, 0.2 * 0.2 / (8 * 2.5) + 1e-9); /* between places 0.2 mm apart */
    array_free(&all);
    edge_trial_free(&trial);
}
END_TEST

START_TEST(nothing_told)
{
    static double (*const of[])(double, double) = {edge_trial_roof, mesa, even, astray};
    struct edge_gaps gaps = told(of[_i / 2], false, _i % 2 ? 0.02 : 0);

    ck_assert_uint_eq(gaps.unknown, 0);
}
END_TEST

/* Points of much noise, measured a little too small, stand out of a smooth surface by three sigmas,
 * but for no edge. */
START_TEST(noise_is_none)
{
    enum { POINTS = 6000, WIDE = 16 };
    static double (*const of[])(double, double) = {round_cone, even};
    const double sigma = 0.02 + 0.01 * (_i / 2), measured = 0.8;
    struct vec3s scan = {0}, to = {0};
    struct edge_trial trial;
    struct edge_gaps gaps;

    noisy_seed(21 + (unsigned)_i);
    for (int i = 0; i < POINTS; i++) {
        double x = WIDE * (noisy_uniform() - 0.5), y = WIDE * (noisy_uniform() - 0.5);
        *array_push(&scan) = vec(x, y, of[_i % 2](x, y) + sigma * noisy_normal());
    }
    edge_trial_of(&trial, scan, WIDE / sqrt(POINTS), measured * sigma);
    edge_points(&trial.options, &to, &gaps);
    ck_assert_uint_eq(gaps.unknown, 0);
    array_free(&to);
    edge_trial_free(&trial);
}
END_TEST

/* A cliff that winds from border to border of a scan whose border is ragged. */
START_TEST(ragged_border_is_none)
{
    const double pitch = 0.4, ragged = 0.15;
    struct vec3s scan = {0}, to = {0};
    struct edge_trial trial;
    struct edge_gaps gaps;

    noisy_seed(31 + (unsigned)_i);
    for (int j = -20; j <= 20; j++)
        for (int i = -20; i <= 20; i++) {
            double x = pitch * i + ragged * (2 * noisy_uniform() - 1);
            double y = pitch * j + ragged * (2 * noisy_uniform() - 1);
            double z = 4 * tanh(1.2 * x + 2 * sin(y / 4) + 6 - _i) + sin(y) / 2;
            *array_push(&scan) = vec(x, y, z);
        }
    edge_trial_of(&trial, scan, pitch, 0);
    edge_points(&trial.options, &to, &gaps);
    ck_assert_uint_eq(gaps.unknown, 0);
    array_free(&to);
    edge_trial_free(&trial);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_unknown");
    TCase *tests = tcase_create("edge_unknown");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, thin_ring, 0, 2);
    tcase_add_loop_test(tests, ends_and_corners, 0, 6);
    tcase_add_loop_test(tests, spurs, 0, 2);
    tcase_add_loop_test(tests, features, 0, 2);
    tcase_add_test(tests, rib_is_guarded);
    tcase_add_loop_test(tests, nothing_told, 0, 8);
    tcase_add_loop_test(tests, noise_is_none, 0, 6);
    tcase_add_loop_test(tests, ragged_border_is_none, 0, 12);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
