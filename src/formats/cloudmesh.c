/* cloudmesh - see cloudmesh.h. */
#include "cloudmesh.h"

#include <stdlib.h>

#include "cli.h"
#include "cloudmesh_base.h"
#include "featuremesh.h"
#include "meshnear.h"
#include "num.h"
#include "subcloud.h"
#include "submesh.h"
#include "wallpoints.h"

/* Three times the mean spacing, to three digits: so that -t can say the same. */
static double three_spacings(double mean)
{
    double step = pow(10, floor(log10(3 * mean)) - 2);
    double digits = step >= 1 ? 0 : fmin(-floor(log10(step)), 9);
    return num_round(round(3 * mean / step) * step, (int)digits);
}

static double spacing_of_cloud(double mean)
{
    double spacing = three_spacings(mean);
    say("spacing %g mm, three times the mean spacing of the points", spacing);
    return spacing;
}

/* The mean spacing, and the points of walls behind the others; the spacing of the grid. */
static int part_walls(struct cloudmesh_wish *wish, struct vec3s *points, int threads,
                      struct cloud_parts *parts, struct error *error)
{
    *parts = (struct cloud_parts){0, points->n};
    if (footprint_check(points->item, points->n, error) < 0)
        return -1;
    bool whole = wish->paper && wish->max_gap == 0;
    if (!wish->smooth || wish->error > 0 || !(wish->spacing > 0) || !(whole || wish->max_gap > 0))
        parts->mean = cloudmesh_spacing(wish, points->item, points->n);
    if (!wish->smooth)
        parts->flat = wallpoints_part(points->item, points->n, parts->mean, threads);
    if (!(wish->spacing > 0) && !(wish->error > 0))
        wish->spacing = spacing_of_cloud(parts->mean);
    return 0;
}

static int mesh_of(const struct cloudmesh_wish *wish, const struct cloud_parts *parts,
                   struct vec3s *points, double noise, int threads, struct mesh *mesh,
                   struct cloudmesh *made, struct error *error)
{
    int status = wish->error > 0
                     ? cloudmesh_by_error(wish, parts, points, threads, mesh, made, error)
                     : cloudmesh_by_grid(wish, parts, points, mesh, made, error);
    if (status < 0 || mesh->face.n == 0)
        return status;
    if (cloudmesh_normals(wish, points->item, parts->flat, noise, threads, mesh, error) < 0)
        return -1;
    if (!wish->smooth) {
        struct featuremesh found =
            featuremesh_keep(mesh, points->item, points->n, parts->flat, parts->mean,
                             fmax(noise, mesh->origin.noise), threads);
        made->creases = found.creases;
        made->walls = found.walls;
        if (found.too_many > 0 && !wish->silent)
            say("%zu edges of the mesh lie where the scan is rough: too many to look for creases "
                "and walls there (a wider spacing has fewer)",
                found.too_many);
    }
    if (!wish->paper)
        mesh_normals_seen(mesh);
    return 0;
}

/* The sum of the squared distances of the points from the mesh, of every so many of them. */
static double off_points(const struct mesh *mesh, const struct vec3s *points, int threads)
{
    const size_t most = 100000;
    struct vec3s some = {0};
    double sum = 0;
    for (size_t i = 0; i < points->n; i += points->n / most + 1)
        *array_push(&some) = points->item[i];
    double *distance = mem_alloc(some.n, sizeof *distance);
    meshnear(mesh, some.item, some.n, threads, distance);
    for (size_t i = 0; i < some.n; i++)
        sum += distance[i] * distance[i];
    free(distance);
    array_free(&some);
    return sum;
}

/* Is there a wall between two nodes of a grid? */
static bool has_walls(const struct cloudmesh_wish *wish, const struct cloud_parts *parts,
                      const struct vec3s *points, double noise, int threads)
{
    struct cloudmesh_wish grid = *wish;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh made;
    struct error error;
    if (!(grid.spacing > 0))
        grid.spacing = three_spacings(parts->mean);
    bool found = cloudmesh_by_grid(&grid, parts, points, &mesh, &made, &error) == 0 &&
                 featuremesh_walls(&mesh, points->item, points->n, parts->flat, parts->mean,
                                   noise, threads) > 0;
    mesh_free(&mesh);
    return found;
}

/* Vertices are chosen from the points of walls, unless the mesh is closer to all points without:
 * steep flanks are no walls. */
static int best_mesh(const struct cloudmesh_wish *asked, struct vec3s *points, double noise,
                     int threads, struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    struct cloudmesh_wish wish = *asked;
    struct cloud_parts parts;
    struct cloudmesh walled = {.walls = 0};
    *made = walled;
    if (part_walls(&wish, points, threads, &parts, error) < 0)
        return -1;
    struct mesh with_walls = {.origin = mesh->origin};
    wish.silent = true;
    int status = 0;
    if (parts.flat < points->n &&
        has_walls(&wish, &parts, points, fmax(noise, mesh->origin.noise), threads))
        status = mesh_of(&wish, &parts, points, noise, threads, &with_walls, &walled, error);
    parts.flat = points->n;
    wish.silent = asked->silent;
    if (status == 0)
        status = mesh_of(&wish, &parts, points, noise, threads, mesh, made, error);
    if (status == 0 && walled.walls > 0 &&
        off_points(&with_walls, points, threads) < off_points(mesh, points, threads)) {
        struct mesh swap = *mesh;
        *mesh = with_walls;
        with_walls = swap;
        *made = walled;
    }
    if (status == 0 && !wish.smooth)
        note("creases cross %zu edges of the mesh, walls %zu", made->creases, made->walls);
    with_walls.origin = (struct mesh_origin){.source = NULL};
    mesh_free(&with_walls);
    return status;
}

/* One part of a cloud that is divided, in its own projection. */
static int add_part(const struct cloudmesh_wish *wish, struct subcloud *part, double noise,
                    int threads, struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    struct mesh own = {.origin.ledger = NAN};
    struct rowmesh worst = made->rows;
    for (size_t k = 0; k < part->point.n; k++)
        part->point.item[k] = subcloud_in(part, part->point.item[k]);
    int status = best_mesh(wish, &part->point, noise, threads, &own, made, error);
    if (status == 0 && own.face.n > 0)
        submesh_add(mesh, &own, part);
    if (worst.worst > made->rows.worst)
        made->rows = worst;
    mesh_free(&own);
    return status;
}

/* The same for each part of a cloud that is divided by orientation, one after the other. */
static int mesh_of_parts(const struct cloudmesh_wish *asked, const struct vec3s *points,
                         double noise, int threads, struct mesh *mesh, struct cloudmesh *made,
                         struct error *error)
{
    struct cloudmesh_wish wish = *asked;
    struct subclouds parts =
        subclouds_find(points->item, points->n, 1.5 * wish.spacing, wish.direction, threads);
    int status = 0;
    wish.spacing = wish.spacing > 0 ? wish.spacing : spacing_of_cloud(parts.spacing);
    wish.direction = 0;
    mesh->origin.spacing = wish.spacing;
    for (size_t i = 0; i < parts.n && status == 0; i++) {
        struct subcloud *part = &parts.item[i];
        note("part %zu of %zu: seen along %.3f %.3f %.3f, %zu points", i + 1, parts.n, part->up.x,
             part->up.y, part->up.z, part->own);
        status = add_part(&wish, part, noise, threads, mesh, made, error);
    }
    if (status == 0)
        say("divided into %zu part%s, each with a projection of its own", parts.n,
            parts.n == 1 ? "" : "s");
    if (status == 0 && parts.left_out > 0)
        say("%zu points belong to no part and are left out", parts.left_out);
    subclouds_free(&parts);
    if (status == 0 && mesh->face.n == 0)
        return error_set(error,
                         "no part has points for three neighbouring nodes of a grid of spacing "
                         "%g mm, expected another spacing (-t)",
                         wish.spacing);
    return status;
}

int cloudmesh_make(const struct cloudmesh_wish *wish, struct vec3s *points, double noise,
                   int threads, struct mesh *mesh, struct cloudmesh *made, struct error *error)
{
    *made = (struct cloudmesh){.walls = 0};
    return wish->subdivide ? mesh_of_parts(wish, points, noise, threads, mesh, made, error)
                           : best_mesh(wish, points, noise, threads, mesh, made, error);
}

int cloudmesh_smooth_points(const struct cloudmesh_wish *wish, struct vec3s *points, double noise,
                            int threads, double *spent, struct error *error)
{
    enum { ALL = 200000 };   /* so many points are all moved, of more some */
    const double apart = 2; /* in spacings */
    struct cloudmesh_wish fine = *wish;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh made;
    if (footprint_check(points->item, points->n, error) < 0)
        return -1;
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
