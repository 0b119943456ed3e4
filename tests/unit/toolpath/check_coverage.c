/* coverage and rest passes over shapes where it is known what a ball cuts and what it reaches. */
#include "toolpath/coverage.h"

#include <check.h>
#include <stdlib.h>

#include "chains.h"
#include "toolpath/rest_passes.h"

static const double R = 5;

static void add_row(struct vec3s *centre, struct sizes *end, struct vec3 from, struct vec3 to)
{
    for (int i = 0; i <= 40; i++)
        *array_push(centre) = vec_mix(from, to, i / 40.0);
    *array_push(end) = centre->n;
}

static struct coverage_options options_of(const struct gouge_check *guard)
{
    return (struct coverage_options){
        .guard = guard, .radius = R, .limit = 0.02, .near = 0.01, .tolerance = 0.01, .threads = 1};
}

/* Points every 0.25 mm on z(x, y) over a square of half width w. */
static struct vec3s points_on(double (*z)(double x, double y), double w)
{
    struct vec3s points = {0};

    for (double x = -w; x <= w + 1e-9; x += 0.25)
        for (double y = -w; y <= w + 1e-9; y += 0.25)
            *array_push(&points) = vec(x, y, z(x, y));
    return points;
}

static double flat(double x, double y)
{
    (void)x;
    (void)y;
    return 0;
}

/* Rows along x over a plane, d apart: half way the ball is sqrt(R^2 + d^2 / 4) - R off. */
START_TEST(rows_over_a_plane_leave_their_cusps)
{
    struct vec3s points = points_on(flat, 8), centre = {0};
    struct sizes end = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);

    for (double y = -8; y <= 8; y += 2)
        add_row(&centre, &end, vec(-8, y, R), vec(8, y, R));
    for (int wide = 0; wide < 2; wide++) {
        double cusp = sqrt(R * R + 1) - R;
        struct coverage *c = coverage_new(points.item, points.n, 1);
        options.limit = wide ? cusp + 0.002 : cusp - 0.002;
        options.near = options.limit / 2;
        coverage_cut(c, &options, &centre, &end);
        struct coverage_report r = coverage_report(c);
        ck_assert_uint_eq(r.points, points.n);
        ck_assert_uint_eq(r.out.n, 0);
        ck_assert_uint_eq(r.left.n, wide ? 0 : 8 * 65);
        if (!wide) {
            ck_assert_double_eq_tol(r.left.highest, cusp, 0.0011);
            ck_assert_double_eq_tol(r.left.area, 8 * 65 / 16.0, 0.3 * 8 * 65 / 16.0);
        }
        coverage_free(c);
    }
    gouge_free(guard);
    array_free(&points);
    array_free(&centre);
    array_free(&end);
}
END_TEST

/* A path that comes nowhere leaves all, with the distance as height; one that grows takes it
 * off. */
START_TEST(a_path_may_grow)
{
    struct vec3s points = points_on(flat, 4), centre = {0};
    struct sizes end = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    struct coverage *c = coverage_new(points.item, points.n, 1);

    add_row(&centre, &end, vec(-4, 0, R + 3), vec(4, 0, R + 3));
    coverage_cut(c, &options, &centre, &end);
    ck_assert_uint_eq(coverage_report(c).left.n, points.n);
    ck_assert_double_eq_tol(coverage_report(c).left.highest, hypot(R + 3, 4) - R, 0.002);
    for (double y = -4; y <= 4; y += 0.5)
        add_row(&centre, &end, vec(-4, y, R), vec(4, y, R));
    coverage_cut(c, &options, &centre, &end);
    ck_assert_uint_eq(coverage_report(c).left.n, 0);
    coverage_free(c);
    gouge_free(guard);
    array_free(&points);
    array_free(&centre);
    array_free(&end);
}
END_TEST

/* Something assumed half a millimetre over the middle of a plane keeps the ball off the points
 * about it, as far as it leans over them: sqrt(R^2 - (R - 0.5)^2).  The points alone would not. */
START_TEST(what_is_assumed_keeps_the_ball_off)
{
    struct vec3s points = points_on(flat, 6), centre = {0};
    struct sizes end = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    struct coverage *c = coverage_new(points.item, points.n, 1);
    const double reach = sqrt(R * R - (R - 0.5) * (R - 0.5));
    size_t n = points.n, kept = 0;

    *array_push(&points) = vec(0, 0, 0.5);
    struct gouge_check *assumed = gouge_from_points(points.item, points.n);
    options.assumed = assumed;
    add_row(&centre, &end, vec(-6, 0, R + 3), vec(6, 0, R + 3));
    coverage_cut(c, &options, &centre, &end);
    const struct coverage_point *p = coverage_points(c, &n);
    for (size_t i = 0; i < n; i++) {
        double far = hypot(p[i].p.x, p[i].p.y);
        kept += p[i].state == COVERAGE_KEPT;
        if (far < reach - 0.5) /* a ball that leans into the next point by the tolerance */
            ck_assert_int_eq(p[i].state, COVERAGE_KEPT);
        if (far > reach + 0.5)
            ck_assert_int_eq(p[i].state, COVERAGE_LEFT);
    }
    struct coverage_report r = coverage_report(c);
    ck_assert_uint_eq(r.kept.n, kept);
    ck_assert_uint_eq(r.left.n, n - kept);
    ck_assert_uint_eq(r.out.n, 0);
    coverage_free(c);
    gouge_free(guard);
    gouge_free(assumed);
    array_free(&points);
    array_free(&centre);
    array_free(&end);
}
END_TEST

/* A V of 90 degrees along x: the ball touches both sides at 45 degrees, R / sqrt(2) beside the
 * bottom and as high; what is nearer stays. */
static double valley(double x, double y)
{
    (void)x;
    return fabs(y);
}

START_TEST(the_bottom_of_a_valley_is_out_of_reach)
{
    struct vec3s points = points_on(valley, 8), centre = {0};
    struct sizes end = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    struct coverage *c = coverage_new(points.item, points.n, 1);
    size_t n;

    add_row(&centre, &end, vec(-8, 0, R * sqrt(2)), vec(8, 0, R * sqrt(2)));
    coverage_cut(c, &options, &centre, &end);
    const struct coverage_point *p = coverage_points(c, &n);
    for (size_t i = 0; i < n; i++) {
        if (fabs(p[i].p.x) > 4) /* the ball may come to the valley's ends from beyond */
            continue;
        double y = fabs(p[i].p.y), touch = R / sqrt(2), off = touch - y;
        double stays = sqrt(R * R + 2 * off * off) - R; /* along the flat side */
        if (y < touch - 0.5 && stays > options.limit + 0.01)
            ck_assert_int_eq(p[i].state, COVERAGE_OUT);
        if (p[i].state == COVERAGE_OUT)
            ck_assert_double_eq_tol(p[i].height, stays, 0.003);
        if (y > touch + 0.75)
            ck_assert_int_eq(p[i].state, COVERAGE_LEFT);
        if (p[i].state == COVERAGE_LEFT && y > touch + 0.75)
            ck_assert_double_lt(vec_angle(p[i].normal, vec(0, p[i].p.y > 0 ? -1 : 1, 1)), 0.1);
    }
    ck_assert_double_eq_tol(coverage_report(c).out.highest, R * (sqrt(2) - 1), 0.002);
    coverage_free(c);
    gouge_free(guard);
    array_free(&points);
    array_free(&centre);
    array_free(&end);
}
END_TEST

/* A slot 16 mm wide and 30 mm deep: the ball fits at its bottom, a holder of radius 12 from 15 mm
 * above it does not. */
static double slot(double x, double y)
{
    (void)x;
    return fabs(y) < 8 ? 0 : 30;
}

/* A slot along x: a shaft comes in upright or leaning along it, not leaning across it, where those
 * are all the axes that there are. */
START_TEST(a_holder_keeps_the_ball_from_the_bottom_of_a_slot)
{
    struct vec3s points = points_on(slot, 20), bottom = {0}, nowhere = {0};
    struct sizes end = {0};
    struct holder holder = {.n = 2, .part = {{R, R, 15}, {12, 12, 40}}};
    struct holder thin = {.n = 1, .part = {{R, R, 55}}};
    struct vec3 axis[] = {{0, 0.6, 0.8}, {0, -0.8, 0.6}, {0.6, 0, 0.8}};
    const struct {
        const struct holder *holder;
        size_t axes;
        bool comes;
    } is[] = {{NULL, 0, true},   {&holder, 0, false}, {&thin, 0, true},
              {&thin, 2, false}, {&thin, 3, true},    {&holder, 3, false}};

    for (double x = -20; x <= 20; x += 0.25)
        for (double z = 0.25; z < 30; z += 0.25)
            for (int side = -1; side <= 1; side += 2)
                *array_push(&points) = vec(x, 8 * side, z);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    for (double x = -2; x <= 2; x += 0.25)
        for (double y = -1; y <= 1; y += 0.25)
            *array_push(&bottom) = vec(x, y, 0);
    *array_push(&nowhere) = vec(0, 0, 100);
    for (size_t i = 0; i < sizeof is / sizeof *is; i++) {
        struct coverage *c = coverage_new(bottom.item, bottom.n, 1);
        options.holder = is[i].holder;
        options.axes = (struct vec3s){.n = is[i].axes, .item = axis};
        coverage_cut(c, &options, &nowhere, &end);
        ck_assert_uint_eq(coverage_report(c).out.n, is[i].comes ? 0 : bottom.n);
        coverage_free(c);
    }
    gouge_free(guard);
    array_free(&points);
    array_free(&bottom);
    array_free(&nowhere);
}
END_TEST

/* Strips over what is left, with the ball's centre off them by its radius, cut it. */
static double wave(double x, double y)
{
    return 2 * sin(x / 4) * cos(y / 5) +
           0.9 * y; /* falls off along y, too steep for rows along x */
}

/* A peak, z = -3 hypot(x, y), among obstacles here and there; points[0] is its top. */
static struct vec3s summit_among(int obstacles)
{
    struct vec3s points = {0};

    *array_push(&points) = vec(0, 0, 0);
    for (int i = -6; i <= 6; i++)
        for (int k = -6; k <= 6; k++)
            if (i || k)
                *array_push(&points) = vec(0.1 * i, 0.1 * k, -0.3 * hypot(i, k));
    for (int i = 0; i < obstacles; i++)
        *array_push(&points) = vec_scale(2 + 10 * chance(), random_unit());
    return points;
}

/* A ball that touches the top along d, and that goes out along d, is clear of all points. */
static bool goes_out(const struct vec3s *points, struct vec3 d)
{
    for (size_t i = 1; i < points->n; i++) {
        struct vec3 q = points->item[i];
        struct vec3 near = vec_segment_nearest(vec_scale(R, d), vec_scale(R + 30, d), q);
        if (vec_distance(near, q) < R)
            return false;
    }
    return true;
}

/* The whole cap of balls 0.3 radians about d touches and goes out; 160 directions over the sphere
 * are 0.28 apart, so that one of them is among it. */
static bool cap_goes_out(const struct vec3s *points, struct vec3 d)
{
    struct vec3 x = vec_unit(vec_cross(d, fabs(d.x) < 0.7 ? vec(1, 0, 0) : vec(0, 1, 0)));
    struct vec3 y = vec_cross(d, x);

    for (int ring = 0; ring <= 6; ring++)
        for (int k = 0; k < 6 * ring + 1; k++) {
            double a = 0.05 * ring, b = 2 * PI * k / (6 * ring + 1);
            struct vec3 aside = vec_along(vec_scale(cos(b), x), sin(b), y);
            if (!goes_out(points, vec_along(vec_scale(cos(a), d), sin(a), aside)))
                return false;
        }
    return true;
}

/* Where a ball touches from a whole cap of directions, far to the side as it may be, it is
 * found. */
START_TEST(a_ball_from_the_side_is_found)
{
    struct vec3s nowhere = {0};
    struct sizes end = {0};
    int reached = 0;

    seed = 2200;
    *array_push(&nowhere) = vec(0, 0, 1000);
    for (int scene = 0; scene < 400; scene++) {
        struct vec3s points = summit_among(3);
        bool open = false;
        for (int i = 0; i < 300 && !open; i++) {
            struct vec3 d = random_unit();
            open = d.z > 0.85 && cap_goes_out(&points, d);
        }
        struct gouge_check *guard = gouge_from_points(points.item, points.n);
        struct coverage_options options = options_of(guard);
        struct coverage *c = coverage_new(points.item, points.n, 1);
        size_t n;
        coverage_cut(c, &options, &nowhere, &end);
        if (open)
            ck_assert_int_eq(coverage_points(c, &n)[0].state, COVERAGE_LEFT);
        reached += open;
        coverage_free(c);
        gouge_free(guard);
        array_free(&points);
    }
    ck_assert_int_gt(reached, 20);
    array_free(&nowhere);
}
END_TEST

enum over { NOTHING, LEVEL, UPRIGHT };

/* What becomes of a summit's top among obstacles of which turning finds no way out, with a square
 * of points over all of it. */
static enum coverage_state top_under(enum over over)
{
    static const struct vec3 obstacle[] = {{-6.5, -1.8, 6.5}, {-0.2, 0.5, 4.5}, {1.4, -2.9, 2.2}};
    struct vec3s points = summit_among(0), nowhere = {0};
    struct sizes end = {0};
    size_t n;

    for (size_t i = 0; i < sizeof obstacle / sizeof *obstacle; i++)
        *array_push(&points) = obstacle[i];
    for (int i = -8; over != NOTHING && i <= 8; i++)
        for (int k = -8; k <= 8; k++)
            *array_push(&points) = over == LEVEL ? vec(0.5 * i, 0.5 * k, 2.5 * R)
                                                 : vec(0.5 * i, 0, 2.5 * R + 0.5 * (k + 8));
    *array_push(&nowhere) = vec(0, 0, 1000);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    struct coverage *c = coverage_new(points.item, points.n, 1);
    coverage_cut(c, &options, &nowhere, &end);
    enum coverage_state state = coverage_points(c, &n)[0].state;
    coverage_free(c);
    gouge_free(guard);
    array_free(&points);
    array_free(&nowhere);
    return state;
}

/* Under a part of the scan that faces up a ball is in the material, though it has room there; under
 * one that is upright it is not. */
START_TEST(a_ball_under_the_scan_is_none)
{
    ck_assert_int_eq(top_under(NOTHING), COVERAGE_LEFT);
    ck_assert_int_eq(top_under(LEVEL), COVERAGE_OUT);
    ck_assert_int_eq(top_under(UPRIGHT), COVERAGE_LEFT);
}
END_TEST

START_TEST(rest_passes_cut_what_is_left)
{
    struct vec3s points = points_on(wave, 10), centre = {0};
    struct sizes end = {0};
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct coverage_options options = options_of(guard);
    struct coverage *c = coverage_new(points.item, points.n, 1);
    struct rest_options rest = {.planes = vec(0, 1, 0), .step = 0.7, .gap = 2};
    size_t n;

    *array_push(&centre) = vec(0, 0, 100);
    coverage_cut(c, &options, &centre, &end);
    ck_assert_uint_eq(coverage_report(c).left.n, points.n);
    const struct coverage_point *p = coverage_points(c, &n);
    struct rest_strips strips = rest_passes_find(p, n, &rest);
    ck_assert_uint_gt(strips.n, 20);
    ck_assert_uint_lt(strips.n, 70); /* long ones: 20 mm by planes 0.7 mm apart */
    for (size_t i = 0; i < strips.n; i++) {
        const struct contacts *strip = &strips.item[i].contact;
        *array_push(&end) = centre.n;
        for (size_t k = 0; k < strip->n; k++) {
            double plane = vec_dot(strip->item[k].p, strips.item[i].planes) / rest.step;
            ck_assert_double_eq_tol(plane, round(plane), 1e-6);
            *array_push(&centre) = vec_along(strip->item[k].p, R, strip->item[k].n);
        }
    }
    coverage_cut(c, &options, &centre, &end);
    ck_assert_uint_lt(coverage_report(c).left.n, points.n / 200);
    ck_assert_double_lt(coverage_report(c).left.highest, 0.05);
    rest_strips_free(&strips);
    coverage_free(c);
    gouge_free(guard);
    array_free(&points);
    array_free(&centre);
    array_free(&end);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("coverage");
    TCase *tests = tcase_create("coverage");
    tcase_set_timeout(tests, 30);
    tcase_add_test(tests, rows_over_a_plane_leave_their_cusps);
    tcase_add_test(tests, a_path_may_grow);
    tcase_add_test(tests, what_is_assumed_keeps_the_ball_off);
    tcase_add_test(tests, the_bottom_of_a_valley_is_out_of_reach);
    tcase_add_test(tests, a_holder_keeps_the_ball_from_the_bottom_of_a_slot);
    tcase_add_test(tests, a_ball_from_the_side_is_found);
    tcase_add_test(tests, a_ball_under_the_scan_is_none);
    tcase_add_test(tests, rest_passes_cut_what_is_left);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
