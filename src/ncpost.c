/*
 * ncpost - a path into an NC program for a control and a machine.
 *
 * Everything is planned and checked before the first byte is written (ncplan.h); the dialect then
 * only sets it down.
 */
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "machine/control.h"
#include "post/dialect.h"
#include "machine/machine.h"
#include "post/nccutcom.h"
#include "post/nchead.h"
#include "post/nchole.h"
#include "post/ncoutput.h"
#include "post/post_setup.h"
#include "io/path/path.h"
#include "post/selftest.h"

struct settings {
    int control;
    bool control_given;
    const char *machine;
    struct cli_list set;
    double tolerance; /* of the whole ledger, 0: none */
    double chord, axis_tolerance;
    double feed;
    bool vectors, rotary, strict;
    bool inch, plane, contact_feed, self_test;
    const char *split;
    struct nc_extract extract;
    const char *program;
};

static struct settings settings_default(void)
{
    return (struct settings){.chord = 0.005,
                             .axis_tolerance = 0.05,
                             .feed = 500,
                             .extract = {.from = -1, .explain = -1}};
}

static void read_limit(struct settings *s, const struct cli *cli)
{
    struct error error;
    if (nc_limit_read(s->split, &s->extract.limit, &error) != 0)
        die_usage("%s", error.text);
    if (!cli->output || strcmp(cli->output, "-") == 0)
        die_usage("option --split: found no -o FILE, expected one to name the parts after");
    if (s->extract.explain >= 0)
        die_usage("found --split and --explain, expected one of them");
}

static void read_options(struct settings *s, struct cli *cli, int argc, char **argv)
{
    const struct cli_option option[] = {
        {'c', "control", CONTROL_NAMES, "control to write for (default: the machine's own)",
         CLI_CHOICE, &s->control, 0, 0, 0, &s->control_given},
        {'m', "machine", "NAME",
         "machine: NAME.txt in this folder, in $CLOUDMILL_MACHINES or among\n"
         "the installed ones, or a file (default: table-ac)",
         CLI_TEXT, &s->machine, 0, 0, 0, NULL},
        {0, "set", "KEY=VALUE", "set one key of the machine; may be given again", CLI_LIST, &s->set,
         0, 0, 0, NULL},
        {'e', "tolerance", "MM",
         "most that all stages together may spend; beyond it the exit\nstatus is 3", CLI_NUMBER,
         &s->tolerance, CLI_POSITIVE, 0, 0, NULL},
        {0, "chord", "MM", "most that blocks may be off the path, before rounding\n(default 0.005)",
         CLI_NUMBER, &s->chord, 1e-6, 10, 0, NULL},
        {0, "axis-tolerance", "DEG", "most that the tool axis may be off (default 0.05)",
         CLI_NUMBER, &s->axis_tolerance, 1e-5, 10, 0, NULL},
        {0, "feed", "MM/MIN", "feed where the path gives none (default 500)", CLI_NUMBER, &s->feed,
         0.1, 1e6, 0, NULL},
        {0, "vectors", NULL, "tool axis as vectors (Fanuc G43.5; usual for Siemens)", CLI_FLAG,
         &s->vectors, 0, 0, 0, NULL},
        {0, "rotary", NULL, "tool axis as rotary words (Siemens ORIAXES; usual for Fanuc)",
         CLI_FLAG, &s->rotary, 0, 0, 0, NULL},
        {0, "plane", NULL,
         "a tool axis that stays as it is: turn the control's plane to it\n"
         "(G68.2, CYCLE800, PLANE SPATIAL) instead of tool-centre-point\ncontrol",
         CLI_FLAG, &s->plane, 0, 0, 0, NULL},
        {0, "contact-feed", NULL, "feeds of the path are those of the contact point", CLI_FLAG,
         &s->contact_feed, 0, 0, 0, NULL},
        {0, "inch", NULL, "write inches", CLI_FLAG, &s->inch, 0, 0, 0, NULL},
        {0, "from", "PASS", "begin with this pass", CLI_COUNT, &s->extract.from, 0, 2e9, 0, NULL},
        {0, "split", "N",
         "divide into programs of at most N blocks, or bytes: 500k, 2M;\n"
         "their files are -o's with -1, -2 ... in the name",
         CLI_TEXT, &s->split, 0, 0, 0, NULL},
        {0, "explain", "N", "say where block number N comes from, and write no program", CLI_COUNT,
         &s->extract.explain, 0, 2e9, 0, NULL},
        {0, "self-test", NULL,
         "instead of a path: a program that shows on the machine whether\n"
         "signs and centres of its rotary axes are right",
         CLI_FLAG, &s->self_test, 0, 0, 0, NULL},
        {0, "program", "NAME", "number (Fanuc) or name of the program", CLI_TEXT, &s->program, 0, 0,
         0, NULL},
        {0, "strict", NULL, "refuse post-processor words that nobody here knows", CLI_FLAG,
         &s->strict, 0, 0, 0, NULL},
        {0, NULL, NULL, NULL, CLI_FLAG, NULL, 0, 0, 0, NULL},
    };
    cli->option = option;
    cli_parse(cli, argc, argv);
    if (cli->files > 1)
        die_usage("found %d files, expected one path", cli->files);
    if (s->vectors && s->rotary)
        die_usage("found --vectors and --rotary, expected one of them");
    if (s->split)
        read_limit(s, cli);
}

static struct machine read_machine(const struct settings *s)
{
    struct machine machine = machine_default();
    struct error error;
    if (s->machine && machine_read(&machine, s->machine, &error) != 0)
        die_error(&error);
    for (size_t i = 0; i < s->set.n; i++)
        if (machine_set(&machine, s->set.item[i], &error) != 0)
            die_usage("%s", error.text);
    if (machine_finish(&machine, &error) != 0)
        die_error(&error);
    return machine;
}

static const struct dialect *choose_dialect(const struct settings *s, const struct machine *machine)
{
    static const char *const names[] = {"fanuc", "siemens", "heidenhain", "linuxcnc"};
    const char *name = s->control_given ? names[s->control] : machine->control;
    if (!*name)
        die_usage("found no control, expected -c %s (machine %s names none)", CONTROL_NAMES,
                  machine->name);
    const struct dialect *dialect = dialect_find(name);
    struct error error;
    if (!dialect)
        die("machine %s: control: found `%s`, expected %s", machine->name, name, CONTROL_NAMES);
    if (s->program && dialect->check_name(s->program, &error) != 0)
        die_usage("%s", error.text);
    if (s->vectors && dialect->vectors_never)
        die_usage("found --vectors, which %s does not know", name);
    return dialect;
}

static void read_path(const struct settings *s, const char *file, struct path *path)
{
    struct error error;
    if (path_read(file, path, &error) != 0)
        die_error(&error);
    for (size_t i = 0; i < path->unknown.n; i++) {
        const struct path_unknown *u = &path->unknown.item[i];
        if (s->strict)
            die("%s:%u: found the word %.40s, which nobody here knows (--strict)", path->name,
                u->line, u->word);
        say("%s:%u: passed over %.40s, which nobody here knows (%zu times)", path->name, u->line,
            u->word, u->times);
    }
    if (path->tools_numbered)
        say("%s: gave numbers to the %zu tools that have none, in the order of the path",
            path->name, path->tools_numbered);
}

/* What was assumed or added. */
static void tell(const struct path *path, const struct nc_plan *plan, const struct dialect *dialect,
                 const struct machine *machine, const struct settings *s)
{
    const struct nc_total *total = &plan->total;
    if (path->head.track == TRACK_CENTRE)
        say("X Y Z of the program are the ball's centre: measure the tool to it");
    if (total->feed_assumed)
        say("the path cuts before it gives a feed: took %g mm/min (--feed)", s->feed);
    if (total->approach_made)
        say("the path starts with a cut: came from above along the tool axis");
    if (total->retract_made)
        say("the path ends in a cut: retracted along the tool axis");
    if (total->holes && dialect->steps_alike && nc_hole_steps_differ(path))
        say("a drilling cycle of this control has steps that are alike, and no dwell with them: "
            "took the smaller step and no dwell");
    if (nc_cutcom_left_out(path, machine, &plan->ability))
        say("CUTCOM: X Y Z are the tool's centre, so the control's radius compensation stays off");
    if (plan->no_vectors)
        say("took rotary words: with vectors the control would run out of a rotary axis's travel");
    if (total->turns)
        say("the travel of a rotary axis ran out: retracted, turned and returned %zu times",
            total->turns);
    note("passes %zu, lines %zu, arcs %zu, splines %zu, rapids %zu; curves chorded %zu",
         total->passes, total->lines, total->arcs, total->splines, total->rapids, total->chorded);
    double unit = plan->ability.unit;
    note("cut %.1f mm, rapid %.1f mm, about %.1f min", total->cut * unit, total->rapid * unit,
         total->minutes);
    note("kept %.4f mm and %.4f deg; with the stages before %.4f mm", total->spent.point * unit,
         total->spent.axis * 180 / PI, nc_ledger_sum(path, plan));
}

static void make_plan(struct nc_program *p, struct nc_plan *plan, struct path *path,
                      struct machine *machine, const struct dialect *dialect,
                      const struct settings *s)
{
    struct error error;
    bool unmet = false;
    struct nc_post_options choice = {.plane = s->plane,
                                     .inch = s->inch,
                                     .axis = s->vectors  ? NC_AXIS_VECTORS
                                             : s->rotary ? NC_AXIS_ROTARY
                                                         : NC_AXIS_USUAL};
    if (s->plane && !dialect->plane)
        die_usage("found --plane, which %s does not know", dialect->name);
    p->wish =
        (struct nc_plan_options){s->chord, RADIANS(s->axis_tolerance), s->feed, s->contact_feed, 1};
    if (nc_settle(p, plan, path, machine, dialect, choice, &unmet, &error) == 0)
        return;
    if (unmet)
        die_unmet("%s", error.text);
    die_error(&error);
}

int main(int argc, char **argv)
{
    struct settings s = settings_default();
    struct cli cli = {.tool = "ncpost",
                      .usage = "-c " CONTROL_NAMES " [-m MACHINE] [options] [FILE]",
                      .about = "Write the NC program of a path for a control and a machine."};
    read_options(&s, &cli, argc, argv);
    struct machine machine = read_machine(&s);
    const struct dialect *dialect = choose_dialect(&s, &machine);
    struct path path = {0};
    if (s.self_test)
        selftest_path(&path, &machine);
    else
        read_path(&s, cli.file[0], &path);

    struct nc_plan plan;
    struct nc_program program = {
        .path = &path, .machine = &machine, .plan = &plan, .name = s.program};
    make_plan(&program, &plan, &path, &machine, dialect, &s);
    size_t files;
    struct error error;
    if (nc_output(dialect, &program, s.extract, cli.output, &files, &error) != 0)
        die_error(&error);
    if (files > 1)
        say("%zu programs", files);

    tell(&path, &plan, dialect, &machine, &s);
    double sum = nc_ledger_sum(&path, &plan);
    array_free(&s.set);
    array_free(&program.planes);
    nc_plan_free(&plan);
    path_free(&path);
    if (s.tolerance > 0 && sum > s.tolerance)
        die_unmet("all stages together spent %.4f mm, expected at most %.4f", sum, s.tolerance);
    return EXIT_DONE;
}
