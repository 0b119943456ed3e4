/* scan_normals - see scan_normals.h. */
#include "meshing/scan_normals.h"

#include <stdlib.h>

#include "cloud/noise.h"
#include "math/cubic.h"
#include "math/moment_fit.h"
#include "base/parallel.h"

enum { MOST_TIMES = 32, QUADRIC = 6, CUBIC = 10 /* terms */ };

/* Of the neighbours, so many lie in the ball of the first round, whose cubic may leave so much of
 * the noise or of the points' spacing; the lean of the points there, at most. */
static const double PART = 0.9, EXPLAINED = 1.4, FINE = 0.01, SURROUNDED = 0.25;

struct estimation {
    struct mesh *mesh;
    const struct point_grid *point_grid;
    size_t neighbours;
    const double *certain;
    double spacing;
    double *distance; /* of each vertex from its quadric; negative: it has none */
};

/* Noise spreads the nearer half about its quadric as much as the whole; where it is spread much
 * less, the surface bends too much for one quadric over the whole, and the half counts. */
static void fit_half(const struct vec3 *near, size_t n, struct vec3 origin, struct quadric *q)
{
    const double much = 0.5;
    const size_t fewest = 12;
    struct quadric half;
    if (n / 2 >= fewest && quadric_settle(near, n / 2, origin, quadric_normal(q), &half) == 0 &&
        quadric_spread(&half, near, n / 2, QUADRIC) < much * quadric_spread(q, near, n, QUADRIC))
        *q = half;
}

/* Where the surface is smooth but no quadric, the third degree explains what noise would not let it
 * explain. */
static void fit_cubic(const struct vec3 *near, size_t n, struct vec3 origin, struct quadric *q)
{
    const double much = 0.5;
    struct quadric cubic;
    size_t some = 3 * n / 5;
    if (some >= 2 * CUBIC && cubic_fit(near, NULL, some, origin, quadric_normal(q), &cubic) == 0 &&
        quadric_spread(&cubic, near, some, CUBIC) < much * quadric_spread(q, near, n / 2, QUADRIC))
        *q = cubic;
}

/* The neighbourhood of the vertex in hand, nearest first. */
struct neighbourhood {
    uint32_t *index;
    double *distance2;
    struct vec3 *point;
};

static int fit_at(const struct estimation *e, struct vec3 vertex, struct vec3 guess,
                  const struct neighbourhood *near, struct quadric *q)
{
    for (size_t k = e->neighbours; k <= MOST_TIMES * e->neighbours; k *= 2) {
        size_t n = point_grid_nearest(e->point_grid, vertex, k, near->index, near->distance2);
        for (size_t i = 0; i < n; i++)
            near->point[i] = e->point_grid->point[near->index[i]];
        if (quadric_fit_steep(near->point, n, vertex, guess, q) == 0) {
            if (k == e->neighbours) {
                fit_half(near->point, n, vertex, q);
                fit_cubic(near->point, n, vertex, q);
            }
            return 0;
        }
        if (n < k)
            break;
    }
    return -1;
}

/* The first round. */
static bool fit_moments(const struct estimation *e, struct vec3 vertex, struct vec3 guess,
                        struct quadric *q)
{
    double radius = moment_fit_radius(PART * (double)e->neighbours, e->spacing, guess);
    double least = fmax(EXPLAINED * e->mesh->origin.noise, FINE * e->spacing);
    struct moment_fit fit;

    if (moment_fit_ball(e->point_grid, vertex, guess, radius, &fit) < 0 || fit.lean > SURROUNDED ||
        fit.cubic_spread > least)
        return false;
    *q = *moment_fit_better(&fit);
    return true;
}

static void fit_vertices(void *context, size_t from, size_t to)
{
    const struct estimation *e = context;
    struct mesh *mesh = e->mesh;
    size_t most = MOST_TIMES * e->neighbours;
    struct neighbourhood near = {mem_alloc(most, sizeof *near.index),
                                 mem_alloc(most, sizeof *near.distance2),
                                 mem_alloc(most, sizeof *near.point)};
    for (size_t i = from; i < to; i++) {
        struct quadric q;
        struct vec3 up = mesh->normal.item[i], at = mesh->vertex.item[i];
        e->distance[i] = e->certain ? e->certain[i] : -1;
        if (e->distance[i] >= 0)
            continue;
        mesh->kmax.item[i] = 0;
        if (!fit_moments(e, at, up, &q) && fit_at(e, at, up, &near, &q) < 0)
            continue;
        mesh->normal.item[i] = quadric_normal(&q);
        mesh->kmax.item[i] = quadric_curvature(&q);
        e->distance[i] = quadric_distance(&q);
    }
    free(near.index);
    free(near.distance2);
    free(near.point);
}

/* Gathers the distances that are there (not below 0) to the front of the array. */
struct scan_normals scan_normals_summary(double *distance, size_t n)
{
    struct scan_normals s = {0};
    double sum2 = 0;
    for (size_t i = 0; i < n; i++) {
        if (distance[i] < 0) {
            s.thin++;
            continue;
        }
        sum2 += distance[i] * distance[i];
        if (distance[i] > s.worst) {
            s.worst = distance[i];
            s.at = i;
        }
        distance[s.fitted++] = distance[i];
    }
    s.rms = s.fitted > 0 ? sqrt(sum2 / (double)s.fitted) : 0;
    s.sigma = noise_of_distances(distance, s.fitted);
    return s;
}

void scan_normals_fit(struct mesh *mesh, const struct point_grid *point_grid,
                      const struct scan_normals_options *options, double *distance)
{
    size_t vertices = mesh->vertex.n;
    struct estimation e = {mesh,
                           point_grid,
                           (size_t)options->neighbours,
                           options->certain,
                           point_grid_spacing(point_grid),
                           distance};

    if (!options->certain)
        mesh_normals_facet(mesh);
    array_reserve(&mesh->kmax, vertices);
    mesh->kmax.n = vertices;
    parallel_for(options->threads, vertices, fit_vertices, &e);
}

struct scan_normals scan_normals_quadric(struct mesh *mesh, const struct point_grid *point_grid,
                                         const struct scan_normals_options *options)
{
    double *certain = options->certain;
    double *distance = certain ? certain : mem_alloc(mesh->vertex.n, sizeof *distance);

    scan_normals_fit(mesh, point_grid, options, distance);
    struct scan_normals result = scan_normals_summary(distance, mesh->vertex.n);
    if (!certain)
        free(distance);
    return result;
}
