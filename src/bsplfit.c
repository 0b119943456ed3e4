/*
 * bsplfit - replaces the points of a path's cutting runs by B-splines.
 *
 * Reads a path stream, writes a path stream.  The fit is splinefit's (paper 2); everything that is
 * no cutting run is carried through.
 */
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/effort.h"
#include "base/out.h"
#include "base/parallel.h"
#include "io/path/path.h"
#include "io/path/path_run.h"
#include "stage/gouge_options.h"
#include "stage/path_reference.h"
#include "splinefit/spline_run.h"
#include "stage/spline_report.h"

static const double TOLERANCE = 0.01; /* mm, when -e is not given */

struct settings {
    struct splinefit_options fit;
    int points; /* 0: as the path is; else one more than its enum path_track */
    bool paper, report, centre;
    struct gouge_options guard;
};

/* One cutting run: the items [from, to) of the path. */
struct job {
    size_t from, to, pass;
    struct spline_run pieces;
    struct gouge_refit_result seen;
};

struct jobs {
    size_t n, cap;
    struct job *item;
};

/* What the workers share. */
struct bench {
    const struct path *path;
    const struct settings *settings;
    struct jobs *jobs;
};

static void read_options(int argc, char **argv, struct cli *cli, struct settings *s)
{
    int params = 0, knots = 0;
    double angle = 1;
    bool tolerance_given = false;
    const struct cli_option option[] = {
        {'e', "tolerance", "MM", "largest distance of tip and ball centre from the path (0.01)",
         CLI_NUMBER, &s->fit.tolerance, 1e-5, 10, 0, &tolerance_given},
        {'g', "guard", "FILE",
         "keep the ball clear of this scan, within the tolerance, along all\n"
         "curves, too (may be given several times)",
         CLI_LIST, &s->guard.files, 0, 0, 0, NULL},
        {0, "noise", "SIGMA", "standard deviation of the scan's noise (default: as found)",
         CLI_NUMBER, &s->guard.noise, 0, 10, 0, NULL},
        EFFORT_OPTION(&s->guard.effort),
        {0, "axis-tolerance", "DEG", "largest error of the tool axis, degrees (1)", CLI_NUMBER,
         &angle, 0.001, 45, 0, NULL},
        {0, "degree", "P", "degree of the curves, 2 to 5 (3); a straight line has 1", CLI_COUNT,
         &s->fit.degree, 2, 5, 0, NULL},
        {0, "points", "same|tip|centre|contact",
         "what the control points stand for: the tip, the ball's centre, or\n"
         "the contact points, to study (the same as in the path)",
         CLI_CHOICE, &s->points, 0, 0, 0, NULL},
        {0, "params", "all|uniform|centripetal|chord", "parameters of the points (all)", CLI_CHOICE,
         &params, 0, 0, 0, NULL},
        {0, "knots", "all|uniform|average|free",
         "knots of the curves (all: free, or what serves where they don't)", CLI_CHOICE, &knots, 0,
         0, 0, NULL},
        {0, "paper", NULL,
         "as published: the points as they are, 5 control points and 5 more\n"
         "each time, judged at the points alone",
         CLI_FLAG, &s->paper, 0, 0, 0, NULL},
        {0, "report", NULL, "a table of all curves on standard error", CLI_FLAG, &s->report, 0, 0,
         0, NULL},
        {0}};

    cli->option = option;
    cli_parse(cli, argc, argv);
    if (cli->files > 1)
        die_usage("%d files, expected one path", cli->files);
    s->fit.params = params - 1;
    s->fit.knots = knots == 3 ? -1 : knots - 1;
    s->fit.angle = RADIANS(angle);
    if (!tolerance_given)
        say("tolerance %g mm (-e)", s->fit.tolerance);
}

static void find_runs(const struct path *path, struct jobs *jobs)
{
    size_t from = 0, to, at = 0, pass = 0;

    for (; path_next_run(path, &from, &to); from = to) {
        for (; at < from; at++)
            if (path->item.item[at].kind == PATH_PASS)
                pass = path->item.item[at].index;
        *array_push(jobs) = (struct job){.from = from, .to = to, .pass = pass};
    }
}

static void fit_jobs(void *context, size_t from, size_t to)
{
    const struct bench *bench = context;
    const struct settings *s = bench->settings;
    struct spline_guard guard = {s->guard.rule, s->paper, s->fit};

    guard.rule.centre = s->centre;
    for (size_t i = from; i < to; i++) {
        struct job *job = &bench->jobs->item[i];
        struct run run = {0};

        path_run_take(bench->path, job->from, job->to, &run);
        job->seen = spline_guard_fit(&guard, &run, &job->pieces);
        array_free(&run);
    }
}

/* The splines of a run, in the place of its points; the pieces give away what they hold. */
static void write_job(const struct path *in, struct job *job, struct path *out)
{
    for (size_t k = 0; k < job->pieces.n; k++) {
        struct spline_run_piece *piece = &job->pieces.item[k];
        const struct path_item *last = &in->item.item[job->from + piece->to];

        if (piece->still) {
            path_add_items(out, in, job->from + piece->from + 1, job->from + piece->to + 1);
            continue;
        }
        struct path_spline spline = {piece->fit.curve, piece->fallback};
        struct motion motion = motion_spline(last->to, last->to, &piece->fit.curve);
        struct pose to = job->seen.lift > 0 ? motion_at(&motion, 1) : last->to;
        struct path_item *item = path_add_spline(out, to, spline);
        if (last->touches)
            path_set_contact(out, item, in->contact.item[last->contact]);
        piece->fit.curve = (struct bspline){0};
        piece->fallback = (struct poses){0};
    }
}

static void assemble(const struct path *in, struct jobs *jobs, double spent, struct path *out)
{
    size_t at = 0;

    path_head_copy(&out->head, &in->head);
    out->head.chord = NAN;
    path_spend(out, "bsplfit", spent);
    for (size_t i = 0; i < jobs->n; i++) {
        path_add_items(out, in, at, jobs->item[i].from + 1);
        write_job(in, &jobs->item[i], out);
        at = jobs->item[i].to;
    }
    path_add_items(out, in, at, in->item.n);
}

static void free_jobs(struct jobs *jobs)
{
    for (size_t i = 0; i < jobs->n; i++)
        spline_run_free(&jobs->item[i].pieces);
    array_free(jobs);
}

/* The totals over all runs, and the table when it is asked for. */
static struct spline_report report(const struct jobs *jobs, bool table)
{
    struct spline_report r = {0};

    if (table)
        spline_report_head(stderr);
    for (size_t i = 0; i < jobs->n; i++) {
        const struct job *job = &jobs->item[i];
        for (size_t k = 0; k < job->pieces.n; k++)
            if (!job->pieces.item[k].still)
                spline_report_add(&r, job->pass, &job->pieces.item[k], table ? stderr : NULL);
    }
    if (table)
        spline_report_totals(&r, stderr);
    return r;
}

/* Exit status, after telling the first place where the promise is not kept. */
static int verdict(const struct jobs *jobs, const struct path *path)
{
    for (size_t i = 0; i < jobs->n; i++) {
        const struct job *job = &jobs->item[i];
        for (size_t k = 0; k < job->pieces.n; k++) {
            const struct spline_run_piece *piece = &job->pieces.item[k];
            if (piece->still || piece->fit.within)
                continue;
            say("%s:%u: pass %zu: %.6f mm at the tip, %.6f mm at the ball, %.4f degrees: "
                "the tolerance is not kept",
                path->name, path->item.item[job->from].line, job->pass, piece->fit.proof.point,
                piece->fit.proof.other, DEGREES(piece->fit.proof.axis));
            return EXIT_UNMET;
        }
    }
    return EXIT_DONE;
}

static void read_path(const char *file, struct path *path, struct settings *s)
{
    struct error error;

    if (path_read(file, path, &error) != 0)
        die_error(&error);
    for (size_t i = 0; i < path->unknown.n; i++)
        say("%s:%u: %s is no word known here, carried along", path->name,
            path->unknown.item[i].line, path->unknown.item[i].word);
    if (s->points > 0 && path_set_reference(path, (enum path_track)(s->points - 1), &error) != 0)
        die_error(&error);
    s->centre = path->head.track == TRACK_CENTRE;
    if (path->head.track != TRACK_CONTACT && !(path_ball(path) > 0))
        say("%s: no ball nose CUTTER: the tolerance is kept at the tracked point alone",
            path->name);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "bsplfit",
                      .usage = "[options] [FILE]",
                      .about = "Replaces the points of a path by B-splines within a tolerance."};
    struct settings settings = {
        .fit = {.degree = 3, .tolerance = TOLERANCE}, .guard.noise = -1, .guard.effort = 1};
    struct path in = {0}, out = {0};
    struct jobs jobs = {0};
    struct error error;

    read_options(argc, argv, &cli, &settings);
    read_path(cli.file[0], &in, &settings);
    if (gouge_options_read(&settings.guard, &in, settings.fit.tolerance, cli.threads, &error) != 0)
        die_error(&error);
    find_runs(&in, &jobs);
    struct bench bench = {&in, &settings, &jobs};
    parallel_shown("fitting", cli.threads, jobs.n, fit_jobs, &bench);
    struct spline_report r = report(&jobs, settings.report);
    for (size_t i = 0; i < jobs.n; i++)
        gouge_options_add(&settings.guard, &in, jobs.item[i].from, &jobs.item[i].seen);
    gouge_options_carried(&settings.guard, &in);
    int status = verdict(&jobs, &in);
    assemble(&in, &jobs, r.spent + settings.guard.lift, &out);
    struct out *o = out_open(cli.output);
    path_write(o, &out);
    out_close(o);
    note("%zu points in %zu runs: %zu splines, %zu control points, %.2f %% fewer; worst tip %.6f, "
         "ball %.6f mm, axis %.4f degrees",
         r.points, jobs.n, r.splines, r.poles, spline_report_fewer(r.points, r.poles),
         r.worst.point, r.worst.other, DEGREES(r.worst.axis));
    if (r.cut > 0)
        note("%zu curves took too long: with more time fewer control points might do", r.cut);
    int guarded = gouge_options_conclude(&settings.guard);
    gouge_options_free(&settings.guard);
    free_jobs(&jobs);
    path_free(&out);
    path_free(&in);
    return status == EXIT_DONE ? guarded : status;
}
