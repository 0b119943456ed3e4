/*
 * edge_points: how deep a ball can go into a part with sharp edges and tips, whose scan has no
 * points on them, when it is kept clear of the guard points; and how far these stand off the part.
 *
 * At places of the true surface the ball is let down beside them, at any distance, until the guard
 * holds it: its depth is what the true surface (sampled far more closely) reaches into it.
 */
#include <check.h>
#include <stdlib.h>

#include "cloud/edge_points.h"
#include "gouge/gouge.h"
#include "gouge/guard_points.h"
#include "noisy.h"

static const double RADIUS = 3, TOLERANCE = 0.01;
static double turn; /* of the shapes about z, radians */

static void turned(double *x, double *y)
{
    double u = *x * cos(turn) + *y * sin(turn), v = *y * cos(turn) - *x * sin(turn);
    *x = u;
    *y = v;
}

static double pyramid(double x, double y)
{
    turned(&x, &y);
    return 20 - fmax(fabs(x + 0.13), fabs(y - 0.07));
}

static const double FLANK = 1.7;

static double plateau(double x, double y)
{
    turned(&x, &y);
    return fmax(0, fmin(6, 6 - FLANK * (fmax(fabs(x) - 9, fabs(y) - 6))));
}

/* A blade of 44 degrees, both sides bent, its edge curved. */
static double blade(double x, double y)
{
    turned(&x, &y);
    double d = fabs(x - 0.02 * y * y / 2);
    return 20 - 2.5 * d - 0.02 * d * d - 0.01 * y * y;
}

static double lens(double x, double y)
{
    turned(&x, &y);
    double a = x - 18, b = x + 18;
    return fmin(sqrt(fmax(0, 55 * 55 - a * a - y * y)), sqrt(fmax(0, 50 * 50 - b * b - y * y)) + 4);
}

/* Ridges 30 degrees flat, a row of them. */
static double saw(double x, double y)
{
    turned(&x, &y);
    return 0.6 * fabs(x - 7 * floor(x / 7 + 0.5)) * -1;
}

static double (*const shape[])(double, double) = {pyramid, plateau, blade, lens, saw};
static const char *const name[] = {"pyramid", "plateau", "blade", "lens", "saw"};
enum { PLATEAU = 1, SHAPES = sizeof shape / sizeof *shape };

/* Places of the true surface over a square, `step` apart. */
static struct vec3s sample(double (*height)(double, double), double x, double y, double half,
                           double step)
{
    struct vec3s to = {0};
    for (double u = x - half; u <= x + half; u += step)
        for (double v = y - half; v <= y + half; v += step)
            *array_push(&to) = vec(u, v, height(u, v));
    return to;
}

/* How deep a ball that comes down with its centre over p + RADIUS * d, d a unit vector, is in the
 * true surface where the guard holds it. */
static double sinks(const struct gouge_check *guard, const struct gouge_check *truth, struct vec3 p,
                    struct vec3 d)
{
    struct vec3 up = vec(0, 0, 1), deep = vec_along(vec_along(p, RADIUS, d), -1, up);

    return gouge_depth(truth, vec_along(deep, gouge_rise(guard, deep, up, RADIUS), up), RADIUS);
}

struct result {
    double deepest;
    struct vec3 at;
    double silent; /* deepest of what is more than the scan's hole there lets it know */
    double told;   /* how uncertain the guard says that its surface is, at worst */
    double over;   /* how far what was put on edges is off, at most, ... */
    size_t high;   /* ... and how many of these stand out by more than 0.1 mm */
    size_t edges;
};

/* How far points stand above the surface. */
static void measure_over(double (*height)(double, double), const struct vec3s *points,
                         struct result *r)
{

    for (size_t i = 0; i < points->n; i++) {
        struct vec3 p = points->item[i];
        double off = p.z - height(p.x, p.y);
        if (fabs(p.x) > 16 || fabs(p.y) > 13 || off <= fmin(r->over, 0.1))
            continue;
        struct vec3s near = sample(height, p.x, p.y, 0.3, 0.06);
        for (size_t k = 0; k < near.n; k++)
            off = fmin(off, vec_distance(p, near.item[k]));
        array_free(&near);
        r->over = fmax(r->over, off);
        r->high += off > 0.1;
    }
    r->edges = points->n;
}

/* A scan and what guards a ball by it. */
struct guarded {
    struct vec3s scan;
    struct point_grid grid;
    struct guard_points points;
};

/* One of 25 places of the surface about p, up to half a millimetre aside. */
static struct vec3 near_place(double (*height)(double, double), struct vec3 p, int k)
{
    double x = p.x + 0.25 * (k % 5 - 2), y = p.y + 0.25 * (k / 5 - 2);
    return vec(x, y, height(x, y));
}

/* `bend`: the least radius of the surface, mm. */
static struct result measure(double (*height)(double, double), const struct guarded *g, double bend)
{
    struct result r = {.deepest = 0};
    struct gouge_check *guard = gouge_from_points(g->points.point.item, g->points.point.n);
    struct gouge_check *scan = gouge_from_points(g->scan.item, g->scan.n);

    for (int i = 0; i < 60; i++) {
        double x = 22 * noisy_uniform() - 11, y = 16 * noisy_uniform() - 8;
        /* near to where it is sharp: the highest of places about it off their mean */
        double best = -1, bx = x, by = y;
        for (int k = 0; k < 200; k++) {
            double u = x + 4 * noisy_uniform() - 2, v = y + 4 * noisy_uniform() - 2;
            double bump = height(u, v) - (height(u + 0.02, v) + height(u - 0.02, v) +
                                          height(u, v + 0.02) + height(u, v - 0.02)) /
                                             4;
            if (bump > best) {
                best = bump;
                bx = u;
                by = v;
            }
        }
        struct vec3 p = vec(bx, by, height(bx, by));
        struct vec3s near = sample(height, bx, by, 2 * RADIUS, 0.1);
        *array_push(&near) = p;
        double hole = 0; /* of those that the ball may lie over, which touches elsewhere */
        for (int k = 0; k < 25; k++)
            hole = fmax(hole, gouge_distance(scan, near_place(height, p, k), RADIUS));
        struct gouge_check *truth = gouge_from_points(near.item, near.n);
        array_free(&near);
        for (int k = 0; k < 40; k++) {
            double t = 2 * PI * noisy_uniform(), z = noisy_uniform(), s = sqrt(1 - z * z);
            double depth = sinks(guard, truth, p, vec(s * cos(t), s * sin(t), z));
            r.silent = fmax(r.silent, depth - hole * hole / (2 * bend));
            if (depth > r.deepest) {
                r.deepest = depth;
                r.at = p;
            }
        }
        gouge_free(truth);
    }
    gouge_free(scan);
    gouge_free(guard);
    return r;
}

/* Leaves of a scan what is so far beside its middle; more is not looked at. */
static void crop(struct vec3s *scan, double x, double y)
{
    size_t n = 0;

    for (size_t i = 0; i < scan->n; i++)
        if (fabs(scan->item[i].x) <= x && fabs(scan->item[i].y) <= y)
            scan->item[n++] = scan->item[i];
    scan->n = n;
}

/* Leaves what is in front of the line x = least of the turned shape. */
static void crop_behind(struct vec3s *scan, double least)
{
    size_t n = 0;

    for (size_t i = 0; i < scan->n; i++) {
        double x = scan->item[i].x, y = scan->item[i].y;
        turned(&x, &y);
        if (x >= least)
            scan->item[n++] = scan->item[i];
    }
    scan->n = n;
}

/* Of g->scan, in cells so wide, mm. */
static void guarded_make(struct guarded *g, double cell, double sigma)
{
    struct guard_points_options options = {.radius = RADIUS,
                                           .sink = TOLERANCE / 5,
                                           .noise = sigma,
                                           .vague = TOLERANCE,
                                           .effort = 1,
                                           .threads = 2};
    struct error error;

    ck_assert_int_eq(point_grid_make(g->scan.item, g->scan.n, cell, 2, &g->grid, &error), 0);
    g->points = guard_points_of_scan(&g->grid, &options);
}

/* Takes the points. */
static struct gouge_check *guarded_gouge(struct guarded *g)
{
    struct gouge_check *guard = gouge_new(g->points.point, 2);

    g->points.point = (struct vec3s){0};
    return guard;
}

static void guarded_free(struct guarded *g)
{
    array_free(&g->points.point);
    array_free(&g->points.certain);
    array_free(&g->points.doubtful);
    point_grid_free(&g->grid);
    array_free(&g->scan);
}

static const double SPACING = 0.48;

/* The guard of a scan of it. */
static struct result guard_scan(double (*height)(double, double), enum noisy_pattern pattern,
                                double sigma, double bend)
{
    enum { POINTS = 17000 };
    struct guarded g = {0};

    noisy_scan(&g.scan, height, POINTS, pattern, sigma);
    crop(&g.scan, 18, 15);
    guarded_make(&g, SPACING, sigma);
    struct result r = measure(height, &g, bend);
    struct vec3s edges = {g.points.edges, 0,
                          g.points.point.item + g.points.point.n - g.points.edges};
    measure_over(height, &edges, &r);
    r.told = g.points.worst;
    guarded_free(&g);
    return r;
}

/* So far may what is put on edges stand out: half of what the scan resolves; and what goes up an
 * edge between two flanks of the plateau goes on over its flat top to where a point of that is the
 * nearest, half the diagonal of a cell, as steep as the flanks are along their edge. */
static double most_over(int s)
{
    return s == PLATEAU ? FLANK / sqrt(2) * SPACING / sqrt(2) : SPACING / 2;
}

/* No deeper than is allowed or the guard says itself; with noise what four deviations explain, for
 * points beside an edge stay where they are, and among some thousand one is off by so much. */
START_TEST(no_gouge)
{
    static const double sigma[] = {0, 0, 0, 0.02};
    int s = _i % SHAPES, p = (s + 2 * (_i / SHAPES)) % 4; /* two patterns of each shape */

    noisy_seed(3 + (unsigned)(s + p * SHAPES));
    turn = 0.35 * s + 0.1 * p;
    struct result r = guard_scan(shape[s], (enum noisy_pattern)(p % 3), sigma[p], HUGE_VAL);
    ck_assert_msg(r.deepest <= fmax(1.5 * TOLERANCE, r.told) + 4 * sigma[p],
                  "%s %d: %.4f mm at %.2f %.2f %.2f, told %.4f", name[s], p, r.deepest, r.at.x,
                  r.at.y, r.at.z, r.told);
    ck_assert_msg(r.over <= most_over(s) + 4 * sigma[p], "%s %d: %.4f mm above", name[s], p,
                  r.over);
    ck_assert_msg(sigma[p] > 0 || 100 * r.high <= r.edges, "%s %d: %zu of %zu stand out", name[s],
                  p, r.high, r.edges);
}
END_TEST

/* A roof rounded with half the spacing and more: the scan knows that it is round. */
static double bend;

static double rounded(double x, double y)
{
    turned(&x, &y);
    return -sqrt(x * x + bend * bend) * 0.8;
}

/* In a grid no deeper than twice what is allowed, or is told, or half of what a chord between two
 * of its points leaves below the arc.  Points anywhere leave holes; what
 * bends within one with a radius r is off the tangent at its rim, h away, by h^2 / 2 r: no deeper
 * than that. */
START_TEST(rounded_edges)
{
    static const double radius[] = {0.5, 1, 2, 4};
    const bool anywhere = _i / 4;

    bend = 0.8 * radius[_i % 4]; /* of the hyperbola, whose radius is bend / slope */
    turn = 0.3 * _i;
    noisy_seed(8);
    struct result r = guard_scan(rounded, anywhere ? NOISY_RANDOM : NOISY_GRID, 0, radius[_i % 4]);
    double chord = SPACING * SPACING / 8 / radius[_i % 4];
    double most = fmax(fmax(2 * TOLERANCE, r.told), anywhere ? 0 : chord / 2);
    ck_assert_msg((anywhere ? r.silent : r.deepest) <= most, "%d: %.4f mm, %.4f for no hole", _i,
                  r.deepest, r.silent);
    ck_assert_msg(r.over <= (_i % 4 < 2 ? SPACING / 2 : 0.04), "%d: %.4f mm above", _i, r.over);
}
END_TEST

/* A crest that is an arc of one or two spacings' radius between sides of 45 or 63 degrees, straight
 * or all round a boss with drafted sides: few points are on the arc, but its sides tell of it. */
static double arc, slope;
static bool is_boss;

static double across_crest(double d)
{
    double c = 1 / hypot(1, slope), touch = arc * slope * c;

    d = fabs(d);
    return d < touch ? 8 - arc + sqrt(arc * arc - d * d) : 8 - arc + arc * c - slope * (d - touch);
}

static double round_crest(double x, double y)
{
    turned(&x, &y);
    return is_boss ? across_crest(hypot(x, y) - 6) : across_crest(x);
}

/* A ball that touches it or its sides goes in no deeper, but at one place in 25, where points
 * leave a hole. */
START_TEST(round_crests)
{
    enum { POINTS = 12000, PLACES = 400 };
    const bool grid = (_i + _i / 2 + _i / 4) % 2; /* each with any two of the others */
    struct guarded g = {0};
    int deeper = 0;

    arc = _i % 2 ? 0.5 : 1;
    slope = _i / 2 % 2 ? 2 : 1;
    is_boss = _i / 4;
    turn = 0.2 + 0.17 * _i;
    noisy_seed(170 + (unsigned)_i);
    noisy_scan(&g.scan, round_crest, POINTS, grid ? NOISY_GRID : NOISY_RANDOM, 0);
    crop(&g.scan, 11, 11);
    guarded_make(&g, 0.57, 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double t = atan(slope) * fmin(1, 1.3 * noisy_uniform()) * (i % 2 ? 1 : -1);
        double v = 2 * PI * noisy_uniform(), far = arc + RADIUS - 1.5 * TOLERANCE;
        double d = far * sin(t), x = is_boss ? (6 + d) * cos(v) : d,
               y = is_boss ? (6 + d) * sin(v) : 14 * (v / (2 * PI) - 0.5);
        struct vec3 c = vec(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn),
                            8 - arc + far * cos(t));
        deeper += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(25 * deeper, PLACES);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A frustum with flanks so steep that a scan from above has few points on them, far apart up and
 * down; with no top it is a pyramid with its tip between the points. */
static double top, steep;

static double frustum(double x, double y)
{
    turned(&x, &y);
    return fmax(0, 8 - steep * fmax(fmax(fabs(x), fabs(y)) - top, 0));
}

/* A ball that touches a flank or the tip from outside goes no deeper, wherever there are points. */
START_TEST(steep_flanks)
{
    enum { POINTS = 17000, PLACES = 400 };
    struct guarded g = {0};
    double worst = 0;

    top = _i % 2 ? 12 : 0;
    steep = _i % 2 ? 3 : 1.3;
    turn = 0.3 * _i;
    noisy_seed(60 + (unsigned)_i);
    noisy_scan(&g.scan, frustum, POINTS, NOISY_RANDOM, 0);
    crop(&g.scan, 21, 21);
    guarded_make(&g, 0.48, 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double u = top + (0.3 + 5 * noisy_uniform()) / steep, v = 1.8 * (noisy_uniform() - 0.5);
        double side = i % 4 * PI / 2 + turn, down = steep / sqrt(1 + steep * steep);
        bool tip = top == 0 && i % 2;
        double x = tip ? 0 : u, y = tip ? 0 : v * u, level = tip ? 0.3 * noisy_uniform() : down;
        struct vec3 p = vec(x * cos(side) - y * sin(side), x * sin(side) + y * cos(side), 0);
        struct vec3 d = vec(level * cos(side), level * sin(side), sqrt(1 - level * level));
        p.z = frustum(p.x, p.y);
        if (hypot(x, y) > 18)
            continue;
        struct vec3 deep = vec_along(p, RADIUS - 1, d);
        double lift = gouge_least_lift(guard, deep, d, RADIUS, 2, NULL);
        worst = fmax(worst, 1 - lift);
    }
    ck_assert_double_le(worst, 2.5 * TOLERANCE);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A roof, some points of whose grid are all but on the ridge: no place is put above it. */
static double roof(double x, double y)
{
    turned(&x, &y);
    return 12 - fabs(x) / 2;
}

START_TEST(points_on_a_ridge)
{
    struct guarded g = {0};

    turn = 0.2094395 + 0.2 * _i; /* of 12 degrees: z is 12 less 0.0016 at (0.6, -2.8) */
    for (int i = -37; i <= 37; i++)
        for (int j = -30; j <= 30; j++)
            *array_push(&g.scan) = vec(0.4 * i + 0.2, 0.4 * j, roof(0.4 * i + 0.2, 0.4 * j));
    guarded_make(&g, 0.8, 0);
    ck_assert_uint_gt(g.points.point.n, g.scan.n); /* there are places at all */
    for (size_t i = 0; i < g.points.point.n; i++) {
        struct vec3 p = g.points.point.item[i];
        ck_assert_double_le(p.z - roof(p.x, p.y), TOLERANCE);
    }
    guarded_free(&g);
}
END_TEST

/* Scan lines 0.8 mm apart, points 0.2 mm apart along them: through few lines a surface goes that
 * has nothing to do with the part.  No place stands far above it, and the ridge is found. */
START_TEST(on_scan_lines)
{
    static double (*const of[])(double, double) = {roof, frustum, frustum};
    double (*height)(double, double) = of[_i], above = 0;
    struct guarded g = {0};

    turn = 0.35;
    top = _i == 2 ? 6 : 0;
    steep = _i == 2 ? 3 : 1;
    for (int line = -15; line <= 15; line++)
        for (int k = -80; k <= 80; k++) {
            double x = 0.2 * k + 0.03 * line, y = 0.8 * line + 0.1 * x;
            *array_push(&g.scan) = vec(x, y, height(x, y));
        }
    guarded_make(&g, 0.8, 0);
    ck_assert_uint_gt(g.points.point.n, 2 * g.scan.n);
    for (size_t i = 0; i < g.points.point.n; i++) {
        struct vec3 p = g.points.point.item[i];
        above = fmax(above, (p.z - height(p.x, p.y)) / hypot(1, steep));
    }
    /* a flank so steep is on too few lines: the one over it is continued to the next of them,
     * 0.8 mm on, and is above it there by that, times the sine of its slope */
    ck_assert_msg(above <= (_i == 2 ? 0.8 * steep / hypot(1, steep) : TOLERANCE),
                  "%d: %.4f mm above", _i, above);
    struct gouge_check *guard = guarded_gouge(&g);
    for (double y = -9; _i == 0 && y <= 9; y += 0.07) {
        struct vec3 p = vec(-y * sin(turn), y * cos(turn), 12);
        ck_assert_double_le(gouge_depth(guard, vec_along(p, RADIUS, vec(0, 0, 1)), RADIUS), 2e-3);
        ck_assert_double_ge(
            gouge_depth(guard, vec_along(p, RADIUS - 1.5 * TOLERANCE, vec(0, 0, 1)), RADIUS), 0);
    }
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A plateau with upright walls that a scan from above has no points on: a ball that comes to its
 * rim or to the wall goes in no deeper, but at one place in a hundred, where points anywhere leave
 * a hole, by a quarter of the spacing; and the rim is put no further out than the points below. */
static double mesa(double x, double y)
{
    turned(&x, &y);
    return fabs(x) < 6 ? 5 : 0;
}

START_TEST(unseen_walls)
{
    enum { POINTS = 12000, PLACES = 300 };
    const double gap = 1.4; /* mm: the reach, 2.8 spacings */
    struct guarded g = {0};

    turn = 0.25 + 0.2 * _i;
    noisy_seed(70 + (unsigned)_i);
    noisy_scan(&g.scan, mesa, POINTS, NOISY_RANDOM, 0);
    crop(&g.scan, 14, 14);
    guarded_make(&g, 0.48, 0);
    for (size_t i = 0; i < g.points.point.n; i++) {
        struct vec3 p = g.points.point.item[i];
        double x = p.x, y = p.y;
        turned(&x, &y);
        ck_assert(p.z < 5 + TOLERANCE && (p.z < TOLERANCE || fabs(x) < 6 + gap));
    }
    struct gouge_check *guard = guarded_gouge(&g);
    int deeper = 0;
    for (int i = 0; i < PLACES; i++) {
        double v = 12 * noisy_uniform() - 6, level = noisy_uniform(), deep = RADIUS - 3 * TOLERANCE;
        struct vec3 out = vec(level * cos(turn), level * sin(turn), sqrt(1 - level * level));
        struct vec3 p = vec(6 * cos(turn) - v * sin(turn), 6 * sin(turn) + v * cos(turn), 5);
        if (i % 2) { /* beside the wall, under its rim */
            out = vec(cos(turn), sin(turn), 0);
            deep = RADIUS - 0.1;
            p.z = RADIUS;
        }
        deeper += gouge_depth(guard, vec_along(p, deep, out), RADIUS) <= 0;
        ck_assert_double_gt(gouge_depth(guard, vec_along(p, RADIUS - SPACING / 4, out), RADIUS), 0);
    }
    ck_assert_int_le(100 * deeper, PLACES);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A boss, its rim rounded by 2 mm down to an upright wall: a scan from above has points on the
 * rounding until it is too steep, and the next ones on the floor. */
static double boss(double x, double y)
{
    turned(&x, &y);
    double d = fmax(fabs(x) - 4, 0);
    return d < 2 ? 6 + sqrt(4 - d * d) : 0;
}

/* The same with a foot rounded by 1 mm, whose surface, gone on with, would meet the rim's. */
static double footed_boss(double x, double y)
{
    double z = boss(x, y);
    turned(&x, &y);
    double d = fabs(x) - 6;
    return d > 0 && d < 1 ? 1 - sqrt(1 - (1 - d) * (1 - d)) : z;
}

/* A ball that comes beside the wall goes in no deeper than its points are apart, in plan, on the
 * rounding's last degrees: there nothing tells where it ends but the floor. */
START_TEST(walls_under_round_rims)
{
    enum { POINTS = 40000, PLACES = 300 };
    static const enum noisy_pattern pattern[] = {NOISY_RANDOM, NOISY_GRID, NOISY_LINES};
    const double noise = _i / 3 % 2 * 0.005, spacing = 0.32;
    const double depth = (_i % 3 == 2 ? 1.2 : 0.7) * spacing; /* lines are farther apart */
    struct guarded g = {0};

    turn = 0.2 + 0.15 * _i;
    noisy_seed(90 + (unsigned)_i);
    noisy_scan(&g.scan, _i % 2 ? footed_boss : boss, POINTS, pattern[_i % 3], noise);
    crop(&g.scan, 14, 14);
    crop_behind(&g.scan, 0);
    guarded_make(&g, spacing, noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double v = 16 * noisy_uniform() - 8, z = 3.5 + 2.5 * noisy_uniform();
        double x = 6 + RADIUS - depth;
        struct vec3 c = vec(x * cos(turn) - v * sin(turn), x * sin(turn) + v * cos(turn), z);
        ck_assert_msg(gouge_depth(guard, c, RADIUS) > 0, "%d: free at %g %g %g", _i, c.x, c.y, c.z);
    }
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A ring groove, half a circle deep: its walls are upright at its rims and bend away below these,
 * so that a scan from above has few points on their upper parts. */
static const double GROOVE = 2.2;

static double ring_groove(double x, double y)
{
    double d = hypot(x - 0.3, y + 0.2) - 9;

    return fabs(d) < GROOVE ? -sqrt(GROOVE * GROOVE - d * d) : 0;
}

/* A ball over it rests on both rims: where points are missing it sinks in by no more than a part of
 * their distance, and hardly anywhere by much. */
START_TEST(rims_of_grooves)
{
    enum { POINTS = 60000, PLACES = 400 };
    static const enum noisy_pattern pattern[] = {NOISY_RANDOM, NOISY_GRID};
    const double noise = _i / 2 * 0.008, most = 0.065, more = 0.02;
    struct guarded g = {0};
    int deep = 0;

    noisy_seed(110 + (unsigned)_i);
    noisy_scan(&g.scan, ring_groove, POINTS, pattern[_i % 2], noise);
    crop(&g.scan, 14, 14);
    guarded_make(&g, 0.26, noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double t = 2 * PI * i / PLACES, level = sqrt(RADIUS * RADIUS - GROOVE * GROOVE);
        struct vec3 c = vec(0.3 + 9 * cos(t), -0.2 + 9 * sin(t), level - most);
        ck_assert_msg(gouge_depth(guard, c, RADIUS) > 0, "%d: free at %g %g %g", _i, c.x, c.y, c.z);
        c.z = level - more;
        deep += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(deep, PLACES / 8);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* Round teeth, their rims and feet rounded: hardly a point of a rim has a surface that is known. */
static const double TOOTH = 1.2, TEETH = 0.9; /* mm; radians a mm */

static double teeth(double x, double y)
{
    const double rim = 0.8, foot = 1, high = 7;
    turned(&x, &y);
    double d = (x - TOOTH * cos(TEETH * y)) / hypot(1, TOOTH * TEETH * sin(TEETH * y));
    if (d < 0)
        return d < -rim ? high : high - rim + sqrt(rim * rim - (d + rim) * (d + rim));
    return d < foot ? foot - sqrt(foot * foot - (foot - d) * (foot - d)) : 0;
}

/* A ball before the tips, anywhere over their feet, goes in by less than points are apart. */
START_TEST(tips_of_teeth)
{
    enum { POINTS = 60000, TIPS = 3, HEIGHTS = 8 };
    const double noise = _i / 2 % 2 * 0.012, depth = 0.1;
    struct guarded g = {0};

    turn = 0.1 + 0.17 * _i;
    noisy_seed(150 + (unsigned)_i);
    noisy_scan(&g.scan, teeth, POINTS, _i % 2 ? NOISY_GRID : NOISY_RANDOM, noise);
    crop(&g.scan, 12, 12);
    guarded_make(&g, 0.26, noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int tip = 0; tip < TIPS; tip++)
        for (int i = 0; i < HEIGHTS; i++) {
            double x = TOOTH + RADIUS - depth, y = 2 * PI / TEETH * (tip - TIPS / 2);
            struct vec3 c = vec(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn),
                                3.2 + 2.8 * i / HEIGHTS);
            ck_assert_msg(gouge_depth(guard, c, RADIUS) > 0, "%d: free at %g %g %g", _i, c.x, c.y,
                          c.z);
        }
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A square post on a grid that is turned: its corners stand out between two points of the floor. */
static double square_post(double x, double y)
{
    turned(&x, &y);
    return fabs(x - 0.11) < 3 && fabs(y + 0.07) < 2 ? 4 : 0;
}

/* A hole: the guard goes on from a point of the top to those of the floor that are no farther than
 * its reach, EDGE_REACH spacings; and there is none that has both the corner and, within 45 degrees
 * of the way there, a point of the floor as near. */
static bool is_in_hole(const struct vec3s *scan, double x, double y)
{
    const double reach = 2.8 * 0.5, beside = 0.7;

    for (size_t i = 0; i < scan->n; i++) {
        struct vec3 from = scan->item[i];
        double u = x - from.x, v = y - from.y;
        if (from.z < 2 || hypot(u, v) >= reach)
            continue;
        for (size_t k = 0; k < scan->n; k++) {
            double a = scan->item[k].x - from.x, b = scan->item[k].y - from.y;
            if (scan->item[k].z < 2 && hypot(a, b) < reach &&
                u * a + v * b > beside * hypot(u, v) * hypot(a, b))
                return false;
        }
    }
    return true;
}

/* Whether a point of the top is no more than 1.5 spacings off. */
static bool is_top_near(const struct vec3s *scan, double x, double y)
{
    for (size_t i = 0; i < scan->n; i++)
        if (scan->item[i].z > 2 && hypot(scan->item[i].x - x, scan->item[i].y - y) <= 1.5 * 0.5)
            return true;
    return false;
}

/* Of the post's corners that have points of the top as near, or of those that have none (without
 * holes): how many a ball that stands on the floor can touch.  It is held off an upright edge by
 * 0.05 mm; where points lie anywhere, within the 0.14 mm that places of the guard are apart,
 * 0.65 sqrt(8 R sink). */
static int free_corners(int i, bool near)
{
    enum { POINTS = 16000, WAYS = 9 };
    const double depth = i % 2 ? 0.14 : 0.05;
    struct guarded g = {0};
    int found = 0;

    turn = 0.1 + 0.13 * i;
    noisy_seed(120 + (unsigned)i);
    noisy_scan(&g.scan, square_post, POINTS, i % 2 ? NOISY_RANDOM : NOISY_GRID, 0);
    crop(&g.scan, 10, 10);
    guarded_make(&g, 0.5, 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int corner = 0; corner < 4; corner++) {
        double u = corner % 2 ? 3.11 : -2.89, v = corner / 2 ? 1.93 : -2.07;
        double x = u * cos(turn) - v * sin(turn), y = u * sin(turn) + v * cos(turn);
        bool touches = false;
        if (is_top_near(&g.scan, x, y) != near || is_in_hole(&g.scan, x, y))
            continue;
        for (int k = 0; k < WAYS; k++) {
            double way = turn + PI / 2 * (k + 1) / (WAYS + 1) +
                         (corner == 3   ? 0
                          : corner == 2 ? PI / 2
                          : corner == 0 ? PI
                                        : -PI / 2);
            struct vec3 c =
                vec(x + (RADIUS - depth) * cos(way), y + (RADIUS - depth) * sin(way), RADIUS);
            touches = touches || !(gouge_depth(guard, c, RADIUS) > 0);
        }
        found += touches;
    }
    gouge_free(guard);
    guarded_free(&g);
    return found;
}

START_TEST(corners_between_points)
{
    ck_assert_int_eq(free_corners(_i, true), 0);
}
END_TEST

/* One corner in six of a scan at random has no point of its top within 1.5 spacings, exp(-1.5^2
 * PI / 4): 8 of 48.  Of these (SEED 1 to 60) one in thirty is free; three would be 5 sigma. */
START_TEST(corners_far_from_points)
{
    int found = 0;

    for (int i = 1; i < 24; i += 2)
        found += free_corners(i, false);
    ck_assert_int_le(found, 3);
}
END_TEST

/* A wall 0.6 mm thick, on which there are one or two points across; and a blade of 14 degrees, on
 * whose sides a scan from above has few. */
static double narrow_wall(double x, double y)
{
    turned(&x, &y);
    return fabs(x) < 0.3 ? 4 : 0;
}

static double thin_blade(double x, double y)
{
    turned(&x, &y);
    return fmax(0, 8 - 8 * fabs(x));
}

/* A ball that comes to the rim of the wall, or to a side of the blade, from outside goes in no
 * deeper; more between the blade's points where chance leaves them a gap. */
START_TEST(thin_parts)
{
    enum { POINTS = 24000, PLACES = 300 };
    static const enum noisy_pattern pattern[] = {NOISY_RANDOM, NOISY_GRID, NOISY_LINES};
    double (*height)(double, double) = _i % 2 ? thin_blade : narrow_wall;
    struct guarded g = {0};

    turn = 0.2 + 0.3 * _i;
    noisy_seed(80 + (unsigned)_i);
    noisy_scan(&g.scan, height, POINTS, pattern[_i / 2], 0);
    crop(&g.scan, 14, 14);
    guarded_make(&g, 0.41, 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double v = 16 * noisy_uniform() - 8, deep = RADIUS - (_i % 2 ? 10 : 5) * TOLERANCE, u = 0.3,
               z = 4;
        double level = noisy_uniform();
        if (_i % 2) {
            z = 2 + 5.5 * noisy_uniform();
            u = 1 - z / 8;
            level = 8 / sqrt(65);
        }
        double x = u + deep * level;
        struct vec3 c = vec(x * cos(turn) - v * sin(turn), x * sin(turn) + v * cos(turn),
                            z + deep * sqrt(1 - level * level));
        ck_assert_double_gt(gouge_depth(guard, c, RADIUS), 0);
    }
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* The foot of a pyramid on a grid as wide as its points are 1 mm apart: some of the floor's points
 * lie within a hundredth of its side. */
static double low_pyramid(double x, double y)
{
    turned(&x, &y);
    return fmax(0, 8 - fmax(fabs(x), fabs(y)));
}

/* A ball that lies on the floor and touches a side goes in no deeper, anywhere along it. */
START_TEST(feet_of_pyramids)
{
    enum { PLACES = 200, POINTS = 4000 };
    struct guarded g = {0};
    int deeper = 0;

    turn = 0.1 + 0.07 * _i;
    noisy_seed(190 + (unsigned)_i);
    noisy_scan(&g.scan, low_pyramid, POINTS, NOISY_GRID, 0);
    crop(&g.scan, 14, 14);
    guarded_make(&g, 1, 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double v = 12 * noisy_uniform() - 6, side = i % 4 * PI / 2 + turn, deep = 1.5 * TOLERANCE;
        double x = 8 + RADIUS * tan(PI / 8) - deep * sqrt(2);
        struct vec3 c = vec(x * cos(side) - v * sin(side), x * sin(side) + v * cos(side), RADIUS);
        deeper += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(deeper, PLACES / 50);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A knife of 30 degrees, scanned with noise: on its sides points are far apart. */
static double noisy_knife(double x, double y)
{
    turned(&x, &y);
    return fmax(0, 6 - 3.7320508 * fabs(x));
}

/* A ball that touches a side goes in by no more than noise may bring its few points in. */
START_TEST(noisy_flanks)
{
    enum { PLACES = 200, POINTS = 12000 };
    const double noise = 0.005, deep = TOLERANCE + 4 * noise;
    struct guarded g = {0};
    int deeper = 0;

    turn = 0.2 + 0.2 * _i;
    noisy_seed(200 + (unsigned)_i);
    noisy_scan(&g.scan, noisy_knife, POINTS, _i % 2 ? NOISY_GRID : NOISY_RANDOM, noise);
    crop(&g.scan, 14, 14);
    guarded_make(&g, 0.57, noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double v = 16 * noisy_uniform() - 8, z = 2.5 + 2.5 * noisy_uniform();
        double side = i % 2 * PI + turn, x = (6 - z) / 3.7320508;
        x += (RADIUS - deep) * cos(PI / 12);
        struct vec3 c = vec(x * cos(side) - v * sin(side), x * sin(side) + v * cos(side),
                            z + (RADIUS - deep) * sin(PI / 12));
        deeper += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(deeper, PLACES / 20);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* Pockets 0.4 deep in a dome, whose floors and ribs are even, but no plane of them is certain. */
static const double STEP = 0.4;

static double dome(double x, double y)
{
    return sqrt(400 - x * x - y * y) - 10;
}

static double pockets(double x, double y)
{
    double u = x, v = y;
    turned(&u, &v);
    u -= 4 * floor(u / 4 + 0.5);
    v -= 4 * floor(v / 4 + 0.5);
    return dome(x, y) - (fabs(u) < 1.2 && fabs(v) < 1.2 ? STEP : 0);
}

/* The points tell of the step at a place of a rim: the guard goes on there from the nearest point
 * of the dome, if three of a floor are within its reach of that, EDGE_REACH spacings, and one of
 * these is beyond the place, within 45 degrees of the way there, so near that no slope of 0.35
 * comes down to it.  Fewer are no floor: there the scan has a hole. */
static bool tells_of_step(const struct vec3s *scan, struct vec3 rim, double spacing)
{
    const double reach = 2.8 * spacing, gentle = 0.35, beside = 0.7;
    struct vec3 from = vec(HUGE_VAL, 0, 0);
    int low = 0, beyond = 0;

    for (size_t i = 0; i < scan->n; i++) {
        struct vec3 p = scan->item[i];
        if (p.z > dome(p.x, p.y) - STEP / 2 &&
            hypot(p.x - rim.x, p.y - rim.y) < hypot(from.x - rim.x, from.y - rim.y))
            from = p;
    }
    double x = rim.x - from.x, y = rim.y - from.y;
    for (size_t i = 0; i < scan->n; i++) {
        struct vec3 p = scan->item[i];
        double u = p.x - from.x, v = p.y - from.y, ahead = u * x + v * y;
        if (p.z > dome(p.x, p.y) - STEP / 2 || hypot(u, v) >= reach)
            continue;
        low++;
        beyond += gentle * hypot(u, v) < STEP && ahead > beside * hypot(u, v) * hypot(x, y) &&
                  ahead < u * u + v * v;
    }
    return low >= 3 && beyond > 0;
}

/* A ball over a rim goes in by no more than a part of the spacing lets the wall be elsewhere, but
 * in holes; with noise, which the floors of the pockets are too narrow to be even in, by four
 * deviations more. */
START_TEST(rims_of_pockets)
{
    enum { PLACES = 400, POINTS = 17000, NOISY = 2 };
    const double noise = _i < NOISY ? 0 : 0.005;
    struct guarded g = {0};
    int deeper = 0, asked = 0;

    turn = 0.2 + 0.3 * _i;
    noisy_seed(210 + (unsigned)_i);
    noisy_scan(&g.scan, pockets, POINTS, NOISY_RANDOM, noise);
    crop(&g.scan, 13, 13);
    guarded_make(&g, SPACING, noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < PLACES; i++) {
        double u = 4 * (i % 5 - 2) + 1.2, v = 4 * (i / 5 % 5 - 2) + 2 * noisy_uniform() - 1;
        double x = u * cos(turn) - v * sin(turn), y = u * sin(turn) + v * cos(turn), level = 0.35;
        struct vec3 rim = vec(x, y, dome(x, y)),
                    up = vec_unit(vec(x, y, sqrt(400 - x * x - y * y)));
        struct vec3 out = vec(-cos(turn), -sin(turn), 0);
        struct vec3 way = vec_unit(vec_along(up, level, out));
        if (hypot(x, y) >= 10 || !tells_of_step(&g.scan, rim, SPACING))
            continue;
        asked++;
        deeper += gouge_depth(guard, vec_along(rim, RADIUS - 2 * TOLERANCE - 4 * noise, way),
                              RADIUS) <= 0;
    }
    ck_assert_int_ge(asked, PLACES / 2);
    ck_assert_int_eq(deeper, 0);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A stepped cone on a grid, risers of 0.9 mm and rings of five points, or of three, through which
 * a cubic goes as if there were no steps. */
static double stepped_cone(double x, double y)
{
    return 0.9 * fmax(0, 6 - floor(hypot(x, y - 0.01) / 1.5));
}

/* A ball over a riser touches its rim, wherever that is between two rows of the grid, and however
 * uneven noise, measured a little too small, makes the dozen points that a tread is known by. */
START_TEST(rims_of_steps)
{
    enum { WAYS = 360, STEPS = 5 };
    const double pitch = _i % 2 ? 0.5 : 0.3, noise = _i < 4 ? 0.005 : 0.01, measured = 0.9;
    const double deep = TOLERANCE + 1.5 * noise;
    struct guarded g = {0};
    int deeper = 0;

    noisy_seed(220 + (unsigned)_i);
    for (double y = -12; y < 12; y += pitch)
        for (double x = -12; x < 12; x += pitch)
            *array_push(&g.scan) = vec(x, y, stepped_cone(x, y) + noise * noisy_normal());
    guarded_make(&g, pitch, measured * noise);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < WAYS * STEPS; i++) {
        int step = i / WAYS + 2;
        double t = 2 * PI * i / WAYS, far = RADIUS - deep, level = 0.45;
        double r = 1.5 * step - 1e-6 + far * level;
        struct vec3 c =
            vec(r * cos(t), r * sin(t) + 0.01, 0.9 * (7 - step) + far * sqrt(1 - level * level));
        deeper += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(deeper, WAYS * STEPS / 300);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

/* A boss on ground that falls away from it, so that no floor is level, scanned on lines so far
 * apart that the nearest points of two rows are half its radius apart and few surfaces are certain:
 * a ball over its rim touches it. */
START_TEST(boss_between_lines)
{
    enum { WAYS = 360, LINES = 6 };
    const double wide = 4, between = 2, along = 0.7, level = 0.45, deep = 2 * TOLERANCE;
    struct guarded g = {0};
    int deeper = 0;

    noisy_seed(240 + (unsigned)_i);
    double ox = noisy_uniform(), oy = noisy_uniform();
    for (int line = -LINES; line <= LINES; line++) {
        double shift = along * noisy_uniform();
        for (double u = -12 + shift; u < 12; u += along) {
            double x = u - ox, y = between * line - oy, r = hypot(x, y);
            *array_push(&g.scan) = vec(x, y, r < wide ? 5 : 3 - 0.25 * r);
        }
    }
    guarded_make(&g, sqrt(between * along), 0);
    struct gouge_check *guard = guarded_gouge(&g);
    for (int i = 0; i < WAYS; i++) {
        double t = 2 * PI * i / WAYS, r = wide - 1e-6 + (RADIUS - deep) * level;
        struct vec3 c = vec(r * cos(t), r * sin(t), 5 + (RADIUS - deep) * sqrt(1 - level * level));
        deeper += gouge_depth(guard, c, RADIUS) <= 0;
    }
    ck_assert_int_le(deeper, WAYS / 100);
    gouge_free(guard);
    guarded_free(&g);
}
END_TEST

static double bowl(double x, double y)
{
    return (x * x + y * y) / 40;
}

/* Noise, a fifth of what points anywhere are apart, makes no tips of cones in a smooth bowl: one
 * neighbourhood in a thousand is too rough for a surface by chance. */
START_TEST(no_tips_by_noise)
{
    enum { POINTS = 16000 };
    const double sigma = 0.1;
    struct vec3s scan = {0}, to = {0};
    struct point_grid grid;
    struct edge_gaps gaps;
    struct error error;

    noisy_seed((unsigned)_i);
    noisy_scan(&scan, bowl, POINTS, NOISY_RANDOM, sigma);
    ck_assert_int_eq(point_grid_make(scan.item, scan.n, 0.5, 1, &grid, &error), 0);
    const struct edge_points_options options = {
        .point_grid = &grid, .noise = sigma, .along = 0.35, .sink = 0.002, .threads = 1};
    ck_assert_uint_eq(edge_points(&options, &to, &gaps), 0);
    point_grid_free(&grid);
    array_free(&scan);
    array_free(&to);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("edge_points");
    TCase *tests = tcase_create("edge_points");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, no_gouge, 0, 2 * SHAPES);
    tcase_add_loop_test(tests, rounded_edges, 0, 8);
    tcase_add_loop_test(tests, round_crests, 0, 8);
    tcase_add_loop_test(tests, steep_flanks, 0, 4);
    tcase_add_loop_test(tests, points_on_a_ridge, 0, 3);
    tcase_add_loop_test(tests, on_scan_lines, 0, 3);
    tcase_add_loop_test(tests, walls_under_round_rims, 0, 6);
    tcase_add_loop_test(tests, rims_of_grooves, 0, 4);
    tcase_add_loop_test(tests, tips_of_teeth, 0, 4);
    tcase_add_loop_test(tests, corners_between_points, 0, 12);
    tcase_add_test(tests, corners_far_from_points);
    tcase_add_loop_test(tests, unseen_walls, 0, 3);
    tcase_add_loop_test(tests, thin_parts, 0, 6);
    tcase_add_loop_test(tests, feet_of_pyramids, 0, 4);
    tcase_add_loop_test(tests, noisy_flanks, 0, 4);
    tcase_add_loop_test(tests, rims_of_pockets, 0, 4);
    tcase_add_loop_test(tests, rims_of_steps, 2, 6);
    tcase_add_loop_test(tests, boss_between_lines, 0, 4);
    tcase_add_loop_test(tests, no_tips_by_noise, 1, 4);
    suite_add_tcase(suite, tests);
    tcase_set_timeout(tests, 60);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
