/*
 * cloud2mesh - scanned points to a triangulated mesh: an oblique grid of equilateral triangles
 * over the cloud, each node moved to the point nearest to it (Chui, Chiu, Yu 2007).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/cli.h"
#include "base/effort.h"
#include "base/out.h"
#include "stage/cloudmesh.h"
#include "cloud/cloud.h"
#include "stage/cloud_options.h"
#include "stage/cloud_prepare.h"
#include "stage/cloud_stream.h"
#include "io/mesh/ply.h"
#include "math/box.h"

/* Part of a scan that is under others from where on it folds under itself; parts of a mesh that
 * face against its points, and that are steep, from where on it is no mesh to be cut. */
static const double FOLDS = 0.02, MUCH_TURNED = 0.1, MOST_STEEP = 0.5;

struct settings {
    struct cloudmesh_options meshing;
    double noise;  /* NAN: from the cloud */
    double extend; /* beyond the border, mm */
    int unit, outliers;
    bool origin, clean, unit_given, stream, outside_given;
    double outside[3];      /* a direction */
    const char *matrix;     /* file, NULL: none */
    const char *clean_file; /* the scan that is believed, NULL: not asked for */
};

/* What a method has no use for. */
static void check_method(const struct settings *s)
{
    if (s->meshing.method != CLOUDMESH_CHUI && s->meshing.paper)
        die_usage("found --paper with --method, expected one of them");
    if (s->meshing.method == CLOUDMESH_LIN && s->meshing.error > 0)
        die_usage("--method lin has a grid of one spacing: expected -t, found -e");
    if (s->meshing.method == CLOUDMESH_DELAUNAY && s->meshing.spacing > 0)
        die_usage("--method delaunay has points of the scan: expected --keep or -e, found -t");
    if (s->meshing.method == CLOUDMESH_DELAUNAY && s->meshing.subdivide)
        die_usage("found --subdivide with --method delaunay, whose parts have no rows to join: "
                  "expected one of them");
    if (s->meshing.method != CLOUDMESH_DELAUNAY && s->meshing.keep > 0)
        die_usage("found --keep without --method delaunay, expected both");
    if (s->meshing.keep > 0 && s->meshing.error > 0)
        die_usage("found --keep with -e, expected one of them");
}

/* A grid that is seen from above has its outside there. */
static void check_outside(struct settings *s)
{
    s->meshing.outside = vec(s->outside[0], s->outside[1], s->outside[2]);
    if (s->outside_given && !s->meshing.subdivide)
        die_usage("found --outside without --subdivide, expected both");
    if (s->outside_given && !(vec_length(s->meshing.outside) > 0))
        die_usage("option --outside: found a direction of no length");
}

/* What is believed of a scan takes the place of no input, and not that of the mesh. */
static void check_clean_file(const char *file, const struct cli *cli)
{
    if (file && cli_is_operand(cli, file))
        die_usage("option --clean: found %s, which is read, expected another file", file);
    if (file && cli->output && out_same_file(file, cli->output))
        die_usage("option --clean: found %s, which the mesh goes to, expected another file", file);
}

static struct settings read_options(struct cli *cli, int argc, char **argv)
{
    struct settings s = {.noise = NAN, .meshing.effort = 1};
    bool normals_given = false;
    int normals = 0, nodes = 0, method = 0;
    const struct cli_option option[] = {
        {'t', "spacing", "MM",
         "spacing of the triangular grid (default: three times\nthat of the points)", CLI_NUMBER,
         &s.meshing.spacing, CLI_POSITIVE, 0, 0, NULL},
        {'e', "tolerance", "MM",
         "a mesh as coarse as keeps every point within this\n"
         "(with -t: no coarser than that)",
         CLI_NUMBER, &s.meshing.error, CLI_POSITIVE, 0, 0, NULL},
        {0, "method", "chui|delaunay|lin",
         "nodes on an oblique grid that move to points (Chui, Chiu and Yu), a\n"
         "triangulation of the points (Choi), or nodes on a rectangular grid by\n"
         "interpolation (Lin and Liu) (default: chui)",
         CLI_CHOICE, &method, 0, 0, 0, NULL},
        {0, "keep", "N", "vertices of --method delaunay, those farthest off first (default: all)",
         CLI_COUNT, &s.meshing.keep, 3, 1e9, 0, NULL},
        UNIT_OPTION("units of the points (default: mm)", &s.unit, &s.unit_given),
        {'a', "direction", "DEG", "direction of the rows, from x towards y (default 0)", CLI_NUMBER,
         &s.meshing.direction, 0, 0, 0, NULL},
        MATRIX_OPTION(&s.matrix),
        ORIGIN_OPTION(&s.origin),
        {0, "max-gap", "MM",
         "no facet over an empty disc wider than this (default: six times the\n"
         "mean spacing of the points; with --paper: no limit)",
         CLI_NUMBER, &s.meshing.max_gap, CLI_POSITIVE, 0, 0, NULL},
        {0, "nodes", "grid|scan",
         "vertices stand at the nodes of the grid, at the height of the surface\n"
         "there, but on edges, walls, ribs and borders; or at points of the scan\n"
         "(default: grid; with --paper or --normals facet: scan)",
         CLI_CHOICE, &nodes, 0, 0, 0, NULL},
        {0, "normals", normals_words(true),
         "normals from a quadric through the nearest points of the cloud, or\n"
         "the mean of the facets' (default: quadric; with --paper: facet)",
         CLI_CHOICE, &normals, 0, 0, 0, &normals_given},
        {0, "neighbours", "N",
         "points that a quadric is fitted to (default: 40; under noise as\n"
         "many as needed)",
         CLI_COUNT, &s.meshing.neighbours, 6, 1000, 0, NULL},
        OUTLIERS_OPTION("(default: drop; with --paper or --normals facet: not detected)",
                        &s.outliers, &s.clean),
        {0, "clean", "FILE",
         "write the points that are believed, as they were read;\n"
         "outliers go to FILE.outliers",
         CLI_TEXT, &s.clean_file, 0, 0, 0, NULL},
        {0, "noise", "MM",
         "standard deviation of the points (default: measured; 0: vertices\n"
         "stay points of the scan)",
         CLI_NUMBER, &s.noise, 0, 1e6, 0, NULL},
        {0, "smooth", NULL, NULL, CLI_ALIAS, "no-features", 0, 0, 0, NULL},
        {0, "no-features", NULL, "do not detect creases, walls and ribs", CLI_FLAG,
         &s.meshing.smooth, 0, 0, 0, NULL},
        {0, "extend", "MM", "extend the surface by this beyond the outer border", CLI_NUMBER,
         &s.extend, CLI_POSITIVE, 0, 0, NULL},
        {0, "subdivide", NULL, "divide the cloud by orientation, for steep sides", CLI_FLAG,
         &s.meshing.subdivide, 0, 0, 0, NULL},
        {0, "outside", "I,J,K",
         "with --subdivide: the side of the surface that is seen from there is\n"
         "its outside (default: 0,0,1, from above)",
         CLI_NUMBERS, s.outside, 0, 0, 3, &s.outside_given},
        {0, "stream", NULL,
         "set the points aside in a file instead of keeping them: memory goes with\n"
         "the nodes of the grid (normals: facet, or as asked for; no outliers,\n"
         "creases, walls and ribs are looked for; with normals of facets files\n"
         "of 8 MB and more are read so anyway)",
         CLI_FLAG, &s.stream, 0, 0, 0, NULL},
        EFFORT_OPTION(&s.meshing.effort),
        {0, "paper", NULL,
         "as published: a node may move to any point nearer than the spacing,\n"
         "holes are bridged, normals are the mean of the facets'",
         CLI_FLAG, &s.meshing.paper, 0, 0, 0, NULL},
        {0}};
    cli->option = option;
    cli_parse(cli, argc, argv);
    s.meshing.normals = (s.meshing.paper || s.stream) && !normals_given
                            ? normals_of("facet")
                            : normals_find(true, normals);
    s.meshing.method = (enum cloudmesh_method)method;
    s.meshing.scan_nodes = nodes == 1;
    s.meshing.smooth =
        s.meshing.smooth || s.meshing.paper || s.stream || !s.meshing.normals->of_surface;
    if (s.extend > 0 && (s.meshing.paper || s.meshing.subdivide))
        die_usage("found --extend with %s, expected one of them",
                  s.meshing.paper ? "--paper" : "--subdivide");
    s.clean = s.clean || (s.meshing.normals->of_surface && !s.stream);
    if (s.clean_file && strcmp(s.clean_file, "-") == 0)
        die_usage("option --clean: found -, expected a file: standard output is for the mesh");
    check_clean_file(s.clean_file, cli);
    check_method(&s);
    check_outside(&s);
    if (s.meshing.paper && s.meshing.error > 0)
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

/* Takes out what is no part of the surface; returns the noise that vertices are to be rid of.
 * *done: what was; where nothing *known is the spacing of the points. */
static double clean_cloud(const char *name, const struct settings *s, struct vec3s *points,
                          int threads, struct cloud_prepare *done, double *known)
{
    struct error error;
    double mean = points->n >= 3 ? cloudmesh_spacing(&s->meshing, points->item, points->n) : 0;
    size_t read = points->n;
    if (!s->clean || !(mean > 0)) /* no area: the mesh will say so */
        return 0;
    enum cloud_prepare_drop drop = s->outliers == OUTLIERS_KEEP ? CLOUD_PREPARE_KEEP
                                   : s->meshing.subdivide       ? CLOUD_PREPARE_DROP_OUTLIERS
                                                                : CLOUD_PREPARE_DROP;
    if (cloud_prepare_clean(points, mean, isnan(s->noise) ? -1 : s->noise, drop, threads, done,
                            &error) < 0)
        die("%s: %s", name, error.text);
    *known = points->n == read ? mean : 0;
    note("noise of the scan %.4f mm (one standard deviation)", done->noise);
    double taken_out = cloud_prepare_noise(isnan(s->noise) ? -1 : s->noise, done->noise, mean);
    done->noise = isnan(s->noise) ? done->noise : s->noise;
    return taken_out;
}

static void say_left_out(const struct settings *settings, const struct grid_mesh_count *count)
{
    if (count->bridges > 0)
        note("left out %zu facet%s over a hole", count->bridges, count->bridges == 1 ? "" : "s");
    if (count->no_area > 0)
        note("left out %zu facet%s without area", count->no_area, count->no_area == 1 ? "" : "s");
    if (count->folded > 0)
        say("left out %zu facet%s that would face down: the spacing is too fine for the points",
            count->folded, count->folded == 1 ? "" : "s");
    if (count->alone > 0 && !settings->meshing.paper)
        say("left out %zu point%s that no facet reaches", count->alone,
            count->alone == 1 ? "" : "s");
}

/* What one projection serves badly; most of a surface that folds under itself, not at all. */
static void say_steep(const char *name, const struct settings *settings, double part, bool folds,
                      struct unmets *unmet)
{
    const double little = 0.005;
    if (!(part > little) || settings->meshing.subdivide || settings->meshing.paper)
        return;
    if (part > MOST_STEEP && folds)
        unmet_say(unmet,
                  "%s: %.1f %% of the surface is steeper than 70 degrees, and it folds under "
                  "itself: a grid seen from above does not serve it, expected --subdivide",
                  name, 100 * part);
    else
        say("%.1f %% of the surface is steeper than 70 degrees, where points are far apart seen "
            "from "
            "above: --subdivide gives it projections of its own",
            100 * part);
}

/* A scan that leans far has two sides, and nobody has said which one is the outside.  Of one that
 * stands upright none is seen from above. */
static void say_facing(const char *name, struct vec3 facing, struct unmets *unmet)
{
    const double one_side = 0.5, level = 0.5, upright = 0.2; /* lengths; cosines: 60, 78 degrees */
    double length = vec_length(facing);
    struct vec3 n = vec_unit(facing);
    if (!(length > one_side) || n.z >= level)
        return;
    if (fabs(n.z) < upright)
        unmet_say(
            unmet,
            "%s: the surface stands upright: the side that faces %.3f %.3f %.3f was taken for "
            "the outside, which nobody knows, expected --subdivide --outside I,J,K",
            name, n.x, n.y, n.z);
    else
        say("the surface leans: the side that faces %.3f %.3f %.3f was taken for the outside "
            "(--outside)",
            n.x, n.y, n.z);
}

/* Where the surface folds under itself. */
static void say_turned(const char *name, const struct settings *s, const struct cloudmesh *result,
                       size_t facets, struct unmets *unmet)
{
    const char *why = s->meshing.subdivide
                          ? "parts fold under themselves"
                          : "the surface folds under itself, seen from above (--subdivide)";
    if (result->turned_part > MUCH_TURNED)
        unmet_say(
            unmet,
            "%s: %.1f %% of the mesh would face against the points about it, expected at most "
            "%g %%: %s",
            name, 100 * result->turned_part, 100 * MUCH_TURNED, why);
    else if (result->turned > 0)
        say("%zu of %zu facets would face against the points about them and are left out: %s",
            result->turned, facets + result->turned, why);
}

/* Whether a mesh seen from above is none to be cut, where one by parts may be. */
static bool must_divide(const struct settings *s, const struct cloudmesh *result, double steep,
                        bool folds)
{
    if (s->meshing.subdivide || s->meshing.paper || s->extend > 0 ||
        s->meshing.method == CLOUDMESH_DELAUNAY)
        return false;
    return result->turned_part > MUCH_TURNED || (folds && steep > MOST_STEEP);
}

static void say_divided(const char *name, const struct cloudmesh *result, double steep)
{
    say("%s: the surface folds under itself, seen from above: %.1f %% of its mesh is steeper than "
        "70 degrees, and %.1f %% would face against the points about it",
        name, 100 * steep, 100 * result->turned_part);
}

/* The mesh by parts in its place; points under others have their place in one. */
static void divide(const char *name, struct settings *s, struct vec3s *points,
                   const struct vec3s *covered, double noise, int threads, struct mesh *mesh,
                   struct cloudmesh *result)
{
    struct error error;
    const struct mesh_origin *from = &mesh->origin;
    struct mesh parts = {
        .origin = {
            .ledger = NAN, .placed = from->placed, .place = from->place, .noise = from->noise}};

    vec3s_add(points, covered->item, covered->n);
    s->meshing.subdivide = true;
    if (cloudmesh_make(&s->meshing, points, noise, threads, &parts, result, &error) < 0)
        die("%s: %s", name, error.text);
    mesh_free(mesh);
    *mesh = parts;
}

static void extend_over_border(const char *name, const struct settings *s, struct vec3s *points,
                               double noise, int threads)
{
    struct error error;
    size_t n = points->n;
    if (plan_extent_check(points->item, n, &error) < 0)
        die("%s: %s", name, error.text);
    double mean = cloudmesh_spacing(&s->meshing, points->item, n);
    double gap = s->meshing.max_gap > 0 ? s->meshing.max_gap : 6 * mean;
    if (extend_cloud(points, mean, gap, s->extend, noise, threads, &error) < 0)
        die("%s: %s", name, error.text);
    say("extended by %g mm beyond the border, by %zu points", s->extend, points->n - n);
}

/* How large the part is in the unit that was taken, so that a wrong one is seen at once. */
static void say_size(const char *name, const struct settings *s, size_t points, struct box box)
{
    struct vec3 size = vec_sub(box.high, box.low);
    double longest = fmax(size.x, fmax(size.y, size.z));

    (s->unit_given ? note : say)("%s: %zu points, %.4g x %.4g x %.4g mm%s", name, points, size.x,
                                 size.y, size.z,
                                 s->unit_given ? "" : ", their unit taken as mm (-u)");
    say_unlikely_size(name, longest);
    say_far_away(name, box);
}

static void say_distance(const struct adaptive_rows *r, bool of_surface)
{
    say("%s within %.4f mm of the mesh at worst (at %.3f %.3f %.3f), %.4f mm rms",
        of_surface ? "the surface below the noise is" : "the points are", r->worst, r->at.x,
        r->at.y, r->at.z, r->rms);
}

static void say_rows(const struct adaptive_rows *r, double error, bool of_surface)
{
    say("%s within %.4f mm of the mesh at worst (at %.3f %.3f %.3f), %.4f mm rms; %zu rows",
        of_surface ? "the surface below the noise is" : "the points are", r->worst, r->at.x,
        r->at.y, r->at.z, r->rms, r->rows);
    if (r->beside > 0)
        note("%zu points beside the mesh, at its borders", r->beside);
    if (r->bridges > 0)
        note("left out %zu facets over a hole", r->bridges);
    if (r->worst > error)
        note("%g mm would take points closer to each other", error);
}

/* Writes what is believed of the points and, apart, what is not; a scan from standard input is
 * named by what is believed of it. */
static void write_clean(const struct settings *s, const char *name, const struct vec3s *raw,
                        const struct vec3s *placed, int threads, struct scan_sources *scan)
{
    struct error error;
    struct vec3s kept = {0};

    if (cloud_prepare_write_clean(s->clean_file, name, raw, placed, isnan(s->noise) ? -1 : s->noise,
                                  threads, &kept, &error) < 0)
        die_error(&error);
    bool piped = false;
    for (size_t i = 0; i < scan->n; i++)
        piped = piped || strcmp(scan->item[i].name, "-") == 0;
    if (piped) {
        scan_sources_free(scan);
        scan_sources_add(scan, s->clean_file, kept.item, kept.n);
    }
    array_free(&kept);
}

static void say_all(size_t read, size_t left_out, const struct grid *grid, size_t vertices,
                    size_t facets)
{
    note("%zu points in, %zu left out; spacing %g mm, %d rows x %d columns; %zu vertices, "
         "%zu facets",
         read, left_out, grid->t, grid->rows, grid->columns, vertices, facets);
}

/* ---- a cloud that is nowhere whole */

static const long LARGE_FILE = 8 << 20; /* bytes: from there on it costs less than its memory */

static bool may_stream(const struct cli *cli, const struct settings *s)
{
    struct stat st;
    bool serves = cli->files == 1 && cloud_stream_serves(&s->meshing) && !s->clean &&
                  !s->clean_file && !s->origin && !(s->extend > 0);

    if (s->stream && !serves)
        die_usage("--stream takes one file and nodes of a grid: found more files or an option that "
                  "needs all points at once");
    return serves && (s->stream || (stat(cli->file[0], &st) == 0 && st.st_size >= LARGE_FILE));
}

/* The mesh by reading the file again and again.  False: that cannot be done, and nothing was said.
 */
static bool stream_mesh(const struct cli *cli, const struct settings *s)
{
    const char *name = cli->file[0];
    struct mesh_origin origin = {.ledger = NAN};
    struct cloud_stream stream;
    struct vec3s none = {0};
    struct error error;

    if (cloud_prepare_place(&none, unit_name[s->unit], s->matrix, false, &origin, &error) < 0)
        die_error(&error);
    int status =
        cloud_stream_begin(name, &origin.place, &s->meshing, s->stream ? 0 : CLOUD_STREAM_KEEP,
                           cli->threads, &stream, &error);
    if (status > 0)
        return false;
    if (status < 0)
        die_error(&error);
    say_skipped(name, &stream.count);
    say_size(name, s, stream.n, stream.box);
    if (cloud_stream_nodes(&stream, &error) < 0)
        die("%s: %s", name, error.text);
    if (s->meshing.normals->of_surface) {
        if (cloud_stream_surface(&stream, isnan(s->noise) ? -1 : s->noise,
                                 cloud_stream_at_a_time(&stream), &error) < 0)
            die_error(&error);
        origin.noise = stream.noise;
        origin.ledger = stream.ledger;
        origin.maker = mem_string("cloud2mesh", strlen("cloud2mesh"));
    }
    say_left_out(s, &stream.facets.count);
    say_steep(NULL, s, stream.facets.steep, false, NULL);
    const struct cloud_count *count = &stream.count;
    say_all(stream.n, cloud_left_out(count), &stream.nodes.grid, stream.facets.vertices,
            stream.facets.facets);
    origin.spacing = stream.options.spacing;
    origin.direction = s->meshing.direction;
    scan_sources_add_known(&origin.scan, name, stream.n, stream.hash);
    origin.source = mem_string(name, strlen(name));
    struct out *out = out_open(cli->output);
    cloud_stream_write(out, &stream, &origin);
    out_close(out);
    scan_sources_free(&origin.scan);
    free(origin.source);
    free(origin.maker);
    cloud_stream_free(&stream);
    return true;
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "cloud2mesh",
                      .usual = "spacing tolerance units direction matrix noise clean subdivide",
                      .usage = "[options] [FILE...]",
                      .about = "Makes a mesh from scanned points (several files are one cloud)."};
    struct settings settings = read_options(&cli, argc, argv);
    struct vec3s points = {0};
    struct mesh mesh = {.origin.ledger = NAN};
    struct scan_sources scan = {0};

    struct error error;
    size_t left_out;

    const char *name = name_of(&cli);
    if (may_stream(&cli, &settings) && stream_mesh(&cli, &settings))
        return 0;
    if (cloud_prepare_read(cli.file, cli.files, cli.threads, &points, &scan, &left_out, &error) < 0)
        die_error(&error);
    struct vec3s raw = {0};
    for (size_t i = 0; settings.clean_file && i < points.n; i++)
        *array_push(&raw) = points.item[i];
    if (cloud_prepare_place(&points, unit_name[settings.unit], settings.matrix, settings.origin,
                            &mesh.origin, &error) < 0)
        die_error(&error);
    if (settings.clean_file)
        write_clean(&settings, name, &raw, &points, cli.threads, &scan);
    array_free(&raw);
    say_size(name, &settings, points.n, box_around(points.item, points.n));
    size_t read = points.n;
    double mean = 0;
    struct cloud_prepare prepared = {.noise = mesh.origin.noise};
    double noise = clean_cloud(name, &settings, &points, cli.threads, &prepared, &mean);
    mesh.origin.noise = prepared.noise;
    left_out += read - points.n;
    if (!(settings.extend > 0) && !(settings.meshing.error > 0)) /* they stay as they are */
        settings.meshing.mean = mean;
    if (settings.extend > 0)
        extend_over_border(name, &settings, &points, noise, cli.threads);
    mesh.origin.extended = settings.extend;
    bool of_surface = settings.meshing.error > 0 && noise > 0;
    struct cloudmesh result;
    if (cloudmesh_make(&settings.meshing, &points, noise, cli.threads, &mesh, &result, &error) < 0)
        die("%s: %s", name, error.text);
    bool folds = (double)prepared.under > FOLDS * (double)read;
    double steep = mesh_steep_part(&mesh, vec(0, 0, 1));
    if (must_divide(&settings, &result, steep, folds)) {
        say_divided(name, &result, steep);
        left_out -= prepared.covered.n;
        divide(name, &settings, &points, &prepared.covered, noise, cli.threads, &mesh, &result);
    }
    say_left_out(&settings, &result.count);
    say_turned(name, &settings, &result, mesh.face.n, &mesh.origin.unmet);
    say_steep(name, &settings, steep, folds, &mesh.origin.unmet);
    if (!settings.meshing.smooth && !settings.outside_given) /* what is streamed does not know it */
        say_facing(name, mesh_facing(&mesh), &mesh.origin.unmet);
    if (settings.meshing.method != CLOUDMESH_CHUI)
        say_distance(&result.rows, of_surface);
    else if (settings.meshing.error > 0)
        say_rows(&result.rows, settings.meshing.error, of_surface);
    say_all(read, left_out, &result.grid, mesh.vertex.n, mesh.face.n);
    mesh.origin.scan = scan;
    mesh.origin.source = mem_string(name, strlen(name));

    if (settings.meshing.error > 0 && result.rows.worst > settings.meshing.error)
        unmet_say(
            &mesh.origin.unmet,
            "%s: the mesh is off by %.4f mm at %.3f %.3f %.3f, expected %g mm: the points are "
            "too far apart there, or it is steep",
            name, result.rows.worst, result.rows.at.x, result.rows.at.y, result.rows.at.z,
            settings.meshing.error);
    int status = unmets_status(&mesh.origin.unmet);
    struct out *out = out_open(cli.output);
    ply_write(out, &mesh, cli.threads);
    out_close(out);
    mesh_free(&mesh);
    array_free(&points);
    array_free(&prepared.covered);
    return status;
}
