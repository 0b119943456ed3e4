/*
 * cloudmesh_within - the mesh within an error: rows as close as the surface asks for, points that
 * rows do not come near, and room for the edges that a grid has found.
 */
#include <stdlib.h>

#include "math/elementary.h"
#include "base/effort.h"
#include "cloud/cloud.h"
#include "cloudmesh_steps.h"
#include "mesh/mesh_distance.h"
#include "meshing/meshing.h"

/* What the mesh is made of: the points, or where there is noise the surface that they stand for;
 * and the scan itself, which creases and walls are found in.  Both with the points of walls after
 * the others, where there are walls. */
struct source {
    struct vec3s *surface, *scan;
    struct cloud_parts surface_parts, scan_parts;
    double noise, spent;             /* of the scan; how far the surface may be off for it, mm */
    struct mesh_origin origin;       /* as it is before a mesh is made */
    const struct feature_zone *zone; /* NULL: not known yet */
    struct vec3s judged;             /* what the last mesh was judged by */
    bool elsewhere;                  /* what is farthest off is near to no crease or wall */
};

/* Of very many points the surface is taken at those of a grid twice as wide as they are apart. */
static bool is_thinned(const struct cloudmesh_options *options, const struct vec3s *points)
{
    return !effort_covers(EFFORT_SURFACE, options->effort, points->n);
}

int cloudmesh_smooth_points(const struct cloudmesh_options *options, struct vec3s *points,
                            struct vec3s *places, double noise, int threads, double *spent,
                            struct error *error)
{
    const double apart = 2;        /* in spacings */
    const double little = 1 / 6.0; /* of the error: then three sigma are half of it */
    struct cloudmesh_options fine = *options;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh result;
    struct cloud_parts parts = {cloudmesh_spacing(options, points->item, points->n), points->n};
    fine.spacing = apart * parts.mean;
    fine.explained = noise <= little * options->error;
    int status = 0;
    bool thinned = is_thinned(options, points);
    effort_say(EFFORT_SURFACE, options->effort, points->n);
    if (thinned)
        status = cloudmesh_place_nodes(&fine, &parts, points, threads, &mesh, &result, error);
    for (size_t i = 0; !thinned && i < places->n; i++)
        *array_push(&mesh.vertex) = places->item[i];
    if (status == 0)
        status = cloudmesh_normals(&fine, points->item, points->n, noise, threads, &mesh, error);
    if (status == 0) {
        array_free(places);
        *places = mesh.vertex;
        mesh.vertex = (struct vec3s){0};
        *spent = mesh.origin.ledger;
    }
    mesh_free(&mesh);
    return status;
}

/* Adds to the surface that of the points, or of those near to the edges or away from them. */
static int add_surface(const struct cloudmesh_options *options, struct source *s,
                       const struct feature_zone *zone, bool near, int threads, struct error *error)
{
    struct vec3s places = {0};
    double spent = 0;
    int status = 0;

    for (size_t i = 0; i < s->scan->n; i++) {
        struct vec3 p = s->scan->item[i];
        if (!zone || feature_zone_near(zone, p.x, p.y) == near)
            *array_push(&places) = p;
    }
    if (s->noise > 0 && places.n > 0)
        status =
            cloudmesh_smooth_points(options, s->scan, &places, s->noise, threads, &spent, error);
    for (size_t i = 0; i < places.n; i++)
        *array_push(s->surface) = places.item[i];
    s->spent = fmax(s->spent, spent);
    s->surface_parts.flat = s->surface->n;
    array_free(&places);
    return status;
}

/* ... of all of them. */
static int find_surface(const struct cloudmesh_options *options, struct source *s, int threads,
                        struct error *error)
{
    if (add_surface(options, s, NULL, false, threads, error) < 0)
        return -1;
    s->surface_parts.mean = cloudmesh_spacing(options, s->surface->item, s->surface->n);
    return 0;
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

/* The vertices near to creases and walls, which the surface is too smooth for, moved onto surfaces
 * of the scan itself. */
static int move_in_zone(const struct cloudmesh_options *options, const struct source *s,
                        int threads, struct mesh *mesh, struct error *error)
{
    struct mesh near = {.origin = mesh->origin};
    struct sizes which = {0};
    int status = 0;

    near.origin.maker = NULL;
    for (size_t i = 0; i < mesh->vertex.n; i++) {
        struct vec3 at = mesh->vertex.item[i];
        if (!feature_zone_near(s->zone, at.x, at.y))
            continue;
        *array_push(&which) = i;
        *array_push(&near.vertex) = at;
    }
    if (which.n > 0)
        status = cloudmesh_normals(options, s->scan->item, s->scan_parts.flat, s->noise, threads,
                                   &near, error);
    for (size_t i = 0; i < which.n && status == 0; i++) {
        mesh->vertex.item[which.item[i]] = near.vertex.item[i];
        mesh->normal.item[which.item[i]] = near.normal.item[i];
        mesh->kmax.item[which.item[i]] = near.kmax.item[i];
    }
    array_free(&which);
    mesh_free(&near);
    return status;
}

static int make_normals(const struct cloudmesh_options *options, const struct source *s,
                        int threads, struct mesh *mesh, struct error *error)
{
    int status = cloudmesh_normals(options, s->surface->item, s->surface_parts.flat, 0, threads,
                                   mesh, error);

    return status == 0 && s->zone && s->noise > 0 ? move_in_zone(options, s, threads, mesh, error)
                                                  : status;
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
        struct cloudmesh_options in_zone = *options;
        in_zone.zone = s->zone;
        in_zone.edges_only = true; /* ribs are within the error by rows and points between them */
        cloudmesh_add_features(&in_zone, &s->scan_parts, s->scan, NULL, s->noise, threads, mesh,
                               result);
        status = mesh_coverage(mesh, points->item, flat, mean, &s->judged, error);
        if (status == 0)
            insert_points(options, s, threads, mesh);
        measure_distances(mesh, s, threads, &result->rows);
        result->rows.beside = points->n - s->judged.n;
    }
    return status;
}

/* The mesh without room for edges, where the one with it is out of the error near to them: that is
 * the result where it is closer.  Both are judged alike. */
static int try_plain(const struct cloudmesh_options *asked, struct source *known,
                     const struct source *in_zone, int threads, struct mesh *mesh,
                     struct cloudmesh *result, struct error *error)
{
    struct cloudmesh_options options = *asked;
    struct mesh other = {.origin = known->origin};
    struct cloudmesh other_result = {.walls = 0};
    int status = 0;

    options.silent = true;
    if (!is_thinned(asked, known->scan))
        status = add_surface(&options, known, known->zone, true, threads, error);
    known->zone = NULL;
    if (status == 0)
        status = mesh_of_source(&options, known, threads, &other, &other_result, error);
    if (status == 0) {
        measure_distances(&other, in_zone, threads, &other_result.rows);
        if (result->rows.worst > fmax(asked->error, other_result.rows.worst))
            cloudmesh_swap(&other, &other_result, mesh, result);
    }
    cloudmesh_drop(&other, &other_result);
    return status;
}

/* Rows that leave room for the edges that a grid has found. */
static int mesh_in_zone(const struct cloudmesh_options *asked, struct source *known, bool walls,
                        int threads, struct mesh *mesh, struct cloudmesh *result,
                        struct error *error)
{
    if (add_surface(asked, known, known->zone, false, threads, error) < 0)
        return -1;
    struct vec3s mixed = mixed_surface(known), *whole = &mixed;
    if (is_thinned(asked, known->scan))
        whole = known->surface;
    known->surface_parts.mean = cloudmesh_spacing(asked, whole->item, whole->n);
    struct source s = *known;

    s.surface = &mixed;
    s.judged = (struct vec3s){0};
    s.scan_parts.flat = s.scan->n;
    s.surface_parts.flat = mixed.n;
    if (walls) {
        s.scan_parts.flat = wall_points_part(s.scan->item, s.scan->n, s.scan_parts.mean, threads);
        s.surface_parts.flat = wall_points_part(mixed.item, mixed.n, s.surface_parts.mean, threads);
    }
    int status = mesh_of_source(asked, &s, threads, mesh, result, error);
    known->elsewhere = !feature_zone_near(s.zone, result->rows.at.x, result->rows.at.y);
    if (status == 0 && result->rows.worst > asked->error && !known->elsewhere) {
        status = try_plain(asked, known, &s, threads, mesh, result, error);
        known->elsewhere = !feature_zone_near(s.zone, result->rows.at.x, result->rows.at.y);
    }
    array_free(&s.judged);
    array_free(&mixed);
    return status;
}

/* Without knowing where edges are, all points are rid of noise first. */
static int mesh_of_all(const struct cloudmesh_options *options, struct source *s, int threads,
                       struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    if (find_surface(options, s, threads, error) < 0)
        return -1;
    return mesh_of_source(options, s, threads, mesh, result, error);
}

/* Creases and walls are found best by a grid, before rows are made: these need not be made twice
 * then.  No grid that serves: no edges are known. */
static int mesh_by_zone(const struct cloudmesh_options *asked, struct source *s, int threads,
                        struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    double fine = cloudmesh_three_spacings(s->scan_parts.mean);
    struct cloudmesh_options options = *asked;
    struct mesh grid = {.origin = s->origin};
    struct cloudmesh grid_result;
    struct error none;
    int status;

    options.error = 0;
    options.silent = options.edges_only = true;
    options.spacing = asked->spacing > 0 ? fmin(asked->spacing, fine) : fine;
    if (cloudmesh_on_grid(&options, s->scan, s->noise, threads, &grid, &grid_result, &none) == 0 &&
        grid_result.edge.n > 0) {
        struct feature_zone zone =
            feature_zone_make(grid_result.edge.item, grid_result.edge.n, options.spacing);
        s->zone = &zone;
        status = mesh_in_zone(asked, s, grid_result.walls > 0, threads, mesh, result, error);
        feature_zone_free(&zone);
        s->zone = NULL;
    } else {
        status = mesh_of_all(asked, s, threads, mesh, result, error);
    }
    cloudmesh_drop(&grid, &grid_result);
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
        cloudmesh_keep_closer(asked, s->scan, threads, &other, &other_result, mesh, result);
    cloudmesh_drop(&other, &other_result);
    return status;
}

int cloudmesh_within(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    struct vec3s surface = {0};

    *result = (struct cloudmesh){.walls = 0};
    if (plan_extent_check(points->item, points->n, error) < 0)
        return -1;
    struct source s = {&surface, points, .noise = noise, .origin = mesh->origin};
    s.scan_parts =
        (struct cloud_parts){cloudmesh_spacing(options, points->item, points->n), points->n};
    int status = options->smooth ? mesh_of_all(options, &s, threads, mesh, result, error)
                                 : mesh_by_zone(options, &s, threads, mesh, result, error);
    bool edges = status == 0 && mesh->face.n > 0 && !options->smooth;
    if (edges && result->creases + result->walls > 0 && !s.elsewhere &&
        result->rows.worst > options->error)
        status = mesh_without_edges(options, &s, threads, mesh, result, error);
    if (noise > 0)
        mesh->origin.ledger = s.spent;
    array_free(&surface);
    array_free(&s.judged);
    return status;
}
