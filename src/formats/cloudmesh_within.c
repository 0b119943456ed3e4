/* cloudmesh_within - the mesh within an error of the points; see cloudmesh_base.h. */
#include <math.h>
#include <stdlib.h>

#include "cloudmesh_base.h"
#include "meshcover.h"
#include "meshnear.h"
#include "wallpoints.h"

/* What the mesh is made of: the points, or where there is noise the surface that they stand for;
 * and the scan itself, which creases and walls are found in.  Both with the points of walls behind
 * the others, where there are walls. */
struct source {
    struct vec3s *surface, *scan;
    struct cloud_parts surface_parts, scan_parts;
    double noise;
    const struct edgezone *zone; /* NULL: not known yet */
};

/* Noisy points moved onto the surface that they stand for, all or, of very many, those of a grid
 * twice as wide as they are apart. */
static int smooth_points(const struct cloudmesh_wish *wish, struct vec3s *points, double noise,
                         int threads, double *spent, struct error *error)
{
    enum { ALL = 200000 };
    const double apart = 2; /* in spacings */
    struct cloudmesh_wish fine = *wish;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh made;
    struct cloud_parts parts = {cloudmesh_spacing(wish, points->item, points->n), points->n};
    fine.spacing = apart * parts.mean;
    int status = 0;
    if (points->n > ALL)
        status = cloudmesh_by_grid(&fine, &parts, points, &mesh, &made, error);
    for (size_t i = 0; i < points->n && points->n <= ALL; i++)
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

/* Rows and what is between them. */
static int make_rows(const struct cloudmesh_wish *wish, const struct source *s, int threads,
                     struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    const double slant = 0.866, widest = 24, gaps = 6;
    double mean = s->surface_parts.mean, gap = wish->max_gap > 0 ? wish->max_gap : gaps * mean;
    struct vec3s *points = s->surface;
    struct holes holes;
    struct buckets buckets;
    struct footprint f = footprint_of(points->item, points->n, wish->direction);
    if (holes_find(points->item, points->n, gap, &holes, error) < 0)
        return -1;
    if (buckets_make(points->item, s->surface_parts.flat, mean, threads, &buckets, error) < 0) {
        holes_free(&holes);
        return -1;
    }
    double apart = wish->spacing > 0 ? slant * wish->spacing : widest * mean;
    struct rowmesh_wish rows = {wish->error, mean, apart, s->zone};
    made->rows = rowmesh_make(&buckets, &f, &holes, &rows, mesh);
    buckets_free(&buckets);
    holes_free(&holes);
    if (mesh->face.n == 0 && !wish->subdivide)
        return error_set(error, "no mesh within %g mm of the points: too few of them", wish->error);
    mesh->origin.spacing = (f.ymax - f.ymin) / (double)(made->rows.rows - 1) / slant;
    mesh->origin.direction = wish->direction;
    made->grid = (struct grid){f,      mesh->origin.spacing, f.xmin, f.ymin, made->rows.columns,
                               (int)made->rows.rows};
    return 0;
}

/* How far the points over and under the mesh are from it as it is in the end, in space.  What is
 * near a crease or wall still has its noise: that is allowed for. */
static void measure(const struct mesh *mesh, const struct source *s, const struct vec3s *points,
                    int threads, struct rowmesh *rows)
{
    const double sigmas = 3.5;
    double *distance = mem_alloc(points->n, sizeof *distance), sum2 = 0;

    meshnear(mesh, points->item, points->n, threads, distance);
    rows->worst = 0;
    for (size_t i = 0; i < points->n; i++) {
        struct vec3 at = points->item[i];
        double off = distance[i];
        if (s->noise > 0 && s->zone && edgezone_near(s->zone, at.x, at.y))
            off = fmax(off - sigmas * s->noise, 0);
        sum2 += off * off;
        if (off > rows->worst) {
            rows->worst = off;
            rows->at = at;
        }
    }
    rows->rms = points->n > 0 ? sqrt(sum2 / (double)points->n) : 0;
    free(distance);
}

static int mesh_of(const struct cloudmesh_wish *wish, const struct source *s, int threads,
                   struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    const struct cloud_parts *parts = &s->surface_parts;
    struct vec3s judged = {0};
    int status = make_rows(wish, s, threads, mesh, made, error);
    if (status == 0 && mesh->face.n > 0)
        status = meshcover(mesh, s->surface->item, s->surface->n, parts->mean, &judged, error);
    if (status == 0 && mesh->face.n > 0)
        status =
            cloudmesh_normals(wish, s->surface->item, parts->flat, 0, threads, mesh, error);
    if (status == 0 && mesh->face.n > 0) {
        cloudmesh_edges(wish, &s->scan_parts, s->scan, s->noise, threads, mesh, made);
        measure(mesh, s, &judged, threads, &made->rows);
        made->rows.beside = s->surface->n - judged.n;
    }
    array_free(&judged);
    return status;
}

/* Creases and walls are found best by a grid: where it has some, rows that leave room for them. */
static int mesh_by_zone(const struct cloudmesh_wish *asked, struct source *s, int threads,
                        struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    double fine = cloudmesh_three_spacings(s->scan_parts.mean);
    struct cloudmesh_wish wish = *asked;
    struct mesh grid = {.origin = mesh->origin}, other = {.origin = mesh->origin};
    struct cloudmesh grid_made, other_made = {.walls = 0};
    wish.error = 0;
    wish.silent = true;
    wish.spacing = asked->spacing > 0 ? fmin(asked->spacing, fine) : fine;
    int status = cloudmesh_on_grid(&wish, s->scan, s->noise, threads, &grid, &grid_made, error);
    if (status == 0 && grid_made.edge.n > 0) {
        struct edgezone zone =
            edgezone_make(grid_made.edge.item, grid_made.edge.n, wish.spacing);
        s->zone = &zone;
        if (grid_made.walls > 0) {
            s->scan_parts.flat =
                wallpoints_part(s->scan->item, s->scan->n, s->scan_parts.mean, threads);
            s->surface_parts.flat =
                wallpoints_part(s->surface->item, s->surface->n, s->surface_parts.mean, threads);
        }
        wish = *asked;
        wish.silent = true;
        status = mesh_of(&wish, s, threads, &other, &other_made, error);
        edgezone_free(&zone);
        s->zone = NULL;
        if (status == 0)
            cloudmesh_closer(s->scan, threads, &other, &other_made, mesh, made);
    }
    cloudmesh_drop(&grid, &grid_made);
    cloudmesh_drop(&other, &other_made);
    return status;
}

int cloudmesh_within(const struct cloudmesh_wish *wish, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    struct vec3s surface = {0};
    double spent = NAN;

    *made = (struct cloudmesh){.walls = 0};
    if (footprint_check(points->item, points->n, error) < 0)
        return -1;
    for (size_t i = 0; i < points->n; i++)
        *array_push(&surface) = points->item[i];
    if (noise > 0 && smooth_points(wish, &surface, noise, threads, &spent, error) < 0) {
        array_free(&surface);
        return -1;
    }
    struct source s = {&surface, points, .noise = noise};
    s.surface_parts = (struct cloud_parts){cloudmesh_spacing(wish, surface.item, surface.n), surface.n};
    s.scan_parts = (struct cloud_parts){cloudmesh_spacing(wish, points->item, points->n), points->n};
    int status = mesh_of(wish, &s, threads, mesh, made, error);
    struct cloud_parts walled = s.scan_parts;
    if (status == 0 && !wish->smooth)
        walled.flat = wallpoints_part(points->item, points->n, walled.mean, threads);
    if (status == 0 && mesh->face.n > 0 && !wish->smooth &&
        (made->creases > 0 ||
         (walled.flat < points->n &&
          cloudmesh_has_walls(wish, &walled, points, fmax(noise, mesh->origin.noise), threads))))
        status = mesh_by_zone(wish, &s, threads, mesh, made, error);
    if (noise > 0)
        mesh->origin.ledger = spent;
    array_free(&surface);
    return status;
}
