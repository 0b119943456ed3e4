/*
 * cloudmesh - see cloudmesh.h.  Nodes by a grid, normals, creases and walls; then the mesh by a
 * grid (mesh_on_grid) or within an error (mesh_within); then that of each part of a divided cloud.
 */
#include "stage/cloudmesh.h"

#include <stdlib.h>
#include <string.h>

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

/* The cloud as wall_points_part put it in order. */
struct cloud_parts {
    double mean; /* spacing of the points, mm */
    size_t flat; /* so many of them lie on no wall */
};

/* Three times the mean spacing, to three digits: so that -t can say the same. */
static double three_spacings(double mean)
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
                             const struct vec3s *points)
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

/* The grid's mesh of the points, without normals.  -1: as cloudmesh_make. */
static int place_nodes(const struct cloudmesh_options *options, const struct cloud_parts *parts,
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
    size_t *chosen = choose_points(options, parts, &result->grid, points);
    result->count = grid_mesh_make(&result->grid, chosen, point, whole ? NULL : &holes, mesh);
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

/* Puts vertices at their nodes, where the scan says how high these are; sorts the points.
 * *certain: as node_heights.h has it, for the caller to free. */
static int stand_at_nodes(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                          struct vec3s *points, double noise, int threads, struct mesh *mesh,
                          const struct cloudmesh *result, double **certain, struct error *error)
{
    double mean = flat_spacing(options, parts, points);
    struct node_heights_options how = {mean, fmax(noise, mesh->origin.noise), threads};
    struct point_grid scan;

    if (options->paper || options->scan_nodes || !options->normals->of_surface)
        return 0;
    if (point_grid_make(points->item, parts->flat, mean, threads, &scan, error) < 0)
        return -1;
    if (!(noise > 0))
        *certain = mem_alloc(mesh->vertex.n, sizeof **certain);
    size_t moved = node_heights(mesh, &result->grid, &scan, &how, *certain);
    if (!options->silent)
        note("%zu of %zu vertices stand at nodes of the grid, the others at points of the scan",
             moved, mesh->vertex.n);
    point_grid_free(&scan);
    return 0;
}

/* Normals, and vertices moved where there is noise, with what is known of them already. */
static int normals_of_nodes(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                            double spacing, double noise, const double *certain, int threads,
                            struct mesh *mesh, struct error *error)
{
    struct normals_options normals = {.point = point,
                                      .n = n,
                                      .spacing = spacing,
                                      .certain = certain,
                                      .noise = noise,
                                      .neighbours = options->neighbours,
                                      .effort = options->effort,
                                      .threads = threads,
                                      .silent = options->silent};

    return options->normals->estimate(mesh, &normals, error);
}

int cloudmesh_normals(const struct cloudmesh_options *options, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error)
{
    return normals_of_nodes(options, point, n, cloudmesh_spacing(options, point, n), noise, NULL,
                            threads, mesh, error);
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
    effort_say(EFFORT_CREST_FACETS, options->effort, crests.facets);
    effort_say(crests.bound, options->effort, crests.wanted);
}

/* Creases and walls put into the mesh, and its normals to the side that is seen. */
static void add_features(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                         const struct vec3s *points, double noise, int threads, struct mesh *mesh,
                         struct cloudmesh *result)
{
    struct feature_scan scan = scan_of(parts, points, fmax(noise, mesh->origin.noise));
    size_t first = mesh->vertex.n;

    if (!options->smooth) {
        keep_features(options, &scan, threads, mesh, result);
        if (!options->edges_only)
            keep_crests(options, &scan, first, threads, mesh, result);
    }
    if (!options->paper)
        mesh_normals_seen(mesh);
}

/* Is there a wall between two nodes of a grid? */
static bool grid_has_walls(const struct cloudmesh_options *options, const struct cloud_parts *parts,
                           const struct vec3s *points, double noise, int threads)
{
    struct cloudmesh_options grid = *options;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh result;
    struct error error;
    struct feature_scan scan = scan_of(parts, points, noise);
    struct feature_walls walls = {.found = 0};

    if (!(grid.spacing > 0))
        grid.spacing = three_spacings(parts->mean);
    if (place_nodes(&grid, parts, points, &mesh, &result, &error) == 0)
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

/* Two meshes, and what came of them, change places. */
static void swap_meshes(struct mesh *other, struct cloudmesh *other_result, struct mesh *mesh,
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
static void keep_closer(const struct cloudmesh_options *options, const struct vec3s *points,
                        int threads, struct mesh *other, struct cloudmesh *other_result,
                        struct mesh *mesh, struct cloudmesh *result)
{
    size_t most = effort_most(EFFORT_COMPARISON, options->effort);

    if (!options->silent)
        effort_say(EFFORT_COMPARISON, options->effort, points->n);
    if (off_points(other, points, most, threads) < off_points(mesh, points, most, threads))
        swap_meshes(other, other_result, mesh, result);
}

/* Of a mesh that was only tried. */
static void drop_mesh(struct mesh *mesh, struct cloudmesh *result)
{
    mesh_free(mesh);
    array_free(&result->edge); /* NOLINT(clang-analyzer-unix.Malloc): it may be empty by then */
}

double cloudmesh_default_spacing(double mean)
{
    double spacing = three_spacings(mean);
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
        parts->mean = cloudmesh_spacing(options, points->item, points->n);
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
    if (place_nodes(options, parts, points, mesh, result, error) < 0)
        return -1;
    if (mesh->face.n == 0)
        return 0;
    double *certain = NULL;
    int status =
        stand_at_nodes(options, parts, points, noise, threads, mesh, result, &certain, error);
    if (status == 0)
        status = normals_of_nodes(options, points->item, parts->flat,
                                  flat_spacing(options, parts, points), noise, certain, threads,
                                  mesh, error);
    free(certain);
    if (status < 0)
        return -1;
    add_features(options, parts, points, noise, threads, mesh, result);
    return 0;
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

    if (place_nodes(options, parts, points, &walled, &result, &error) == 0) {
        mesh_normals_facet(&walled);
        walls = feature_mesh_try_walls(&walled, &scan, options->effort, threads);
    }
    if (!options->silent)
        effort_say(EFFORT_WALLS, options->effort, walls.edges);
    if (walls.found > 0 && place_nodes(options, &all, points, &plain, &result, &error) == 0)
        serve = off_points(&walled, points, some, threads) <
                about * off_points(&plain, points, some, threads);
    mesh_free(&walled);
    mesh_free(&plain);
    return serve;
}

/* The mesh by a grid: vertices are chosen from the points of walls, unless it is closer to all
 * points without: steep flanks are no walls.  result->edge is for the caller to free. */
static int mesh_on_grid(const struct cloudmesh_options *asked, struct vec3s *points, double noise,
                        int threads, struct mesh *mesh, struct cloudmesh *result,
                        struct error *error)
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
        keep_closer(&options, points, threads, &with_walls, &walled, mesh, result);
    drop_mesh(&with_walls, &walled);
    return status;
}

/* What the mesh is made of: the points, or where there is noise the surface that they stand for;
 * and the scan itself, which creases and walls are found in.  Both with the points of walls after
 * the others, where there are walls. */
struct source {
    struct vec3s *surface, *scan;
    struct cloud_parts surface_parts, scan_parts;
    double noise;
    struct mesh_origin origin;       /* as it is before a mesh is made */
    const struct feature_zone *zone; /* NULL: not known yet */
    struct vec3s judged;             /* what the last mesh was judged by */
    bool elsewhere;                  /* what is farthest off is near to no crease or wall */
};

/* Noisy points moved onto the surface that they stand for, all or, of very many, those of a grid
 * twice as wide as they are apart. */
int cloudmesh_smooth_points(const struct cloudmesh_options *options, struct vec3s *points,
                            double noise, int threads, double *spent, struct error *error)
{
    const double apart = 2; /* in spacings */
    struct cloudmesh_options fine = *options;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh result;
    struct cloud_parts parts = {cloudmesh_spacing(options, points->item, points->n), points->n};
    fine.spacing = apart * parts.mean;
    int status = 0;
    bool all = effort_covers(EFFORT_SURFACE, options->effort, points->n);
    effort_say(EFFORT_SURFACE, options->effort, points->n);
    if (!all)
        status = place_nodes(&fine, &parts, points, &mesh, &result, error);
    for (size_t i = 0; all && i < points->n; i++)
        *array_push(&mesh.vertex) = points->item[i];
    if (status == 0)
        status = cloudmesh_normals(&fine, points->item, points->n, noise, threads, &mesh, error);
    if (status == 0) {
        array_free(points);
        *points = mesh.vertex;
        mesh.vertex = (struct vec3s){0};
        *spent = mesh.origin.ledger;
    }
    mesh_free(&mesh);
    return status;
}

/* Rows far nearer to each other than the points hold no more, and cost all the more. */
static int check_rows(double t, double mean, struct error *error)
{
    enum { ROWS_A_POINT = 50 };
    if (!(t > 0) || t >= mean / ROWS_A_POINT)
        return 0;
    return error_set(error,
                     "rows %g mm apart (-t), expected at least %.3g mm, a fiftieth of the points' "
                     "mean spacing",
                     t, mean / ROWS_A_POINT);
}

/* Rows and what is between them. */
static int make_rows(const struct cloudmesh_options *options, const struct source *s, int threads,
                     struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    const double slant = 0.866, widest = 24, gaps = 6, rims = 2, out = 0.12; /* an eighth */
    double mean = s->surface_parts.mean,
           gap = options->max_gap > 0 ? options->max_gap : gaps * mean;
    struct vec3s *points = s->surface;
    struct holes holes;
    struct point_grid point_grid;
    struct plan_extent f = plan_extent_of(points->item, points->n, options->direction);
    if (check_rows(options->spacing, mean, error) < 0 ||
        holes_find(points->item, points->n, gap, rims * mean, &holes, error) < 0)
        return -1;
    if (point_grid_make(points->item, s->surface_parts.flat, mean, threads, &point_grid, error) <
        0) {
        holes_free(&holes);
        return -1;
    }
    double apart = options->spacing > 0 ? slant * options->spacing : widest * mean;
    struct adaptive_rows_options rows = {options->error, mean, apart, s->zone, out, threads};
    result->rows = adaptive_rows_make(&point_grid, &f, &holes, &rows, mesh);
    point_grid_free(&point_grid);
    holes_free(&holes);
    if (mesh->face.n == 0 && !options->subdivide)
        return error_set(error, "no mesh within %g mm of the points: too few of them",
                         options->error);
    mesh->origin.spacing = (f.ymax - f.ymin) / (double)(result->rows.rows - 1) / slant;
    mesh->origin.direction = options->direction;
    result->grid = (struct grid){f,      mesh->origin.spacing, f.xmin,
                                 f.ymin, result->rows.columns, (int)result->rows.rows};
    return 0;
}

/* What a point may be off besides: near a crease or wall it has its noise. */
static double allowance(const struct source *s, struct vec3 at)
{
    const double sigmas = 3.5;

    return s->noise > 0 && s->zone && feature_zone_near(s->zone, at.x, at.y) ? sigmas * s->noise
                                                                             : 0;
}

/* Points that rows do not come near enough to become vertices between them.  Half a thousandth of
 * the error is for the digits of the mesh. */
static void insert_points(const struct cloudmesh_options *options, const struct source *s,
                          int threads, struct mesh *mesh)
{
    const struct vec3s *points = &s->judged;
    double *within = mem_alloc(points->n, sizeof *within);

    for (size_t i = 0; i < points->n; i++)
        within[i] = 0.9995 * options->error + allowance(s, points->item[i]);
    greedy_insert(mesh, points->item, within, points->n, threads);
    free(within);
}

/* How far the points over and under the mesh are from it as it is in the end, in space. */
static void measure_distances(const struct mesh *mesh, const struct source *s, int threads,
                              struct adaptive_rows *rows)
{
    const struct vec3s *points = &s->judged;
    double *distance = mem_alloc(points->n, sizeof *distance), sum2 = 0;

    mesh_distance(mesh, points->item, points->n, threads, distance);
    rows->worst = 0;
    for (size_t i = 0; i < points->n; i++) {
        double off = fmax(distance[i] - allowance(s, points->item[i]), 0);
        sum2 += off * off;
        if (off > rows->worst) {
            rows->worst = off;
            rows->at = points->item[i];
        }
    }
    rows->rms = points->n > 0 ? sqrt(sum2 / (double)points->n) : 0;
    free(distance);
}

/* The surface that the points stand for, and near creases and walls, which that is too smooth for,
 * the points themselves. */
static struct vec3s mixed_surface(const struct source *s)
{
    struct vec3s mixed = {0};

    for (size_t i = 0; i < s->surface->n; i++) {
        struct vec3 p = s->surface->item[i];
        if (!feature_zone_near(s->zone, p.x, p.y))
            *array_push(&mixed) = p;
    }
    for (size_t i = 0; i < s->scan->n; i++) {
        struct vec3 p = s->scan->item[i];
        if (feature_zone_near(s->zone, p.x, p.y))
            *array_push(&mixed) = p;
    }
    return mixed;
}

/* Normals: with a zone, vertices near to it are moved onto surfaces yet. */
static int make_normals(const struct cloudmesh_options *options, const struct source *s,
                        int threads, struct mesh *mesh, struct error *error)
{
    bool raw = s->zone && s->noise > 0;
    struct vec3s *points = raw ? s->scan : s->surface;
    size_t flat = raw ? s->scan_parts.flat : s->surface_parts.flat;

    return cloudmesh_normals(options, points->item, flat, raw ? s->noise : 0, threads, mesh, error);
}

static int mesh_of_source(const struct cloudmesh_options *options, struct source *s, int threads,
                          struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    const struct vec3s *points = s->surface;
    size_t flat = s->surface_parts.flat, walls = points->n - flat;
    double mean = s->surface_parts.mean;
    int status = make_rows(options, s, threads, mesh, result, error);
    s->judged.n = 0;
    /* the points of walls before these are there: then nothing is under them */
    if (status == 0 && mesh->face.n > 0)
        status = mesh_coverage(mesh, points->item + flat, walls, mean, &s->judged, error);
    if (status == 0 && mesh->face.n > 0)
        status = make_normals(options, s, threads, mesh, error);
    if (status == 0 && mesh->face.n > 0) {
        add_features(options, &s->scan_parts, s->scan, s->noise, threads, mesh, result);
        status = mesh_coverage(mesh, points->item, flat, mean, &s->judged, error);
        if (status == 0)
            insert_points(options, s, threads, mesh);
        measure_distances(mesh, s, threads, &result->rows);
        result->rows.beside = points->n - s->judged.n;
    }
    return status;
}

/* Rows that leave room for the edges that a grid has found: that mesh is the one where it is within
 * the error, or closer than the other.  Both are judged alike. */
static int mesh_in_zone(const struct cloudmesh_options *asked, const struct source *known,
                        bool walls, int threads, struct mesh *mesh, struct cloudmesh *result,
                        struct error *error)
{
    struct cloudmesh_options options = *asked;
    struct source s = *known;
    struct vec3s mixed = mixed_surface(known);
    struct mesh other = {.origin = s.origin};
    struct cloudmesh other_result = {.walls = 0};

    options.silent = true;
    s.surface = &mixed;
    s.judged = (struct vec3s){0};
    s.scan_parts.flat = s.scan->n;
    s.surface_parts.flat = mixed.n;
    if (walls) {
        s.scan_parts.flat = wall_points_part(s.scan->item, s.scan->n, s.scan_parts.mean, threads);
        s.surface_parts.flat = wall_points_part(mixed.item, mixed.n, s.surface_parts.mean, threads);
    }
    int status = mesh_of_source(&options, &s, threads, &other, &other_result, error);
    if (status == 0) {
        measure_distances(mesh, &s, threads, &result->rows);
        if (other_result.rows.worst <= fmax(asked->error, result->rows.worst))
            swap_meshes(&other, &other_result, mesh, result);
    }
    drop_mesh(&other, &other_result);
    array_free(&s.judged);
    array_free(&mixed);
    return status;
}

/* Creases and walls are found best by a grid. */
static int mesh_by_zone(const struct cloudmesh_options *asked, struct source *s, int threads,
                        struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    double fine = three_spacings(s->scan_parts.mean);
    struct cloudmesh_options options = *asked;
    struct mesh grid = {.origin = s->origin};
    struct cloudmesh grid_result;

    options.error = 0;
    options.silent = options.edges_only = true;
    options.spacing = asked->spacing > 0 ? fmin(asked->spacing, fine) : fine;
    int status = mesh_on_grid(&options, s->scan, s->noise, threads, &grid, &grid_result, error);
    if (status == 0 && grid_result.edge.n > 0) {
        struct feature_zone zone =
            feature_zone_make(grid_result.edge.item, grid_result.edge.n, options.spacing);
        s->zone = &zone;
        status = mesh_in_zone(asked, s, grid_result.walls > 0, threads, mesh, result, error);
        s->elsewhere = !feature_zone_near(&zone, result->rows.at.x, result->rows.at.y);
        feature_zone_free(&zone);
        s->zone = NULL;
    }
    drop_mesh(&grid, &grid_result);
    return status;
}

/* A false edge may take the mesh out of the error; then the mesh without edges is the result.  Not
 * where it is out of it elsewhere, for there that mesh is too. */
static int mesh_without_edges(const struct cloudmesh_options *asked, struct source *s, int threads,
                              struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    struct cloudmesh_options options = *asked;
    struct mesh other = {.origin = s->origin};
    struct cloudmesh other_result = {.walls = 0};

    options.smooth = options.silent = true;
    int status = mesh_of_source(&options, s, threads, &other, &other_result, error);
    if (status == 0 && other_result.rows.worst <= options.error)
        keep_closer(asked, s->scan, threads, &other, &other_result, mesh, result);
    drop_mesh(&other, &other_result);
    return status;
}

/* Are there points on walls, and walls under edges of a mesh? */
static bool has_walls(const struct cloudmesh_options *options, struct source *s, int threads)
{
    struct cloud_parts walled = s->scan_parts;

    walled.flat = wall_points_part(s->scan->item, s->scan->n, walled.mean, threads);
    return walled.flat < s->scan->n &&
           grid_has_walls(options, &walled, s->scan, fmax(s->noise, s->origin.noise), threads);
}

/* The mesh within an error; the same. */
static int mesh_within(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                       int threads, struct mesh *mesh, struct cloudmesh *result,
                       struct error *error)
{
    struct vec3s surface = {0};
    double spent = NAN;

    *result = (struct cloudmesh){.walls = 0};
    if (plan_extent_check(points->item, points->n, error) < 0)
        return -1;
    for (size_t i = 0; i < points->n; i++)
        *array_push(&surface) = points->item[i];
    if (noise > 0 &&
        cloudmesh_smooth_points(options, &surface, noise, threads, &spent, error) < 0) {
        array_free(&surface);
        return -1;
    }
    struct source s = {&surface, points, .noise = noise, .origin = mesh->origin};
    s.surface_parts =
        (struct cloud_parts){cloudmesh_spacing(options, surface.item, surface.n), surface.n};
    s.scan_parts =
        (struct cloud_parts){cloudmesh_spacing(options, points->item, points->n), points->n};
    int status = mesh_of_source(options, &s, threads, mesh, result, error);
    bool edges = status == 0 && mesh->face.n > 0 && !options->smooth;
    if (edges && (result->creases > 0 || has_walls(options, &s, threads)))
        status = mesh_by_zone(options, &s, threads, mesh, result, error);
    if (edges && status == 0 && result->creases + result->walls > 0 && !s.elsewhere &&
        result->rows.worst > options->error)
        status = mesh_without_edges(options, &s, threads, mesh, result, error);
    if (noise > 0)
        mesh->origin.ledger = spent;
    array_free(&surface);
    array_free(&s.judged);
    return status;
}

/* A cloud that one projection serves. */
static int one_mesh(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                    int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    if (options->method != CLOUDMESH_CHUI)
        return cloudmesh_by_way(options, points, noise, threads, mesh, result, error);
    int status = options->error > 0
                     ? mesh_within(options, points, noise, threads, mesh, result, error)
                     : mesh_on_grid(options, points, noise, threads, mesh, result, error);
    if (status == 0 && !options->smooth)
        note("creases cross %zu edges of the mesh, walls %zu, ribs and grooves %zu",
             result->creases, result->walls, result->crests);
    array_free(&result->edge);
    return status;
}

/* One part of a cloud that is divided, in its own projection. */
static int add_part(const struct cloudmesh_options *options, struct segment *part, double noise,
                    int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    struct mesh own = {.origin.ledger = NAN};
    struct adaptive_rows worst = result->rows;
    for (size_t k = 0; k < part->point.n; k++)
        part->point.item[k] = segment_in(part, part->point.item[k]);
    int status = one_mesh(options, &part->point, noise, threads, &own, result, error);
    if (status == 0 && own.face.n > 0)
        mesh_join_add(mesh, &own, part);
    if (worst.worst > result->rows.worst)
        result->rows = worst;
    mesh_free(&own);
    return status;
}

/* The same for each part of a cloud that is divided by orientation, one after the other. */
static int mesh_of_parts(const struct cloudmesh_options *asked, const struct vec3s *points,
                         double noise, int threads, struct mesh *mesh, struct cloudmesh *result,
                         struct error *error)
{
    struct cloudmesh_options options = *asked;
    struct segments parts =
        segments_find(points->item, points->n, 1.5 * options.spacing, options.direction, threads);
    int status = 0;
    options.spacing =
        options.spacing > 0 ? options.spacing : cloudmesh_default_spacing(parts.spacing);
    options.direction = 0;
    mesh->origin.spacing = options.spacing;
    for (size_t i = 0; i < parts.n && status == 0; i++) {
        struct segment *part = &parts.item[i];
        note("part %zu of %zu: seen along %.3f %.3f %.3f, %zu points", i + 1, parts.n, part->up.x,
             part->up.y, part->up.z, part->own);
        status = add_part(&options, part, noise, threads, mesh, result, error);
    }
    if (status == 0)
        say("divided into %zu part%s, each with a projection of its own", parts.n,
            parts.n == 1 ? "" : "s");
    if (status == 0 && parts.left_out > 0)
        say("%zu points belong to no part and are left out", parts.left_out);
    segments_free(&parts);
    if (status == 0 && mesh->face.n == 0)
        return error_set(error,
                         "no part has points for three neighbouring nodes of a grid of spacing "
                         "%g mm, expected another spacing (-t)",
                         options.spacing);
    return status;
}

int cloudmesh_make(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                   int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    *result = (struct cloudmesh){.walls = 0};
    return options->subdivide ? mesh_of_parts(options, points, noise, threads, mesh, result, error)
                              : one_mesh(options, points, noise, threads, mesh, result, error);
}
