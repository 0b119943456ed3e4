/*
 * cloudmesh - see cloudmesh.h.  One mesh, by a grid or within an error; that of each part of a
 * divided cloud.
 */
#include "stage/cloudmesh.h"

#include <stdlib.h>

#include "base/cli.h"
#include "cloud/cloud.h"
#include "cloudmesh_steps.h"
#include "meshing/meshing.h"

/* Part of a mesh that is steep from where on facets are looked for that are turned over: it takes a
 * quarter of the time of the mesh of a head. */
static const double STEEP = 0.25, STEEP_ELSE = 0.05;

/* A cloud that one projection serves. */
static int one_mesh(const struct cloudmesh_options *options, struct vec3s *points, double noise,
                    int threads, struct mesh *mesh, struct cloudmesh *result, struct error *error)
{
    if (options->method != CLOUDMESH_CHUI)
        return cloudmesh_by_way(options, points, noise, threads, mesh, result, error);
    int status = options->error > 0
                     ? cloudmesh_within(options, points, noise, threads, mesh, result, error)
                     : cloudmesh_on_grid(options, points, noise, threads, mesh, result, error);
    if (status == 0 && !options->smooth)
        note("creases cross %zu edges of the mesh, walls %zu, ribs and grooves %zu",
             result->creases, result->walls, result->crests);
    array_free(&result->edge);
    return status;
}

/* Up, where nothing is said. */
static struct vec3 outside_of(const struct cloudmesh_options *options)
{
    return vec_length(options->outside) > 0 ? vec_unit(options->outside) : vec(0, 0, 1);
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
    const struct segments_options how = {1.5 * options.spacing, options.direction,
                                         outside_of(asked), threads};
    struct segments parts = segments_find(points->item, points->n, &how);
    struct smoothed_parts smoothed = {.n = 0};
    int status = 0;
    options.spacing =
        options.spacing > 0 ? options.spacing : cloudmesh_default_spacing(parts.spacing);
    options.direction = 0;
    options.mean = 0; /* each part has its own */
    options.parts = &smoothed;
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
    if (status == 0)
        say_smoothed_parts(&smoothed);
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
    double steep = options->subdivide ? 0 : options->method == CLOUDMESH_CHUI ? STEEP : STEEP_ELSE;

    *result = (struct cloudmesh){.walls = 0};
    int status = options->subdivide
                     ? mesh_of_parts(options, points, noise, threads, mesh, result, error)
                     : one_mesh(options, points, noise, threads, mesh, result, error);
    if (status != 0 || options->paper || options->smooth) /* what is streamed is not at hand */
        return status;
    result->turned = cloudmesh_drop_turned(points, outside_of(options), steep, threads, mesh,
                                           &result->turned_part);
    mesh_normals_turn(mesh);
    if (!options->subdivide)
        mesh_normals_seen(mesh);
    return status;
}
