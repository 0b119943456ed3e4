/*
 * ncpost - a path into an NC program for a control and a machine.
 *
 * Everything is planned and checked before the first byte is written (post/post.h).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/out.h"
#include "io/path/path.h"
#include "machine/machine_options.h"
#include "post/post.h"

struct settings {
    struct machine_options machine;
    double tolerance;      /* of the whole ledger, 0: none */
    double axis_tolerance; /* degrees */
    bool feed_given;
    bool vectors, rotary, strict, self_test, accept;
    int unit, insert; /* -u; --insert: enum post_insert */
    bool unit_given;
    const char *split, *part;
    struct post_options post;
    struct post_extract extract;
};

static const double USUAL_AXIS = 0.05; /* degrees */

/* mm: what stages spent is written to a millionth. */
static const double LEDGER_ROUNDED = 5e-7;

/* mm: by more no end of a tool that a scan guards is moved for a larger tolerance of its axis. */
static const double END_MOVED = 0.02;

static struct settings settings_default(void)
{
    return (struct settings){.axis_tolerance = USUAL_AXIS,
                             .post = {.chord = 0.002, .feed = 500},
                             .extract = {.from = -1, .explain = -1}};
}

static void read_limit(struct settings *s, const struct cli *cli)
{
    struct error error;
    if (post_limit_read(s->split, &s->extract, &error) != 0)
        die_given(&error);
    if (!cli->output || strcmp(cli->output, "-") == 0)
        die_usage("option --split: found no -o FILE, expected one to name the parts after");
    if (!out_may_be_file(cli->output))
        die_usage("option --split: found -o %s, which is no file, expected one to name the parts "
                  "after",
                  cli->output);
    if (s->extract.explain >= 0)
        die_usage("found --split and --explain, expected one of them");
}

static void read_part(struct settings *s)
{
    struct error error;
    if (path_part_read(s->part, &s->extract.part, &error) != 0)
        die_given(&error);
    if (s->split || s->extract.explain >= 0)
        die_usage("found --part and %s, expected one of them", s->split ? "--split" : "--explain");
}

static void read_options(struct settings *s, struct cli *cli, int argc, char **argv)
{
    const struct cli_option option[] = {
        machine_option_control(&s->machine,
                               "fanuc, siemens, heidenhain, linuxcnc, another that is\n"
                               "installed, or a file (default: the machine's own)"),
        machine_option_name(&s->machine),
        machine_option_set(&s->machine),
        {'e', "tolerance", "MM",
         "largest sum that all stages may spend; beyond it the\nexit status is 3", CLI_NUMBER,
         &s->tolerance, CLI_POSITIVE, 0, 0, NULL},
        {0, "chord", "MM",
         "largest deviation of blocks from the path, before rounding\n(default 0.002)", CLI_NUMBER,
         &s->post.chord, 1e-6, 10, 0, NULL},
        {0, "axis-tolerance", "DEG", "largest deviation of the tool axis (default 0.05)",
         CLI_NUMBER, &s->axis_tolerance, 1e-5, 10, 0, NULL},
        {0, "feed", "MM/MIN", "feed where the path gives none (default 500)", CLI_NUMBER,
         &s->post.feed, 0.1, 1e6, 0, &s->feed_given},
        {0, "vectors", NULL,
         "tool axis as vectors (Fanuc G43.5, Heidenhain LN; default for Siemens)", CLI_FLAG,
         &s->vectors, 0, 0, 0, NULL},
        {0, "rotary", NULL, "tool axis as rotary words (Siemens ORIAXES; default for the others)",
         CLI_FLAG, &s->rotary, 0, 0, 0, NULL},
        {0, "plane", NULL,
         "for a fixed tool axis: tilt the control's plane to it (G68.2,\n"
         "CYCLE800, PLANE SPATIAL) instead of tool-centre-point control",
         CLI_FLAG, &s->post.plane, 0, 0, 0, NULL},
        {0, "contact-feed", NULL, "apply the feeds of the path to the contact point", CLI_FLAG,
         &s->post.contact_feed, 0, 0, 0, NULL},
        {0, "inch", NULL, "write inches", CLI_FLAG, &s->post.inch, 0, 0, 0, NULL},
        {0, "from", "PASS", "begin with this pass", CLI_COUNT, &s->extract.from, 0, 2e9, 0, NULL},
        {0, "split", "N",
         "divide into programs of at most N blocks, or bytes: 500k, 2M;\n"
         "their files are -o's with -1, -2 ... in the name",
         CLI_TEXT, &s->split, 0, 0, 0, NULL},
        {0, "part", "K/N", "only part K of N of the program: whole passes, to be joined by cat",
         CLI_TEXT, &s->part, 0, 0, 0, NULL},
        {0, "explain", "N", "explain the origin of block number N instead of writing a program",
         CLI_COUNT, &s->extract.explain, 0, 2e9, 0, NULL},
        {0, "self-test", NULL,
         "write a test program that shows on the machine whether the signs and\n"
         "centres of its rotary axes are right; reads no path",
         CLI_FLAG, &s->self_test, 0, 0, 0, NULL},
        {0, "program", "NAME", "number (Fanuc) or name of the program", CLI_TEXT, &s->post.name, 0,
         0, 0, NULL},
        {'u', "units", "inch|mm",
         "unit of a path that does not say it (default: mm; inch\n"
         "where it has feeds in IPM or IPR)",
         CLI_CHOICE, &s->unit, 0, 0, 0, &s->unit_given},
        {0, "insert", "pass|comment|refuse",
         "what INSERT of the path becomes: a block as it stands (default), a\n"
         "comment, or an error",
         CLI_CHOICE, &s->insert, 0, 0, 0, NULL},
        {0, "no-spindle", NULL,
         "a path may cut without a speed of the spindle or a tool's number;\n"
         "otherwise the exit status is 3",
         CLI_FLAG, &s->post.no_spindle, 0, 0, 0, NULL},
        {0, "accept", NULL,
         "exit status 0 though an earlier stage could not keep\n"
         "what was asked of it (otherwise 3)",
         CLI_FLAG, &s->accept, 0, 0, 0, NULL},
        {0, "strict", NULL, "refuse unknown post-processor words", CLI_FLAG, &s->strict, 0, 0, 0,
         NULL},
        {0, NULL, NULL, NULL, CLI_FLAG, NULL, 0, 0, 0, NULL},
    };
    cli->option = option;
    cli_parse(cli, argc, argv);
    if (cli->files > 1)
        die_usage("found %d files, expected one path", cli->files);
    if (s->vectors && s->rotary)
        die_usage("found --vectors and --rotary, expected one of them");
    s->post.insert = (enum post_insert)s->insert;
    s->post.axis = s->vectors ? POST_AXIS_VECTORS : s->rotary ? POST_AXIS_ROTARY : POST_AXIS_USUAL;
    s->post.axis_tolerance = RADIANS(s->axis_tolerance);
    if (s->split)
        read_limit(s, cli);
    if (s->part)
        read_part(s);
}

static struct machine read_machine(const struct settings *s)
{
    struct machine machine;
    struct error error;
    int status = machine_options_read(&s->machine, &machine, &error);
    if (status)
        die_status(status, &error);
    return machine;
}

static enum control_id choose_control(const struct settings *s, const struct machine *machine)
{
    enum control_id control = (enum control_id)machine->text.dialect;
    if (control == CONTROLS)
        die_usage("found no control, expected -c %s or another (machine %s names none)",
                  control_names(), machine->name);
    struct error error;
    if (post_check(control, machine, &s->post, &error) != 0)
        die_given(&error);
    return control;
}

static void read_path(const struct settings *s, const char *file, struct path *path)
{
    struct error error;
    enum path_unit unit = !s->unit_given ? PATH_UNIT_SAID
                          : s->unit == 0 ? PATH_UNIT_INCH
                                         : PATH_UNIT_MM;
    if (path_read_as(file, unit, path, &error) != 0)
        die_error(&error);
    if (path->inches_taken)
        say("%s: found feeds in inches and no UNITS: took inches (-u inch; else -u mm)",
            path->name);
    if (path->feeds_mm)
        say("%s:%u: found a feed in mm under UNITS/INCHES: lengths are in inches, this feed in mm",
            path->name, path->feeds_mm);
    for (size_t i = 0; i < path->unknown.n; i++) {
        const struct path_unknown *u = &path->unknown.item[i];
        if (s->strict)
            die("%s:%u: found the unknown word %.40s (--strict)", path->name, u->line, u->word);
        say("%s:%u: ignored the unknown word %.40s (%zu times)", path->name, u->line, u->word,
            u->times);
    }
    if (path->tools_numbered)
        say("%s: numbered the %zu tools without a number in the order of the path", path->name,
            path->tools_numbered);
}

/* What was assumed or added. */
static void say_report(const struct settings *s, const struct path *path,
                       const struct post_report *r)
{
    double feed = s->post.feed;
    if (path->head.track == TRACK_CENTRE)
        say("X Y Z of the program are the ball's centre: measure the tool to it");
    if (r->feed_assumed)
        say("the path cuts before it gives a feed: used %g mm/min (--feed)", feed);
    else if (s->feed_given)
        say("the path has feeds of its own: --feed %g is not used (--feed of meshnorm and planecut "
            "sets them)",
            feed);
    if (r->approach_made)
        say("the path starts with a cut: added an approach along the tool axis");
    if (r->retract_made)
        say("the path ends in a cut: added a retract along the tool axis");
    if (r->steps_evened)
        say("a drilling cycle of this control has equal steps and no dwell with them: "
            "used the smaller step and no dwell");
    if (r->cutcom_off)
        say("CUTCOM: X Y Z are the tool's centre, so the control's radius compensation stays off");
    if (r->no_vectors)
        say("used rotary words: with vectors a rotary axis would reach the end of its travel");
    if (r->turns)
        say("a rotary axis reached the end of its travel: retracted, turned and returned %zu times",
            r->turns);
    note("passes %zu, lines %zu, arcs %zu, splines %zu, rapids %zu; curves chorded %zu", r->passes,
         r->lines, r->arcs, r->splines, r->rapids, r->chorded);
    note("cut %.1f mm, rapid %.1f mm, about %.1f min", r->cut, r->rapid, r->minutes);
    if (r->fast > 0)
        say("%zu %s an axis for more than its largest speed, up to %.2f times, first for line %u "
            "of the path",
            r->fast, r->fast == 1 ? "block asks" : "blocks ask", r->fastest, r->fast_line);
    else if (r->peaks > 0)
        note("%zu %s an axis for more than its largest speed, up to %.2f times, over less than "
             "0.02 mm: the control slows down there",
             r->peaks, r->peaks == 1 ? "block asks" : "blocks ask", r->peak);
    note("kept %.4f mm and %.4f deg; with the stages before %.4f mm", r->point, DEGREES(r->axis),
         r->ledger);
}

/* What earlier stages could not keep; true where it is not accepted. */
static bool say_unmet(const struct settings *s, const struct unmets *unmet)
{
    for (size_t i = 0; i < unmet->n; i++)
        if (strcmp(unmet->item[i].stage, "ncpost") != 0) /* its own is said */
            (s->accept ? say : warn)("unmet, %s: %s", unmet->item[i].stage, unmet->item[i].text);
    if (unmet->n > 0 && !s->accept)
        say("a stage could not keep what was asked of it; the program is written, and its "
            "head says so (--accept ends with 0)");
    return unmet->n > 0 && !s->accept;
}

/* Shank and holder were kept clear of a scan or mesh, which is not looked at here: the axis is no
 * farther off than moves their upper end by a little, or than it usually is. */
static void limit_axis(struct settings *s, const struct path *path, const struct holder *holder)
{
    double length = 0;

    for (int i = 0; i < holder->n; i++)
        length += holder->part[i].length;
    double most = fmax(RADIANS(USUAL_AXIS), length > 0 ? END_MOVED / length : 0);
    bool clear = path->head.scan.n > 0 || path->head.mesh.n > 0;
    if (!clear || holder->n == 0 || s->post.axis_tolerance <= most)
        return;
    s->post.axis_tolerance = most;
    say("the tool axis stays within %.3g degrees, not %g (--axis-tolerance): by more a tool of "
        "%.4g mm may be in the scan that the path keeps it clear of",
        DEGREES(most), s->axis_tolerance, length);
}

/* What is added to the path is held against its scan, before the head is written. */
static void check_made(const struct post *post, struct gouge_refit_options tool, int threads,
                       struct path *path)
{
    if (path->head.scan.n == 0 && path->head.mesh.n == 0) {
        if (post_report(post).turns > 0)
            say("the path names neither scan nor mesh: the moves added for rotary axes are not "
                "checked");
        return;
    }
    struct made_moves moves = post_made_moves(post);
    struct error error;
    if (made_moves_check(&moves, path, tool, post_report(post).ledger, threads, &path->head.unmet,
                         &error) != 0)
        die_error(&error);
    array_free(&moves);
}

/* Parts of an earlier run that had more of them, which a control would go on with. */
static void say_older_parts(const char *file, size_t files)
{
    char *next = post_part_name(file, files + 1);
    if (access(next, F_OK) == 0)
        say("%s was there before and is no part of this: the last is number %zu", next, files);
    free(next);
}

int main(int argc, char **argv)
{
    struct settings s = settings_default();
    struct cli cli = {.tool = "ncpost",
                      .usual = "control machine tolerance feed units program accept inch",
                      .usage = "-c CONTROL [-m MACHINE] [options] [FILE]",
                      .about = "Writes an NC program from a path, for a control and a machine."};
    read_options(&s, &cli, argc, argv);
    struct machine machine = read_machine(&s);
    enum control_id control = choose_control(&s, &machine);
    struct path path = {0};
    s.post.no_spindle = s.post.no_spindle || s.self_test;
    if (s.self_test)
        post_selftest(&path, &machine);
    else
        read_path(&s, cli.file[0], &path);
    unmets_add_all(&path.head.unmet, &path.head.unfitted); /* no fitter came between */

    const struct gouge_refit_options tool = made_moves_tool(&path); /* of lengths in mm still */
    limit_axis(&s, &path, &tool.holder);
    struct error error;
    int status;
    size_t files;
    struct post *post = post_plan(control, &path, &machine, &s.post, &status, &error);
    if (!post)
        die_status(status, &error);
    check_made(post, tool, cli.threads, &path);
    if (post_write(post, s.extract, cli.output, &files, &error) != 0)
        die_error(&error);
    if (files > 1)
        say("%zu programs", files);
    if (s.extract.blocks || s.extract.bytes)
        say_older_parts(cli.output, files);

    struct post_report report = post_report(post);
    say_report(&s, &path, &report);
    bool unmet = say_unmet(&s, &path.head.unmet);
    bool missing = report.no_spindle_on || report.no_tool || report.no_coolant;
    post_free(post);
    machine_options_free(&s.machine);
    path_free(&path);
    if (s.tolerance > 0 && report.ledger > s.tolerance + LEDGER_ROUNDED)
        die_unmet("all stages together spent %.6f mm, expected at most %g", report.ledger,
                  s.tolerance);
    if (report.fast > 0)
        die_unmet("an axis would be too fast, expected no block beyond its largest speed");
    if (missing)
        die_unmet("%s%s%s%s%s; the program says it where it happens",
                  report.no_spindle_on ? "it cuts without a speed of the spindle (--no-spindle)"
                                       : "",
                  report.no_spindle_on && report.no_tool ? ", " : "",
                  report.no_tool ? "a tool has no number (--no-spindle)" : "",
                  (report.no_spindle_on || report.no_tool) && report.no_coolant ? ", " : "",
                  report.no_coolant ? "the machine file has no word for a coolant (coolant.thru, "
                                      "coolant.air)"
                                    : "");
    return unmet ? EXIT_UNMET : EXIT_DONE;
}
