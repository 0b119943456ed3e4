/* steep_facets - see steep_facets.h. */
#include "cloud/steep_facets.h"

#include <stdlib.h>

#include "math/triangle_points.h"
#include "plan_star.h"

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
    struct vec3s *found; /* places, of each point */
    uint32_t *facets;    /* of each point, how many */
};

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
static double stands_above(const struct facets_work *work, const struct plan_about *about,
                           size_t corner, struct uv a, struct uv b, struct vec3 normal)
{
    size_t k = plan_star_corner(about, a, b);

    return k == PLAN_STAR_NONE
               ? -HUGE_VAL
               : vec_dot(normal, vec_sub(work->place[about->item[k].index], work->place[corner]));
}

/* What is beyond the two edges at a corner of a facet stands up above it. */
static bool is_hollow_at(const struct facets_work *work, const struct plan_about *about,
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
static bool is_hollow(const struct facets_work *work, const struct plan_about *about,
                      const size_t corner[3], struct vec3 normal, struct plan_about *other)
{
    for (int k = 0; k < 3; k++) {
        struct corner at = {corner[k], corner[(k + 2) % 3], corner[(k + 1) % 3]};
        if (k > 0 && !plan_star_about(work->scan, at.at, GAP * work->spacing, other))
            continue;
        if (is_hollow_at(work, k == 0 ? about : other, &at, normal))
            return true;
    }
    return false;
}

/* The facet of three points, the first with those about it, is one that keeps a ball off. */
static bool is_wanted(const struct facets_work *work, const struct plan_about *about,
                      const size_t corner[3], struct plan_about *other)
{
    const struct steep_facets_options *o = work->options;
    struct vec3 p[3] = {work->place[corner[0]], work->place[corner[1]], work->place[corner[2]]};
    struct vec3 normal = vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]));
    double low = fmin(p[0].z, fmin(p[1].z, p[2].z));
    double high = fmax(p[0].z, fmax(p[1].z, p[2].z));

    return triangle_longest(p) > work->least && high - low > THROWN * o->noise && normal.z > 0 &&
           hypot(normal.x, normal.y) > (o->sure ? SURELY_STEEP : STEEP) * normal.z &&
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

/* A facet that the scan has. */
static void take_facet(void *context, const struct plan_about *about, const size_t corner[3],
                       struct plan_about *other)
{
    const struct facets_work *work = context;
    size_t i = corner[0];
    double pitch = sqrt(6 * work->options->radius * work->options->sink);

    if (is_wanted(work, about, corner, other)) {
        struct vec3 v[3] = {work->place[i], work->place[corner[1]], work->place[corner[2]]};
        fill_facet(v, pitch, &work->found[i]);
        work->facets[i]++;
    }
}

size_t steep_facets(const struct point_grid *scan, const struct steep_facets_options *options,
                    struct vec3s *to)
{
    struct facets_work work = {.scan = scan,
                               .options = options,
                               .place = options->place ? options->place : scan->point,
                               .spacing = point_grid_spacing(scan),
                               .found = mem_alloc(scan->n + 1, sizeof *work.found),
                               .facets = mem_alloc(scan->n + 1, sizeof *work.facets)};
    size_t facets = 0;

    work.least = fmax(fmax(LONG, options->longest) * work.spacing,
                      sqrt(8 * options->radius * SINKS * options->sink));
    for (size_t i = 0; i < scan->n; i++) {
        work.found[i] = (struct vec3s){0};
        work.facets[i] = 0;
    }
    const struct plan_star_options star = {GAP * work.spacing, work.least, NEAR * work.spacing,
                                           options->threads};
    plan_star_facets(scan, &star, take_facet, &work);
    for (size_t i = 0; i < scan->n; i++) {
        facets += work.facets[i];
        for (size_t k = 0; k < work.found[i].n; k++)
            *array_push(to) = work.found[i].item[k];
        array_free(&work.found[i]);
    }
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
