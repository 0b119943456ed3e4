/*
 * nurbs2mesh - NURBS surfaces to a triangulated mesh with exact normals and curvatures, trimmed,
 * joined along common edges and turned to the tool (Bey, Boudjouad, Tafat-Bouzid 2007, 2.1).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "io/cloud/cloud.h"
#include "stage/nurbs_report.h"
#include "nurbs/orient.h"
#include "base/parallel.h"
#include "io/mesh/ply.h"
#include "io/nurbs/surfaces.h"
#include "nurbs/sew.h"

enum { MOST = 5000 };

/* By the size of the part: edges so near are one, and a surface so narrow is none. */
static const double WIDE = 2.5e-4, NARROW = 1e-5;

struct settings {
    int n;
    double tolerance; /* 0: by n */
    double gap;       /* 0: from the size */
    double up[3];
    int unit, grid; /* grid 0: none */
    bool report, count_given, unit_given;
};

static const char *const unit_name[] = {"mm", "cm", "m", "um", "inch", "in"};

static struct settings read_options(struct cli *cli, int argc, char **argv)
{
    static struct settings s = {.n = 200, .up = {0, 0, 1}};
    const struct cli_option option[] = {
        {'n', "count", "N", "triangles in each direction of a surface (default: 200)", CLI_COUNT,
         &s.n, 1, MOST, 0, &s.count_given},
        {'e', "tolerance", "MM",
         "instead: as many as keep each triangle and each trimmed edge so near\nto the surface",
         CLI_NUMBER, &s.tolerance, CLI_POSITIVE, 0, 0, NULL},
        {'u', "units", "mm|cm|m|um|inch|in", "units of the files, whatever they say themselves",
         CLI_CHOICE, &s.unit, 0, 0, 0, &s.unit_given},
        {'k', "curvature", NULL,
         "print the smallest hollow radius of each surface and where it is,\ninstead of the mesh",
         CLI_FLAG, &s.report, 0, 0, 0, NULL},
        {0, "up", "I,J,K", "where the tool comes from, for which side is outside (default: 0,0,1)",
         CLI_NUMBERS, s.up, 0, 0, 3, NULL},
        {0, "gap", "MM",
         "edges of neighbours so near are one (default: 0.00025 of the size of\nthe part, at most "
         "-e)",
         CLI_NUMBER, &s.gap, CLI_POSITIVE, 0, 0, NULL},
        {0, "grid", "N",
         "print points and normals of an N x N grid of the parameters of each\n"
         "surface, untrimmed, instead of the mesh",
         CLI_COUNT, &s.grid, 2, MOST, 0, NULL},
        {0}};
    cli->option = option;
    cli_parse(cli, argc, argv);
    if (s.count_given && s.tolerance > 0)
        die_usage("-n and -e together, expected one of them");
    if (!(s.up[0] * s.up[0] + s.up[1] * s.up[1] + s.up[2] * s.up[2] > 0))
        die_usage("--up 0,0,0, expected a direction");
    return s;
}

static void read_files(const struct cli *cli, const struct settings *s, struct patches *patches)
{
    struct surfaces_unit unit;
    struct error error;
    double mm = s->unit_given ? cloud_unit(unit_name[s->unit]) : 0;
    for (int i = 0; i < cli->files; i++) {
        if (surfaces_read(cli->file[i], mm, patches, &unit, &error) < 0)
            die_error(&error);
        surfaces_tell_unit(cli->file[i], &unit, s->unit_given ? unit_name[s->unit] : NULL);
    }
    surfaces_tell(patches);
}

/* What the threads share: a surface is a unit of work. */
struct job {
    const struct patches *patches;
    struct tessellation how;
    struct sheet *sheet;
};

static void tessellate_some(void *context, size_t from, size_t to)
{
    struct job *job = context;
    for (size_t i = from; i < to; i++)
        tessellate(&job->patches->item[i], job->how, &job->sheet[i]);
}

/* The farthest any triangle is off its surface. */
static double judge(const struct settings *s, const struct patches *patches,
                    const struct sheet *sheet)
{
    size_t worst = 0;
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        if (sheet[i].too_fine)
            die_unmet(
                "%s: surface %d: more than 4 million cells for %g mm (-e), expected a tolerance "
                "that fewer keep",
                p->file, p->entity, s->tolerance);
        if (sheet[i].error > sheet[worst].error)
            worst = i;
    }
    struct vec3 at = sheet[worst].error_at;
    note("triangles are off the surfaces by %.6f mm at worst (surface %d, at %.3f %.3f %.3f)",
         sheet[worst].error, patches->item[worst].entity, at.x, at.y, at.z);
    if (s->tolerance > 0 && sheet[worst].error > s->tolerance)
        die_unmet("%s: surface %d: %g mm off at %.3f %.3f %.3f, expected %g mm (-e)",
                  patches->item[worst].file, patches->item[worst].entity, sheet[worst].error, at.x,
                  at.y, at.z, s->tolerance);
    return sheet[worst].error;
}

/* Sheets to the tolerance, made one; returns how far triangles are off, with what their corners
 * moved where surfaces do not quite meet. */
static double make_sheets(const struct cli *cli, const struct settings *s,
                          const struct patches *patches, double size, double fine,
                          struct sheet *sheet, struct patch_mesh *patch_mesh,
                          struct sew_count *welded)
{
    /* Few surfaces: the threads share each of them, else each takes one. */
    bool few = patches->n < 8;
    struct job job = {patches, {s->tolerance > 0 ? 0 : s->n, fine, few ? cli->threads : 1}, sheet};
    double gap = s->gap > 0 ? s->gap : WIDE * size;
    if (s->gap == 0 && s->tolerance > 0)
        gap = fmin(gap, s->tolerance);
    for (size_t i = 0; i < patches->n; i++)
        sheet_free(&sheet[i]);
    patch_mesh_free(patch_mesh);
    parallel_shown("tessellating", few ? 1 : cli->threads, patches->n, tessellate_some, &job);
    nurbs_report_trimming(patches, sheet, fine);
    double error = judge(s, patches, sheet);
    patch_mesh_make(sheet, patches->n, fmin(NARROW * size, gap), patch_mesh);
    *welded = sew(patch_mesh, patches, gap, fine);
    return error + welded->moved;
}

/* Everything between reading and writing; returns how far triangles are off. */
static double make_quilt(const struct cli *cli, const struct settings *s,
                         const struct patches *patches, struct sheet *sheet,
                         struct patch_mesh *patch_mesh)
{
    double size = patches_size(patches);
    double fine = s->tolerance > 0 ? s->tolerance : fmax(1e-5 * size, 1e-3);
    struct sew_count welded;
    double error = make_sheets(cli, s, patches, size, fine, sheet, patch_mesh, &welded);
    /* What joining edges takes of the tolerance, triangles must leave. */
    for (int i = 0; i < 3 && s->tolerance > 0 && error > s->tolerance; i++) {
        fine = fmax(s->tolerance - 1.1 * welded.moved, s->tolerance / 4);
        error = make_sheets(cli, s, patches, size, fine, sheet, patch_mesh, &welded);
    }
    if (s->tolerance > 0 && error > s->tolerance)
        die_unmet("neighbours lie %g mm and more apart, expected %g mm (-e): take a smaller --gap",
                  welded.moved, s->tolerance);
    struct orient_count out = orient_outward(patch_mesh, vec(s->up[0], s->up[1], s->up[2]));
    note("%zu border vertices joined and %zu inserted, moved by at most %g mm; %zu %s; %zu open "
         "edges",
         welded.joined, welded.inserted, welded.moved, out.bodies,
         out.bodies == 1 ? "body" : "bodies", out.open);
    if (patch_mesh->narrow > 0)
        say("%zu surfaces narrower than %g mm left out", patch_mesh->narrow, NARROW * size);
    if (out.unclear > 0)
        say("%zu of %zu bodies stand upright: --up does not say which side is outside", out.unclear,
            out.bodies);
    if (out.conflicts > 0)
        say("%zu neighbours cannot be turned to the same side", out.conflicts);
    return error;
}

static char *source_of(const struct cli *cli)
{
    char name[300];
    int n = cli->files == 1
                ? snprintf(name, sizeof name, "%.290s", cli->file[0])
                : snprintf(name, sizeof name, "%.250s and %d more", cli->file[0], cli->files - 1);
    return mem_string(name, (size_t)n);
}

/* What the mesh says of each surface: its name and where it is most tightly hollow. */
static void tell_surfaces(const struct patches *patches, const struct concave_radius *hollow,
                          struct mesh_surfaces *told)
{
    for (size_t i = 0; i < patches->n; i++) {
        char name[300];
        int n = snprintf(name, sizeof name, "%.280s:%d", patches->item[i].file,
                         patches->item[i].entity);
        bool is_hollow = hollow[i].curvature > 1e-9;
        *array_push(told) = (struct mesh_surface){
            mem_string(name, (size_t)n), is_hollow ? 1 / hollow[i].curvature : 0, hollow[i].point};
    }
}

static void write_mesh(const struct cli *cli, const struct patches *patches,
                       const struct concave_radius *hollow, const struct patch_mesh *patch_mesh,
                       double error)
{
    struct mesh mesh = {.origin = {.ledger = error}};
    tell_surfaces(patches, hollow, &mesh.origin.surface);
    mesh.origin.source = source_of(cli);
    mesh.origin.maker = mem_string("nurbs2mesh", strlen("nurbs2mesh"));
    patch_mesh_mesh(patch_mesh, &mesh);
    double area = 0;
    for (size_t i = 0; i < mesh.face.n; i++)
        area += vec_length(mesh_face_cross(&mesh, i));
    if (!(area > 0))
        die("%s: surfaces without area, expected some", mesh.origin.source);
    note("%zu surfaces in; %zu vertices, %zu facets", patch_mesh->sheets, mesh.vertex.n,
         mesh.face.n);
    struct out *out = out_open(cli->output);
    ply_write(out, &mesh);
    out_close(out);
    mesh_free(&mesh);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "nurbs2mesh",
                      .usage = "[options] [FILE...]",
                      .about = "Make a mesh of NURBS surfaces (IGES, or NURBS text)."};
    struct settings settings = read_options(&cli, argc, argv);
    struct patches patches = {0};
    struct patch_mesh patch_mesh = {0};

    read_files(&cli, &settings, &patches);
    struct sheet *sheet = mem_alloc(patches.n, sizeof *sheet);
    if (settings.grid > 0) {
        nurbs_report_grid(cli.output, &patches, settings.grid);
    } else {
        double error = make_quilt(&cli, &settings, &patches, sheet, &patch_mesh);
        struct concave_radius *hollow =
            concave_radius_find_all(&patches, patch_mesh.flipped, cli.threads);
        if (settings.report)
            nurbs_report_radii(cli.output, &patches, hollow);
        else
            write_mesh(&cli, &patches, hollow, &patch_mesh, error);
        free(hollow);
    }
    for (size_t i = 0; i < patches.n; i++)
        sheet_free(&sheet[i]);
    free(sheet);
    patch_mesh_free(&patch_mesh);
    patches_free(&patches);
    return EXIT_DONE;
}
