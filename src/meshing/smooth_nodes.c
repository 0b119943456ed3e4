/* smooth_nodes - see smooth_nodes.h. */
#include "meshing/smooth_nodes.h"

#include <stdlib.h>

#include "base/effort.h"
#include "base/parallel.h"
#include "math/surface_fit.h"

enum { FEWEST = 56 }; /* points that a surface begins with, however many vertices there are */

struct smoothing {
    struct mesh *mesh;
    struct surface_fit_options rule;
    double *variance; /* of each vertex, in sigma^2; negative: not moved */
    double *distance; /* that it was moved; negative: there was no surface at all */
};

static void smooth_vertices(void *context, size_t from, size_t to)
{
    const double far = 8;     /* in sigma */
    const double down = -0.1; /* a scan seen from above: slivers may say otherwise */
    const struct smoothing *s = context;
    double sigma = s->rule.sigma;
    struct mesh *mesh = s->mesh;
    struct surface_fit_hood *hood = surface_fit_hood_new();
    for (size_t i = from; i < to; i++) {
        struct surface_fit fit;
        struct vec3 *vertex = &mesh->vertex.item[i];
        s->variance[i] = s->distance[i] = -1;
        mesh->kmax.item[i] = 0;
        if (!surface_fit_at(&s->rule, *vertex, mesh->normal.item[i], hood, &fit))
            continue;
        struct vec3 normal = quadric_normal(&fit.q);
        mesh->normal.item[i] = normal.z < down ? vec_scale(-1, normal) : normal;
        mesh->kmax.item[i] = quadric_curvature(&fit.q);
        s->distance[i] = 0;
        struct vec3 foot = quadric_foot(&fit.q);
        if (!surface_fit_holds(&fit, sigma) || vec_distance(foot, *vertex) > far * sigma)
            continue;
        s->variance[i] = fit.q.variance;
        s->distance[i] = vec_distance(foot, *vertex);
        *vertex = foot;
    }
    surface_fit_hood_free(hood);
}

void smooth_nodes_count(const double *variance, const double *distance, size_t n, size_t first,
                        struct smooth_nodes *r, double *sum)
{
    for (size_t i = 0; i < n; i++) {
        r->thin += distance[i] < 0;
        r->kept += distance[i] >= 0 && variance[i] < 0;
        if (variance[i] < 0)
            continue;
        r->moved++;
        *sum += variance[i];
        if (distance[i] > r->farthest) {
            r->farthest = distance[i];
            r->at = first + i;
        }
    }
}

/* How many points to begin with: `wanted`, but for the effort. */
static size_t neighbours_of(size_t wanted, size_t vertices, double effort)
{
    double most = (double)effort_most(EFFORT_NEIGHBOURS, effort) / (double)vertices;
    double affordable = fmax(most, FEWEST);

    return (double)wanted > affordable ? (size_t)affordable : wanted;
}

struct surface_fit_options smooth_nodes_rule(const struct point_grid *point_grid,
                                             const struct smooth_nodes_options *options,
                                             size_t vertices, const struct vec3 *place,
                                             const struct vec3 *normal, size_t places,
                                             struct smooth_nodes *r)
{
    struct surface_fit_options rule = {point_grid, options->sigma, options->neighbours,
                                       effort_covers(EFFORT_ALONG, options->effort, vertices),
                                       options->first};

    r->wanted = options->neighbours;
    if (r->wanted == 0) {
        r->wanted = surface_fit_typical(&rule, place, normal, places, options->threads);
        rule.neighbours = neighbours_of(r->wanted, vertices, options->effort);
    }
    r->typical = rule.neighbours;
    return rule;
}

void smooth_nodes_fit(struct mesh *mesh, const struct surface_fit_options *rule, int threads,
                      double *variance, double *distance)
{
    struct smoothing s = {mesh, *rule, variance, distance};

    array_reserve(&mesh->kmax, mesh->vertex.n);
    mesh->kmax.n = mesh->vertex.n;
    parallel_for(threads, mesh->vertex.n, smooth_vertices, &s);
}

struct smooth_nodes smooth_nodes(struct mesh *mesh, const struct point_grid *point_grid,
                                 const struct smooth_nodes_options *options)
{
    size_t n = mesh->vertex.n;
    struct smooth_nodes r = {.moved = 0};
    double *variance = mem_alloc(n, sizeof *variance), *distance = mem_alloc(n, sizeof *distance);
    double sum = 0;

    mesh_normals_facet(mesh);
    const struct surface_fit_options rule =
        smooth_nodes_rule(point_grid, options, n, mesh->vertex.item, mesh->normal.item, n, &r);
    smooth_nodes_fit(mesh, &rule, options->threads, variance, distance);
    smooth_nodes_count(variance, distance, n, 0, &r, &sum);
    r.error = r.moved > 0 ? options->sigma * sqrt(sum / (double)r.moved) : 0;
    free(variance);
    free(distance);
    return r;
}
