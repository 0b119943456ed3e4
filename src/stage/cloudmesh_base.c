/* cloudmesh_base - see cloudmesh_base.h. */
#include "cloudmesh_base.h"

#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "base/effort.h"
#include "feature/feature.h"
#include "cloud/cloud.h"
#include "mesh/mesh_distance.h"
#include "base/num.h"
#include "meshing/meshing.h"

double cloudmesh_three_spacings(double mean)
{
    double step = pow(10, floor(log10(3 * mean)) - 2);
    double digits = step >= 1 ? 0 : fmin(-floor(log10(step)), 9);
    return num_round(round(3 * mean / step) * step, (int)digits);
}

double cloudmesh_spacing(const struct cloudmesh_options *options, const struct vec3 *point,
                         size_t n)
{
    struct plan_extent f = plan_extent_of(point, n, options->direction);
    return plan_extent_spacing(&f, point, n);
}

/* A point for each node; one on a wall only where there is no other. */
static size_t *choose(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                      const struct grid *grid, const struct vec3s *points)
{
    enum reach reach = options->paper ? REACH_CIRCLE : REACH_NEAREST;
    size_t walls = points->n - parts->flat, nodes = grid_nodes(grid);
    size_t *chosen = reposition(grid, points->item, parts->flat, reach);
    if (walls == 0)
        return chosen;
    size_t *on_wall = reposition(grid, points->item + parts->flat, walls, reach);
    for (size_t i = 0; i < nodes; i++)
        if (chosen[i] == NO_POINT && on_wall[i] != NO_POINT)
            chosen[i] = parts->flat + on_wall[i];
    free(on_wall);
    return chosen;
}

int cloudmesh_by_grid(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                      const struct vec3s *points, struct mesh *mesh, struct cloudmesh *result,
                      struct error *error)
{
    const struct vec3 *point = points->item;
    struct holes holes = {0};
    struct plan_extent f = plan_extent_of(point, points->n, options->direction);
    bool whole = options->paper && options->max_gap == 0;
    double t = options->spacing;
    double gap = options->max_gap > 0 ? options->max_gap : 6 * parts->mean;
    double rim = fmax(t / 2, 1.5 * parts->mean);
    if (grid_make(&f, points->n, t, &result->grid, error) < 0 ||
        (!whole &&
         holes_find(point, points->n, gap, options->paper ? gap / 2 : rim, &holes, error) < 0))
        return -1;
    size_t *chosen = choose(options, parts, &result->grid, points);
    result->count = grid_mesh_make(&result->grid, chosen, point, whole ? NULL : &holes, mesh);
    free(chosen);
    holes_free(&holes);
    if (mesh->face.n == 0 && !options->subdivide)
        return error_set(error,
                         "no three neighbouring nodes of a grid of spacing %g mm have points on an "
                         "area of %g x %g mm, expected another spacing (-t) or a wider area",
                         t, f.xmax - f.xmin, f.ymax - f.ymin);
    mesh->origin.spacing = t;
    mesh->origin.direction = options->direction;
    return 0;
}

int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error)
{
    struct normals_options normals = {.point = point,
                                      .n = n,
                                      .spacing = cloudmesh_spacing(options, point, n),
                                      .noise = noise,
                                      .neighbours = options->neighbours,
                                      .effort = options->effort,
                                      .threads = threads,
                                      .silent = options->silent};

    return options->normals->estimate(mesh, &normals, error);
}

static struct feature_scan scan_of(const struct cloud_parts *parts, const struct vec3s *points,
                                   double noise)
{
    return (struct feature_scan){points->item, points->n, parts->flat, parts->mean, noise};
}

static void keep_features(const struct cloudmesh_options *options, const struct feature_scan *scan,
                          int threads, struct mesh *mesh, struct cloudmesh *result)
{
    struct feature_mesh found = feature_mesh_keep(mesh, scan, options->effort, threads);

    result->creases = found.creases;
    result->walls = found.walls;
    array_free(&result->edge);
    result->edge = found.place;
    if (!options->silent)
        effort_say(EFFORT_CREASES, options->effort, found.doubtful);
}

static void keep_crests(const struct cloudmesh_options *options, const struct feature_scan *scan,
                        size_t first, int threads, struct mesh *mesh, struct cloudmesh *result)
{
    struct crest_mesh_options crest = {scan->spacing, scan->noise, options->effort, threads};
    struct crests crests = crest_mesh_keep(mesh, first, scan->point, scan->flat, &crest);

    result->crests = crests.found;
    if (options->silent)
        return;
    effort_say(EFFORT_CREST_EDGES, options->effort, crests.edges);
    effort_say(crests.bound, options->effort, crests.wanted);
}

void cloudmesh_edges(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                     const struct vec3s *points, double noise, int threads, struct mesh *mesh,
                     struct cloudmesh *result)
{
    struct feature_scan scan = scan_of(parts, points, fmax(noise, mesh->origin.noise));
    size_t first = mesh->vertex.n;

    if (!options->smooth) {
        keep_features(options, &scan, threads, mesh, result);
        keep_crests(options, &scan, first, threads, mesh, result);
    }
    if (!options->paper)
        mesh_normals_seen(mesh);
}

bool cloudmesh_has_walls(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                         const struct vec3s *points, double noise, int threads)
{
    struct cloudmesh_options grid = *options;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh result;
    struct error error;
    struct feature_scan scan = scan_of(parts, points, noise);
    struct feature_walls walls = {.found = 0};

    if (!(grid.spacing > 0))
        grid.spacing = cloudmesh_three_spacings(parts->mean);
    if (cloudmesh_by_grid(&grid, parts, points, &mesh, &result, &error) == 0)
        walls = feature_mesh_walls(&mesh, &scan, options->effort, threads);
    if (!options->silent)
        effort_say(EFFORT_WALLS, options->effort, walls.edges);
    mesh_free(&mesh);
    return walls.found > 0;
}

/* The sum of the squared distances of the points from the mesh, of every so many of them. */
static double off_points(const struct mesh *mesh, const struct vec3s *points, size_t most,
                         int threads)
{
    struct vec3s some = {0};
    double sum = 0;
    size_t step = most > 0 && points->n > most ? (points->n - 1) / most + 1 : 1;
    for (size_t i = 0; i < points->n; i += step)
        *array_push(&some) = points->item[i];
    double *distance = mem_alloc(some.n, sizeof *distance);
    mesh_distance(mesh, some.item, some.n, threads, distance);
    for (size_t i = 0; i < some.n; i++)
        sum += distance[i] * distance[i];
    free(distance);
    array_free(&some);
    return sum;
}

void cloudmesh_swap(struct mesh *other, struct cloudmesh *other_result, struct mesh *mesh,
                    struct cloudmesh *result)
{
    struct mesh swap = *mesh;
    struct cloudmesh swap_result = *result;
    *mesh = *other;
    *result = *other_result;
    *other = swap;
    *other_result = swap_result;
}

void cloudmesh_closer(const struct cloudmesh_options *options, const struct vec3s *points,
                      int threads, struct mesh *other, struct cloudmesh *other_result,
                      struct mesh *mesh, struct cloudmesh *result)
{
    size_t most = effort_most(EFFORT_COMPARISON, options->effort);

    if (!options->silent)
        effort_say(EFFORT_COMPARISON, options->effort, points->n);
    if (off_points(other, points, most, threads) < off_points(mesh, points, most, threads))
        cloudmesh_swap(other, other_result, mesh, result);
}

void cloudmesh_drop(struct mesh *mesh, struct cloudmesh *result)
{
    mesh_free(mesh);
    array_free(&result->edge);
}
