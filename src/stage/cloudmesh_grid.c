/*
 * cloudmesh_grid - the mesh by a grid: nodes with a point each, normals, creases and walls; with
 * the points of walls or without, whichever is closer to the points.
 */
#include <stdlib.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "base/effort.h"
#include "base/num.h"
#include "cloud/cloud.h"
#include "cloudmesh_steps.h"
#include "feature/feature.h"
#include "mesh/mesh_distance.h"
#include "meshing/node_heights.h"
#include "meshing/meshing.h"

/* Three times the mean spacing, to three digits: so that -t can say the same. */
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
static size_t *choose_points(const struct cloudmesh_options *options,
                             const struct cloud_parts *parts, const struct grid *grid,
                             const struct vec3s *points, int threads)
{
    enum reach reach = options->paper ? REACH_CIRCLE : REACH_NEAREST;
    size_t walls = points->n - parts->flat, nodes = grid_nodes(grid);
    size_t *chosen = reposition(grid, points->item, parts->flat, reach, threads);
    if (walls == 0)
        return chosen;
    size_t *on_wall = reposition(grid, points->item + parts->flat, walls, reach, threads);
    for (size_t i = 0; i < nodes; i++)
        if (chosen[i] == NO_POINT && on_wall[i] != NO_POINT)
            chosen[i] = parts->flat + on_wall[i];
    free(on_wall);
    return chosen;
}

/* The grid's mesh of the points, without normals.  -1: as cloudmesh_make. */
int cloudmesh_place_nodes(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                          const struct vec3s *points, int threads, struct mesh *mesh,
                          struct cloudmesh *result, struct error *error)
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
    size_t *chosen = choose_points(options, parts, &result->grid, points, threads);
    result->count =
        grid_mesh_make(&result->grid, chosen, point, whole ? NULL : &holes, threads, mesh);
    free(chosen);
    holes_free(&holes);
    if (mesh->face.n == 0 && !options->subdivide)
        return error_set(error, CLOUDMESH_NO_FACET, t, f.xmax - f.xmin, f.ymax - f.ymin);
    mesh->origin.spacing = t;
    mesh->origin.direction = options->direction;
    return 0;
}

/* Mean spacing of the points on no wall. */
static double flat_spacing(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                           const struct vec3s *points)
{
    return parts->flat == points->n && parts->mean > 0
               ? parts->mean
               : cloudmesh_spacing(options, points->item, parts->flat);
}

/* Puts vertices at their nodes, where the scan says how high these are.  *certain: as
 * node_heights.h has it, for the caller to free. */
static void stand_at_nodes(const struct cloudmesh_options *options, const struct point_grid *scan,
                           double mean, double noise, int threads, struct mesh *mesh,
                           const struct cloudmesh *result, double **certain)
{
    struct node_heights_options how = {mean, fmax(noise, mesh->origin.noise), threads};

    if (options->paper || options->scan_nodes)
        return;
    if (!(noise > 0))
        *certain = mem_alloc(mesh->vertex.n, sizeof **certain);
    size_t moved = node_heights(mesh, &result->grid, scan, &how, *certain);
    if (!options->silent)
        note("%zu of %zu vertices stand at nodes of the grid, the others at points of the scan",
             moved, mesh->vertex.n);
}

/* Normals, and vertices moved where there is noise, with what is known of them already. */
static int normals_of_nodes(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                            const struct point_grid *scan, double spacing, double noise,
                            double *certain, int threads, struct mesh *mesh, struct error *error)
{
    struct normals_options normals = {.point = point,
                                      .n = n,
                                      .scan = scan,
                                      .spacing = spacing,
                                      .certain = certain,
                                      .noise = noise,
                                      .neighbours = options->neighbours,
                                      .effort = options->effort,
                                      .threads = threads,
                                      .parts = options->parts,
                                      .silent = options->silent,
                                      .explained = options->explained};

    return options->normals->estimate(mesh, &normals, error);
}

int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error)
{
    return normals_of_nodes(options, point, n, NULL, cloudmesh_spacing(options, point, n), noise,
                            NULL, threads, mesh, error);
}

static struct feature_scan scan_of(const struct cloud_parts *parts, const struct vec3s *points,
                                   double noise)
{
    return (struct feature_scan){points->item, points->n, parts->flat, parts->mean,
                                 noise,        NULL,      NULL};
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
    struct crest_mesh_options crest = {scan->spacing, scan->noise, options->effort, threads,
                                       scan->sorted};
    struct crests crests = crest_mesh_keep(mesh, first, scan->point, scan->flat, &crest);

    result->crests = crests.found;
    if (options->silent)
        return;
    effort_say(EFFORT_CREST_FACETS, options->effort, crests.facets);
    effort_say(crests.bound, options->effort, crests.wanted);
}

/* Creases and walls put into the mesh, and its normals to the side that is seen. */
void cloudmesh_add_features(const struct cloudmesh_options *options,
                            const struct cloud_parts *parts, const struct vec3s *points,
                            const struct point_grid *sorted, double noise, int threads,
                            struct mesh *mesh, struct cloudmesh *result)
{
    struct feature_scan scan = scan_of(parts, points, fmax(noise, mesh->origin.noise));
    scan.sorted = sorted;
    scan.zone = options->zone;
    size_t first = mesh->vertex.n;

    if (!options->smooth) {
        keep_features(options, &scan, threads, mesh, result);
        if (!options->edges_only)
            keep_crests(options, &scan, first, threads, mesh, result);
    }
    if (!options->paper)
        mesh_normals_seen(mesh);
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

/* Two meshes, and what came of them, change places. */
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

/* Puts `other` in the place of `mesh` where that is closer to the points (squares, every so many of
 * them). */
void cloudmesh_keep_closer(const struct cloudmesh_options *options, const struct vec3s *points,
                           int threads, struct mesh *other, struct cloudmesh *other_result,
                           struct mesh *mesh, struct cloudmesh *result)
{
    size_t most = effort_most(EFFORT_COMPARISON, options->effort);

    if (!options->silent)
        effort_say(EFFORT_COMPARISON, options->effort, points->n);
    if (off_points(other, points, most, threads) < off_points(mesh, points, most, threads))
        cloudmesh_swap(other, other_result, mesh, result);
}

/* Of a mesh that was only tried. */
void cloudmesh_drop(struct mesh *mesh, struct cloudmesh *result)
{
    mesh_free(mesh);
    array_free(&result->edge); /* NOLINT(clang-analyzer-unix.Malloc): it may be empty by then */
}

double cloudmesh_default_spacing(double mean)
{
    double spacing = cloudmesh_three_spacings(mean);
    say("spacing %g mm, three times the mean spacing of the points", spacing);
    return spacing;
}

/* The mean spacing, and the points of walls after the others; the spacing of the grid. */
static int find_walls(struct cloudmesh_options *options, struct vec3s *points, int threads,
                      struct cloud_parts *parts, struct error *error)
{
    *parts = (struct cloud_parts){0, points->n};
    if (plan_extent_check(points->item, points->n, error) < 0)
        return -1;
    bool whole = options->paper && options->max_gap == 0;
    if (!options->smooth || !(options->spacing > 0) || !(whole || options->max_gap > 0))
        parts->mean =
            options->mean > 0 ? options->mean : cloudmesh_spacing(options, points->item, points->n);
    if (!options->smooth)
        parts->flat = wall_points_part(points->item, points->n, parts->mean, threads);
    if (!(options->spacing > 0))
        options->spacing = cloudmesh_default_spacing(parts->mean);
    return 0;
}

static int mesh_of_nodes(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                         struct vec3s *points, double noise, int threads, struct mesh *mesh,
                         struct cloudmesh *result, struct error *error)
{
    if (cloudmesh_place_nodes(options, parts, points, threads, mesh, result, error) < 0)
        return -1;
    if (mesh->face.n == 0)
        return 0;
    double *certain = NULL, mean = flat_spacing(options, parts, points);
    struct point_grid sorted = {.first = NULL};
    const struct point_grid *scan = options->normals->of_surface ? &sorted : NULL;
    if (scan && point_grid_make(points->item, parts->flat, mean, threads, &sorted, error) < 0)
        return -1;
    if (scan)
        stand_at_nodes(options, scan, mean, noise, threads, mesh, result, &certain);
    int status = normals_of_nodes(options, points->item, parts->flat, scan, mean, noise, certain,
                                  threads, mesh, error);
    free(certain);
    if (status == 0)
        cloudmesh_add_features(options, parts, points, scan && mean == parts->mean ? scan : NULL,
                               noise, threads, mesh, result);
    point_grid_free(&sorted);
    return status;
}

/* Are there walls between nodes of the grid, and do they, put into a mesh of nodes alone, bring
 * that about as close to the points as nodes do that are chosen from all of them?  Else they are
 * steep flanks, and no mesh with walls need be made. */
static bool walls_serve(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                        const struct vec3s *points, double noise, int threads)
{
    const size_t some = 10000; /* points tell which is closer */
    const double about = 1.1;  /* of the squares: more is made of the mesh afterwards */
    struct cloud_parts all = {parts->mean, points->n};
    struct mesh walled = {.origin.ledger = NAN}, plain = {.origin.ledger = NAN};
    struct cloudmesh result = {.walls = 0};
    struct feature_scan scan = scan_of(parts, points, noise);
    struct feature_walls walls = {.found = 0};
    struct error error;
    bool serve = false;

    if (cloudmesh_place_nodes(options, parts, points, threads, &walled, &result, &error) == 0) {
        mesh_normals_facet(&walled);
        walls = feature_mesh_try_walls(&walled, &scan, options->effort, threads);
    }
    if (!options->silent)
        effort_say(EFFORT_WALLS, options->effort, walls.edges);
    if (walls.found > 0 &&
        cloudmesh_place_nodes(options, &all, points, threads, &plain, &result, &error) == 0)
        serve = off_points(&walled, points, some, threads) <
                about * off_points(&plain, points, some, threads);
    mesh_free(&walled);
    mesh_free(&plain);
    return serve;
}

/* The mesh by a grid: vertices are chosen from the points of walls, unless it is closer to all
 * points without: steep flanks are no walls.  result->edge is for the caller to free. */
int cloudmesh_on_grid(const struct cloudmesh_options *asked, struct vec3s *points, double noise,
                      int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    struct cloudmesh_options options = *asked;
    struct cloud_parts parts;
    struct cloudmesh walled = {.walls = 0};
    *result = walled;
    if (find_walls(&options, points, threads, &parts, error) < 0)
        return -1;
    struct mesh with_walls = {.origin = mesh->origin};
    int status = 0;
    bool has_walls =
        parts.flat < points->n &&
        walls_serve(&options, &parts, points, fmax(noise, mesh->origin.noise), threads);
    options.silent = true;
    options.edges_only = asked->edges_only && !has_walls; /* or two meshes are compared */
    if (has_walls)
        status =
            mesh_of_nodes(&options, &parts, points, noise, threads, &with_walls, &walled, error);
    parts.flat = points->n;
    options.silent = asked->silent;
    if (status == 0)
        status = mesh_of_nodes(&options, &parts, points, noise, threads, mesh, result, error);
    if (status == 0 && walled.walls > 0)
        cloudmesh_keep_closer(&options, points, threads, &with_walls, &walled, mesh, result);
    cloudmesh_drop(&with_walls, &walled);
    return status;
}
