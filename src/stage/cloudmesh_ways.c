/*
 * cloudmesh_ways - the ways to a mesh that paper 1 reviews, beside its own: rows and columns by
 * interpolation (Lin and Liu), and a triangulation of the points themselves (Choi).
 */
#include <stdlib.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "cloudmesh_steps.h"
#include "mesh/mesh_distance.h"
#include "meshing/delaunay_mesh.h"
#include "meshing/lin_grid.h"
#include "meshing/reposition.h"

enum { MOST_POINTS = 1000000000 / 3 };

static double gap_of(const struct cloudmesh_options *options, double mean)
{
    return options->max_gap > 0 ? options->max_gap : 6 * mean;
}

/* How far the points above and under the mesh are from it. */
static int measure(const struct mesh *mesh, const struct vec3s *points, double mean, int threads,
                   struct adaptive_rows *rows, struct error *error)
{
    struct vec3s judged = {0};
    double sum2 = 0;

    if (mesh_coverage(mesh, points->item, points->n, mean, &judged, error) < 0)
        return -1;
    double *distance = mem_alloc(judged.n, sizeof *distance);
    mesh_distance(mesh, judged.item, judged.n, threads, distance);
    for (size_t i = 0; i < judged.n; i++) {
        sum2 += distance[i] * distance[i];
        if (distance[i] > rows->worst) {
            rows->worst = distance[i];
            rows->at = judged.item[i];
        }
    }
    rows->rms = judged.n > 0 ? sqrt(sum2 / (double)judged.n) : 0;
    rows->beside = points->n - judged.n;
    free(distance);
    array_free(&judged);
    return 0;
}

/* ---- rows and columns by interpolation */

/* The facets between nodes that have a height and over no hole. */
static struct grid_mesh_count mesh_of_net(const struct lin_grid *net, const struct holes *holes,
                                          struct mesh *mesh)
{
    size_t nodes = net->columns * net->rows;
    size_t *chosen = mem_alloc(nodes, sizeof *chosen);
    struct vec3 *node = mem_alloc(nodes, sizeof *node);
    struct grid grid = {.columns = (int)net->columns, .rows = (int)net->rows};

    for (size_t i = 0; i < nodes; i++) {
        node[i] = lin_grid_node(net, i % net->columns, i / net->columns);
        chosen[i] = isnan(net->z[i]) ? NO_POINT : i;
    }
    struct grid_mesh_count count = grid_mesh_make(&grid, chosen, node, holes, 1, mesh);
    free(node);
    free(chosen);
    return count;
}

static int mesh_by_lin(const struct cloudmesh_options *options, struct vec3s *points, double mean,
                       struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    double t = options->spacing > 0 ? options->spacing : cloudmesh_default_spacing(mean);
    double gap = gap_of(options, mean);
    struct lin_grid_options how = {t, mean, gap, fmax(t, 2 * mean)};
    struct plan_extent f = plan_extent_of(points->item, points->n, options->direction);
    struct holes holes;
    struct lin_grid net;

    if (holes_find(points->item, points->n, gap, fmax(t / 2, 1.5 * mean), &holes, error) < 0)
        return -1;
    int status = lin_grid_make(&f, points->item, points->n, &how, &net, error);
    if (status == 0) {
        result->count = mesh_of_net(&net, &holes, mesh);
        result->count.alone = 0; /* nodes are no points of the scan: nothing of it is lost */
        result->grid = (struct grid){f, t, f.xmin, f.ymin, (int)net.columns, (int)net.rows};
        mesh->origin.spacing = t;
        mesh->origin.direction = options->direction;
        lin_grid_free(&net);
    }
    holes_free(&holes);
    return status;
}

/* ---- points of the scan */

static int mesh_by_delaunay(const struct cloudmesh_options *options, const struct vec3s *points,
                            double mean, struct mesh *mesh, struct cloudmesh *result,
                            struct error *error)
{
    const double digits = 0.9995; /* of the error: the rest is for those of the mesh */
    struct delaunay_mesh_options how = {gap_of(options, mean), digits * options->error,
                                        (size_t)options->keep};

    if (points->n > MOST_POINTS)
        return error_set(error, "%zu points, expected %d at most for --method delaunay", points->n,
                         MOST_POINTS);
    delaunay_mesh_make(points->item, points->n, &how, mesh);
    struct plan_extent f = plan_extent_of(points->item, points->n, options->direction);
    result->grid = (struct grid){f, mean, f.xmin, f.ymin, 0, 0};
    return 0;
}

/* ---- both */

static int mesh_by_method(const struct cloudmesh_options *options, struct vec3s *points,
                          double mean, struct mesh *mesh, struct cloudmesh *result,
                          struct error *error)
{
    return options->method == CLOUDMESH_LIN
               ? mesh_by_lin(options, points, mean, mesh, result, error)
               : mesh_by_delaunay(options, points, mean, mesh, result, error);
}

/* The points become the surface that they stand for. */
static int smooth_all(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                      int threads, double *spent, struct error *error)
{
    struct vec3s surface = {0};

    for (size_t i = 0; i < points->n; i++)
        *array_push(&surface) = points->item[i];
    if (cloudmesh_smooth_points(options, points, &surface, noise, threads, spent, error) < 0) {
        array_free(&surface);
        return -1;
    }
    array_free(points);
    *points = surface;
    return 0;
}

/* The mesh of the points or, where an error is asked for and there is noise, of the surface that
 * they stand for; its distance from what it is of. */
int cloudmesh_by_way(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    double spent = NAN;

    if (plan_extent_check(points->item, points->n, error) < 0)
        return -1;
    double mean = cloudmesh_spacing(options, points->item, points->n);
    bool of_surface = options->error > 0 && noise > 0;
    if (of_surface && smooth_all(options, points, noise, threads, &spent, error) < 0)
        return -1;
    if (mesh_by_method(options, points, mean, mesh, result, error) < 0)
        return -1;
    if (mesh->face.n == 0 && options->subdivide)
        return 0;
    if (mesh->face.n == 0)
        return error_set(error, "no facet between the points: they are too far apart, expected "
                                "another spacing (-t) or a wider gap (--max-gap)");
    if (cloudmesh_normals(options, points->item, points->n, of_surface ? 0 : noise, threads, mesh,
                          error) < 0)
        return -1;
    mesh_normals_seen(mesh);
    if (of_surface)
        mesh->origin.ledger = spent;
    return measure(mesh, points, mean, threads, &result->rows, error);
}
