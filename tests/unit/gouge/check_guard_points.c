/* guard_points against a sphere: its points stay on it, the ball does not sink between them, noise
 * is found and taken out, holes and rough places stay. */
#include "gouge/guard_points.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "gouge/gouge.h"
#include "io/cloud/cloud.h"
#include "math/kdtree.h"
#include "cloud/noise.h"
#include "cloud/settle.h"
#include "seed.h"

static const double SPHERE = 40, BALL = 8, VAGUE = 0.01, HOLE = 6;

static uint64_t state = 11;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static double gauss(double sigma)
{
    double u = uniform(1e-12, 1), v = uniform(0, 1);
    return sigma * sqrt(-2 * log(u)) * cos(2 * PI * v);
}

static bool is_inside(struct vec3 p, double half)
{
    return fabs(p.x) <= half && fabs(p.y) <= half;
}

/* Random points on the top of the sphere, 30 mm square, none nearer to (hole, 0) than HOLE. */
static void sphere(size_t n, double noise, double hole, struct vec3s *points)
{
    while (points->n < n) {
        double x = uniform(-15, 15), y = uniform(-15, 15);
        if (hypot(x - hole, y) < HOLE)
            continue;
        struct vec3 p = vec(x, y, sqrt(SPHERE * SPHERE - x * x - y * y));
        *array_push(points) = vec_scale(1 + gauss(noise) / SPHERE, p);
    }
}

static double noise_taken;
static bool edged;

/* Sorts the points. */
static struct guard_points surface_for(struct vec3s *points, double noise, double radius)
{
    struct guard_points_options rule = {
        .radius = radius, .sink = 0.002, .noise = noise, .edged = edged, .vague = VAGUE};
    struct point_grid point_grid;
    struct error error;
    ck_assert_int_eq(point_grid_make(points->item, points->n, 0.5, 1, &point_grid, &error), 0);
    if (noise < 0) { /* as found */
        struct noise found = noise_measure(&point_grid, 1);
        rule.noise = found.alike && found.sigma > 0.005 ? found.sigma : 0;
    }
    noise_taken = rule.noise;
    struct guard_points surface = guard_points_of_scan(&point_grid, &rule);
    point_grid_free(&point_grid);
    array_free(&surface.certain);
    array_free(&surface.doubtful);
    return surface;
}

static struct guard_points surface_of(struct vec3s *points, double noise)
{
    return surface_for(points, noise, BALL);
}

/* The deepest that a ball sinks which touches the sphere, at 2000 places off the border. */
static double deepest_sink(const struct vec3 *point, size_t n)
{
    struct gouge_check *guard = gouge_from_points(point, n);
    double deepest = 0;
    for (int i = 0; i < 2000; i++) {
        struct vec3 c = vec_unit(vec(uniform(-12, 12), uniform(-12, 12), SPHERE));
        double distance = gouge_distance(guard, vec_scale(SPHERE + BALL, c), HUGE_VAL);
        deepest = fmax(deepest, distance - BALL);
    }
    gouge_free(guard);
    return deepest;
}

START_TEST(what_is_sparse_is_filled)
{
    struct vec3s points = {0};
    sphere(1500, 0, 100, &points); /* 0.8 mm apart in the mean */
    double before = deepest_sink(points.item, points.n);
    struct guard_points s = surface_of(&points, -1);
    double after = deepest_sink(s.point.item, s.point.n);
    ck_assert_double_gt(before, 0.02);
    ck_assert_double_lt(after, 0.005);
    ck_assert(noise_taken == 0);
    ck_assert_uint_eq(s.moved, 0);
    ck_assert_uint_eq(s.vague, 0);
    ck_assert_double_lt(s.worst, 0.003);
    ck_assert_uint_eq(s.point.n, points.n + s.added);
    for (size_t i = 0; i < s.point.n; i++) /* beyond the border as sure as any surface: VAGUE */
        ck_assert_double_eq_tol(vec_length(s.point.item[i]), SPHERE,
                                is_inside(s.point.item[i], 15) ? 0.003 : VAGUE);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Two scans of a sphere, as far apart from each other as no surface may be off its points here: one
 * half way between them stands between their points, if it is said to, as well as few points
 * tell. */
START_TEST(two_sheets_are_filled)
{
    const double apart = 0.018;
    double sinks[2];

    for (int said = 0; said < 2; said++) {
        struct vec3s points = {0};
        struct point_grid point_grid;
        struct error error;
        struct guard_points_options rule = {
            .radius = BALL, .sink = 0.0005, .vague = VAGUE, .apart = said ? apart / 2 : 0};
        sphere(700, 0, 100, &points);
        size_t half = points.n;
        sphere(2 * half, 0, 100, &points);
        for (size_t i = half; i < points.n; i++)
            points.item[i] = vec_scale(1 + apart / SPHERE, points.item[i]);
        ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &point_grid, &error), 0);
        struct guard_points s = guard_points_of_scan(&point_grid, &rule);
        sinks[said] = deepest_sink(s.point.item, s.point.n);
        ck_assert_uint_eq(s.moved, 0);
        point_grid_free(&point_grid);
        array_free(&s.certain);
        array_free(&s.doubtful);
        array_free(&points);
        array_free(&s.point);
    }
    ck_assert_double_gt(sinks[0], 0.02);
    ck_assert_double_lt(sinks[1], 0.012);
}
END_TEST

static struct vec3 swell(double x, double y)
{
    return vec(x, y, 4 * sin(2 * PI * x / 20) * cos(2 * PI * y / 30));
}

static struct vec3 swell_normal(double x, double y)
{
    double u = 4 * 2 * PI / 20 * cos(2 * PI * x / 20) * cos(2 * PI * y / 30);
    double v = -4 * 2 * PI / 30 * sin(2 * PI * x / 20) * sin(2 * PI * y / 30);
    return vec_unit(vec(-u, -v, 1));
}

/*
 * How far a surface through points about a place may be off there.  Among them it is off the wave
 * by what a cubic leaves out, the fourth derivative, 4 (a^2 + b^2)^2 at most for
 * 4 sin(a x) cos(b y), times the fourth power of their distance by 4!; by noise as far as any of
 * them, five deviations.
 * A point is put where the surface is as sure as VAGUE.
 */
static double surface_off(const struct point_grid *scan, struct vec3 place, double noise)
{
    enum { ABOUT = 20 };
    static const double FOURTH =
        4 * (4 * PI * PI / 400 + 4 * PI * PI / 900) * (4 * PI * PI / 400 + 4 * PI * PI / 900);
    struct vec3 near[ABOUT];
    double reach = 0;
    size_t n = point_grid_near(scan, place, ABOUT, near);
    for (size_t k = 0; k < n; k++)
        reach = fmax(reach, hypot(near[k].x - place.x, near[k].y - place.y));
    return VAGUE + FOURTH / 24 * pow(reach, 4) + 5 * noise;
}

/* A wave as hollow as 2.5 mm, points anywhere, so that there are holes of 2 mm, and gaps of 1 mm at
 * its border.  How deep a ball of 2 mm goes at places of the wave, by how far it may there, with
 * what is put between the points or without.  In a corner the place is not among its points. */
static double deepest_in_wave(double noise, bool filled)
{
    struct vec3s points = {0}, scan = {0};
    struct point_grid grid;
    struct error error;
    while (points.n < 8900) {
        double x = uniform(-20, 20), y = uniform(-20, 20), off = noise > 0 ? gauss(noise) : 0;
        *array_push(&points) = vec_along(swell(x, y), off, swell_normal(x, y));
    }
    for (size_t i = 0; i < points.n; i++)
        *array_push(&scan) = points.item[i];
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.5, 1, &grid, &error), 0);
    struct guard_points s = surface_for(&points, noise, 2);
    struct gouge_check *guard =
        filled ? gouge_from_points(s.point.item, s.point.n) : gouge_from_points(scan.item, scan.n);
    double deepest = 0;
    for (double x = -19.9; x < 20; x += 0.1) {
        for (double y = -19.9; y < 20; y += 0.1) {
            if (fmin(fabs(x), fabs(y)) > 18)
                continue;
            struct vec3 c = vec_along(swell(x, y), 2, swell_normal(x, y));
            double sink = gouge_distance(guard, c, HUGE_VAL) - 2;
            deepest = fmax(deepest, sink / surface_off(&grid, swell(x, y), noise));
        }
    }
    gouge_free(guard);
    point_grid_free(&grid);
    array_free(&points);
    array_free(&scan);
    array_free(&s.point);
    return deepest;
}

START_TEST(holes_and_gaps_of_a_border_are_bridged)
{
    ck_assert_double_gt(deepest_in_wave(0, false), 1.5);
    ck_assert_double_lt(deepest_in_wave(0, true), 1);
    ck_assert_double_lt(deepest_in_wave(0.01, true), 1);
}
END_TEST

/* A ripple of 0.3 mm every 6 mm under points 0.7 mm apart, flat for x < 0; also where some noise,
 * which is much less, is taken out of it. */
START_TEST(what_is_too_sparse_is_told)
{
    struct vec3s points = {0};
    for (double x = -12; x < 12; x += 0.7)
        for (double y = -12; y < 12; y += 0.7)
            *array_push(&points) = vec(x, y, x > 0 ? 0.3 * (1 - cos(x * PI / 3)) : 0);
    struct guard_points s = surface_of(&points, _i * 0.002);
    ck_assert_uint_gt(s.vague, 10);
    ck_assert_uint_lt(s.vague, points.n / 2);
    ck_assert_double_gt(s.worst, 0.01);
    ck_assert_double_gt(s.at.x, -2);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Lines 3 mm apart with points every 0.7: the gap is that from line to line. */
START_TEST(the_gap_is_that_between_lines)
{
    struct vec3s points = {0};
    for (double y = -15; y < 15; y += 3)
        for (double x = -15; x < 15; x += 0.7)
            *array_push(&points) = vec(x + 0.1 * sin(70 * x + y), y, 2 * cos(y / 2));
    struct guard_points s = surface_for(&points, 0, 6);
    ck_assert_uint_gt(s.vague, 0);
    ck_assert_double_gt(s.gap, 2.9);
    ck_assert_double_lt(s.gap, 3.8);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

START_TEST(noise_is_found_and_taken_out)
{
    static const double noises[] = {0.01, 0.02, 0.05};
    for (int k = 0; k < 3; k++) {
        struct vec3s points = {0};
        double noise = noises[k], sum2 = 0, worst = 0, filled = 0;
        sphere(4000, noise, 100, &points);
        struct guard_points s = surface_of(&points, -1);
        ck_assert_double_eq_tol(noise_taken, noise, 0.1 * noise);
        ck_assert_uint_gt(s.moved, points.n * 98 / 100);
        size_t inside = 0;
        /* noise may look like a sharp edge, which stands out: in one scan of thirty, one point */
        ck_assert_uint_le(s.edges, 3);
        for (size_t i = 0; i < points.n + s.added; i++) {
            struct vec3 p = s.point.item[i];
            if (fabs(p.x) > 13 || fabs(p.y) > 13)
                continue;
            double off = fabs(vec_length(p) - SPHERE);
            sum2 += off * off;
            if (i < points.n || s.edges == 0)
                worst = fmax(worst, off);
            else
                filled = fmax(filled, off);
            inside++;
        }
        /* the one in fifty that may stay where it is keeps its noise: within five deviations; what
         * is filled beside such an edge goes up to it, no further than a point is moved: six */
        ck_assert_double_lt(sqrt(sum2 / (double)inside), 0.35 * noise);
        ck_assert_double_lt(worst, 5 * noise);
        ck_assert_double_lt(filled, 6 * noise);
        array_free(&points);
        array_free(&s.point);
    }
}
END_TEST

/* Waves as high as six noises and no longer than the neighbourhoods that smooth them: where the
 * judge's own, smaller ones see more of them, the ball is kept clear of that. */
START_TEST(no_shape_is_smoothed_over)
{
    const double sigma = 0.02;
    struct vec3s points = {0};
    struct point_grid grid;
    struct error error;
    for (int i = 0; i < 6000; i++) {
        double x = uniform(-15, 15), y = uniform(-15, 15);
        *array_push(&points) = vec(x, y, 0.12 * sin(2 * x) * cos(2.2 * y) + gauss(sigma));
    }
    ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &grid, &error), 0);
    struct guard_points surface = surface_of(&points, sigma);
    struct gouge_check *guard = gouge_from_points(surface.point.item, surface.point.n);
    for (size_t i = 0; i < grid.n; i++) {
        struct vec3 settled = settle_point(&grid, sigma, grid.point[i]);
        ck_assert_double_le(gouge_distance(guard, settled, HUGE_VAL), 1.0001 * sigma);
    }
    gouge_free(guard);
    point_grid_free(&grid);
    array_free(&surface.point);
    array_free(&surface.certain);
    array_free(&surface.doubtful);
    array_free(&points);
}
END_TEST

START_TEST(noise_that_is_said_counts)
{
    struct vec3s points = {0};
    sphere(4000, 0.02, 100, &points);
    struct guard_points none = surface_of(&points, 0), said = surface_of(&points, 0.02);
    ck_assert_uint_eq(none.moved, 0);
    for (size_t i = 0, at = 0; i < points.n; i++, at++) { /* all are there, in their order */
        while (at < none.point.n && vec_distance(none.point.item[at], points.item[i]) > 0)
            at++;
        ck_assert_uint_lt(at, none.point.n);
    }
    ck_assert_uint_gt(said.moved, points.n * 98 / 100);
    array_free(&points);
    array_free(&none.point);
    array_free(&said.point);
}
END_TEST

/*
 * A surface through the nearest of a point at the rim reaches as far as sixteen of them: with 1.67
 * points to a mm2 on its one side, by five standard deviations, no farther than 4.45 mm (2.6 r^2 -
 * 5 sqrt(2.6 r^2) = 16).  What is put there is on the sphere.
 */
START_TEST(a_hole_stays)
{
    struct vec3s points = {0};
    sphere(1500, 0, 4, &points);
    struct guard_points s = surface_of(&points, -1);
    for (size_t i = 0; i < s.point.n; i++) {
        ck_assert_double_gt(hypot(s.point.item[i].x - 4, s.point.item[i].y), HOLE - 4.45);
        ck_assert_double_eq_tol(vec_length(s.point.item[i]), SPHERE, VAGUE);
    }
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Here and there so many points lie by chance as on something smooth: about two neighbourhoods of
 * a scan (21 seeds), nine by five deviations, and none is wider than 4 mm, 13 mm2, however many
 * points are put there.  Cells of 1 mm2 of 900. */
START_TEST(what_is_rough_stays_as_it_is)
{
    struct vec3s points = {0};
    bool filled[30 * 30] = {false};
    int cells = 0;
    for (int i = 0; i < 5000; i++) {
        double x = uniform(-15, 15), y = uniform(-15, 15);
        *array_push(&points) = vec(x, y, 0.4 * sin(3 * x) * cos(4 * y));
    }
    struct guard_points s = surface_of(&points, -1);
    ck_assert(noise_taken == 0);
    ck_assert_uint_eq(s.moved, 0);
    ck_assert_uint_eq(s.point.n, points.n + s.added);
    for (size_t i = points.n; i < s.point.n; i++) {
        int x = (int)fmin(fmax(s.point.item[i].x + 15, 0), 29);
        int y = (int)fmin(fmax(s.point.item[i].y + 15, 0), 29);
        cells += !filled[30 * y + x];
        filled[30 * y + x] = true;
    }
    ck_assert_int_le(cells, 9 * 13);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Facets that touch a paraboloid 3 mm apart, and meet at 8 degrees. */
static double facets(double x, double y)
{
    double cx = 3 * round(x / 3), cy = 3 * round(y / 3);

    return (cx * cx + cy * cy - 2 * (cx * x + cy * y)) / 43;
}

/* Points of them, as noisy; how many are moved, points put between, and what part of all is below
 * the facets by more than `deep`. */
static double below_facets(double sigma, double deep, struct guard_points *s, struct vec3s *points)
{
    double below = 0, n = 0;

    for (int j = -30; j <= 30; j++)
        for (int i = -30; i <= 30; i++) {
            double x = 0.5 * i + 0.2, y = 0.5 * j + 0.1;
            *array_push(points) = vec(x, y, facets(x, y) + gauss(sigma));
        }
    *s = surface_for(points, sigma, 2.5);
    for (size_t i = 0; i < s->point.n; i++) {
        struct vec3 p = s->point.item[i];
        n += is_inside(p, 12);
        below += is_inside(p, 12) && facets(p.x, p.y) - p.z > deep;
    }
    return below / n;
}

/* Where the noise that is known explains facets, and no smooth surface, points are moved to these:
 * a surface that bends is below an edge, and so were one in 28 points by 0.02 mm and more.  With
 * more noise it is by all of the scan that they are told from smooth shapes. */
START_TEST(blunt_edges_stand_in_noise)
{
    struct vec3s points = {0};
    struct guard_points s;

    edged = _i == 0;
    double below = below_facets(_i == 0 ? 0.01 : 0.015, 0.02 + 0.008 * _i, &s, &points);
    edged = false;
    ck_assert_uint_gt(s.moved, points.n * 9 / 10);
    ck_assert_uint_gt(s.added, 5 * points.n);
    ck_assert_double_lt(below, 0.01);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* The guard of a scan keeps a ball off that would be `deep` in at p, where this is the normal. */
static bool is_kept_off(const struct gouge_check *guard, struct vec3 p, struct vec3 normal,
                        double radius, double deep)
{
    return gouge_distance(guard, vec_along(p, radius - deep, vec_unit(normal)), HUGE_VAL) < radius;
}

/* Of places on the edges of a pyramid with noise those where the guard keeps a ball off that would
 * be `deep` in; *by_scan: where its points alone do. */
static int kept_off_edges(double sigma, double deep, int places, int *by_scan)
{
    struct vec3s points = {0};
    int kept = 0;

    for (int j = -24; j <= 24; j++)
        for (int i = -24; i <= 24; i++) {
            double x = 0.5 * i + uniform(-0.25, 0.25), y = 0.5 * j + uniform(-0.25, 0.25);
            *array_push(&points) = vec(x, y, fmax(0, 8 - fmax(fabs(x), fabs(y))) + gauss(sigma));
        }
    struct guard_points s = surface_for(&points, sigma, 2.5);
    struct gouge_check *guard = gouge_from_points(s.point.item, s.point.n);
    struct gouge_check *scan = gouge_from_points(points.item, points.n);
    for (int i = 0; i < places; i++) {
        double x = uniform(0.2, 7.6), u = i % 2 ? 1 : -1, v = i % 4 < 2 ? 1 : -1;
        struct vec3 at = vec(u * x, v * x, 8 - x), out = vec(u, v, 2); /* between two normals */
        kept += is_kept_off(guard, at, out, 2.5, deep);
        *by_scan += is_kept_off(scan, at, out, 2.5, deep);
    }
    gouge_free(guard);
    gouge_free(scan);
    array_free(&points);
    array_free(&s.point);
    return kept;
}

/* A pyramid whose noise is known by its sides: its edges are found by that down to their feet, and
 * a ball that is deep in one is kept off; the points alone let it in, and so did facets at one in
 * two hundred places. */
START_TEST(sharp_edges_stand_in_noise)
{
    enum { SCANS = 4, PLACES = 1000 };
    int kept = 0, by_scan = 0;

    edged = true;
    for (int i = 0; i < SCANS; i++)
        kept += kept_off_edges(0.01 + 0.01 * (i % 2), 0.05 + 0.02 * (i % 2), PLACES, &by_scan);
    edged = false;
    ck_assert_int_ge(kept, SCANS * PLACES - SCANS);
    ck_assert_int_lt(by_scan, SCANS * PLACES * 6 / 10);
}
END_TEST

static double wedge(double x)
{
    return fmax(0, fmin(5 + 0.4 * x, 5 - 6 * x));
}

/* Points anywhere leave gaps on a flank of 80 degrees, whose points have those of the floor about
 * them sooner than each other: it is filled, and a ball kept off all over it. */
START_TEST(steep_flanks_are_filled_over_gaps)
{
    enum { POINTS = 2401, PLACES = 2000 };
    int kept = 0;

    state = (uint64_t)_i;
    struct vec3s points = {0};
    for (int i = 0; i < POINTS; i++) {
        double x = uniform(-12, 12);
        *array_push(&points) = vec(x, uniform(-12, 12), wedge(x));
    }
    struct guard_points s = surface_for(&points, 0, 2.5);
    struct gouge_check *guard = gouge_from_points(s.point.item, s.point.n);
    for (int i = 0; i < PLACES; i++) {
        double x = uniform(0.05, 0.4);
        kept += is_kept_off(guard, vec(x, uniform(-10, 10), wedge(x)), vec(6, 0, 1), 2.5, 0.02);
    }
    ck_assert_int_eq(kept, PLACES);
    gouge_free(guard);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

static double ridge(double x)
{
    return 10 / (1 + x * x / 25);
}

/* A noise of less than a hundredth of what the points are apart, as of coordinates rounded, hides
 * no edge that is guarded without it. */
START_TEST(faint_noise_hides_no_edges)
{
    enum { PLACES = 2000 };
    int kept = 0;

    struct vec3s points = {0};
    for (double y = -15; y <= 15; y += 1.33)
        for (double x = -15 + 0.665; x <= 15; x += 1.33)
            *array_push(&points) = vec(x, y, ridge(x));
    struct guard_points s = surface_for(&points, _i == 0 ? 0 : 0.003, 3.76);
    struct gouge_check *guard = gouge_from_points(s.point.item, s.point.n);
    for (int i = 0; i < PLACES; i++) {
        double x = uniform(-6, 6), z = ridge(x);
        struct vec3 normal = vec(2 * x * z * z / 250, 0, 1);
        kept += is_kept_off(guard, vec(x, uniform(-12, 12), z), normal, 3.76, 0.1);
    }
    ck_assert_int_eq(kept, PLACES);
    gouge_free(guard);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* A steep pyramid on a grid 1.26 mm apart, its ridges on points, which have the surface of one side
 * of these alone: the other side is filled, too, and keeps a small ball off beside the ridges. */
START_TEST(both_sides_of_points_on_a_ridge)
{
    const double ball = 0.5, deep = 0.06, pitch = 1.26, steep = 1.5;
    struct vec3s points = {0};

    for (int j = -10; j < 10; j++)
        for (int i = -10; i < 10; i++)
            *array_push(&points) =
                vec(pitch * i, pitch * j, -steep * pitch * (abs(i) > abs(j) ? abs(i) : abs(j)));
    struct guard_points s = surface_for(&points, 0, ball);
    struct gouge_check *guard = gouge_from_points(s.point.item, s.point.n);
    struct vec3 out = vec_unit(vec(steep, 0, 1)); /* of the side towards x */
    for (double x = 1.8; x < 9; x += 0.09)
        for (double beside = 0.1; beside < 0.8; beside += 0.1)
            for (int turn = 0; turn < 8; turn++) {
                double u = turn & 1 ? -1 : 1, v = turn & 2 ? -1 : 1;
                struct vec3 p = vec_along(vec(x, x - beside, -steep * x), ball - deep, out);
                p = turn & 4 ? vec(u * p.y, v * p.x, p.z) : vec(u * p.x, v * p.y, p.z);
                ck_assert_double_lt(gouge_distance(guard, p, HUGE_VAL), ball);
            }
    gouge_free(guard);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Ribs three rows of points wide, whose noise is known by their sides alone: where no other surface
 * is as usual, their walls count.  A ball that would be deep in a rim is kept off, which the points
 * alone let in, and it is told that rims are not resolved. */
START_TEST(walls_stand_in_noise)
{
    const double ball = 1, pitch = 0.6, deep = 0.2;
    struct vec3s points = {0};
    int kept = 0, by_scan = 0, places = 0;

    for (int j = -12; j <= 12; j++)
        for (int i = -20; i <= 20; i++) {
            double x = pitch * (i + 0.5 * (j & 1)), off = fabs(remainder(x, 5.5));
            *array_push(&points) =
                vec(x, pitch * j, fmax(-1.1, fmin(0, 5 * (0.7 - off))) + gauss(0.02));
        }
    edged = true;
    struct guard_points s = surface_for(&points, 0.02, ball);
    edged = false;
    struct gouge_check *guard = gouge_from_points(s.point.item, s.point.n);
    struct gouge_check *scan = gouge_from_points(points.item, points.n);
    for (double y = -6; y < 6; y += 0.05)
        for (int side = -1; side <= 1; side += 2) {
            struct vec3 out = vec_unit(vec(side, 0, 0.3));
            struct vec3 at = vec_along(vec(0.7 * side, y, 0), ball - deep, out);
            kept += gouge_distance(guard, at, HUGE_VAL) < ball;
            by_scan += gouge_distance(scan, at, HUGE_VAL) < ball;
            places++;
        }
    ck_assert_int_eq(kept, places);
    ck_assert_int_lt(by_scan, places);
    ck_assert_uint_gt(s.gaps.n, 0);
    gouge_free(guard);
    gouge_free(scan);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

/* Crossed grooves that leave pyramids 2.5 mm wide; a rough ground. */
static double knurl(double x, double y)
{
    double u = x - 2.5 * round(x / 2.5), v = y - 2.5 * round(y / 2.5);

    return 1.25 - fmax(fabs(u), fabs(v));
}

static double ground(double x, double y)
{
    return 0.4 * sin(2 * x) * cos(1.7 * y) + 0.2 * sin(4.3 * x + 2 * y) + gauss(0.06);
}

/* Sharp edges of five points a side that noise hides, where that is taken as none for it cannot be
 * told from the shape: they are told, and those of rough ground are not, for it has none. */
START_TEST(hidden_edges_are_suspected)
{
    struct vec3s points = {0};
    struct error error;
    struct point_grid point_grid;

    for (int j = -24; j <= 24; j++)
        for (int i = -24; i <= 24; i++) {
            double x = 0.5 * i + uniform(-0.25, 0.25), y = 0.5 * j + uniform(-0.25, 0.25);
            *array_push(&points) = vec(x, y, _i % 2 ? ground(x, y) : knurl(x, y) + gauss(0.02));
        }
    ck_assert_int_eq(point_grid_make(points.item, points.n, 0.5, 1, &point_grid, &error), 0);
    const struct guard_points_options rule = {
        .radius = 2.5, .sink = 0.002, .rough = _i < 2 ? 0.09 : 0, .vague = VAGUE};
    struct guard_points s = guard_points_of_scan(&point_grid, &rule);
    if (_i == 0)
        ck_assert_uint_gt(s.gaps.unknown, points.n / 200);
    else
        ck_assert_uint_le(s.gaps.unknown, points.n / 1000);
    point_grid_free(&point_grid);
    array_free(&points);
    array_free(&s.point);
    array_free(&s.certain);
    array_free(&s.doubtful);
}
END_TEST

/* One in some points of half a face, with noise. */
static void sparse_face(unsigned one_in, double noise, struct vec3s *points)
{
    struct cloud_count count = {0};
    struct error error;
    size_t kept = 0;

    ck_assert_int_eq(cloud_read("samples/face_nefertiti_26493.xyz", 1, points, &count, &error), 0);
    for (size_t i = 0; i < points->n; i++)
        if (points->item[i].x > 0 && uniform(0, one_in) < 1)
            points->item[kept++] =
                vec_add(points->item[i], vec(gauss(noise), gauss(noise), gauss(noise)));
    points->n = kept;
}

/* Noise bends what is seen of a steep flank to anything, and makes crests as steep as anything:
 * what is taken to be there stays near to what was scanned.  The face's rims are 12 mm high. */
START_TEST(nothing_is_far_from_the_scan)
{
    const double far = 13.5;
    struct vec3s points = {0};

    state = 11 + 2 * (uint64_t)_i;
    sparse_face(3, 0.05, &points);
    struct guard_points s = surface_for(&points, 0.05, 2);
    struct kdtree *tree = kdtree_new(points.item, points.n);
    double most = 0;
    for (size_t i = 0; i < s.point.n; i++) {
        size_t at;
        double distance2;
        ck_assert_uint_eq(kdtree_nearest(tree, s.point.item[i], 1, &at, &distance2), 1);
        most = fmax(most, sqrt(distance2));
    }
    ck_assert_double_lt(most, far);
    kdtree_free(tree);
    array_free(&points);
    array_free(&s.point);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("guard_points");
    TCase *tcase = tcase_create("guard_points");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, what_is_sparse_is_filled);
    tcase_add_test(tcase, two_sheets_are_filled);
    tcase_add_test(tcase, holes_and_gaps_of_a_border_are_bridged);
    tcase_add_loop_test(tcase, what_is_too_sparse_is_told, 0, 2);
    tcase_add_test(tcase, the_gap_is_that_between_lines);
    tcase_add_test(tcase, noise_is_found_and_taken_out);
    tcase_add_test(tcase, no_shape_is_smoothed_over);
    tcase_add_test(tcase, noise_that_is_said_counts);
    tcase_add_test(tcase, a_hole_stays);
    tcase_add_test(tcase, what_is_rough_stays_as_it_is);
    tcase_add_loop_test(tcase, blunt_edges_stand_in_noise, 0, 2);
    tcase_add_test(tcase, sharp_edges_stand_in_noise);
    tcase_add_loop_test(tcase, steep_flanks_are_filled_over_gaps, 29, 35);
    tcase_add_loop_test(tcase, faint_noise_hides_no_edges, 0, 2);
    tcase_add_test(tcase, both_sides_of_points_on_a_ridge);
    tcase_add_test(tcase, walls_stand_in_noise);
    tcase_add_loop_test(tcase, hidden_edges_are_suspected, 0, 4);
    tcase_add_loop_test(tcase, nothing_is_far_from_the_scan, 0, 2);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
