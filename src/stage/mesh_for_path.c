/* mesh_for_path - see mesh_for_path.h. */
#include "stage/mesh_for_path.h"

#include <string.h>
#include <strings.h>

#include "base/cli.h"
#include "io/mesh/meshfile.h"
#include "io/mesh/ply.h"
#include "mesh/mesh_repair.h"
#include "stage/cloud_options.h"

static const double FITS = 1 + 1e-6;

/* Before anything is done to its vertices. */
static void name_itself(const char *file, struct mesh *mesh)
{
    scan_sources_add(&mesh->origin.itself, file ? file : "-", mesh->vertex.item, mesh->vertex.n);
}

int mesh_for_rows_read(const char *file, const struct normal_estimator *normals, struct mesh *mesh,
                       struct error *error)
{
    struct error why;
    struct normals_options options = {.silent = false};

    if (ply_read(file, mesh, error) != 0)
        return -1;
    name_itself(file, mesh);
    if (normals->estimate(mesh, &options, &why) != 0)
        return error_at(error, file, 0, "%s", why.text);
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        if (vec_length(mesh->normal.item[v]) < 0.5)
            return error_at(error, file, 0,
                            "vertex %zu: found a normal of no length, expected a "
                            "unit vector",
                            v);
    }
    return 0;
}

static void say_repairs(const char *file, const struct mesh_repair_report *r)
{
    if (r->welded > 0)
        note("%s: %zu vertices at the places of others made one with them", file, r->welded);
    if (r->no_area > 0)
        say("%s: %zu facets without area left out", file, r->no_area);
    if (r->doubled > 0)
        say("%s: %zu facets were there twice, one of each left out", file, r->doubled);
    if (r->many > 0)
        say("%s: %zu edges have more than two facets: passes end there", file, r->many);
    if (r->flipped > 0)
        say("%s: %zu facets had the opposite orientation to their neighbours or normals: flipped",
            file, r->flipped);
    if (r->turned > 0)
        say("%s: normals pointed down, or into a closed part: %zu of %zu sheets flipped", file,
            r->turned, r->sheets);
    if (r->normals > 0)
        say("%s: %zu normals pointed away from their facets: turned to their side", file,
            r->normals);
    if (r->normals_made)
        say("%s: the mesh has no normals: taking the mean of the facets', sharp edges kept", file);
}

/* Of a mesh of another program, whose unit nobody can tell: how large it is in mm, and what a
 * comment calls its unit. */
static void say_unit(const char *file, const struct mesh *mesh)
{
    const char *unit = mesh->origin.unit;
    struct box box = box_around(mesh->vertex.item, mesh->vertex.n);
    struct vec3 size = vec_sub(box.high, box.low);
    bool likely = size_is_likely(fmax(size.x, fmax(size.y, size.z)));
    bool mm = unit && (strncasecmp(unit, "mm", 2) == 0 || strncasecmp(unit, "milli", 5) == 0);

    if (mesh->origin.own || (mm && likely))
        return;
    if (unit && !mm)
        say("%s: a comment calls the unit `%.20s`, which is not worked in: make the mesh anew in "
            "mm",
            file, unit);
    say("%s: %.4g x %.4g x %.4g mm, its unit taken as mm%s", file, size.x, size.y, size.z,
        likely ? "" : ": is that right?");
}

int mesh_for_planes_read(const char *file, struct vec3 up, int threads, struct mesh *mesh,
                         bool *closed, struct error *error)
{
    if (mesh_read(file, mesh, error) != 0)
        return -1;
    name_itself(file, mesh);
    struct mesh_repair_report report = mesh_repair(mesh, up, threads);
    if (mesh->face.n == 0)
        return error_set(error, "%s: found no facet that has an area", file);
    say_unit(file, mesh);
    for (size_t i = 0; i < 3 * mesh->face.n; i++) {
        int v = mesh->face.item[i / 3].v[i % 3];
        if (vec_length(mesh->normal.item[v]) < 0.5)
            return error_set(error,
                             "%s: vertex %d: found a normal of no length, expected a unit vector",
                             file, v);
    }
    say_repairs(file, &report);
    *closed = report.closed == report.sheets;
    return 0;
}

static void take_hollow(struct tightest_hollow *h, double radius, struct vec3 at,
                        const char *surface, double ball)
{
    h->tighter += ball > radius * FITS;
    if (radius < h->radius) {
        h->radius = radius;
        h->at = at;
        h->surface = surface;
    }
}

struct tightest_hollow mesh_tightest_hollow(const struct mesh *mesh, double ball)
{
    const struct mesh_surfaces *s = &mesh->origin.surface;
    struct tightest_hollow h = {.known = s->n > 0 || mesh->kmax.n > 0, .radius = HUGE_VAL};

    for (size_t i = 0; i < s->n; i++) {
        if (s->item[i].radius > 0)
            take_hollow(&h, s->item[i].radius, s->item[i].at, s->item[i].name, ball);
    }
    if (s->n > 0)
        return h;
    for (size_t v = 0; v < mesh->kmax.n; v++) {
        if (mesh->kmax.item[v] > 0)
            take_hollow(&h, 1 / mesh->kmax.item[v], mesh->vertex.item[v], NULL, ball);
    }
    return h;
}
