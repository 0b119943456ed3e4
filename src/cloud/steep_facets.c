/* steep_facets - see steep_facets.h. */
#include "cloud/steep_facets.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/predicates.h"
#include "math/triangle_points.h"

/* Points about one, seen from above: where there are more they stand over each other, and what is
 * steep was scanned; corners about one of them. */
enum { CROWD = 400, STAR = 64 };

/* In mean spacings: no circle of a facet is wider; so near is a point that a steep way leads to; a
 * point that stands so far above a facet beside it makes a hollow. */
static const double GAP = 3, NEAR = 2, HOLLOW = 0.3, SURELY_HOLLOW = 0.15;

/* Rise for way, seen from above, of what is steep: 60 degrees; and a little more. */
static const double STEEP = 1.7, SURELY_STEEP = 2;

/* In mean spacings: the longest edge of a facet of a flank that has few points; times what a ball
 * may sink in: it may sink in along the edge; noises: less is no height. */
static const double LONG = 2.2, SINKS = 5, THROWN = 8;

/* Who asks: longest edge, in mean spacings, of facets in front of which the points do not tell what
 * is within reach; mm that a ball may sink in. */
static const double FAR_APART = 3, SINK = 0.002;

struct facets_work {
    const struct point_grid *scan;
    const struct steep_facets_options *options;
    const struct vec3 *place;
    double spacing;
    double least;        /* mm: the longest edge of a facet */
    bool *corner;        /* of each point: facets are looked for about it */
    struct vec3s *found; /* places, of each point */
    uint32_t *facets;    /* of each point, how many */
};

/* A point seen from another, as from above. */
struct beside {
    struct uv at;
    double far2;
    uint32_t index;
};

/* The points about one, nearest first; itself is not among them. */
struct about {
    size_t n;
    struct beside item[CROWD];
};

static int by_distance(const void *pa, const void *pb)
{
    const struct beside *a = pa, *b = pb;

    return a->far2 != b->far2 ? (a->far2 > b->far2) - (a->far2 < b->far2)
                              : (a->index > b->index) - (a->index < b->index);
}

/* The cells about a place, as far as `reach`. */
struct cells {
    size_t left, right, low, high;
};

static struct cells cells_about(const struct point_grid *g, struct vec3 p, double reach)
{
    return (struct cells){point_grid_column(g, p.x - reach), point_grid_column(g, p.x + reach),
                          point_grid_row(g, p.y - reach), point_grid_row(g, p.y + reach)};
}

/* A long way goes up or down steeply from the point to one near to it. */
static bool is_steep(const struct facets_work *work, size_t i)
{
    const struct point_grid *g = work->scan;
    struct vec3 p = g->point[i];
    double reach = NEAR * work->spacing;
    struct cells c = cells_about(g, p, reach);

    for (size_t row = c.low; row <= c.high; row++)
        for (size_t k = g->first[row * g->columns + c.left];
             k < g->first[row * g->columns + c.right + 1]; k++) {
            struct vec3 to = vec_sub(g->point[k], p);
            double far2 = to.x * to.x + to.y * to.y, up2 = to.z * to.z;
            if (far2 < reach * reach && up2 > far2 && up2 + far2 > work->least * work->least)
                return true;
        }
    return false;
}

/* False: there are too many. */
static bool find_about(const struct facets_work *work, size_t i, struct about *about)
{
    const struct point_grid *g = work->scan;
    struct vec3 p = g->point[i];
    double reach = GAP * work->spacing;
    struct cells c = cells_about(g, p, reach);

    about->n = 0;
    for (size_t row = c.low; row <= c.high; row++)
        for (size_t k = g->first[row * g->columns + c.left];
             k < g->first[row * g->columns + c.right + 1]; k++) {
            struct uv at = {g->point[k].x - p.x, g->point[k].y - p.y};
            double far2 = at.u * at.u + at.v * at.v;
            if (far2 >= reach * reach || far2 == 0)
                continue;
            if (about->n == CROWD)
                return false;
            about->item[about->n++] = (struct beside){at, far2, (uint32_t)k};
        }
    if (about->n > 0)
        qsort(about->item, about->n, sizeof *about->item, by_distance);
    return about->n > 0;
}

/* The corner of the facet to the left of the way from a to b: no point is in the circle of all
 * three; NONE: there is none. */
enum { NONE = CROWD };

static size_t third_corner(const struct about *about, struct uv a, struct uv b)
{
    size_t best = NONE;

    for (size_t k = 0; k < about->n; k++) {
        struct uv at = about->item[k].at;
        if (orient2d(a, b, at) > 0 &&
            (best == NONE || incircle(a, b, about->item[best].at, at) > 0))
            best = k;
    }
    return best;
}

/* Diameter of the circle through the origin and two places. */
static double circle_of(struct uv a, struct uv b)
{
    double area2 = fabs(a.u * b.v - a.v * b.u);
    double product = hypot(a.u, a.v) * hypot(b.u, b.v) * hypot(a.u - b.u, a.v - b.v);

    return area2 > 0 ? product / area2 : HUGE_VAL;
}

/* A corner of a facet, the one before it and the one after it, counter-clockwise from above. */
struct corner {
    size_t at, before, after;
};

static struct uv seen_from(const struct facets_work *work, size_t at, size_t i)
{
    struct vec3 way = vec_sub(work->scan->point[i], work->scan->point[at]);

    return (struct uv){way.x, way.y};
}

/* How far the point that makes the facet beyond an edge, or the corner, stands above a facet. */
static double stands_above(const struct facets_work *work, const struct about *about, size_t corner,
                           struct uv a, struct uv b, struct vec3 normal)
{
    size_t k = third_corner(about, a, b);

    return k == NONE
               ? -HUGE_VAL
               : vec_dot(normal, vec_sub(work->place[about->item[k].index], work->place[corner]));
}

/* What is beyond the two edges at a corner of a facet stands up above it. */
static bool is_hollow_at(const struct facets_work *work, const struct about *about,
                         const struct corner *corner, struct vec3 normal)
{
    const struct uv zero = {0, 0};
    double hollow = (work->options->sure ? SURELY_HOLLOW : HOLLOW) * work->spacing;
    struct uv before = seen_from(work, corner->at, corner->before);
    struct uv after = seen_from(work, corner->at, corner->after);

    return stands_above(work, about, corner->at, zero, before, normal) > hollow ||
           stands_above(work, about, corner->at, after, zero, normal) > hollow;
}

/* Each edge as seen from both its ends: from one the point beyond may be too far to be seen, and it
 * must not matter which is the first. */
static bool is_hollow(const struct facets_work *work, const struct about *about,
                      const size_t corner[3], struct vec3 normal, struct about *other)
{
    for (int k = 0; k < 3; k++) {
        struct corner at = {corner[k], corner[(k + 2) % 3], corner[(k + 1) % 3]};
        if (k > 0 && !find_about(work, at.at, other))
            continue;
        if (is_hollow_at(work, k == 0 ? about : other, &at, normal))
            return true;
    }
    return false;
}

/* The facet of three points, the first with those about it, is one that keeps a ball off. */
static bool is_wanted(const struct facets_work *work, const struct about *about,
                      const size_t corner[3], struct about *other)
{
    const struct steep_facets_options *o = work->options;
    struct vec3 p[3] = {work->place[corner[0]], work->place[corner[1]], work->place[corner[2]]};
    struct vec3 normal = vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]));
    double low = fmin(p[0].z, fmin(p[1].z, p[2].z));
    double high = fmax(p[0].z, fmax(p[1].z, p[2].z));

    return triangle_longest(p) > work->least && high - low > THROWN * o->noise && normal.z > 0 &&
           hypot(normal.x, normal.y) > (o->sure ? SURELY_STEEP : STEEP) * normal.z &&
           !(circle_of(seen_from(work, corner[0], corner[1]),
                       seen_from(work, corner[0], corner[2])) > GAP * work->spacing) &&
           !is_hollow(work, about, corner, vec_unit(normal), other);
}

/* Places on a facet, its edges with them: rows along the longest of these. */
static void fill_facet(const struct vec3 v[3], double pitch, struct vec3s *to)
{
    enum { MOST = 1000 };
    int first = triangle_longest_side(v);
    struct vec3 a = v[first], b = v[(first + 1) % 3], c = v[(first + 2) % 3];
    double rows = fmin(ceil(vec_line_distance(a, b, c) / pitch), MOST);
    for (double r = 0; r < rows; r++) {
        struct vec3 p = vec_mix(a, c, r / rows), q = vec_mix(b, c, r / rows);
        double n = fmin(ceil(vec_distance(p, q) / pitch), MOST);
        for (double k = 0; k <= n; k++)
            *array_push(to) = vec_mix(p, q, n > 0 ? k / n : 0);
    }
}

/* Facets are looked for about both points, and about the first of them first. */
static bool is_before(const struct facets_work *work, size_t i, size_t other)
{
    return i < other || !work->corner[other];
}

/* The facet of point i and two about it, if it is to be found about this one. */
static void take_facet(const struct facets_work *work, const struct about *about,
                       const size_t corner[3], struct about *other)
{
    size_t i = corner[0];
    double pitch = sqrt(6 * work->options->radius * work->options->sink);

    if (is_before(work, i, corner[1]) && is_before(work, i, corner[2]) &&
        is_wanted(work, about, corner, other)) {
        struct vec3 v[3] = {work->place[i], work->place[corner[1]], work->place[corner[2]]};
        fill_facet(v, pitch, &work->found[i]);
        work->facets[i]++;
    }
}

/* The facets about point i: counter-clockwise from the point nearest to it, which is next to it,
 * and where they end, at a gap, clockwise, too. */
static void fill_star(const struct facets_work *work, size_t i, const struct about *about,
                      struct about *other)
{
    const struct uv zero = {0, 0};
    bool back = false;
    size_t b = 0;

    for (int turn = 0; turn < STAR; turn++) {
        struct uv at = about->item[b].at;
        size_t c = back ? third_corner(about, at, zero) : third_corner(about, zero, at);
        if (c == NONE && back)
            return;
        if (c == NONE) {
            back = true;
            b = 0;
            continue;
        }
        size_t left = about->item[back ? c : b].index, right = about->item[back ? b : c].index;
        take_facet(work, about, (size_t[]){i, left, right}, other);
        b = c;
        if (b == 0)
            return;
    }
}

static void find_corners(void *context, size_t from, size_t to)
{
    const struct facets_work *work = context;
    struct about *about = mem_alloc(1, sizeof *about);

    for (size_t i = from; i < to; i++)
        work->corner[i] = is_steep(work, i) && find_about(work, i, about);
    free(about);
}

static void find_facets(void *context, size_t from, size_t to)
{
    const struct facets_work *work = context;
    struct about *about = mem_alloc(2, sizeof *about);

    for (size_t i = from; i < to; i++)
        if (work->corner[i] && find_about(work, i, &about[0]))
            fill_star(work, i, &about[0], &about[1]);
    free(about);
}

size_t steep_facets(const struct point_grid *scan, const struct steep_facets_options *options,
                    struct vec3s *to)
{
    struct facets_work work = {.scan = scan,
                               .options = options,
                               .place = options->place ? options->place : scan->point,
                               .spacing = point_grid_spacing(scan),
                               .corner = mem_alloc(scan->n + 1, sizeof *work.corner),
                               .found = mem_alloc(scan->n + 1, sizeof *work.found),
                               .facets = mem_alloc(scan->n + 1, sizeof *work.facets)};
    size_t facets = 0;

    work.least = fmax(fmax(LONG, options->longest) * work.spacing,
                      sqrt(8 * options->radius * SINKS * options->sink));
    for (size_t i = 0; i < scan->n; i++) {
        work.found[i] = (struct vec3s){0};
        work.facets[i] = 0;
    }
    parallel_for(options->threads, scan->n, find_corners, &work);
    parallel_for(options->threads, scan->n, find_facets, &work);
    for (size_t i = 0; i < scan->n; i++) {
        facets += work.facets[i];
        for (size_t k = 0; k < work.found[i].n; k++)
            *array_push(to) = work.found[i].item[k];
        array_free(&work.found[i]);
    }
    free(work.corner);
    free(work.found);
    free(work.facets);
    return facets;
}

void steep_facets_asked(const struct point_grid *scan, double radius, double noise, int threads,
                        struct vec3s *to)
{
    const struct steep_facets_options options = {
        .radius = radius, .sink = SINK, .noise = noise, .longest = FAR_APART, .threads = threads};

    steep_facets(scan, &options, to);
}

void steep_facets_sure(const struct point_grid *scan, const struct vec3 *place, double radius,
                       double noise, int threads, struct vec3s *to)
{
    const struct steep_facets_options options = {.place = place,
                                                 .radius = radius,
                                                 .sink = SINK,
                                                 .noise = noise,
                                                 .sure = true,
                                                 .threads = threads};

    steep_facets(scan, &options, to);
}
