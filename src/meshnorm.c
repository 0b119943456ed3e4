/*
 * meshnorm - rows of a mesh to a path: contact points, normals, tool centres, tool axes, tips
 * (paper 1, 3.3 to 3.5).
 */
#include <stdlib.h>

#include "stage/path_coverage.h"
#include "stage/path_options.h"
#include "stage/mesh_for_path.h"
#include "stage/plane_passes.h"
#include "toolpath/passes.h"
#include "toolpath/rows.h"
#include "toolpath/scallop.h"
#include "meshing/mesh_join.h"
#include "mesh/mesh_clip.h"

enum { ROWS_SCALLOP, ROWS_MESH };

static const double SCALLOP = 0.02; /* of --scallop, mm, where the radius allows it */

/* Planes are no denser than facets of this sine ask for, and a share of the area may ask for more:
 * rest passes cut what these leave. */
static const double STEEPEST = 0.5, BEYOND = 0.1;

static int normals, row_kind;
static double scallop; /* 0: the rows are the mesh's */
static bool rows_given;
static const char *direction; /* as text: auto or degrees */

static void read_options(struct cli *cli, int argc, char **argv)
{
    const struct cli_option options[] = {
        {'r', "radius", "MM", "radius of the ball (required)", CLI_NUMBER, &path_options.radius,
         0.001, 1000, 0, NULL},
        {0, "normals", normals_words(false),
         "the mesh's own (default), the mean of the facets' (eq 8) or of the\n"
         "neighbours' (eq 7), central differences on a regular grid",
         CLI_CHOICE, &normals, 0, 0, 0, NULL},
        {0, "rows", "scallop|mesh",
         "planes so close that the ball leaves no scallop above --scallop (the\n"
         "default), or the rows of the mesh",
         CLI_CHOICE, &row_kind, 0, 0, 0, &rows_given},
        {0, "scallop", "MM",
         "height of the scallops between rows (default: 0.02, or\n"
         "a twentieth of the radius if that is less)",
         CLI_NUMBER, &scallop, CLI_POSITIVE, 0, 0, NULL},
        {'a', "direction", "auto|DEG",
         "direction of the rows: auto, the shortest cut, or from\n"
         "x towards y (default: that of the mesh's rows)",
         CLI_TEXT, &direction, 0, 0, 0, NULL},
        {0}};

    cli->option = options;
    cli_parse(cli, argc, argv);
}

static void read_mesh(const char *file, struct mesh *mesh, struct rows *rows)
{
    struct error error;

    if (mesh_for_rows_read(file, normals_find(false, normals), mesh, &error) != 0)
        die_error(&error);
    if (scallop > 0 && mesh->row.n == 0) { /* planes need none */
        double angle = isfinite(mesh->origin.direction) ? RADIANS(mesh->origin.direction) : 0;
        rows->along = vec(cos(angle), sin(angle), 0);
        return;
    }
    if (rows_find(mesh, rows, &error) != 0)
        die("%s: %s", file, error.text);
    if (rows->loose > 0)
        say("%zu nodes belong to no facet and are left out", rows->loose);
}

/* The contacts of a strip in the order they are cut, the ball rolled over its sharp edges. */
static void strip_contacts(const struct mesh *mesh, const struct rows *rows, struct strip strip,
                           bool back, struct contacts *to)
{
    const double sink = 0.002; /* of the ball into an edge between two of the points, mm */
    size_t n = strip.to - strip.from;

    to->n = 0;
    for (size_t k = 0; k < n; k++) {
        size_t v = rows->node.item[back ? strip.to - 1 - k : strip.from + k];
        struct contact next = {mesh->vertex.item[v], mesh->normal.item[v]};
        if (to->n > 1 && vec_distance(next.p, to->item[to->n - 1].p) < 1e-9) {
            struct contact last = to->item[to->n - 1];
            struct vec3 forward = vec_sub(last.p, to->item[to->n - 2].p);
            edge_roll(to, forward, last, next, path_options.radius, sink);
        }
        *array_push(to) = next;
    }
}

/* All strips of the row that begins with strip s, in one pass; returns the first of the next. */
static size_t make_pass(const struct mesh *mesh, const struct rows *rows, size_t s, size_t pass,
                        struct toolpath *t)
{
    bool back = !path_options.one_way && pass % 2 == 0;
    size_t end = s;
    struct contacts contact = {0};

    while (end < rows->strip.n && rows->strip.item[end].row == rows->strip.item[s].row)
        end++;
    for (size_t i = s; i < end; i++) {
        struct strip strip = rows->strip.item[back ? end - 1 - (i - s) : i];
        strip_contacts(mesh, rows, strip, back, &contact);
        t->lift.feed.side = strip.side;
        t->lift.feed.up = strip.up;
        toolpath_strip(t, pass, contact.item, contact.n, vec_scale(back ? -1 : 1, strip.along));
    }
    array_free(&contact);
    return end;
}

static void make_path(const struct mesh *mesh, const struct rows *rows, struct toolpath *t)
{
    struct error error;
    size_t pass = 1;

    for (int layer = path_options.layers - 1; layer >= 0; layer--) {
        t->lift.offset = path_options.radius + layer * path_options.depth;
        for (size_t s = 0; s < rows->strip.n; pass++) {
            s = make_pass(mesh, rows, s, pass, t);
            progress("rows", s, rows->strip.n);
        }
        if (layer == path_options.layers - 1 &&
            toolpath_bounded(t, path_options.layers, &error) != 0)
            die_error(&error);
    }
    toolpath_cut(t);
}

/* Planes along the rows, or in the direction of --direction; through a part with a projection of
 * its own along its rows. */
static void find_planes(const struct mesh *mesh, const struct mesh_part *part, double spacing,
                        double angle, struct plane_passes *p)
{
    bool upright = !part || part->up.z >= 1;
    struct error error;

    if (plane_passes_bounded(mesh, vec(0, 0, 0), scallop_step(scallop, path_options.radius, 0),
                             &error) != 0)
        die_error(&error);
    if (upright && direction)
        angle = plane_passes_direction(direction, mesh, path_options.radius, scallop);
    p->rule = upright ? plane_passes_upright(angle, path_options.radius)
                      : plane_passes_along(part, path_options.radius);
    /* A node that random points do not have makes no hole: where the scan guards, rows go on. */
    if (path_options.guarded && spacing > 0) {
        p->rule.gap = 2 * spacing;
        p->rule.bare = 0.6 * spacing;
    }
    p->steepest = STEEPEST;
    p->beyond = BEYOND;
    if (plane_passes_bounded(mesh, p->rule.normal, scallop_step(scallop, path_options.radius, 0),
                             &error) != 0)
        die_error(&error);
    plane_passes_scallop(p, mesh, path_options_row_scallop());
    if (plane_passes_bounded(mesh, p->rule.normal, plane_passes_apart(p), &error) != 0 ||
        plane_passes_short(p, mesh, &error) != 0)
        die_error(&error);
}

/* The parts of a mesh, or what of them is in the region, and the planes through them. */
struct planes {
    size_t n;
    struct mesh *part; /* NULL: the mesh is one, and all of it is cut */
    struct plane_passes *passes;
    double widest;
    bool steep, region;
};

/* What of a part is in the region takes its place.  False: nothing is. */
static bool take_region(struct mesh *part)
{
    struct mesh_region_options region = path_options_region();
    struct mesh inside;
    struct error error;

    if (mesh_region_take(&region, part, &inside, &error) != 0)
        die_given(&error);
    mesh_free(part);
    *part = inside;
    return inside.face.n > 0;
}

/* The parts that are cut, each with its frame. */
static void find_parts(const struct mesh *mesh, struct planes *all, const struct mesh_part **frame)
{
    const struct mesh_parts *parts = &mesh->origin.part;
    struct mesh_region_options region = path_options_region();
    size_t n = parts->n > 1 ? parts->n : 1, facets = 0;

    all->region = mesh_region_given(&region);
    all->part = parts->n > 1 || all->region ? mem_alloc(n, sizeof *all->part) : NULL;
    for (size_t k = 0; k < n; k++) {
        frame[all->n] = parts->n > 1 ? &parts->item[k] : NULL;
        if (all->part)
            all->part[all->n] = parts->n > 1 ? mesh_join_of(mesh, k) : mesh_clip_copy(mesh);
        if (all->region && !take_region(&all->part[all->n])) {
            mesh_free(&all->part[all->n]);
            continue;
        }
        facets += all->part ? all->part[all->n].face.n : 0;
        all->n++;
    }
    if (all->n == 0)
        die("nothing of the mesh is in the region asked for (--box, --region)");
    if (all->region)
        note("region: %zu facets of the mesh's %zu", facets, mesh->face.n);
}

static void find_all_planes(const struct mesh *mesh, const struct rows *rows, struct planes *all)
{
    double angle = atan2(rows->along.y, rows->along.x), spacing = mesh->origin.spacing;
    const struct mesh_part **frame = mem_alloc(mesh->origin.part.n + 1, sizeof(void *));

    find_parts(mesh, all, frame);
    if (all->region)
        spacing = 0; /* what is left out is no hole to be crossed */
    all->passes = mem_alloc(all->n, sizeof *all->passes);
    for (size_t k = 0; k < all->n; k++) {
        all->passes[k] = (struct plane_passes){.region = all->region};
        find_planes(all->part ? &all->part[k] : mesh, frame[k], spacing, angle, &all->passes[k]);
        all->widest = fmax(all->widest, all->passes[k].widest);
        all->steep = all->steep || all->passes[k].steep;
    }
    free(frame);
}

/* Passes end at holes of the scan. */
static void stop_at_holes(struct planes *all, const struct gouge_check *scan)
{
    for (size_t k = 0; k < all->n; k++)
        all->passes[k].rule.guard = all->passes[k].rule.bare > 0 ? scan : NULL;
}

static void free_planes(struct planes *all)
{
    for (size_t k = 0; k < all->n; k++) {
        plane_passes_free(&all->passes[k]);
        if (all->part)
            mesh_free(&all->part[k]);
    }
    free(all->passes);
    free(all->part);
}

/* The rows of the mesh have no scallop of their own, and no direction but theirs. */
static void check_rows(void)
{
    bool mesh_rows = path_options.paper || row_kind == ROWS_MESH;

    if (path_options.paper && (scallop > 0 || (rows_given && row_kind != ROWS_MESH)))
        die_usage("found --paper with %s: the paper's rows are those of the mesh",
                  scallop > 0 ? "--scallop" : "--rows scallop");
    if (mesh_rows && (direction || scallop > 0 || path_options.box_given || path_options.region))
        die_usage("found %s with the rows of the mesh, expected --rows scallop",
                  direction                ? "--direction"
                  : scallop > 0            ? "--scallop"
                  : path_options.box_given ? "--box"
                                           : "--region");
    if (scallop >= path_options.radius && path_options.radius > 0)
        die_usage("option --scallop: found %g, expected less than the radius", scallop);
    if (direction && !plane_passes_direction_read(direction))
        die_usage("option --direction: found '%s', expected auto or degrees", direction);
    if (mesh_rows || scallop > 0)
        return;
    scallop = fmin(SCALLOP, path_options.radius / 20);
    say("rows so close that scallops are no higher than %g mm (--scallop)", scallop);
}

static void check_options(struct tool_axis_options *axis)
{
    struct error error;

    if (path_options_check(axis, &error) != 0)
        die_given(&error);
    check_rows();
    path_options.scallop = scallop;
    if (scallop > 0 && path_options.tolerance == 0)
        path_options.tolerance = 0.01;
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "meshnorm",
                      .usual = "radius scallop guard tolerance avoid tilt holder",
                      .usage = "-r R [options] [FILE]",
                      .about = "Makes a tool path from the rows of a mesh: mesh stream in, path "
                               "stream out.",
                      .more = path_option_table};
    struct mesh mesh = {0};
    struct rows rows = {0};
    struct path path = {0};
    struct planes planes = {0};
    struct toolpath t = {.path = &path};
    struct gouge_check *guard;
    struct error error;

    read_options(&cli, argc, argv);
    t.threads = cli.threads;
    check_options(&t.lift.axis);
    if (cli.files > 1)
        die_usage("found %d files, expected one mesh", cli.files);
    read_mesh(cli.file[0], &mesh, &rows);
    if (path_options_scan(&mesh, &error) != 0)
        die_error(&error);
    if (scallop > 0)
        find_all_planes(&mesh, &rows, &planes);
    double distance = scallop > 0 ? planes.widest : rows.distance;
    if (path_options_guard(&mesh, NULL, mesh.row.n > 0 ? rows.distance : distance, cli.threads,
                           &guard, &error) != 0)
        die_error(&error);
    stop_at_holes(&planes, guard);
    if (path_options_rules(&mesh, guard, distance, &t, &error) != 0)
        die_given(&error);

    struct path_coverage coverage = {.scallop = 0};
    if (!planes.region || path_options.guarded)
        coverage = path_coverage_new(&mesh, &mesh, &t);
    t.coverage = coverage.coverage;
    path_options_begin(&mesh, "meshnorm", cli.output, &t);
    if (scallop > 0 && mesh.origin.part.n < 2)
        plane_passes_run_out(&planes.passes[0], &mesh);
    if (scallop == 0)
        make_path(&mesh, &rows, &t);
    else if (plane_passes_make(planes.passes, planes.n, &t, &error) != 0)
        die_error(&error);
    path_coverage_rest(&coverage, scallop > 0 ? planes.passes[0].rule.normal : vec(0, 0, 0), &t);
    toolpath_end(&t);
    path_coverage_measure(&coverage, &t);
    if (mesh.row.n > 0)
        note("%zu nodes in %zu strips", rows.node.n, rows.strip.n);
    int status = toolpath_conclude(&t);
    if (unmets_status(&path_options.unguarded) != EXIT_DONE)
        status = EXIT_UNMET;
    if (path_coverage_conclude(&coverage, &path.head) != EXIT_DONE)
        status = EXIT_UNMET;
    path_options_end(&mesh, "meshnorm", &t);

    path_coverage_free(&coverage);
    free_planes(&planes);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
    rows_free(&rows);
    mesh_free(&mesh);
    return status;
}
