/*
 * check_deviation_map - the ball rolled over a dome, a bowl and the panel, all known exactly: a
 * path that goes so deep, or stays so far off, is measured as it is.
 */
#include <check.h>
#include <stdlib.h>

#include "panel.h"
#include "simulate/deviation_map.h"
#include "seed.h"

#define RADIUS 6.0

struct place {
    struct vec3 p, n;
};

/* A sphere of radius 40 from above, and one of radius 25 from within. */
static struct place dome(double x, double y)
{
    struct vec3 n = vec(x / 40, y / 40, sqrt(1600 - x * x - y * y) / 40);
    return (struct place){vec_scale(40, n), n};
}

static struct place bowl(double x, double y)
{
    struct vec3 n = vec(-x / 25, -y / 25, sqrt(625 - x * x - y * y) / 25);
    return (struct place){vec_scale(-25, n), n};
}

static struct place panel(double x, double y)
{
    const double h = 1e-5;
    double zx = (panel_height(x + h, y) - panel_height(x - h, y)) / (2 * h);
    double zy = (panel_height(x, y + h) - panel_height(x, y - h)) / (2 * h);
    return (struct place){vec(x, y, panel_height(x, y)), vec_unit(vec(-zx, -zy, 1))};
}

static struct place (*const surfaces[])(double, double) = {dome, bowl, panel};

/* Passes 0.5 mm apart, the ball's centre `off` mm further from the surface than its radius. */
static struct centre_path path_over(struct place (*surface)(double, double), double off)
{
    struct centre_path path = {0};
    for (int row = -16; row <= 16; row++)
        for (int k = -60; k < 60; k++) {
            struct place a = surface(k * 0.15, row * 0.5), b = surface((k + 1) * 0.15, row * 0.5);
            struct vec3 from = vec_along(a.p, RADIUS + off, a.n);
            struct vec3 to = vec_along(b.p, RADIUS + off, b.n);
            *array_push(&path) =
                (struct centre_segment){from, to, {0, 1}, (unsigned)row + 16, false};
        }
    return path;
}

static struct vec3s points_on(struct place (*surface)(double, double), double half)
{
    struct vec3s points = {0};
    for (int i = -40; i <= 40; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = surface(half * i / 40, half * k / 40).p;
    return points;
}

static struct deviation_map roll(struct centre_path *path, const struct vec3s *points, int threads)
{
    struct deviation_map_options setup = {RADIUS, 0.01, 1.5, threads, false, HUGE_VAL};
    struct deviation_map result;
    deviation_map_run(path, points->item, points->n, &setup, &result);
    return result;
}

START_TEST(depth_is_what_it_is)
{
    static const double depth[] = {0.05, 0.2, 0};
    for (size_t i = 0; i < sizeof depth / sizeof *depth; i++) {
        struct centre_path path = path_over(surfaces[_i], -depth[i]);
        struct vec3s points = points_on(surfaces[_i], 7.5);
        struct deviation_map r = roll(&path, &points, 1);
        ck_assert_uint_eq(r.cut, points.n);
        ck_assert_double_lt(fabs(r.gouge - depth[i]), 0.002);
        ck_assert_uint_eq(r.gouged, depth[i] > 0 ? points.n : 0);
        /* a scallop takes a little away from the depth between two passes */
        ck_assert_double_le(r.gouge_part[0], depth[i] + 0.002);
        ck_assert_double_ge(r.gouge_part[0], depth[i] - 0.012);
        deviation_map_free(&r);
        array_free(&path);
        array_free(&points);
    }
}
END_TEST

START_TEST(what_is_left_is_what_it_is)
{
    struct centre_path path = path_over(surfaces[_i], 0.03);
    struct vec3s points = points_on(surfaces[_i], 11.5);
    struct deviation_map r = roll(&path, &points, 1);
    ck_assert_double_lt(r.gouge, 1e-6);
    ck_assert_double_ge(r.over, 0.03);
    ck_assert_double_lt(r.over, 0.03 + 0.012); /* and half a step's scallop */
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        if (fabs(p.x) > 8 || fabs(p.y) > 7.4)
            continue;
        ck_assert(r.region[i]);
        ck_assert_double_ge(r.deviation[i], 0.03 - 0.002);
    }
    deviation_map_free(&r);
    array_free(&path);
    array_free(&points);
}
END_TEST

START_TEST(scallop_of_the_dome)
{
    /* between two passes s apart: the distance on the sphere of the centres, by its angle */
    struct centre_path path = path_over(dome, 0);
    struct vec3 between = dome(0, 0.25).p, centre = vec_scale(46, dome(0, 0).n);
    double angle = vec_angle(between, centre);
    double truth = sqrt(40 * 40 + 46 * 46 - 2 * 40 * 46 * cos(angle)) - RADIUS;
    struct vec3s points = {0};
    *array_push(&points) = between;
    struct deviation_map r = roll(&path, &points, 1);
    ck_assert_double_lt(fabs(r.deviation[0] - truth), 0.0001);
    deviation_map_free(&r);
    array_free(&path);
    array_free(&points);
}
END_TEST

START_TEST(beside_is_not_cut)
{
    struct centre_path path = path_over(surfaces[_i], 0);
    struct vec3s points = points_on(surfaces[_i], 11.5);
    struct deviation_map r = roll(&path, &points, 1);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        bool in = fabs(p.x) < 8.5 && fabs(p.y)<7.5, out = fabs(p.x)> 9.6 || fabs(p.y) > 8.6;
        if (in)
            ck_assert(r.region[i]);
        if (out)
            ck_assert(!r.region[i]);
    }
    ck_assert_double_lt(r.over, 0.012);
    deviation_map_free(&r);
    array_free(&path);
    array_free(&points);
}
END_TEST

START_TEST(threads_change_nothing)
{
    struct centre_path path = path_over(surfaces[_i], -0.02);
    struct vec3s points = points_on(surfaces[_i], 11);
    struct deviation_map one = roll(&path, &points, 1), four = roll(&path, &points, 4);
    for (size_t i = 0; i < points.n; i++) {
        ck_assert(one.deviation[i] == four.deviation[i]);
        ck_assert(one.region[i] == four.region[i]);
    }
    deviation_map_free(&one);
    deviation_map_free(&four);
    array_free(&path);
    array_free(&points);
}
END_TEST

static double wave_height(double x, double y)
{
    return 2 * sin(x / 5) * cos(y / 6);
}

static double saddle_height(double x, double y)
{
    return (x * x - y * y) / 60;
}

static double ridge_height(double x, double y)
{
    double s = (x * 0.8 + y * 0.6) / 2.6;
    return 0.8 * exp(-s * s);
}

static double dome_height(double x, double y)
{
    return sqrt(3600 - x * x - y * y);
}

static double bowl_height(double x, double y)
{
    return -sqrt(900 - x * x - y * y);
}

static double (*const heights[])(double, double) = {wave_height,  saddle_height, ridge_height,
                                                    panel_height, bowl_height,   dome_height};

/* Where the ball's centre is meant to be over x in a pass: some passes too deep, some too high. */
static struct vec3 centre_over(int kind, double radius, double x, int row)
{
    const double h = 1e-5, y = row * 0.6;
    double (*z)(double, double) = heights[kind];
    struct vec3 n = vec_unit(
        vec((z(x - h, y) - z(x + h, y)) / (2 * h), (z(x, y - h) - z(x, y + h)) / (2 * h), 1));
    double off = 0.03 * sin(1.7 * row) + 0.02 * sin(0.9 * x);
    return vec_along(vec(x, y, z(x, y)), radius + off, n);
}

/* How far p is from the passes, by a search along each: no segments, no tree. */
static double truth_of(int kind, double radius, struct vec3 p)
{
    double best = HUGE_VAL;
    for (int row = -14; row <= 14; row++) {
        if (fabs(row * 0.6 - p.y) > 3)
            continue;
        double at = 0, nearest = HUGE_VAL, step = 0.25;
        for (double x = fmax(p.x - 4, -9); x <= fmin(p.x + 4, 9); x += step) {
            double d = vec_distance(p, centre_over(kind, radius, x, row));
            at = d < nearest ? x : at;
            nearest = fmin(nearest, d);
        }
        for (; step > 1e-4; step /= 2) {
            double low = vec_distance(p, centre_over(kind, radius, fmax(at - step, -9), row));
            double high = vec_distance(p, centre_over(kind, radius, fmin(at + step, 9), row));
            at = low < fmin(nearest, high) ? fmax(at - step, -9)
                 : high < nearest          ? fmin(at + step, 9)
                                           : at;
            nearest = fmin(nearest, fmin(low, high));
        }
        best = fmin(best, nearest);
    }
    return best;
}

static int rising(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

enum { SCATTERED = 400 };

/* Six surfaces, two balls each, points at random: all figures within 0.002 mm of the truth. */
START_TEST(figures_are_those_of_the_truth)
{
    static const double share[] = {0.50, 0.95, 0.99};
    const int kind = _i / 2;
    const double radius = _i % 2 ? 8 : 5;
    struct centre_path path = {0};
    struct vec3s points = {0};
    double truth[SCATTERED];
    unsigned seed = 77 + (unsigned)_i;
    for (int row = -14; row <= 14; row++)
        for (int k = -450; k < 450; k++)
            *array_push(&path) =
                (struct centre_segment){centre_over(kind, radius, k * 0.02, row),
                                        centre_over(kind, radius, (k + 1) * 0.02, row),
                                        {0, 1},
                                        (unsigned)row + 14,
                                        false};
    for (int i = 0; i < SCATTERED; i++) {
        double xy[2];
        for (int k = 0; k < 2; k++) {
            seed = seed * 1664525 + seed_step_32();
            xy[k] = 6.0 * (seed >> 8) / 8388608 - 6;
        }
        struct vec3 p = vec(xy[0], xy[1], heights[kind](xy[0], xy[1]));
        *array_push(&points) = p;
        truth[i] = truth_of(kind, radius, p) - radius;
    }
    struct deviation_map_options setup = {radius, 0.02, 1.2, 1, false, HUGE_VAL};
    struct deviation_map r;
    deviation_map_run(&path, points.item, points.n, &setup, &r);
    for (int i = 0; i < SCATTERED; i++)
        ck_assert_double_eq_tol(r.deviation[i], truth[i], 0.0005);
    /* of points so scattered a few are not among places that the ball touches, as chance has it */
    size_t n = 0;
    for (int i = 0; i < SCATTERED; i++)
        if (r.region[i])
            truth[n++] = truth[i];
    ck_assert_uint_eq(r.cut, n);
    ck_assert_uint_ge(n, SCATTERED - SCATTERED / 100);
    qsort(truth, n, sizeof *truth, rising);
    ck_assert_double_eq_tol(r.gouge, fmax(0, -truth[0]), 0.002);
    ck_assert_double_eq_tol(r.over, fmax(0, truth[n - 1]), 0.002);
    for (int k = 0; k < DEVIATION_MAP_PERCENTILES; k++) {
        /* the point of that rank, by whichever of the usual rules, or one beside it */
        size_t rank = (size_t)(share[k] * (double)n), over = rank + 1 < n ? rank + 1 : n - 1;
        ck_assert_double_ge(r.over_part[k], fmax(0, truth[rank - 1]) - 0.002);
        ck_assert_double_le(r.over_part[k], fmax(0, truth[over]) + 0.002);
        ck_assert_double_ge(r.gouge_part[k], fmax(0, -truth[n - rank]) - 0.002);
        ck_assert_double_le(r.gouge_part[k], fmax(0, -truth[n - 1 - over]) + 0.002);
    }
    deviation_map_free(&r);
    array_free(&path);
    array_free(&points);
}
END_TEST

/* Passes along x, 1 mm apart, over a square of +-10, turned about Z; points of a plane on a larger
 * one, which the ball misses by a tenth. */
START_TEST(among_passes_and_beside_them)
{
    double turn = _i * 0.37, c = cos(turn), s = sin(turn);
    struct deviation_map_options options = {4.9, 0.05, 0.6, 1, false, HUGE_VAL};
    struct centre_path path = {0};
    struct vec3s points = {0};
    struct deviation_map map;
    for (int row = -10; row <= 10; row++)
        for (int k = -20; k < 20; k++) {
            double x0 = k * 0.5, x1 = x0 + 0.5, y = row;
            struct vec3 a = vec(c * x0 - s * y, s * x0 + c * y, 5);
            struct vec3 b = vec(c * x1 - s * y, s * x1 + c * y, 5);
            *array_push(&path) = (struct centre_segment){a, b, {0, 1}, 0, false};
        }
    for (double x = -13; x <= 13; x += 0.37)
        for (double y = -13; y <= 13; y += 0.41)
            *array_push(&points) = vec(c * x - s * y, s * x + c * y, 0);
    deviation_map_run(&path, points.item, points.n, &options, &map);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        double out = fmax(fabs(c * p.x + s * p.y), fabs(c * p.y - s * p.x)) - 10;
        if (out < -2.3) /* cuts are seen 2.29 around it */
            ck_assert(map.region[i]);
        if (out > 0.6)
            ck_assert(!map.region[i]);
    }
    deviation_map_free(&map);
    array_free(&path);
    array_free(&points);
}
END_TEST

/* Passes along x, 2 mm apart, that touch a plane over a square of +-10: more stays between them
 * than may.  So it does on points beside the square that the ball comes near to, which are none of
 * the region though it comes within the tolerance of them. */
START_TEST(near_but_beside)
{
    struct deviation_map_options options = {5, 0.05, 0.6, 1, false, 0.02};
    struct centre_path path = {0};
    struct vec3s points = {0};
    struct deviation_map map;
    for (int row = -10; row <= 10; row += 2)
        for (int x = -10; x < 10; x++)
            *array_push(&path) =
                (struct centre_segment){vec(x, row, 5), vec(x + 1, row, 5), {0, 1}, 0, false};
    for (double x = -12; x <= 12; x += 0.23)
        for (double y = -12; y <= 12; y += 0.19)
            *array_push(&points) = vec(x, y, 0);
    deviation_map_run(&path, points.item, points.n, &options, &map);
    for (size_t i = 0; i < points.n; i++) {
        struct vec3 p = points.item[i];
        double out = fmax(fabs(p.x), fabs(p.y)) - 10;
        if (out < -2.5)
            ck_assert(map.region[i]);
        if (out > sqrt(2 * 5 * 0.02) + 0.01) /* more stays on it than may */
            ck_assert(!map.region[i]);
    }
    ck_assert_double_gt(map.over, 0.09);
    deviation_map_free(&map);
    array_free(&path);
    array_free(&points);
}
END_TEST

/* Rows along x on a plane, two by two joined by a half circle beyond the border, turned about Z and
 * leaned: a point between two of these, further out than all of them, is beside the cuts. */
START_TEST(beside_loops_of_rows)
{
    enum { ARC = 8 };
    const double turn = _i * 0.41, lean = 0.2 * (_i % 4), step = 1.4, radius = 3;
    const struct vec3 u = vec(cos(turn), sin(turn), 0);
    const struct vec3 v = vec(-sin(turn) * cos(lean), cos(turn) * cos(lean), sin(lean));
    const struct vec3 n = vec_cross(u, v);
    struct deviation_map_options options = {radius, 0.05, 0.75, 1, false, HUGE_VAL};
    struct centre_path path = {0};
    struct vec3s points = {0}, place = {0};
    struct deviation_map map;
    for (int row = -6; row <= 6; row++) {
        double y = row * step, way = row % 2 ? -1 : 1;
        for (double x = 0; x <= 10; x += 0.5)
            *array_push(&place) = vec(way > 0 ? x : 10 - x, y, radius);
        for (int k = 1; k < ARC; k++) {
            double a = PI * k / ARC;
            *array_push(&place) = vec((way > 0 ? 10 : 0) + way * step / 2 * sin(a),
                                      y + step / 2 * (1 - cos(a)), radius);
        }
    }
    for (size_t i = 1; i < place.n; i++) {
        struct vec3 p = place.item[i - 1], q = place.item[i];
        struct vec3 a = vec_along(vec_along(vec_scale(p.x, u), p.y, v), p.z, n);
        struct vec3 b = vec_along(vec_along(vec_scale(q.x, u), q.y, v), q.z, n);
        *array_push(&path) = (struct centre_segment){a, b, {0, 1}, 0, false};
    }
    for (double x = -4; x <= 14; x += 0.13)
        for (double y = -6; y <= 6; y += 0.17)
            *array_push(&points) = vec_along(vec_scale(x, u), y, v);
    deviation_map_run(&path, points.item, points.n, &options, &map);
    for (size_t i = 0; i < points.n; i++) {
        double x = vec_dot(points.item[i], u);
        if (x > 1 && x < 9) /* between rows more is left than may be: at their ends nobody knows */
            ck_assert(map.region[i]);
        if (x < -step / 2 - 0.6 || x > 10 + step / 2 + 0.6)
            ck_assert(!map.region[i]);
    }
    deviation_map_free(&map);
    array_free(&path);
    array_free(&points);
    array_free(&place);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("deviation_map");
    TCase *tcase = tcase_create("deviation_map");
    tcase_add_loop_test(tcase, depth_is_what_it_is, 0, 3);
    tcase_add_loop_test(tcase, what_is_left_is_what_it_is, 0, 3);
    tcase_add_test(tcase, scallop_of_the_dome);
    tcase_add_loop_test(tcase, beside_is_not_cut, 0, 3);
    tcase_add_loop_test(tcase, among_passes_and_beside_them, 0, 17);
    tcase_add_test(tcase, near_but_beside);
    tcase_add_loop_test(tcase, beside_loops_of_rows, 0, 12);
    tcase_add_loop_test(tcase, threads_change_nothing, 0, 3);
    tcase_add_loop_test(tcase, figures_are_those_of_the_truth, 0, 12);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
