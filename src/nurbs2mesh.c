/*
 * nurbs2mesh - NURBS surfaces to a triangulated mesh with exact normals and curvatures, trimmed,
 * joined along common edges and turned to the tool (Bey, Boudjouad, Tafat-Bouzid 2007, 2.1).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "base/parallel.h"
#include "io/cloud/cloud.h"
#include "io/mesh/ply.h"
#include "io/nurbs/surfaces.h"
#include "io/nurbs/surfaces_told.h"
#include "nurbs/coincident.h"
#include "nurbs/orient.h"
#include "nurbs/patch_weld.h"
#include "nurbs/sew.h"
#include "nurbs/skin.h"
#include "nurbs/skin_close.h"
#include "nurbs/skin_measure.h"
#include "stage/cloud_options.h"
#include "stage/nurbs_report.h"

enum { CELLS_MAX = 5000, USUAL = 200 };

/* By the size of the part: surfaces so narrow are left out, and two so near everywhere are one. */
static const double NARROW = 1e-5, SAME = 1e-6;

/* In widths of a slit that is closed without a word: wider ones between surfaces are closed too,
 * unless --gap says how far apart neighbours are. */
static const double SLIT_WIDEST = 8;

struct settings {
    int n;
    double tolerance; /* 0: by n */
    double gap;       /* 0: from the size */
    double up[3];
    int unit, grid; /* grid 0: none */
    bool report, partial, count_given, unit_given;
};

static struct settings read_options(struct cli *cli, int argc, char **argv)
{
    static struct settings s = {.n = USUAL, .up = {0, 0, 1}};
    const struct cli_option option[] = {
        {'n', "count", "N", "triangles in each direction of a surface (default: 200)", CLI_COUNT,
         &s.n, 1, CELLS_MAX, 0, &s.count_given},
        {'e', "tolerance", "MM",
         "instead of -n: largest deviation of triangles and trimmed edges from\nthe surface",
         CLI_NUMBER, &s.tolerance, CLI_POSITIVE, 0, 0, NULL},
        UNIT_OPTION("units of the files, whatever they state", &s.unit, &s.unit_given),
        {'k', "curvature", NULL,
         "print the smallest concave radius of each surface and its place\ninstead of the mesh",
         CLI_FLAG, &s.report, 0, 0, 0, NULL},
        {0, "up", "I,J,K", "direction towards the tool, for the outer side (default: 0,0,1)",
         CLI_NUMBERS, s.up, 0, 0, 3, NULL},
        {0, "gap", "MM",
         "join edges of neighbours within this (default: 0.00025 of the size of\nthe part, at most "
         "-e)",
         CLI_NUMBER, &s.gap, CLI_POSITIVE, 0, 0, NULL},
        {0, "partial", NULL, "continue without surfaces and trimming curves of unsupported types",
         CLI_FLAG, &s.partial, 0, 0, 0, NULL},
        {0, "grid", "N",
         "print points and normals of an N x N grid of the parameters of each\n"
         "surface, untrimmed, instead of the mesh",
         CLI_COUNT, &s.grid, 2, CELLS_MAX, 0, NULL},
        {0}};
    cli->option = option;
    cli_parse(cli, argc, argv);
    if (s.count_given && s.tolerance > 0)
        die_usage("-n and -e together, expected one of them");
    if (!(s.up[0] * s.up[0] + s.up[1] * s.up[1] + s.up[2] * s.up[2] > 0))
        die_usage("--up 0,0,0, expected a direction");
    return s;
}

static void read_files(const struct cli *cli, const struct settings *s, struct patches *patches,
                       struct unmets *unmet)
{
    struct surfaces_unit unit;
    struct error error;
    double mm = s->unit_given ? cloud_unit(unit_name[s->unit]) : 0;
    for (int i = 0; i < cli->files; i++) {
        if (surfaces_read(cli->file[i], mm, patches, &unit, &error) < 0)
            die_error(&error);
        surfaces_tell_unit(cli->file[i], &unit, s->unit_given ? unit_name[s->unit] : NULL);
    }
    say_unlikely_size(cli->file[0], patches_size(patches));
    if (!surfaces_tell(patches) && !s->partial)
        unmet_say(unmet, "part of the model is left out, of types that are not supported "
                         "(--partial accepts it)");
}

/* The cells of all surfaces, n times n each, as many as a surface may have to a tolerance: more are
 * refused; where nobody asked for so many, there are fewer. */
static void bound_cells(struct settings *s, size_t surfaces)
{
    const double most = TESSELLATE_CELLS_MAX, each = s->grid > 0 ? s->grid : s->n;
    const char *option = s->grid > 0 ? "--grid" : "-n";

    if (s->tolerance > 0 && s->grid == 0)
        return;
    if (each * each * (double)surfaces <= most)
        return;
    if (s->grid > 0 || s->count_given)
        die("option %s: found %g x %g on each of %zu surfaces, expected at most %.0f on each, or "
            "a tolerance (-e)",
            option, each, each, surfaces, fmax(1, floor(sqrt(most / (double)surfaces))));
    s->n = (int)fmax(1, floor(sqrt(most / (double)surfaces)));
    say("%zu surfaces: %d triangles in each direction of each, not %d (-n; -e makes as many as a "
        "tolerance needs)",
        surfaces, s->n, USUAL);
}

/* What the threads share: a surface is a unit of work. */
struct tessellate_all {
    const struct patches *patches;
    struct tessellate_options how;
    struct sheet *sheet;
};

static void tessellate_some(void *context, size_t from, size_t to)
{
    struct tessellate_all *all = context;
    for (size_t i = from; i < to; i++)
        if (all->patches->item[i].doubled)
            all->sheet[i].refused = true;
        else
            tessellate(&all->patches->item[i], all->how, &all->sheet[i]);
}

/* How far triangles are off their surfaces at most; ends where it would take too many. */
static double check_error(const struct settings *s, const struct patches *patches,
                          const struct sheet *sheet)
{
    size_t worst = 0;
    for (size_t i = 0; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        if (sheet[i].too_fine)
            die("%s: surface %d: more than 4 million cells for %g mm (-e), expected a tolerance "
                "that fewer keep",
                p->file, p->entity, s->tolerance);
        if (sheet[i].error > sheet[worst].error)
            worst = i;
    }
    struct vec3 at = sheet[worst].error_at;
    note("triangles are off the surfaces by %.6f mm at worst (surface %d, at %.3f %.3f %.3f)",
         sheet[worst].error, patches->item[worst].entity, at.x, at.y, at.z);
    return sheet[worst].error;
}

/* Edges of neighbours are joined within this, mm. */
static double gap_of(const struct settings *s, double size)
{
    if (s->gap > 0)
        return s->gap;
    return s->tolerance > 0 ? fmin(SURFACES_GAP * size, s->tolerance) : SURFACES_GAP * size;
}

/* How fine triangles and trimmed edges are at first, mm. */
static double fine_of(const struct settings *s, double size)
{
    return s->tolerance > 0 ? s->tolerance : fmax(1e-5 * size, 1e-3);
}

/* The triangles of each surface; returns how far they are off at most. */
static double tessellate_surfaces(const struct cli *cli, const struct settings *s,
                                  const struct patches *patches, double fine, struct sheet *sheet)
{
    /* Few surfaces: the threads share each of them, else each takes one. */
    bool few = patches->n < 8;
    struct tessellate_all all = {
        patches, {s->tolerance > 0 ? 0 : s->n, fine, few ? cli->threads : 1}, sheet};
    double gap = gap_of(s, patches_size(patches));
    for (size_t i = 0; i < patches->n; i++)
        sheet_free(&sheet[i]);
    parallel_shown("tessellating", few ? 1 : cli->threads, patches->n, tessellate_some, &all);
    struct error why;
    if (surfaces_tell_refused(patches, sheet, fmax(gap, s->tolerance), s->partial ? NULL : &why) >
            0 &&
        !s->partial)
        die_error(&why);
    double error = check_error(s, patches, sheet);
    surfaces_tell_trimming(patches, sheet, fine);
    return error;
}

/* Of surfaces that coincide one is used, and the mesh of the others is empty. */
static void leave_doubled(const struct settings *s, struct patches *patches, struct sheet *sheet)
{
    double size = patches_size(patches);
    int *twin = coincident_find(patches, sheet, SAME * size, gap_of(s, size));
    for (size_t i = 0; i < patches->n; i++) {
        if (twin[i] < 0)
            continue;
        const struct patch *p = &patches->item[i], *q = &patches->item[twin[i]];
        say("%s: surface %d coincides with %s:%d, which is used", p->file, p->entity, q->file,
            q->entity);
        patches->item[i].doubled = true;
        sheet_free(&sheet[i]);
        sheet[i].refused = true;
    }
    free(twin);
}

static struct sew_count sew_surfaces(const struct settings *s, const struct patches *patches,
                                     double fine, const struct sheet *sheet,
                                     struct patch_mesh *patch_mesh)
{
    double size = patches_size(patches), gap = gap_of(s, size);
    patch_mesh_free(patch_mesh);
    patch_mesh_make(sheet, patches->n, fmin(NARROW * size, gap), patch_mesh);
    struct sew_count sewn = sew(patch_mesh, patches, gap, fine);
    patch_mesh_weld(patch_mesh, patches);
    return sewn;
}

/* Curves and surfaces that no spline is near enough to. */
static void check_rough(const struct patches *patches, double tolerance, struct unmets *unmet)
{
    double rough;
    const struct patch *roughest = nurbs_report_roughest(patches, &rough);
    if (rough > tolerance)
        unmet_say(unmet,
                  "surface %d: it or its trimming is approximated, up to %g mm off what the file "
                  "has, expected %g mm",
                  roughest->entity, rough, tolerance);
}

/* Loops that could not be used, or of which the file does not tell the side, and surfaces of which
 * their trimming leaves nothing. */
static void check_trimming(const struct patches *patches, const struct sheet *sheet, bool partial,
                           struct unmets *unmet)
{
    size_t lost = 0, empty = 0, unknown = 0, first = patches->n;
    for (size_t i = 0; i < patches->n && !partial; i++) {
        bool is_empty = sheet[i].face.n == 0 && !sheet[i].refused;
        lost += sheet[i].lost > 0;
        empty += is_empty;
        bool is_unknown = sheet[i].side != PATCH_SIDE_TOLD && sheet[i].lost == 0;
        bool is_off = is_empty || sheet[i].lost > 0 || is_unknown;
        unknown += is_unknown;
        first = first == patches->n && is_off ? i : first;
    }
    if (lost + empty + unknown > 0)
        unmet_say(
            unmet,
            "trimming is not as the file has it: %zu surfaces whose loops are ignored, %zu of "
            "which nothing is left, %zu with a side taken that the file does not tell, the first "
            "is surface %d (--partial accepts it)",
            lost, empty, unknown, patches->item[first].entity);
}

/* Loops whose curves are farther apart than neighbours may be. */
static void check_gaps(const struct settings *s, const struct patches *patches,
                       const struct sheet *sheet, struct unmets *unmet)
{
    double limit = fmax(gap_of(s, patches_size(patches)), s->tolerance);
    size_t open = surfaces_tell_gaps(patches, sheet, limit);
    if (open > 0 && !s->partial)
        unmet_say(unmet,
                  "%zu surfaces have a trimming loop that does not close within %g mm, expected "
                  "none (--partial accepts it)",
                  open, limit);
}

/* Of a shell that the file calls closed nothing may stay open; no skin may touch itself along an
 * edge, or be turned both ways. */
static void check_closed(const struct patches *patches, const struct skin *skin,
                         struct unmets *unmet)
{
    size_t open = 0, first = patches->n;
    for (size_t i = 0; i < patches->n; i++)
        if (patches->item[i].body != 0 && skin->open_on[i] > 0) {
            open += skin->open_on[i];
            first = first == patches->n ? i : first;
        }
    if (skin->many > 0)
        unmet_say(unmet,
                  "%zu edges have more than two facets, expected none: a smaller -e may help",
                  skin->many);
    if (skin->unlike > 0)
        unmet_say(unmet,
                  "%zu edges have facets that are turned differently, expected none: a smaller -e "
                  "may help",
                  skin->unlike);
    if (open > 0)
        unmet_say(unmet,
                  "%zu edges of shells that the file calls closed are open, expected none, the "
                  "first of surface %d: a smaller -e may help",
                  open, patches->item[first].entity);
}

/* Edges that are open or have more than two facets, of the surfaces as they would be joined. */
static size_t count_unsound(const struct settings *s, const struct patches *patches,
                            const struct sheet *sheet, struct patch_mesh *patch_mesh)
{
    double size = patches_size(patches), fine = fine_of(s, size);
    double slit = gap_of(s, size) + fine;
    sew_surfaces(s, patches, fine, sheet, patch_mesh);
    skin_close(patch_mesh, slit, s->gap > 0 ? slit : SLIT_WIDEST * slit);
    struct skin skin = skin_of(patch_mesh);
    size_t unsound = skin.open + skin.many;
    skin_free(&skin);
    return unsound;
}

/* Groups of loose faces are bodies of their own, which stay apart where they touch, if less is
 * open, or meets in more than two facets, than where all faces are joined. */
static void settle_groups(const struct settings *s, struct patches *patches,
                          const struct sheet *sheet, struct patch_mesh *patch_mesh)
{
    bool grouped = false;
    int *group = mem_alloc(patches->n + 1, sizeof *group);
    for (size_t i = 0; i < patches->n; i++) {
        group[i] = patches->item[i].group;
        grouped = grouped || group[i] != 0;
    }
    size_t apart = grouped ? count_unsound(s, patches, sheet, patch_mesh) : 0;
    for (size_t i = 0; i < patches->n && apart > 0; i++)
        patches->item[i].group = 0;
    bool joined = apart > 0 && count_unsound(s, patches, sheet, patch_mesh) <= apart;
    for (size_t i = 0; i < patches->n && !joined; i++)
        patches->item[i].group = group[i];
    if (grouped)
        note("groups of loose faces are %s", joined ? "joined" : "bodies of their own");
    free(group);
}

/* From triangles, which are off the surfaces by `error`, to a skin; returns how far it is off. */
static double make_patch_mesh(const struct cli *cli, const struct settings *s,
                              const struct patches *patches, double error, struct sheet *sheet,
                              struct patch_mesh *patch_mesh, struct unmets *unmet)
{
    double size = patches_size(patches), fine = fine_of(s, size);
    struct sew_count sewn = sew_surfaces(s, patches, fine, sheet, patch_mesh);
    error += sewn.moved;
    /* What sewing takes of the tolerance is left to it: triangles keep less. */
    for (int i = 0; i < 3 && s->tolerance > 0 && error > s->tolerance; i++) {
        fine = fmax(s->tolerance - 1.1 * sewn.moved, s->tolerance / 4);
        error = tessellate_surfaces(cli, s, patches, fine, sheet);
        sewn = sew_surfaces(s, patches, fine, sheet, patch_mesh);
        error += sewn.moved;
    }
    if (s->tolerance > 0 && error > s->tolerance)
        unmet_say(
            unmet,
            "triangles are off the surfaces by %g mm, of it %g mm between neighbours that lie "
            "apart, expected %g mm (-e): use a smaller --gap",
            error, sewn.moved, s->tolerance);
    struct orient_count out =
        orient_outward(patch_mesh, patches, vec(s->up[0], s->up[1], s->up[2]));
    note("%zu border vertices joined and %zu inserted, moved by at most %g mm; %zu %s; %zu edges "
         "open before slits are filled",
         sewn.joined, sewn.inserted, sewn.moved, out.bodies, out.bodies == 1 ? "body" : "bodies",
         out.open);
    check_trimming(patches, sheet, s->partial, unmet);
    check_gaps(s, patches, sheet, unmet);
    if (out.voids > 0)
        say("%zu closed skins of loose faces lie within others and are taken for voids", out.voids);
    check_rough(patches, s->tolerance > 0 ? s->tolerance : fine, unmet);
    if (patch_mesh->narrow > 0)
        say("%zu surfaces narrower than %g mm left out", patch_mesh->narrow, NARROW * size);
    if (out.unclear > 0)
        say("%zu of %zu bodies are upright: --up does not determine the outer side", out.unclear,
            out.bodies);
    double slit = gap_of(s, size) + fine, widest = s->gap > 0 ? slit : SLIT_WIDEST * slit;
    struct skin_close_count closed = skin_close(patch_mesh, slit, widest);
    if (closed.folded + closed.filled > 0)
        note("%zu slits, up to %g mm wide, filled with %zu facets, %zu folds taken out",
             closed.filled, closed.width, closed.facets, closed.folded);
    if (s->tolerance > 0 && closed.width / 2 > s->tolerance)
        unmet_say(unmet,
                  "neighbours lie up to %g mm apart, and what is between them is filled: expected "
                  "twice %g mm (-e)",
                  closed.width, s->tolerance);
    struct skin skin = skin_of(patch_mesh);
    if (out.conflicts > 0 && skin.unlike > 0)
        say("%zu neighbours cannot be oriented alike", out.conflicts);
    if (notes_shown())
        skin_measure(&skin, patch_mesh, patches, cli->threads);
    nurbs_report_skin(patches, &skin);
    check_closed(patches, &skin, unmet);
    skin_free(&skin);
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

/* What the mesh says of each surface: its name and its smallest concave radius. */
static void name_surfaces(const struct patches *patches, const struct concave_radius *concave,
                          struct mesh_surfaces *surfaces)
{
    for (size_t i = 0; i < patches->n; i++) {
        char name[300];
        int n = snprintf(name, sizeof name, "%.280s:%d", patches->item[i].file,
                         patches->item[i].entity);
        bool is_concave = concave[i].curvature > 1e-9;
        *array_push(surfaces) =
            (struct mesh_surface){mem_string(name, (size_t)n),
                                  is_concave ? 1 / concave[i].curvature : 0, concave[i].point};
    }
}

static void write_mesh(const struct cli *cli, const struct patches *patches,
                       const struct concave_radius *concave, const struct patch_mesh *patch_mesh,
                       double error, bool scan, const struct unmets *unmet)
{
    struct mesh mesh = {.origin = {.ledger = error}};
    unmets_add_all(&mesh.origin.unmet, unmet);
    name_surfaces(patches, concave, &mesh.origin.surface);
    mesh.origin.source = source_of(cli);
    if (scan) {
        mesh.origin.scan = scan_sources_copy(&patches->scan);
        mesh.origin.placed = patches->scan.placed;
        mesh.origin.place = patches->scan.place;
    }
    mesh.origin.maker = mem_string("nurbs2mesh", strlen("nurbs2mesh"));
    patch_mesh_mesh(patch_mesh, &mesh);
    if (!(mesh_area(&mesh) > 0))
        die("%s: surfaces without area, or nothing but two within --gap of each other, expected "
            "others",
            mesh.origin.source);
    note("%zu surfaces in; %zu vertices, %zu facets", patch_mesh->sheets, mesh.vertex.n,
         mesh.face.n);
    struct out *out = out_open(cli->output);
    ply_write(out, &mesh, cli->threads);
    out_close(out);
    mesh_free(&mesh);
}

int main(int argc, char **argv)
{
    struct cli cli = {
        .tool = "nurbs2mesh",
        .usual = "tolerance units up partial quiet verbose",
        .usage = "[options] [FILE...]",
        .about = "Makes a mesh of the surfaces of a CAD model (IGES, STEP, or NURBS text)."};
    struct settings settings = read_options(&cli, argc, argv);
    struct patches patches = {0};
    struct patch_mesh patch_mesh = {0};
    struct unmets unmet = {0};

    read_files(&cli, &settings, &patches, &unmet);
    bound_cells(&settings, patches.n);
    struct sheet *sheet = mem_alloc(patches.n, sizeof *sheet);
    if (settings.grid > 0) {
        nurbs_report_grid(cli.output, &patches, settings.grid);
    } else {
        double error = tessellate_surfaces(&cli, &settings, &patches,
                                           fine_of(&settings, patches_size(&patches)), sheet);
        leave_doubled(&settings, &patches, sheet);
        settle_groups(&settings, &patches, sheet, &patch_mesh);
        error = make_patch_mesh(&cli, &settings, &patches, error, sheet, &patch_mesh, &unmet);
        struct concave_radius *concave =
            concave_radius_find_all(&patches, patch_mesh.flipped, cli.threads);
        if (settings.report)
            nurbs_report_radii(cli.output, &patches, concave, &patch_mesh);
        else
            write_mesh(&cli, &patches, concave, &patch_mesh, error, !settings.unit_given, &unmet);
        free(concave);
    }
    int status = unmets_status(&unmet);
    for (size_t i = 0; i < patches.n; i++)
        sheet_free(&sheet[i]);
    unmets_free(&unmet);
    free(sheet);
    patch_mesh_free(&patch_mesh);
    patches_free(&patches);
    return status;
}
