/* biarcfit - the points of a path's cutting runs as arcs and lines within a tolerance. */
#include <stdio.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "base/effort.h"
#include "stage/arcrun.h"
#include "stage/fitter.h"
#include "stage/path_tilt.h"

struct settings {
    struct fitter_options common;
    double tilt; /* degrees */
    bool tilted, chords;
};

static int prepare(void *settings, struct path *in, struct error *error)
{
    struct settings *s = settings;
    s->common.least = s->common.paper ? 0 : fitter_least(&s->common, in);
    if (!s->common.tolerance_given && !s->common.paper)
        say("tolerance %g mm (-e)", s->common.tolerance);
    if (in->head.track == TRACK_CONTACT)
        return error_set(
            error, "%s: found a path of contact points, expected one of the tip or the centre",
            in->name);
    if (fitter_check_tolerance(&s->common, in, error) < 0)
        return -1;
    return s->tilted ? path_set_tilt(in, RADIANS(s->tilt), s->common.paper, error) : 0;
}

/* What a fit of one run needs. */
struct run_fit {
    const struct gouge_refit_options *gouge;
    struct arcrun_options options;
    struct path *fitted;
    struct arcrun_report *report;
    struct arcrun_memo memo; /* of the fit before */
    struct gouge_memo found; /* of all fits */
};

/* Fits the run anew, and appends to `gouges` where the ball then goes too deep. */
static void fit_and_check(void *context, const struct run *run, struct gouges *gouges)
{
    struct run_fit *f = context;
    struct path *fitted = f->fitted;
    struct vec3 start = f->options.centre ? run->item[0].ball : run->item[0].tip;
    struct pose at = {start, run->item[0].axis};

    path_free(fitted);
    *fitted = (struct path){0};
    *f->report = (struct arcrun_report){0};
    arcrun_fit(run, &f->options, &f->memo, fitted, f->report);
    for (size_t i = 0; f->gouge->guard && i < fitted->item.n; i++) {
        const struct path_item *item = &fitted->item.item[i];
        if (item->kind != PATH_POINT && item->kind != PATH_ARC)
            continue;
        struct motion motion = path_item_motion(fitted, item, at);
        gouge_refit_once(f->gouge, &motion, &f->found, gouges);
        at = item->to;
    }
}

/* A link that is guarded: as few pieces as are clear. */
static bool fit_link(const struct fit_request *request, const struct arcrun_options *options,
                     const struct run *points, struct fitted_run *run)
{
    const struct arcrun_link link = {run->leave,
                                     run->arrive,
                                     {run->out[0], run->out[1]},
                                     request->in->head.scallop + options->tolerance,
                                     request->gouge};

    run->swept = request->gouge->guard && !options->paper &&
                 arcrun_fit_link(points, &link, options, &run->fitted, run->result);
    return run->swept;
}

static void fit_run(const void *settings, const struct fit_request *request, struct run *points,
                    struct fitted_run *run)
{
    const struct settings *s = settings;
    const struct gouge_refit_options *gouge = request->gouge;
    struct run_fit f = {.gouge = gouge,
                        .options = {.tolerance = s->common.tolerance,
                                    .axis = request->axis_share * RADIANS(s->common.angle),
                                    .centre = request->in->head.track == TRACK_CENTRE,
                                    .paper = s->common.paper,
                                    .chords = s->chords,
                                    .least = s->common.least,
                                    .work = request->work,
                                    .guarded = gouge->guard != NULL},
                        .fitted = &run->fitted,
                        .report = run->result};
    if (run->link && fit_link(request, &f.options, points, run))
        return;
    run->stays = run->rough;
    if (run->stays)
        return;
    run->gouge = gouge_refit_fit(gouge, points, fit_and_check, &f);
    run->swept = gouge->guard != NULL;
    arcrun_memo_free(&f.memo);
    gouge_memo_free(&f.found);
}

static void report_run(const struct arcrun_report *r, size_t number)
{
    if (number == 1)
        fprintf(stderr, "%6s %7s %6s %6s %6s %6s %10s %10s %10s\n", "run", "points", "arcs",
                "lines", "C", "S", "length", "off, mm", "axis, deg");
    fprintf(stderr, "%6zu %7zu %6zu %6zu %6zu %6zu %10.3f %10.6f %10.6f\n", number, r->points,
            r->arcs, r->lines, r->c, r->s, r->length, r->spent, DEGREES(r->worst.axis));
}

/* With a biarc for each interval no tolerance is promised, so what came of it is always said. */
static void report_totals(const struct arcrun_report *r, const struct path *in, bool paper)
{
    void (*message)(const char *format, ...) = paper ? say : note;
    if (r->points == 0)
        say("no cutting run found: nothing fitted");
    message("%zu points in; %zu arcs and %zu lines out, %.1f mm; %zu biarcs of C type, %zu of S "
            "type; %zu corners kept, %zu other kinks",
            r->points, r->arcs, r->lines, r->length, r->c, r->s, r->corners, r->kinks);
    if (r->loops > 0)
        say("in %zu intervals the paper's biarc is a loop: equal legs taken", r->loops);
    if (r->shorter > 0)
        say("%zu %s shorter than asked for (--min-length), the shortest %.4f mm: the tolerance or "
            "a "
            "corner leaves no room",
            r->shorter, r->shorter == 1 ? "piece is" : "pieces are", r->shortest);
    message("largest jumps from piece to piece: curvature %.4f 1/mm, turn of the axis %.3f degrees "
            "a millimetre; the shortest piece is %.3f mm long",
            r->bend, DEGREES(r->turn), r->shortest);
    bool centre = in->head.track == TRACK_CENTRE;
    double tip = centre ? r->worst.other : r->worst.point;
    double ball = centre ? r->worst.point : r->worst.other;
    message("off by at most %.6f mm at the tip and %.6f mm at the centre, axis %.4f degrees", tip,
            ball, DEGREES(r->worst.axis));
}

static void report(const void *settings, const struct path *in, const struct fitted_runs *runs,
                   struct unmets *unmet)
{
    const struct settings *s = settings;
    struct arcrun_report sum = {0};
    for (size_t i = 0; i < runs->n; i++) {
        arcrun_add(&sum, runs->item[i].result);
        if (s->common.report)
            report_run(runs->item[i].result, i + 1);
    }
    report_totals(&sum, in, s->common.paper);
    if (!s->common.paper && sum.spent > s->common.tolerance)
        unmet_say(unmet, "%s: arcs and lines are %.6f mm off the path, expected at most %g (-e)",
                  in->name, sum.spent, s->common.tolerance);
}

static double spent(const void *result)
{
    return ((const struct arcrun_report *)result)->spent;
}

int main(int argc, char **argv)
{
    static struct settings s;
    static const struct cli_option option[] = {
        {'e', "tolerance", "MM", "largest distance of tip and ball from the path (0.01)",
         CLI_NUMBER, &s.common.tolerance, 1e-4, 100, 0, &s.common.tolerance_given},
        {'g', "guard", "FILE",
         "keep the tool clear of this scan along the arcs too\n"
         "(default: the one that the path names)",
         CLI_LIST, &s.common.gouge.scan.files, 0, 0, 0, NULL},
        FITTER_OPTIONS(&s.common),
        {0, "axis-tolerance", "DEG",
         "largest deviation of the tool axis (1; without\n"
         "a scan what moves the flute's end by twice -e)",
         CLI_NUMBER, &s.common.angle, CLI_POSITIVE, 90, 0, &s.common.angle_given},
        {0, "tilt", "DEG",
         "set a new tool axis: tilted this far from the normal, to the side of\n"
         "the path (with --paper by the Frenet frame of the centres' biarcs)",
         CLI_NUMBER, &s.tilt, -89, 89, 0, &s.tilted},
        {0, "paper", NULL, "one biarc for each interval between points, as in paper 1", CLI_FLAG,
         &s.common.paper, 0, 0, 0, NULL},
        {0, "linear-arcs", NULL,
         "straight chords within the tolerance, the arcs as comments,\n"
         "for readers without CIRCLE",
         CLI_FLAG, &s.chords, 0, 0, 0, NULL},
        {0, "table", NULL, "a table of the runs on standard error", CLI_FLAG, &s.common.report, 0,
         0, 0, NULL},
        {0, "report", NULL, NULL, CLI_ALIAS, "table", 0, 0, 0, NULL},
        {0},
    };
    struct fitter fitter = {.name = "biarcfit",
                            .options = &s.common,
                            .settings = &s,
                            .prepare = prepare,
                            .fit = fit_run,
                            .report = report,
                            .spent = spent,
                            .result_size = sizeof(struct arcrun_report)};
    struct cli cli = {.tool = "biarcfit",
                      .usual = "tolerance guard axis-tolerance table quiet verbose",
                      .usage = "[options] [FILE]",
                      .about =
                          "Replaces the points of a path by arcs and lines within a tolerance.",
                      .option = option,
                      .in_place = true};
    struct error error;

    s.common = fitter_defaults(0.01);
    cli_parse(&cli, argc, argv);
    if (cli.files > 1)
        die_usage("found %d files, expected one path", cli.files);
    if (s.common.gouge.scan.none && s.common.gouge.scan.files.n > 0)
        die_usage("found -g and --no-guard, expected one of them");
    if (s.common.part_text && path_part_read(s.common.part_text, &s.common.part, &error) < 0)
        die_given(&error);
    fitter.whole = s.tilted;
    int status = fitter_run(&fitter, &cli, &error);
    if (status < 0)
        die_error(&error);
    return status;
}
