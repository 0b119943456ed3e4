/*
 * ncverify - an NC program, read as its control reads it, judged against the scan or the mesh that
 * it was made for.
 *
 * The reading shares nothing with the writing (ncread.h): what is judged is what the control gets.
 */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/cli.h"
#include "base/reader.h"
#include "io/cloud/cloud.h"
#include "io/mesh/meshfile.h"
#include "mesh/scan_source.h"
#include "gouge/holder_text.h"
#include "stage/tool_options.h"
#include "machine/machine_options.h"
#include "ncread/ncread.h"
#include "ncread/ncread_made.h"
#include "stage/cloud_options.h"
#include "stage/path_motion.h"
#include "verify/verify.h"

static const double USUAL = 0.05; /* mm: the deepest gouge, where the head does not say */

struct settings {
    int unit;
    bool radius_given, flute_given, band_given, left_given, tolerance_given, scallop_given;
    bool ball_only, partial, centre, accept;
    struct machine_options machine;
    const char *map, *path, *page, *holder, *stock;
    struct cli_list part;
    double radius, tolerance, left, rows, left_share, scallop, band, noise, flute, cell;
    struct tool_options files; /* --tool-file */
    struct tool_shape tool;
    struct stock_options block;
};

static void read_stock(struct settings *s)
{
    struct error error;
    if (s->stock && verify_stock_read(s->stock, &s->block, &error) < 0)
        die_usage("option --stock: %s", error.text);
}

/* The files of --tool-file, and the ball that they say. */
static void read_tool_files(struct settings *s)
{
    struct error error;
    if (tool_options_files(&s->files, &s->radius, &error) < 0)
        die_given(&error);
    s->radius_given = s->radius_given || s->radius > 0;
}

/* ---- what options say, or else the program's head */

static void add_cone(struct settings *s, double low, struct holder_part part)
{
    if (!tool_shape_add(&s->tool, (struct tool_span){low, low + part.length, part.low, part.high}))
        die_usage("option --holder: found an outline of more than %d parts", TOOL_SPANS);
}

static void add_above(struct settings *s, const struct holder *above)
{
    double height = 0;
    for (int i = 0; i < above->n; i++) {
        add_cone(s, height, above->part[i]);
        height += above->part[i].length;
    }
}

/* The tool that --tool-file says, with what other options say of it. */
static void find_tool_of_files(struct settings *s)
{
    struct tool_options how = s->files;
    struct tool_body body;
    struct error error;
    how.flute = s->flute;
    how.flute_given = s->flute_given;
    how.holder = s->holder;
    if (tool_options_read(&how, s->radius, &body, &error) < 0)
        die_usage("%s", error.text);
    if (body.flute > 0)
        add_cone(s, 0, (struct holder_part){s->radius, s->radius, body.flute});
    add_above(s, &body.above);
    tool_options_say(&body, s->radius);
}

/* The tool above its ball. */
static void find_tool(struct settings *s, const struct ncread_head *head)
{
    if (s->files.files.n > 0) {
        find_tool_of_files(s);
        return;
    }
    const char *text = s->holder ? s->holder : *head->holder ? head->holder : NULL;
    bool said = head->flute_given && !s->flute_given && (head->flute > 0 || *head->holder);
    double flute = s->flute_given ? s->flute : said ? head->flute : TOOL_FLUTE * s->radius;
    struct holder above = {0};
    struct error error;
    if (text && !s->ball_only && holder_text_read(text, &above, &error) < 0)
        die_usage("%s: %s", s->holder ? "option --holder" : "the holder of the program's head",
                  error.text);
    if (!s->ball_only && flute > 0)
        add_cone(s, 0, (struct holder_part){s->radius, s->radius, flute});
    add_above(s, &above);
    if (s->ball_only)
        say("tool: the ball alone, R %g", s->radius);
    else
        note("tool: ball R %g, flute %g%s, holder %s", s->radius, flute,
             said ? " (as the program's head says)" : "", text ? text : "none");
}

/* The deepest gouge: what the stages spent by the program's head, where a scan guarded it, but for
 * how far its mesh is off the scan; of another they do not say how far the path may be off the
 * part. */
static void find_tolerance(struct settings *s, const struct ncread_head *head)
{
    bool guarded = head->scans > 0;
    double spent = head->tolerance - (guarded ? head->mesh : 0);
    if (s->tolerance_given || !(spent > (guarded ? 0 : s->tolerance)))
        return;
    (spent > s->tolerance ? say : note)("tolerance: %g mm (as the program's head says)", spent);
    s->tolerance = spent;
}

/* How much may be left. */
static void find_limit(struct settings *s, const struct ncread_head *head)
{
    double tolerance = s->tolerance_given || head->tolerance == 0 ? s->tolerance : head->tolerance;
    double scallop = s->scallop_given ? s->scallop : head->scallop;
    s->rows = s->left;
    if (s->left_given)
        return;
    s->rows = scallop + head->mesh;
    s->left = scallop > 0 || s->scallop_given ? scallop + tolerance : HUGE_VAL;
    if (isfinite(s->left))
        note("at most %g mm may be left: a scallop of %g and a tolerance of %g", s->left, scallop,
             tolerance);
    else if (!s->partial)
        note("the scallop is not known (--scallop, --left): what is left is reported, not judged");
}

static void read_options(struct settings *s, struct cli *cli, int argc, char **argv)
{
    const struct cli_option option[] = {
        {'g', "guard", "FILE",
         "check against this: points, a mesh (.ply, .stl, .off),\n"
         "surfaces (.igs, .stp, .nurbs), or several such files",
         CLI_LIST, &s->part, 0, 0, 0, NULL},
        {'p', "path", "FILE",
         "the path that the program was made from: tip, tool axis and feed are\n"
         "compared with it",
         CLI_TEXT, &s->path, 0, 0, 0, NULL},
        {'r', "radius", "MM", "radius of the ball (default: as the head says)", CLI_NUMBER,
         &s->radius, CLI_POSITIVE, 1e4, 0, &s->radius_given},
        machine_option_control(&s->machine,
                               "control of the program (default: the machine's own, or\n"
                               "recognized by its first lines)"),
        machine_option_name(&s->machine),
        machine_option_set(&s->machine),
        {'e', "tolerance", "MM", "deepest gouge, or exit status 3 (by the head)", CLI_NUMBER,
         &s->tolerance, CLI_POSITIVE, 100, 0, &s->tolerance_given},
        {0, "scallop", "MM",
         "height of the scallops between passes: material left beyond it and the\n"
         "tolerance, where the tool could cut it, gives exit status 3 (default:\n"
         "what the program's head says)",
         CLI_NUMBER, &s->scallop, 0, 1e4, 0, &s->scallop_given},
        {0, "left", "MM", "most material left, scallop and tolerance together", CLI_NUMBER,
         &s->left, 0, 1e4, 0, &s->left_given},
        {0, "left-share", "PERCENT",
         "share of the points, with --partial of the region's, that may have\n"
         "more than that left: what is reached is found by samples (default: 0.5)",
         CLI_NUMBER, &s->left_share, 0, 100, 0, NULL},
        {0, "partial", NULL,
         "the program cuts a part of the scan: what is left is judged in the\n"
         "region that its head (or that of -p) says, or without one in what it cuts",
         CLI_FLAG, &s->partial, 0, 0, 0, NULL},
        {0, "band", "MM",
         "with --partial: points more than this below the ball are outside of\n"
         "the region cut (default: a quarter of the radius, or twice the\n"
         "tolerance if that is more)",
         CLI_NUMBER, &s->band, CLI_POSITIVE, 1e4, 0, &s->band_given},
        {0, "accept", NULL,
         "judge the program alone, whatever its head says, as UNMET, that could not\n"
         "be kept (default: that gives exit status 3)",
         CLI_FLAG, &s->accept, 0, 0, 0, NULL},
        {0, "noise", "MM",
         "noise of the scan, one standard deviation, that is taken out of it\n"
         "(default: what the program's head says, or measured); 0: every point is\n"
         "believed as it is",
         CLI_NUMBER, &s->noise, 0, 100, 0, NULL},
        {0, "flute", "MM",
         "length of the shaft of the ball's diameter above the ball's centre,\n"
         "checked in all moves (default: four radii)",
         CLI_NUMBER, &s->flute, 0, 1e4, 0, &s->flute_given},
        {0, "shank", "MM", NULL, CLI_ALIAS, "flute", 0, 0, 0, NULL},
        {0, "holder", "SPEC",
         "shank and holder from the ball's centre upward, as cylinders R:L and\n"
         "cones R0:R1:L joined by +, besides the shaft",
         CLI_TEXT, &s->holder, 0, 0, 0, NULL},
        {0, "tool-file", "NAME",
         "cutter or holder: NAME.txt in this folder, in $CLOUDMILL_TOOLS or\n"
         "among the installed ones, or a file; may be given for each of them",
         CLI_LIST, &s->files.files, 0, 0, 0, NULL},
        {0, "ball-only", NULL, "check the ball alone, without shaft and holder", CLI_FLAG,
         &s->ball_only, 0, 0, 0, NULL},
        {0, "stock", "SPEC",
         "stock: box (around the part), box,MM (larger by MM),\n"
         "box:X0,Y0,Z0,X1,Y1,Z1, or offset,MM (up to MM above the surface)",
         CLI_TEXT, &s->stock, 0, 0, 0, NULL},
        {0, "cell", "MM", "distance of the columns of the stock (default: by its size)", CLI_NUMBER,
         &s->cell, 1e-4, 1e3, 0, NULL},
        {0, "centre", NULL, "coordinates of the program are the centre of the ball, not the tip",
         CLI_FLAG, &s->centre, 0, 0, 0, NULL},
        UNIT_OPTION("units of the files of -g (default: mm)", &s->unit, NULL),
        {0, "map", "FILE", "write the points with their deviations as a PLY", CLI_TEXT, &s->map, 0,
         0, 0, NULL},
        {0, "report", "FILE",
         "write a page for a browser: the part in three\n"
         "dimensions, passes, blocks, figures",
         CLI_TEXT, &s->page, 0, 0, 0, NULL},
        {0},
    };
    *cli = (struct cli){.tool = "ncverify",
                        .usual = "guard radius control machine tolerance partial report",
                        .usage = "-g FILE [-r MM] [options] [PROGRAM]",
                        .about = "Checks an NC program against the scan or mesh it was made for.",
                        .option = option};
    cli_parse(cli, argc, argv);
    if (s->part.n == 0)
        die_usage("expected -g, the scan or mesh that the program was made for");
    if (cli->files != 1)
        die_usage("found %d programs, expected one", cli->files);
    if (s->left_given && s->scallop_given)
        die_usage("found --left and --scallop, expected one of them");
    if (s->ball_only && (s->holder || s->flute_given || s->files.files.n > 0))
        die_usage("found --ball-only with --flute, --holder or --tool-file, expected one of them");
    read_stock(s);
    read_tool_files(s);
}

/* The ball, and how far below it the region cut reaches: what is left is beyond the tolerance. */
static void find_ball(struct settings *s, const struct ncread_head *head)
{
    if (!s->radius_given && head->ball == 0)
        die_usage("expected -r, the radius of the ball: the program's head does not say it");
    if (!s->radius_given) {
        s->radius = head->ball;
        note("ball: R %g (as the program's head says)", s->radius);
    }
    if (s->radius <= s->tolerance)
        die_usage("option --radius: found %g, expected more than the tolerance %g", s->radius,
                  s->tolerance);
    s->band = s->band_given ? s->band : fmax(s->radius / 4, 2 * s->tolerance);
    if (s->band < s->tolerance)
        die_usage("option --band: found %g, expected more than the tolerance %g", s->band,
                  s->tolerance);
}

/* Control and machine that the program's head says, where options don't. */
static void adopt_head(struct settings *s, const char *file, struct ncread_head *said)
{
    struct machine_options *m = &s->machine;
    const char *missing;
    struct error error;
    if (reader_reads_once(file))
        return;
    if (ncread_head_of(file, said, &error) < 0)
        die_error(&error);
    if (!machine_options_adopt(m, said->control_file, said->machine_file, &missing))
        say("the program's head says %s, and there is no such file here (-c, -m)", missing);
    if (m->name == said->machine_file)
        note("machine: %s (as the program's head says)", m->name);
}

/* What options say otherwise, or lack, of control and --set. */
static void say_contradictions(const struct settings *s, const struct ncread_head *said)
{
    if (s->machine.control && *said->control_file &&
        strcasecmp(s->machine.control, said->control_file) != 0)
        say("the program's head says the control %s, it is read as one for %s (-c)",
            said->control_file, s->machine.control);
    if (*said->set && s->machine.set.n == 0)
        say("the program was made with --set %s: give the same, if it bears on what is judged",
            said->set);
}

/* The machine, with what the head says of its offset and coolant. */
static struct machine read_machine(const struct settings *s, const struct ncread_head *said)
{
    struct machine machine;
    struct error error;
    int status = machine_options_read(&s->machine, &machine, &error);
    if (status)
        die_status(status, &error);
    ncread_made_set(&machine, said, &s->machine.set);
    return machine;
}

/* Words of the machine's own for coolant. */
static void add_coolant(const struct machine *machine, struct ncread_options *options)
{
    const struct machine_templates *b = &machine->blocks;
    options->coolant[0] = b->coolant_on;
    options->coolant[1] = b->coolant_mist;
    options->coolant[2] = b->coolant_thru;
    options->coolant[3] = b->coolant_air;
    options->coolant_off = b->coolant_off;
}

/* The control that the head names has a word that calls a tool by its number. */
static bool calls_tools(const struct machine *machine, const struct ncread_head *head)
{
    return ncread_made_for(head, machine->used) && strstr(machine->blocks.tool_change, "{tool}");
}

static struct verify_program read_program(const struct settings *s, const struct machine *machine,
                                          const char *file, struct nc_motion *motion,
                                          struct ncread_head *head, bool *tcp)
{
    struct ncread_options options = {.kinematics = ncread_kinematics(machine), .head = head};
    struct error error;
    enum control_id control = (enum control_id)machine->text.dialect, told;
    bool once = reader_reads_once(file);
    if (control == CONTROLS && once)
        die_usage("the program is read from standard input or a pipe: give its control by -c");
    if (!s->machine.control && !once) {
        told = ncread_tell(file, &error);
        control = told == CONTROLS ? control : told;
    }
    if (control == CONTROLS)
        die_error(&error);
    options.cutcom = machine->cutcom;
    options.words = machine->text.words;
    options.home = machine->blocks.home;
    options.text = s->accept ? NULL : &machine->text;
    options.control = machine->used;
    options.tool_change = machine->blocks.tool_change;
    options.safe = machine->blocks.safe;
    options.z_top = machine->max[MACHINE_Z];
    options.tool = machine->tool;
    options.tools = machine->tools;
    add_coolant(machine, &options);
    options.dialect = ncread_of(control);
    options.tcp = *tcp = machine_has_tcp(machine, control);
    ncread_wraps(machine, &options.kinematics, options.wraps);
    if (ncread_read(file, &options, motion, &error) < 0) {
        if (!error.system && s->machine.name && *head->machine_file &&
            strcasecmp(s->machine.name, head->machine_file) != 0)
            error_add(&error, "; the program's head says the machine %s, not %s (-m)",
                      head->machine_file, s->machine.name);
        die_error(&error);
    }
    if (nc_motion_bounded(motion, &error) < 0)
        die_error(&error);
    if (head->centre && !s->centre)
        note("places: the centre of the ball (as the program's head says)");
    motion->track = s->centre || head->centre ? NC_MOTION_CENTRE : NC_MOTION_TIP;
    return (struct verify_program){.file = motion->name,
                                   .control = control_row(control)->name,
                                   .machine = machine->name,
                                   .motion = motion,
                                   .ball = head->ball,
                                   .made_for = head->machine,
                                   .unmet = s->accept ? 0 : head->unmet,
                                   .unmet_first = head->unmet_first,
                                   .wet = head->numbered && !head->dry && !s->accept,
                                   .clockwise =
                                       head->numbered && !head->anticlockwise && !s->accept,
                                   .tool = s->accept || head->numbers > 1 ? 0 : head->number,
                                   .calls = calls_tools(machine, head),
                                   .contact_feed = head->contact_feed,
                                   .of_whole = head->of_whole && !s->left_given && !s->accept,
                                   .post = head->post,
                                   .ours = head->numbered,
                                   .axis = head->axis,
                                   .rapid = s->accept || head->of_whole ? 0 : head->rapid};
}

/* With so many points it may be a file of the scan that the head names, or all of them. */
static bool is_of_scan(const struct ncread_head *head, double points)
{
    double all = 0;
    bool one = false;

    for (size_t i = 0; i < head->scans; i++) {
        all += head->scan_points[i];
        one = one || head->scan_points[i] == points;
    }
    return one || all == points;
}

/* A program may be judged by another scan of the same part, or by part of its own; by next to none
 * of it it is not judged. */
static void check_scan(const struct settings *s, const struct ncread_head *head, size_t n)
{
    const double few = 0.01;
    const char *file = s->part.item[0];
    double all = 0;

    for (size_t i = 0; i < head->scans; i++)
        all += head->scan_points[i];
    if (head->scans == 0 || is_of_scan(head, (double)n))
        return;
    if ((double)n < few * all)
        die("%s: found %zu points, expected the scan of %.0f that the program was made for, or a "
            "hundredth of it at least",
            file, n, all);
    if (head->place_rows != 7) /* else it has been said */
        say("%s: %zu points, none of the scan of %.0f that the program was made for: judged by "
            "them alone",
            file, n, all);
}

/* As a file stands, in the unit of -u. */
static struct transform place_as_it_stands(const struct settings *s)
{
    return transform_scale(cloud_unit(unit_name[s->unit]));
}

/* A scan is placed as the head says of one with as many points, or else by its unit. */
static void place_scan(const struct settings *s, const struct ncread_head *head, const char *file,
                       struct vec3 *point, size_t n)
{
    struct transform place = place_as_it_stands(s);
    bool placed = head->place_rows == 7;

    if (placed && is_of_scan(head, (double)n)) {
        place = head->place;
        note("%s: placed as the program's head says", file);
    } else if (placed) {
        say("%s: %zu points, none of the scan that the program's head places: taken in %s, as it "
            "stands",
            file, n, unit_name[s->unit]);
    }
    transform_points(&place, point, n);
}

/* Where a mesh, or surfaces, belong: as the head says, if the corners are those of the scan; any
 * other stands where it should, in its unit. */
static struct transform place_of_mesh(const struct settings *s, const struct ncread_head *head,
                                      const char *file)
{
    struct transform place = place_as_it_stands(s);
    struct cloud_count count = {0};
    struct vec3s corner = {0};
    struct error error;

    if (head->place_rows != 7 || reader_reads_once(file) || !mesh_is_there(file))
        return place;
    if (cloud_read(file, 1, &corner, &count, &error) != 0)
        die_error(&error);
    uint64_t hash = scan_source_hash(corner.item, corner.n);
    bool same = false;
    for (size_t i = 0; i < head->scans; i++)
        same = same || (head->scan_points[i] == (double)corner.n && head->scan_hash[i] == hash);
    if (same)
        note("%s: placed as the program's head says", file);
    array_free(&corner);
    return same ? head->place : place;
}

/* True if all of it are scans. */
static bool read_part(const struct settings *s, const struct ncread_head *head,
                      struct vec3s *points)
{
    struct error error;
    double spacing;
    size_t corners;
    bool scans = true;
    for (size_t i = 0; i < s->part.n; i++) {
        size_t from = points->n;
        struct transform place = place_of_mesh(s, head, s->part.item[i]);
        if (verify_part_read(s->part.item[i], &place, s->radius, points, &spacing, &corners,
                             &error) < 0)
            die_error(&error);
        if (corners > 0)
            say("%s: a mesh that is piped in: the corners of its %zu facets are taken as a scan; "
                "in a file the facets themselves are looked at",
                s->part.item[i], corners);
        if (spacing == 0)
            place_scan(s, head, s->part.item[i], points->item + from, points->n - from);
        if (spacing > 0)
            note("%s: points %.3f mm apart on its faces", s->part.item[i], spacing);
        scans = scans && spacing == 0;
    }
    if (points->n == 0)
        die("%s: found no points to check against", s->part.item[0]);
    return scans;
}

/* The noise that the scan was said to have when the path was made; measured where these are not
 * its points. */
static void find_noise(struct settings *s, const struct ncread_head *head, size_t points)
{
    if (s->noise >= 0 || !head->noise_given)
        return;
    if (head->scans > 0 && !is_of_scan(head, (double)points))
        return;
    s->noise = head->noise;
    say("noise of the scan: %g mm, as the program's head or path says (--noise)", s->noise);
}

/* The surface that the points of a scan stand for. */
static void find_surface(const struct settings *s, int threads, struct vec3s *points,
                         struct verify_surface *surface)
{
    const char *file = s->part.item[0];
    struct error error;
    if (verify_surface_find(points, s->noise, s->radius, threads, surface, &error) < 0)
        die("%s: %s", file, error.text);
    if (surface->rounded > 0)
        say("%s: heights were rounded to %.3g mm: taken to be anywhere within half of it "
            "(--noise 0 believes them)",
            file, surface->rounded);
    if (surface->noise > 0)
        note("%s: noise of %.3g mm taken out", file, surface->noise);
    if (surface->outliers.n > 0)
        note("%s: %zu outliers", file, surface->outliers.n);
    if (surface->sheets > 0)
        say("%s: two sheets %.3g mm apart, as at %.3f %.3f %.3f", file, surface->sheets,
            surface->sheets_at.x, surface->sheets_at.y, surface->sheets_at.z);
}

static void say_tool(const struct path_head *head, struct nc_motion *motion)
{
    motion->speed = head->spindle;
    motion->turns = head->spindle_ccw ? -1 : 1;
    motion->tool = head->tool;
    motion->offset = head->offset ? head->offset : head->tool;
}

/* The noise that a path says, and of which scan, where the program's head says none. */
static void adopt_noise(const struct path_head *said, struct ncread_head *head)
{
    if (head->noise_given || !said->noise_given)
        return;
    head->noise_given = true;
    head->noise = said->noise;
    size_t n = head->scans > 0 ? 0 : said->scan.n;
    for (size_t i = 0; i < n && i < NCREAD_SCANS; i++) {
        head->scan_points[head->scans] = (double)said->scan.item[i].points;
        head->scan_hash[head->scans++] = said->scan.item[i].hash;
    }
}

/* The motion of a path; the region and noise that it says, where the program says none. */
static void read_path(const char *file, struct nc_motion *motion, struct ncread_head *head,
                      struct region *region)
{
    struct path path = {0};
    struct error error;
    if (path_read(file, &path, &error) < 0 || path_motion_of(&path, motion, &error) < 0)
        die_error(&error);
    motion->name = file;
    motion->coolant = path.head.coolant > COOLANT_OFF;
    bool speeds = path_statements(&path, "SPINDL") > 0;
    motion->asked = (speeds ? NC_ASKED_SPEEDS : 0u) |
                    (path_statements(&path, "OPSKIP") > 0 ? NC_ASKED_SKIPS : 0u);
    if (path.tool.n == 0 && !speeds) /* all of it by the tool of its head, at that speed */
        say_tool(&path.head, motion);
    adopt_noise(&path.head, head);
    if (!region_given(region)) {
        *region = path.head.region;
        path.head.region.polygons = (struct region_polygons){0};
    }
    path_free(&path);
}

int main(int argc, char **argv)
{
    struct settings s = {.tolerance = USUAL, .left_share = 0.5, .noise = -1};
    struct cli cli;
    struct nc_motion motion = {0};
    struct ncread_head head = {.post = -1, .axis = -1};
    struct nc_motion path = {0};
    bool tcp;
    struct vec3s points = {0};
    struct verify_surface surface = {0};
    struct region region = {0};
    read_options(&s, &cli, argc, argv);
    struct ncread_head said = {.post = -1, .axis = -1};
    adopt_head(&s, cli.file[0], &said);
    struct machine machine = read_machine(&s, &said);
    say_contradictions(&s, &said);
    struct verify_program program = read_program(&s, &machine, cli.file[0], &motion, &head, &tcp);
    char work[NCREAD_MADE_TEXT];
    if (!s.accept && ncread_made_work(&machine, &head, &s.machine.set, work))
        program.work = work;
    note("work offset: %s", *motion.work ? motion.work : "none");
    find_tolerance(&s, &head);
    find_ball(&s, &head);
    find_tool(&s, &head);
    find_limit(&s, &head);
    ncread_head_region(&head, &region);
    if (s.path) {
        read_path(s.path, &path, &head, &region);
        program.path = &path;
    }
    program.rounding = s.tolerance_given || s.path ? s.tolerance : 0;
    if (read_part(&s, &head, &points)) {
        check_scan(&s, &head, points.n);
        program.guarded = head.scans > 0 && is_of_scan(&head, (double)points.n);
        find_noise(&s, &head, points.n);
        find_surface(&s, cli.threads, &points, &surface);
        program.surface = &surface;
    }
    program.part = &points;
    if (region_given(&region))
        program.region = &region;
    if (program.region && !s.partial)
        say("its head says that a region is cut: --partial judges that alone");
    const struct verify_options options = {.radius = s.radius,
                                           .tolerance = s.tolerance,
                                           .left = s.left,
                                           .rows = s.rows,
                                           .told = s.tolerance_given ? 0 : USUAL,
                                           .share = s.left_share / 100,
                                           .partial = s.partial,
                                           .band = s.band,
                                           .tool = s.tool,
                                           .stock = s.stock ? &s.block : NULL,
                                           .cell = s.cell,
                                           .digit = ncread_digit(&machine),
                                           .limits = ncread_limits(&machine, tcp),
                                           .time = ncread_time_options(&machine),
                                           .threads = cli.threads};
    struct verdict v = verify_run(&program, &options);
    if (s.map)
        verdict_map(&v, s.map);
    if (s.page)
        verdict_page(&v, s.page);
    verdict_text(&v, cli.output);
    bool refused = verdict_refused(&v);
    for (size_t i = 0; i < v.finding.n; i++)
        say("%s: %s%s", program.file,
            v.finding.item[i].fault ? "" : "notice: ", v.finding.item[i].text);
    verdict_free(&v);
    region_polygons_free(&region.polygons);
    array_free(&points);
    verify_surface_free(&surface);
    array_free(&s.part);
    array_free(&s.files.files);
    machine_options_free(&s.machine);
    nc_motion_free(&motion);
    nc_motion_free(&path);
    return refused ? EXIT_UNMET : EXIT_DONE;
}
