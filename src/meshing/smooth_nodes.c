/* smooth_nodes - see smooth_nodes.h. */
#include "meshing/smooth_nodes.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/surface_fit.h"

enum { RIBS = 71000 }; /* ribs are looked along on meshes of fewer vertices, for its time */

struct job {
    struct mesh *mesh;
    struct surface_fit_options rule;
    double *variance; /* of each vertex, in sigma^2; negative: not moved */
    double *distance; /* that it was moved; negative: there was no surface at all */
};

static void smooth_vertices(void *context, size_t from, size_t to)
{
    const double far = 8;     /* in sigma */
    const double down = -0.1; /* a scan seen from above: slivers may say otherwise */
    const struct job *job = context;
    double sigma = job->rule.sigma;
    struct mesh *mesh = job->mesh;
    struct surface_fit_hood *hood = surface_fit_hood_new();
    for (size_t i = from; i < to; i++) {
        struct surface_fit fit;
        struct vec3 *vertex = &mesh->vertex.item[i];
        job->variance[i] = job->distance[i] = -1;
        mesh->kmax.item[i] = 0;
        if (!surface_fit_at(&job->rule, *vertex, mesh->normal.item[i], hood, &fit))
            continue;
        struct vec3 normal = quadric_normal(&fit.q);
        mesh->normal.item[i] = normal.z < down ? vec_scale(-1, normal) : normal;
        mesh->kmax.item[i] = quadric_curvature(&fit.q);
        job->distance[i] = 0;
        struct vec3 foot = quadric_foot(&fit.q);
        if (!surface_fit_holds(&fit, sigma) || vec_distance(foot, *vertex) > far * sigma)
            continue;
        job->variance[i] = fit.q.variance;
        job->distance[i] = vec_distance(foot, *vertex);
        *vertex = foot;
    }
    surface_fit_hood_free(hood);
}

static struct smooth_nodes sum_up(const struct job *job)
{
    struct smooth_nodes s = {.typical = job->rule.neighbours};
    double sum = 0;
    for (size_t i = 0; i < job->mesh->vertex.n; i++) {
        s.thin += job->distance[i] < 0;
        s.kept += job->distance[i] >= 0 && job->variance[i] < 0;
        if (job->variance[i] < 0)
            continue;
        s.moved++;
        sum += job->variance[i];
        if (job->distance[i] > s.farthest) {
            s.farthest = job->distance[i];
            s.at = i;
        }
    }
    s.error = s.moved > 0 ? job->rule.sigma * sqrt(sum / (double)s.moved) : 0;
    return s;
}

struct smooth_nodes smooth_nodes(struct mesh *mesh, const struct point_grid *point_grid,
                                 double sigma, size_t neighbours, int threads)
{
    size_t n = mesh->vertex.n;
    struct job job = {.mesh = mesh, .rule = {point_grid, sigma, neighbours, n < RIBS}};
    mesh_normals_facet(mesh);
    array_reserve(&mesh->kmax, n);
    mesh->kmax.n = n;
    if (neighbours == 0)
        job.rule.neighbours =
            surface_fit_typical(&job.rule, mesh->vertex.item, mesh->normal.item, n, threads);
    job.variance = mem_alloc(n, sizeof *job.variance);
    job.distance = mem_alloc(n, sizeof *job.distance);
    parallel_for(threads, n, smooth_vertices, &job);
    struct smooth_nodes result = sum_up(&job);
    free(job.variance);
    free(job.distance);
    return result;
}
