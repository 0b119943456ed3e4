/* rim_points - see rim_points.h. */
#include "cloud/rim_points.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/quadric.h"

enum {
    SECTORS = 24, /* of a turn, in which there are points, or none ... */
    OPEN = 8,     /* ... at a rim in so many beside each other, ... */
    SPUR = 13,    /* ... and at what is as narrow as points are apart */
    WAYS = 3,     /* on which the surface is gone on with, from one rim point */
    SMOOTH = 24,  /* points that a surface goes through, ... */
    FEW = 12,     /* ... or where these are none: half as many; a plane through ... */
    LEAST = 7,
    TERMS = 6 /* of a quadric */
};

/* In mean spacings, seen from above: so far there is no point beyond a rim; so far the surface is
 * gone on with. */
static const double ABOUT = 3, BEYOND = 1.5;

/* In mean spacings, and in noises: points are no further off a surface of theirs on average. */
static const double EVEN = 0.04, SIGMAS = 1.5;

/* Standard deviations that a place may lie too high by, of the points from their surface; and of
 * points that lie on no surface from their plane. */
static const double SURE = 2, LOW = 1;

/* Sines of the slope down: a flank is gone on with further from the first on, as far as the ball is
 * wide if it is upright; an even one that goes down less than the last but one, or up, was cut off;
 * one that nobody knows goes on where it goes down by more than the last. */
static const double STEEP = 0.8, UPRIGHT = 0.02, LEVEL = 0.05, FLANK = 0.5;

/* Variance of a plane's slope, for points off it by as much as they are apart: it is unknown, as
 * where all points are on one line of a scan. */
static const double VAGUE = 3;

/* Of the way on: where it goes up. */
static const double RISES = 0.5;

/* In mean spacings: a chord along a spur is so long; it goes on so far, up by no more than that. */
static const double SHORT = 0.6, LONG = 2, TIP = 1;

/* Cosine of 45 degrees: points so far aside of a way lie that way. */
static const double AHEAD = 0.7;

/* From that slope on (68 degrees) no curtain hangs (roof.h): one hangs where the flank ends. */
static const double HANGS = 0.93;

struct rim_work {
    const struct point_grid *scan;
    uint32_t *filled; /* of each point the sectors that have points */
};

static unsigned sector_of(double x, double y)
{
    return (unsigned)((atan2(y, x) + PI) / (2 * PI) * SECTORS) % SECTORS;
}

static uint32_t look_about(const struct point_grid *g, size_t i)
{
    double reach = ABOUT * point_grid_spacing(g);
    struct point_grid_walk about = point_grid_about(g, g->point[i], reach);
    uint32_t filled = 0;

    for (size_t k; point_grid_next(&about, &k);) {
        double x = g->point[k].x - g->point[i].x, y = g->point[k].y - g->point[i].y;
        if (x * x + y * y < reach * reach && (x != 0 || y != 0))
            filled |= 1u << sector_of(x, y);
    }
    return filled;
}

static void find_filled(void *context, size_t from, size_t to)
{
    const struct rim_work *work = context;

    for (size_t i = from; i < to; i++)
        work->filled[i] = look_about(work->scan, i);
}

/* The widest run of empty sectors: its first in *first. */
static unsigned widest_open(uint32_t filled, unsigned *first)
{
    unsigned widest = 0, run = 0;

    for (unsigned k = 0; k < 2 * SECTORS; k++) {
        run = filled & 1u << k % SECTORS ? 0 : run + 1;
        if (run > widest && run <= SECTORS) {
            widest = run;
            *first = (k + 1 - run) % SECTORS;
        }
    }
    return widest;
}

/* The surface at a point of the rim, how far it is gone on with, and the lowest place.  Not even:
 * it is a plane along the nearest points. */
struct rim_way {
    struct vec3 near[SMOOTH]; /* the points about it, itself the first */
    struct quadric q;
    bool even, vague; /* vague: not even the plane is known */
    double beyond, bottom, spacing;
    double off; /* standard deviation of points from it, mm */
};

/* A plane along the points, and below most of them. */
static struct quadric plane_below(const struct vec3 *near, size_t n)
{
    struct quadric plane = quadric_frame(near[0], plane_normal(near, n));
    double uu = 0, vv = 0, uv = 0;

    quadric_face_up(&plane);
    for (size_t k = 0; k < n; k++) {
        struct vec3 at = quadric_local(&plane, near[k]);
        plane.c[0] += at.z / (double)n;
        uu += at.x * at.x;
        vv += at.y * at.y;
        uv += at.x * at.y;
    }
    plane.c[0] -= LOW * quadric_rms(&plane, near, n);
    plane.variance = 1 / (double)n;
    plane.tilt_u = vv / (uu * vv - uv * uv);
    plane.tilt = plane.tilt_u + uu / (uu * vv - uv * uv);
    plane.tilt_uv = -uv / (uu * vv - uv * uv);
    return plane;
}

/* The surface about point i, or, where none is even, a plane; facing up.  -1: it is upright. */
static int surface_about(const struct point_grid *scan, double noise, size_t i, struct rim_way *rim)
{
    struct vec3 *near = rim->near;
    struct quadric *q = &rim->q;
    size_t n = point_grid_near(scan, scan->point[i], SMOOTH, near);
    double even = fmax(EVEN * point_grid_spacing(scan), SIGMAS * noise);

    if (n < SMOOTH)
        return -1;
    for (; n >= FEW; n /= 2)
        if (quadric_fit_free(near, n, near[0], q) == 0 && quadric_rms(q, near, n) <= even)
            break;
    rim->even = n >= FEW;
    if (!rim->even)
        *q = plane_below(near, LEAST);
    rim->vague = !rim->even && !(q->tilt * rim->spacing * rim->spacing < VAGUE);
    if (rim->vague)
        *q = plane_below(near, FEW);
    rim->off = rim->even ? fmax(noise, quadric_spread(q, near, n, TERMS)) : noise;
    quadric_face_up(q);
    return quadric_normal(q).z > UPRIGHT ? 0 : -1;
}

/* Points of the scan lie that way: it has an undercut, that was scanned. */
static bool has_ahead(const struct rim_way *rim, struct vec3 way)
{
    for (int k = 1; k < SMOOTH; k++) {
        struct vec3 to = vec_sub(rim->near[k], rim->near[0]);
        if (vec_dot(to, way) > AHEAD * vec_length(to))
            return true;
    }
    return false;
}

/* What the surface is surely no lower than, so far from its origin: the lower of it and of its
 * tangent plane, less what these are uncertain by. */
static struct vec3 surely(const struct rim_way *rim, double u, double v)
{
    const struct quadric *q = &rim->q;
    double far2 = u * u + v * v;

    struct vec3 at = vec_along(vec_along(q->origin, u, q->u), v, q->v);
    double plane = q->c[0] + q->c[1] * u + q->c[2] * v;
    double w = fmin(vec_dot(vec_sub(quadric_at(q, u, v), q->origin), q->w), plane);
    struct vec3 way = vec_add(vec_scale(u, q->u), vec_scale(v, q->v));
    double tilt = far2 > 0 ? sqrt(far2 * quadric_tilt_along(q, way)) : 0;
    return vec_along(at, w - SURE * rim->off * (sqrt(q->variance) + tilt), q->w);
}

/* On from a place the way from the one before, as far as the flank is steep. */
static void go_down(struct vec3 before, struct vec3 last, const struct rim_way *rim, bool hangs,
                    const struct rim_points_options *options, struct vec3s *to)
{
    struct vec3 way = vec_unit(vec_sub(last, before));
    double pitch = options->pitch, far = pitch;
    double down = fmin((-way.z - STEEP) / (1 - STEEP), 1) * options->radius;

    for (; far < down; far += pitch)
        *array_push(to) = vec_along(last, far, way);
    last = vec_along(last, far, way);
    for (double low = last.z; hangs && -way.z > HANGS && low > rim->bottom; low -= options->gap)
        *array_push(to) = vec(last.x, last.y, low);
}

/* From the point over the surface's origin along (x, y), as seen from above; down to the bottom
 * where it hangs. */
static void go_on(const struct rim_way *rim, double x, double y, bool hangs,
                  const struct rim_points_options *options, struct vec3s *to)
{
    const struct quadric *q = &rim->q;
    struct vec3 n = quadric_normal(q);
    struct vec3 way = vec_unit(vec(x * n.z, y * n.z, -(x * n.x + y * n.y)));
    double u = vec_dot(way, q->u), v = vec_dot(way, q->v);
    double beyond = (way.z > 0 ? RISES : 1) * rim->beyond;
    struct vec3 last = surely(rim, 0, 0), before = last;
    size_t steps = (size_t)ceil(beyond / options->pitch);

    if ((rim->even && way.z > -LEVEL) || (rim->vague && way.z > -FLANK) || has_ahead(rim, way))
        return;
    for (size_t k = 1; k <= steps; k++) {
        double far = beyond * (double)k / (double)steps;
        before = last;
        last = surely(rim, far * u, far * v);
        *array_push(to) = last;
    }
    go_down(before, last, rim, hangs, options, to);
}

/* The steepest way up from a point behind, as far back as a chord is long: its rise for its length
 * as seen from above; -HUGE_VAL without such a point. */
static double chord_on(const struct rim_way *rim, double x, double y)
{
    double steepest = -HUGE_VAL;

    for (int k = 1; k < FEW; k++) {
        struct vec3 from = vec_sub(rim->near[0], rim->near[k]);
        double far = hypot(from.x, from.y);
        if (far > SHORT * rim->spacing && far < LONG * rim->spacing &&
            from.x * x + from.y * y > AHEAD * far)
            steepest = fmax(steepest, from.z / far);
    }
    return steepest;
}

/* At the tip of what is as narrow as points are apart: its crest may go on. */
static void go_on_tip(const struct rim_way *rim, double x, double y,
                      const struct rim_points_options *options, struct vec3s *to)
{
    double rise = fmin(chord_on(rim, x, y), TIP), far = TIP * rim->spacing;
    struct vec3 way = vec_unit(vec(x, y, rise));
    size_t steps = (size_t)ceil(far / options->pitch);

    if (rise == -HUGE_VAL || has_ahead(rim, way))
        return;
    for (size_t k = 1; k <= steps; k++)
        *array_push(to) = vec_along(rim->near[0], far * (double)k / (double)steps, way);
    go_down(rim->near[0], to->item[to->n - 1], rim, false, options, to);
}

size_t rim_points(const struct point_grid *scan, const struct rim_points_options *options,
                  struct vec3s *to)
{
    struct rim_work work = {scan, mem_alloc(scan->n + 1, sizeof *work.filled)};
    struct rim_way way = {
        .beyond = BEYOND * point_grid_spacing(scan),
        .spacing = point_grid_spacing(scan),
        .bottom = HUGE_VAL,
    };
    size_t rim = 0;

    for (size_t i = 0; i < scan->n; i++)
        way.bottom = fmin(way.bottom, scan->point[i].z);
    parallel_for(options->threads, scan->n, find_filled, &work);
    for (size_t i = 0; i < scan->n; i++) {
        unsigned first = 0, open = widest_open(work.filled[i], &first);
        if (open < OPEN || open == SECTORS || surface_about(scan, options->noise, i, &way) != 0)
            continue;
        rim++;
        for (int k = 1; k <= WAYS; k++) {
            double angle = 2 * PI * (first + (double)open * k / (WAYS + 1)) / SECTORS - PI;
            double x = cos(angle), y = sin(angle);
            go_on(&way, x, y, 2 * k == WAYS + 1, options, to);
            if (!way.even && !way.vague && open >= SPUR)
                go_on_tip(&way, x, y, options, to);
        }
    }
    free(work.filled);
    return rim;
}

void rim_points_asked(const struct point_grid *scan, double radius, double noise, int threads,
                      struct vec3s *to)
{
    const double sink = 0.002, gap = 0.25; /* mm that it sinks between places; of the radius */
    const struct rim_points_options options = {.pitch = sqrt(8 * radius * sink),
                                               .gap = gap * radius,
                                               .radius = radius,
                                               .noise = noise,
                                               .threads = threads};

    rim_points(scan, &options, to);
}
