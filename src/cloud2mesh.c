/*
 * cloud2mesh - scanned points to a triangulated mesh: an oblique grid of equilateral triangles
 * over the cloud, each node moved to the point nearest to it (Chui, Chiu, Yu 2007).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "extend.h"
#include "featuremesh.h"
#include "footprint.h"
#include "grid.h"
#include "gridmesh.h"
#include "intake.h"
#include "meshnear.h"
#include "num.h"
#include "ply.h"
#include "reposition.h"
#include "rowmesh.h"
#include "scannormals.h"
#include "scansmooth.h"
#include "subcloud.h"
#include "submesh.h"
#include "wallpoints.h"

enum normals { NORMALS_QUADRIC, NORMALS_FACET };
enum outliers { OUTLIERS_DROP, OUTLIERS_KEEP };

struct settings {
    double spacing; /* 0: from the cloud */
    double error;   /* 0: the spacing counts */
    double max_gap; /* 0: from the cloud */
    double direction;
    double noise; /* NAN: from the cloud */
    double extend; /* beyond the border, mm */
    int unit, normals, neighbours, outliers;
    bool paper, origin, smooth, subdivide, clean;
    bool silent; /* of what became of the vertices: a trial */
    const char *matrix; /* file, NULL: none */
};

/* The cloud as wallpoints_part put it in order. */
struct cloud_parts {
    double mean; /* spacing of the points, mm */
    size_t flat; /* so many of them lie on no wall */
};

static const char *const unit_name[] = {"mm", "cm", "m", "um", "inch", "in"};

static struct settings read_options(struct cli *cli, int argc, char **argv)
{
    struct settings s = {.noise = NAN};
    bool normals_given = false;
    const struct cli_option option[] = {
        {'t', "spacing", "MM",
         "spacing of the triangular grid (default: three times the mean\nspacing of the points)",
         CLI_NUMBER, &s.spacing, CLI_POSITIVE, 0, 0, NULL},
        {'e', "tolerance", "MM",
         "rows and points on them as far apart as every point of the cloud is\n"
         "within this of the mesh (with -t: no farther than that)",
         CLI_NUMBER, &s.error, CLI_POSITIVE, 0, 0, NULL},
        {'u', "units", "mm|cm|m|um|inch|in", "units of the points (default: mm)", CLI_CHOICE,
         &s.unit, 0, 0, 0, NULL},
        {'a', "direction", "DEG", "direction of the rows, from x towards y (default: 0)",
         CLI_NUMBER, &s.direction, 0, 0, 0, NULL},
        {0, "matrix", "FILE", "place the points by the 4 x 4 matrix in FILE (in mm) first",
         CLI_TEXT, &s.matrix, 0, 0, 0, NULL},
        {0, "origin", NULL, "make the lowest leftmost point the origin of x and y", CLI_FLAG,
         &s.origin, 0, 0, 0, NULL},
        {0, "max-gap", "MM",
         "no facet over an empty disc wider than this (default: six times the\n"
         "mean spacing of the points; with --paper: no limit)",
         CLI_NUMBER, &s.max_gap, CLI_POSITIVE, 0, 0, NULL},
        {0, "normals", "quadric|facet",
         "normals from a quadric through the nearest points of the cloud, or\n"
         "the mean of the facets' (default: quadric; with --paper: facet)",
         CLI_CHOICE, &s.normals, 0, 0, 0, &normals_given},
        {0, "neighbours", "N",
         "points that a quadric is fitted to (default: 40; where there is noise,\n"
         "as many as it takes)",
         CLI_COUNT, &s.neighbours, 6, 1000, 0, NULL},
        {0, "outliers", "drop|keep",
         "leave out outliers and what lies under other points, or only count\n"
         "them (default: drop; with --paper or --normals facet: not looked for)",
         CLI_CHOICE, &s.outliers, 0, 0, 0, &s.clean},
        {0, "noise", "MM",
         "standard deviation of the points (default: as measured; 0: vertices\n"
         "stay points of the scan)",
         CLI_NUMBER, &s.noise, 0, 1e6, 0, NULL},
        {0, "smooth", NULL, "look for no creases and no walls", CLI_FLAG, &s.smooth, 0, 0, 0, NULL},
        {0, "extend", "MM", "continue the surface so far beyond the outer border", CLI_NUMBER,
         &s.extend, CLI_POSITIVE, 0, 0, NULL},
        {0, "subdivide", NULL,
         "divide the cloud by orientation, each part with a projection of its own", CLI_FLAG,
         &s.subdivide, 0, 0, 0, NULL},
        {0, "paper", NULL,
         "as published: a node takes any point nearer than the spacing, holes\n"
         "are bridged, normals are the mean of the facets'",
         CLI_FLAG, &s.paper, 0, 0, 0, NULL},
        {0}};
    cli->option = option;
    cli_parse(cli, argc, argv);
    if (s.paper && !normals_given)
        s.normals = NORMALS_FACET;
    if (s.paper || s.normals == NORMALS_FACET)
        s.smooth = true;
    if (s.extend > 0 && (s.paper || s.subdivide))
        die_usage("found --extend with %s, expected one of them",
                  s.paper ? "--paper" : "--subdivide");
    s.clean = s.clean || s.normals == NORMALS_QUADRIC;
    if (s.paper && s.error > 0)
        die_usage("--paper has a grid of one spacing: expected -t or -e");
    return s;
}

/* What the messages call the cloud: its file, or the first of several. */
static const char *name_of(const struct cli *cli)
{
    static char name[300];
    if (cli->files == 1)
        return cli->file[0];
    snprintf(name, sizeof name, "%.250s and %d more", cli->file[0], cli->files - 1);
    return name;
}

/* Mean spacing of the points, mm. */
static double spacing_of_points(const struct settings *s, const struct vec3 *point, size_t n)
{
    struct footprint f = footprint_of(point, n, s->direction);
    return footprint_spacing(&f, point, n);
}

/* Three times the mean spacing, to three digits: so that -t can say the same. */
static double spacing_of_cloud(double mean)
{
    double step = pow(10, floor(log10(3 * mean)) - 2);
    double digits = step >= 1 ? 0 : fmin(-floor(log10(step)), 9);
    double spacing = num_round(round(3 * mean / step) * step, (int)digits);
    say("spacing %g mm, three times the mean spacing of the points", spacing);
    return spacing;
}

/* Takes out what is no part of the surface; returns the noise that vertices are to be rid of. */
static double clean(const char *name, const struct settings *s, struct vec3s *points, int threads,
                    struct mesh_origin *origin)
{
    const double least = 0.004; /* in spacings: less does not matter beside the facets */
    struct intake intake;
    struct error error;
    double mean = points->n >= 3 ? spacing_of_points(s, points->item, points->n) : 0;
    if (!s->clean || !(mean > 0)) /* no area: the mesh will say so */
        return 0;
    enum intake_drop drop = s->outliers == OUTLIERS_KEEP ? INTAKE_KEEP
                            : s->subdivide               ? INTAKE_DROP_OUTLIERS
                                                         : INTAKE_DROP;
    if (intake_clean(points, mean, drop, threads, &intake, &error) < 0)
        die("%s: %s", name, error.text);
    origin->noise = isnan(s->noise) ? intake.noise : s->noise;
    note("noise of the scan %.4f mm (one standard deviation)", intake.noise);
    return isnan(s->noise) && intake.noise < least * mean ? 0 : origin->noise;
}

/* A point for each node; one on a wall only where there is no other. */
static size_t *choose(const struct settings *s, const struct cloud_parts *parts,
                      const struct grid *grid, const struct vec3s *points)
{
    enum reach reach = s->paper ? REACH_CIRCLE : REACH_NEAREST;
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

/* The mesh of the points, without normals. */
static struct gridmesh_count make_mesh(const char *name, const struct settings *s,
                                       const struct vec3s *points, struct mesh *mesh,
                                       struct grid *grid, const struct cloud_parts *parts)
{
    const struct vec3 *point = points->item;
    struct holes holes = {0};
    struct error error;
    struct footprint f = footprint_of(point, points->n, s->direction);
    bool whole = s->paper && s->max_gap == 0;
    double t = s->spacing;
    double gap = s->max_gap > 0 ? s->max_gap : 6 * parts->mean;
    if (grid_make(&f, points->n, t, grid, &error) < 0 ||
        (!whole && holes_find(point, points->n, gap, &holes, &error) < 0))
        die("%s: %s", name, error.text);
    size_t *chosen = choose(s, parts, grid, points);
    struct gridmesh_count count = gridmesh_make(grid, chosen, point, whole ? NULL : &holes, mesh);
    free(chosen);
    holes_free(&holes);
    if (mesh->face.n == 0 && !s->subdivide)
        die("%s: no three neighbouring nodes of a grid of spacing %g mm have points on an area of "
            "%g x %g mm, expected another spacing (-t) or a wider area",
            name, t, f.xmax - f.xmin, f.ymax - f.ymin);
    mesh->origin.spacing = t;
    mesh->origin.direction = s->direction;
    return count;
}

static void say_left_out(const struct settings *settings, const struct gridmesh_count *count)
{
    if (count->bridges > 0)
        note("left out %zu facet%s over a hole", count->bridges, count->bridges == 1 ? "" : "s");
    if (count->no_area > 0)
        note("left out %zu facet%s without area", count->no_area, count->no_area == 1 ? "" : "s");
    if (count->folded > 0)
        say("left out %zu facet%s that would lie face down: the spacing is too fine for the points",
            count->folded, count->folded == 1 ? "" : "s");
    if (count->alone > 0 && !settings->paper)
        say("left out %zu point%s that no facet reaches", count->alone,
            count->alone == 1 ? "" : "s");
}

/* What one projection serves badly. */
static void say_steep(const struct settings *settings, const struct mesh *mesh)
{
    const double little = 0.005;
    double part = mesh_steep_part(mesh, vec(0, 0, 1));
    if (part > little && !settings->subdivide && !settings->paper)
        say("%.1f %% of the surface is steeper than 70 degrees, where points are far apart seen from "
            "above: --subdivide gives it projections of its own",
            100 * part);
}

static void say_thin(size_t thin, const struct mesh *mesh)
{
    if (thin > 0)
        say("%zu of %zu vertices have too few points about them for a quadric: their normals are "
            "the facets'",
            thin, mesh->vertex.n);
}

/* Normals of the points as they are; returns the tolerance spent. */
static double normals_of_points(const struct settings *s, const struct buckets *buckets,
                                int threads, struct mesh *mesh)
{
    int neighbours = s->neighbours ? s->neighbours : 40;
    struct scannormals r = scannormals_quadric(mesh, buckets, neighbours, threads);
    if (s->silent)
        return r.noise;
    say_thin(r.thin, mesh);
    struct vec3 at = mesh->vertex.item[r.at];
    note("vertices are off their quadrics by %.4f mm at worst (at %.3f %.3f %.3f), %.4f mm rms; "
         "three sigma of the noise %.4f mm",
         r.worst, at.x, at.y, at.z, r.rms, r.noise);
    return r.noise;
}

/* Vertices moved onto the surface, and its normals; returns the tolerance spent. */
static double move_vertices(const struct settings *s, const struct buckets *buckets, double noise,
                            int threads, struct mesh *mesh)
{
    struct scansmooth r = scansmooth(mesh, buckets, noise, (size_t)s->neighbours, threads);
    if (s->silent)
        return 3 * r.error;
    say_thin(r.thin, mesh);
    say("noise %.4f mm (one standard deviation): %zu of %zu vertices moved onto surfaces through "
        "about %zu points, to within %.4f mm (one standard deviation)",
        noise, r.moved, mesh->vertex.n, r.typical, r.error);
    if (r.kept > 0)
        say("%zu vertices not moved: no surface explains the points about them", r.kept);
    struct vec3 at = mesh->vertex.item[r.at];
    note("moved by %.4f mm at most, to %.3f %.3f %.3f", r.farthest, at.x, at.y, at.z);
    return 3 * r.error;
}

/* Sorts the points. */
static void make_normals(const char *name, const struct settings *s, struct vec3 *point, size_t n,
                         double noise, int threads, struct mesh *mesh)
{
    struct buckets buckets;
    struct error error;
    if (s->normals == NORMALS_FACET) {
        mesh_normals_facet(mesh);
        return;
    }
    if (buckets_make(point, n, spacing_of_points(s, point, n), threads, &buckets, &error) < 0)
        die("%s: %s", name, error.text);
    mesh->origin.ledger = noise > 0 ? move_vertices(s, &buckets, noise, threads, mesh)
                                    : normals_of_points(s, &buckets, threads, mesh);
    mesh->origin.maker = mem_string("cloud2mesh", strlen("cloud2mesh"));
    buckets_free(&buckets);
}

/* The vertices of a fine mesh, on the surface that noisy points stand for, instead of these; returns
 * the tolerance spent. */
static double replace_by_surface(const char *name, const struct settings *s, struct vec3s *points,
                                 double noise, int threads)
{
    struct settings fine = *s;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloud_parts parts = {spacing_of_points(s, points->item, points->n), points->n};
    struct grid grid;
    struct error error;
    if (footprint_check(points->item, points->n, &error) < 0)
        die("%s: %s", name, error.text);
    fine.spacing = 2 * parts.mean;
    make_mesh(name, &fine, points, &mesh, &grid, &parts);
    make_normals(name, &fine, points->item, points->n, noise, threads, &mesh);
    array_free(points);
    *points = mesh.vertex;
    mesh.vertex = (struct vec3s){0};
    double spent = mesh.origin.ledger;
    mesh_free(&mesh);
    return spent;
}

/* The mesh that an error asks for, without normals. */
static struct rowmesh make_row_mesh(const char *name, const struct settings *s,
                                    const struct cloud_parts *parts, struct vec3s *points,
                                    int threads, struct mesh *mesh, struct grid *grid)
{
    const double slant = 0.866, widest = 24, gaps = 6;
    double gap = s->max_gap > 0 ? s->max_gap : gaps * parts->mean;
    struct holes holes;
    struct buckets buckets;
    struct error error;
    struct footprint f = footprint_of(points->item, points->n, s->direction);
    if (holes_find(points->item, points->n, gap, &holes, &error) < 0 ||
        buckets_make(points->item, parts->flat, parts->mean, threads, &buckets, &error) < 0)
        die("%s: %s", name, error.text);
    double apart = s->spacing > 0 ? slant * s->spacing : widest * parts->mean;
    struct rowmesh made = rowmesh_make(&buckets, &f, &holes, s->error, parts->mean, apart, mesh);
    buckets_free(&buckets);
    holes_free(&holes);
    if (mesh->face.n == 0 && !s->subdivide)
        die("%s: no mesh within %g mm of the points: too few of them", name, s->error);
    mesh->origin.spacing = (f.ymax - f.ymin) / (double)(made.rows - 1) / slant;
    mesh->origin.direction = s->direction;
    *grid = (struct grid){f, mesh->origin.spacing, f.xmin, f.ymin, made.columns, (int)made.rows};
    return made;
}

static size_t keep_features(const struct vec3s *points, const struct cloud_parts *parts,
                            double noise, int threads, struct mesh *mesh, size_t *creases)
{
    struct featuremesh found =
        featuremesh_keep(mesh, points->item, points->n, parts->flat, parts->mean, noise, threads);
    *creases = found.creases;
    return found.walls;
}

/* What became of the points, for the summary. */
struct made {
    struct gridmesh_count count;
    struct grid grid;
    struct rowmesh rows;   /* with an error */
    size_t creases, walls; /* edges that cross one */
};

/* The mean spacing, and the points of walls behind the others; the spacing of the grid. */
static struct cloud_parts part_walls(const char *name, struct settings *s, struct vec3s *points,
                                     int threads)
{
    struct error error;
    struct cloud_parts parts = {0, points->n};
    if (footprint_check(points->item, points->n, &error) < 0)
        die("%s: %s", name, error.text);
    bool whole = s->paper && s->max_gap == 0;
    if (!s->smooth || s->error > 0 || !(s->spacing > 0) || !(whole || s->max_gap > 0))
        parts.mean = spacing_of_points(s, points->item, points->n);
    if (!s->smooth)
        parts.flat = wallpoints_part(points->item, points->n, parts.mean, threads);
    if (!(s->spacing > 0) && !(s->error > 0))
        s->spacing = spacing_of_cloud(parts.mean);
    return parts;
}

static struct made mesh_of(const char *name, const struct settings *settings,
                           const struct cloud_parts *parts, struct vec3s *points, double noise,
                           int threads, struct mesh *mesh)
{
    struct made made = {.walls = 0};
    if (settings->error > 0)
        made.rows = make_row_mesh(name, settings, parts, points, threads, mesh, &made.grid);
    else
        made.count = make_mesh(name, settings, points, mesh, &made.grid, parts);
    if (mesh->face.n == 0)
        return made;
    make_normals(name, settings, points->item, parts->flat, noise, threads, mesh);
    if (!settings->smooth)
        made.walls = keep_features(points, parts, fmax(noise, mesh->origin.noise), threads, mesh,
                                   &made.creases);
    if (!settings->paper)
        mesh_normals_seen(mesh);
    return made;
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

/* Is there a wall between two nodes? */
static bool has_walls(const char *name, const struct settings *s, const struct cloud_parts *parts,
                      const struct vec3s *points, double noise, int threads)
{
    struct mesh mesh = {.origin.ledger = NAN};
    struct grid grid;
    make_mesh(name, s, points, &mesh, &grid, parts);
    size_t walls = featuremesh_walls(&mesh, points->item, points->n, parts->flat, parts->mean,
                                     noise, threads);
    mesh_free(&mesh);
    return walls > 0;
}

/* Vertices are chosen from the points of walls, unless the mesh is closer to all points without:
 * steep flanks are no walls. */
static struct made best_mesh(const char *name, const struct settings *settings,
                             struct vec3s *points, double noise, int threads, struct mesh *mesh)
{
    struct settings s = *settings;
    struct cloud_parts parts = part_walls(name, &s, points, threads);
    struct mesh with_walls = {.origin = mesh->origin};
    struct made walled = {.walls = 0};
    s.silent = true;
    if (parts.flat < points->n &&
        has_walls(name, &s, &parts, points, fmax(noise, mesh->origin.noise), threads))
        walled = mesh_of(name, &s, &parts, points, noise, threads, &with_walls);
    parts.flat = points->n;
    s.silent = false;
    struct made made = mesh_of(name, &s, &parts, points, noise, threads, mesh);
    if (walled.walls > 0 &&
        off_points(&with_walls, points, threads) < off_points(mesh, points, threads)) {
        struct mesh swap = *mesh;
        *mesh = with_walls;
        with_walls = swap;
        made = walled;
    }
    if (!s.smooth)
        note("creases cross %zu edges of the mesh, walls %zu", made.creases, made.walls);
    with_walls.origin = (struct mesh_origin){.source = NULL};
    mesh_free(&with_walls);
    return made;
}

/* The same for each part of a cloud that is divided by orientation, one after the other. */
static struct made mesh_of_parts(const char *name, const struct settings *settings,
                                 const struct vec3s *points, double noise, int threads,
                                 struct mesh *mesh)
{
    struct settings s = *settings;
    struct made made = {0};
    struct subclouds parts =
        subclouds_find(points->item, points->n, 1.5 * s.spacing, s.direction, threads);
    s.spacing = s.spacing > 0 ? s.spacing : spacing_of_cloud(parts.spacing);
    s.direction = 0;
    mesh->origin.spacing = s.spacing;
    for (size_t i = 0; i < parts.n; i++) {
        struct subcloud *part = &parts.item[i];
        struct mesh own = {.origin.ledger = NAN};
        for (size_t k = 0; k < part->point.n; k++)
            part->point.item[k] = subcloud_in(part, part->point.item[k]);
        note("part %zu of %zu: seen along %.3f %.3f %.3f, %zu points", i + 1, parts.n, part->up.x,
             part->up.y, part->up.z, part->own);
        made = best_mesh(name, &s, &part->point, noise, threads, &own);
        if (own.face.n > 0)
            submesh_add(mesh, &own, part);
        mesh_free(&own);
    }
    say("divided into %zu part%s, each with a projection of its own", parts.n,
        parts.n == 1 ? "" : "s");
    if (parts.left_out > 0)
        say("%zu points belong to no part and are left out", parts.left_out);
    subclouds_free(&parts);
    if (mesh->face.n == 0)
        die("%s: no part has points for three neighbouring nodes of a grid of spacing %g mm, "
            "expected another spacing (-t)",
            name, s.spacing);
    return made;
}

static void extend(const char *name, const struct settings *s, struct vec3s *points, double noise,
                   int threads)
{
    struct error error;
    size_t n = points->n;
    if (footprint_check(points->item, n, &error) < 0)
        die("%s: %s", name, error.text);
    double mean = spacing_of_points(s, points->item, n);
    double gap = s->max_gap > 0 ? s->max_gap : 6 * mean;
    if (extend_cloud(points, mean, gap, s->extend, noise, threads, &error) < 0)
        die("%s: %s", name, error.text);
    say("continued by %g mm beyond the border, by %zu points", s->extend, points->n - n);
}

static void say_rows(const struct rowmesh *r, double error, bool of_surface)
{
    say("%s within %.4f mm of the mesh at worst (at %.3f %.3f %.3f), %.4f mm rms; %zu rows",
        of_surface ? "the surface that the points stand for is" : "the points are", r->worst,
        r->at.x, r->at.y, r->at.z, r->rms, r->rows);
    if (r->beside > 0)
        note("%zu points beside the mesh, at its borders", r->beside);
    if (r->bridges > 0)
        note("left out %zu facets over a hole", r->bridges);
    if (r->worst > error)
        note("%g mm would take points closer to each other", error);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "cloud2mesh",
                      .usage = "[options] [FILE...]",
                      .about = "Make a mesh of scanned points (several files are one cloud)."};
    struct settings settings = read_options(&cli, argc, argv);
    struct vec3s points = {0};
    struct mesh mesh = {.origin.ledger = NAN};

    struct error error;
    size_t left_out;

    const char *name = name_of(&cli);
    if (intake_read(cli.file, cli.files, &points, &left_out, &error) < 0 ||
        intake_place(&points, unit_name[settings.unit], settings.matrix, settings.origin,
                     &mesh.origin, &error) < 0)
        die_error(&error);
    size_t read = points.n;
    double noise = clean(name, &settings, &points, cli.threads, &mesh.origin);
    left_out += read - points.n;
    if (settings.extend > 0)
        extend(name, &settings, &points, noise, cli.threads);
    bool of_surface = settings.error > 0 && noise > 0 && !settings.subdivide;
    double spent = of_surface
                       ? replace_by_surface(name, &settings, &points, noise, cli.threads)
                       : NAN;
    noise = of_surface ? 0 : noise;
    struct made made = settings.subdivide
                           ? mesh_of_parts(name, &settings, &points, noise, cli.threads, &mesh)
                           : best_mesh(name, &settings, &points, noise, cli.threads, &mesh);
    if (of_surface)
        mesh.origin.ledger = spent;
    say_left_out(&settings, &made.count);
    say_steep(&settings, &mesh);
    if (settings.error > 0)
        say_rows(&made.rows, settings.error, of_surface);
    note("%zu points in, %zu left out; spacing %g mm, %d rows x %d columns; %zu vertices, "
         "%zu facets",
         read, left_out, made.grid.t, made.grid.rows, made.grid.columns, mesh.vertex.n,
         mesh.face.n);
    mesh.origin.source = mem_string(name, strlen(name));

    struct out *out = out_open(cli.output);
    ply_write(out, &mesh);
    out_close(out);
    mesh_free(&mesh);
    array_free(&points);
    if (settings.error > 0 && made.rows.worst > settings.error)
        die_unmet("%s: the mesh is off by %.4f mm at %.3f %.3f %.3f, expected %g mm: the points are "
                  "too far apart there, or it is steep",
                  name, made.rows.worst, made.rows.at.x, made.rows.at.y, made.rows.at.z,
                  settings.error);
    return EXIT_DONE;
}
