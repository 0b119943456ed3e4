/* biarcfit - the points of a path's cutting runs as arcs and lines within a tolerance. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "stage/arcrun.h"
#include "base/cli.h"
#include "base/effort.h"
#include "base/out.h"
#include "base/parallel.h"
#include "io/path/path.h"
#include "stage/gouge_options.h"
#include "stage/path_tilt.h"

struct settings {
    double tolerance, axis, tilt;
    bool tolerance_given, tilted, paper, chords, report;
    struct gouge_options guard;
};

/* One cutting run: items [from, to) of the input, and what became of them. */
struct job {
    size_t from, to;
    struct path fitted;
    struct arcrun_report report;
    struct arcmemory memory; /* while it is fitted again and again */
    struct gouge_refit_result seen;
};

struct jobs {
    size_t n, cap;
    struct job *item;
};

struct work {
    const struct path *in;
    const struct arcrun_options *options;
    const struct gouge_refit_options *guard;
    struct jobs jobs;
};

/* What a fit of one job needs. */
struct attempt {
    const struct work *work;
    struct job *job;
};

static void fit_run(void *context, const struct run *run, struct gouges *deeps)
{
    const struct attempt *a = context;
    const struct work *work = a->work;
    struct path *fitted = &a->job->fitted;
    struct vec3 start = work->options->centre ? run->item[0].ball : run->item[0].tip;
    struct pose at = {start, run->item[0].axis};

    path_free(fitted);
    *fitted = (struct path){0};
    a->job->report = (struct arcrun_report){0};
    bool guarded = work->guard->guard != NULL;
    arcrun_fit(run, work->options, guarded ? &a->job->memory : NULL, fitted, &a->job->report);
    for (size_t i = 0; guarded && i < fitted->item.n; i++) {
        const struct path_item *item = &fitted->item.item[i];
        if (item->kind != PATH_POINT && item->kind != PATH_ARC)
            continue;
        struct motion motion = path_item_motion(fitted, item, at);
        gouge_refit_motion(work->guard, &motion, deeps);
        at = item->to;
    }
}

static void fit_jobs(void *context, size_t from, size_t to)
{
    struct work *work = context;
    for (size_t i = from; i < to; i++) {
        struct job *job = &work->jobs.item[i];
        struct run run = arcrun_read(work->in, job->from, job->to);
        struct attempt attempt = {work, job};
        job->seen = gouge_refit_fit(work->guard, &run, fit_run, &attempt);
        arcmemory_free(&job->memory);
        array_free(&run);
    }
}

static void report_job(const struct job *job, size_t number)
{
    const struct arcrun_report *r = &job->report;
    if (number == 1)
        fprintf(stderr, "%6s %7s %6s %6s %6s %6s %10s %10s %10s\n", "run", "points", "arcs",
                "lines", "C", "S", "length", "off, mm", "axis, deg");
    fprintf(stderr, "%6zu %7zu %6zu %6zu %6zu %6zu %10.3f %10.6f %10.6f\n", number, r->points,
            r->arcs, r->lines, r->c, r->s, r->length, r->spent, DEGREES(r->worst.axis));
}

/* Fits all runs of `in` into `out`; all else goes over as it is. */
static struct arcrun_report fit_path(const struct path *in, struct settings *s, int threads,
                                     struct path *out)
{
    struct arcrun_options options = {.tolerance = s->tolerance,
                                     .axis = RADIANS(s->axis),
                                     .centre = in->head.track == TRACK_CENTRE,
                                     .paper = s->paper,
                                     .chords = s->chords};
    struct work work = {.in = in, .options = &options, .guard = &s->guard.rule};
    for (size_t from = 0, to; path_next_run(in, &from, &to); from = to)
        *array_push(&work.jobs) = (struct job){.from = from, .to = to};
    parallel_shown("fitting", threads, work.jobs.n, fit_jobs, &work);

    struct arcrun_report sum = {0};
    size_t done = 0;
    for (size_t i = 0; i < work.jobs.n; i++) {
        struct job *job = &work.jobs.item[i];
        path_add_items(out, in, done, job->from + 1);
        path_add_items(out, &job->fitted, 0, job->fitted.item.n);
        done = job->to;
        arcrun_add(&sum, &job->report);
        gouge_options_add(&s->guard, in, job->from, &job->seen);
        if (s->report)
            report_job(job, i + 1);
        path_free(&job->fitted);
    }
    path_add_items(out, in, done, in->item.n);
    array_free(&work.jobs);
    return sum;
}

/* What came of it; with a biarc an interval nobody has promised a tolerance, so it is told. */
static void tell(const struct arcrun_report *r, const struct path *in, const struct settings *s)
{
    void (*message)(const char *format, ...) = s->paper ? say : note;
    if (r->points == 0)
        say("no cutting run found: nothing fitted");
    message("%zu points in; %zu arcs and %zu lines out, %.1f mm; %zu biarcs of C type, %zu of S "
            "type; %zu corners kept, %zu other kinks",
            r->points, r->arcs, r->lines, r->length, r->c, r->s, r->corners, r->kinks);
    if (r->loops > 0)
        say("in %zu intervals the paper's biarc is a loop: equal legs taken", r->loops);
    bool centre = in->head.track == TRACK_CENTRE;
    double tip = centre ? r->worst.other : r->worst.point;
    double ball = centre ? r->worst.point : r->worst.other;
    message("off by at most %.6f mm at the tip and %.6f mm at the centre, axis %.4f degrees", tip,
            ball, DEGREES(r->worst.axis));
}

static struct settings read_settings(struct cli *cli, int argc, char **argv)
{
    static struct settings s = {.tolerance = 0.01, .axis = 1, .guard.noise = -1, .guard.effort = 1};
    static const struct cli_option options[] = {
        {'e', "tolerance", "MM", "how far tip and ball centre may be off the path (0.01)",
         CLI_NUMBER, &s.tolerance, 1e-4, 100, 0, &s.tolerance_given},
        {'g', "guard", "FILE",
         "keep the ball clear of this scan, within the tolerance, along all that\n"
         "is fitted, too (may be given several times)",
         CLI_LIST, &s.guard.files, 0, 0, 0, NULL},
        {0, "noise", "SIGMA", "standard deviation of the scan's noise (default: as found)",
         CLI_NUMBER, &s.guard.noise, 0, 10, 0, NULL},
        EFFORT_OPTION(&s.guard.effort),
        {0, "axis-tolerance", "DEG", "how far the tool axis may be off (1)", CLI_NUMBER, &s.axis,
         CLI_POSITIVE, 90, 0, NULL},
        {0, "tilt", "DEG",
         "set the tool axis anew: this far from the normal, to the side of the\n"
         "path (with --paper by the Frenet frame of the centres' biarcs)",
         CLI_NUMBER, &s.tilt, -89, 89, 0, &s.tilted},
        {0, "paper", NULL, "a biarc for each interval between points, as paper 1 has it", CLI_FLAG,
         &s.paper, 0, 0, 0, NULL},
        {0, "linear-arcs", NULL,
         "straight chords within the tolerance, the arcs as comments,\n"
         "for readers that know no CIRCLE",
         CLI_FLAG, &s.chords, 0, 0, 0, NULL},
        {0, "report", NULL, "a table of the runs on standard error", CLI_FLAG, &s.report, 0, 0, 0,
         NULL},
        {0},
    };
    cli->option = options;
    cli_parse(cli, argc, argv);
    if (cli->files > 1)
        die_usage("found %d files, expected one path", cli->files);
    if (!s.tolerance_given && !s.paper)
        say("tolerance %g mm (-e)", s.tolerance);
    return s;
}

static void check(const struct path *in)
{
    if (in->head.track == TRACK_CONTACT)
        die("%s: found a path of contact points, expected one of the tip or the centre", in->name);
    if (path_ball(in) < 0)
        say("no ball cutter in the head: the tolerance is kept at the tip alone");
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "biarcfit",
                      .usage = "[options] [FILE]",
                      .about = "fits arcs and lines to the points of a path"};
    struct settings s = read_settings(&cli, argc, argv);
    struct path in = {0}, out = {0};
    struct error error;
    if (path_read(cli.file[0], &in, &error) < 0)
        die_error(&error);
    check(&in);
    if (s.tilted && path_set_tilt(&in, RADIANS(s.tilt), s.paper, &error) < 0)
        die_error(&error);

    if (gouge_options_read(&s.guard, &in, s.tolerance, cli.threads, &error) < 0)
        die_error(&error);

    out.name = in.name;
    path_head_copy(&out.head, &in.head);
    out.head.chord = NAN;
    struct arcrun_report report = fit_path(&in, &s, cli.threads, &out);
    if (report.points > 0)
        path_spend(&out, "biarcfit", report.spent + s.guard.lift);
    tell(&report, &in, &s);

    struct out *o = out_open(cli.output);
    path_write(o, &out);
    out_close(o);
    gouge_options_carried(&s.guard, &in);
    int status = gouge_options_conclude(&s.guard);
    gouge_options_free(&s.guard);
    path_free(&in);
    path_free(&out);
    return !s.paper && report.spent > s.tolerance ? EXIT_UNMET : status;
}
