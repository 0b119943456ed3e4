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

static struct smooth_nodes summarize(const struct smoothing *s)
{
    struct smooth_nodes r = {.typical = s->rule.neighbours};
    double sum = 0;
    for (size_t i = 0; i < s->mesh->vertex.n; i++) {
        r.thin += s->distance[i] < 0;
        r.kept += s->distance[i] >= 0 && s->variance[i] < 0;
        if (s->variance[i] < 0)
            continue;
        r.moved++;
        sum += s->variance[i];
        if (s->distance[i] > r.farthest) {
            r.farthest = s->distance[i];
            r.at = i;
        }
    }
    r.error = r.moved > 0 ? s->rule.sigma * sqrt(sum / (double)r.moved) : 0;
    return r;
}

/* How many points to begin with: `wanted`, but for the effort. */
static size_t neighbours_of(size_t wanted, size_t vertices, double effort)
{
    double most = (double)effort_most(EFFORT_NEIGHBOURS, effort) / (double)vertices;
    double affordable = fmax(most, FEWEST);

    return (double)wanted > affordable ? (size_t)affordable : wanted;
}

struct smooth_nodes smooth_nodes(struct mesh *mesh, const struct point_grid *point_grid,
                                 const struct smooth_nodes_options *options)
{
    size_t n = mesh->vertex.n, wanted = options->neighbours;
    struct smoothing s = {.mesh = mesh,
                          .rule = {point_grid, options->sigma, options->neighbours,
                                   effort_covers(EFFORT_ALONG, options->effort, n),
                                   options->first}};
    mesh_normals_facet(mesh);
    array_reserve(&mesh->kmax, n);
    mesh->kmax.n = n;
    if (wanted == 0) {
        wanted =
            surface_fit_typical(&s.rule, mesh->vertex.item, mesh->normal.item, n, options->threads);
        s.rule.neighbours = neighbours_of(wanted, n, options->effort);
    }
    s.variance = mem_alloc(n, sizeof *s.variance);
    s.distance = mem_alloc(n, sizeof *s.distance);
    parallel_for(options->threads, n, smooth_vertices, &s);
    struct smooth_nodes result = summarize(&s);
    result.wanted = wanted;
    free(s.variance);
    free(s.distance);
    return result;
}
