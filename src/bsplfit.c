/* bsplfit - the points of a path's cutting runs as B-splines within a tolerance (paper 2). */
#include <stdio.h>
#include <stdlib.h>

#include "base/cli.h"
#include "base/effort.h"
#include "math/elementary.h"
#include "splinefit/spline_run.h"
#include "stage/fitter.h"
#include "stage/path_track.h"
#include "stage/spline_report.h"

struct settings {
    struct fitter_options common;
    int degree;
    int points;        /* 0: as the path is; else one more than its enum path_track */
    int params, knots; /* by their place among the choices */
    int ends;          /* enum spline_ends */
    bool degree_given, params_given, knots_given, ends_given, interpolate;
    struct spline_run_options run;
};

/* The curves of a run. */
struct result {
    struct spline_run pieces;
};

static int prepare(void *settings, struct path *in, struct error *error)
{
    struct settings *s = settings;
    if (!s->common.tolerance_given)
        say("tolerance %g mm (-e)", s->common.tolerance);
    s->common.least = s->common.paper || s->interpolate ? 0 : fitter_least(&s->common, in);
    s->common.links_stay = s->interpolate;
    if (fitter_check_tolerance(&s->common, in, error) < 0)
        return -1;
    if (s->points > 0 && path_set_track(in, (enum path_track)(s->points - 1), error) != 0)
        return -1;
    s->run = (struct spline_run_options){.centre = in->head.track == TRACK_CENTRE,
                                         .paper = s->common.paper,
                                         .through = s->interpolate,
                                         .ends = (enum spline_ends)s->ends,
                                         .fit = {.degree = s->degree,
                                                 .params = s->params - 1,
                                                 .knots = s->knots == 3 ? -1 : s->knots - 1,
                                                 .tolerance = s->common.tolerance,
                                                 .least = s->common.least,
                                                 .angle = RADIANS(s->common.angle)}};
    return 0;
}

/* The splines of a run, in the place of its points. */
static void add_pieces(const struct path *in, const struct spline_run *pieces,
                       struct fitted_run *run)
{
    for (size_t k = 0; k < pieces->n; k++) {
        const struct spline_run_piece *piece = &pieces->item[k];
        const struct path_item *last = &in->item.item[run->from + piece->to];

        if (piece->still) {
            path_add_items(&run->fitted, in, run->from + piece->from + 1,
                           run->from + piece->to + 1);
            continue;
        }
        struct path_spline spline = {bspline_copy(&piece->fit.curve), {0}};
        for (size_t i = 0; i < piece->fallback.n; i++)
            *array_push(&spline.fallback) = piece->fallback.item[i];
        struct motion motion = motion_spline(last->to, last->to, &piece->fit.curve);
        struct pose to = run->gouge.lift > 0 ? motion_at(&motion, 1) : last->to;
        struct path_item *item = path_add_spline(&run->fitted, to, spline);
        if (last->touches)
            path_set_contact(&run->fitted, item, in->contact.item[last->contact]);
    }
}

/* Some points stay as they came. */
static bool any_still(const struct spline_run *pieces)
{
    for (size_t k = 0; k < pieces->n; k++)
        if (pieces->item[k].still)
            return true;
    return false;
}

/* Spans of a curve from row to row that may leave the part, at least: who judges a program takes a
 * curve that does so over fewer for one with a wrong pole, which reaches over no more. */
enum { LINK_SPANS = 12 };

/* Of the ball's radius, over the chord: a curve that rises less stays on the part. */
static const double RISES = 0.2;

static bool rises(const struct bspline *curve, double most)
{
    struct vec3 from = curve->pole[0], to = curve->pole[curve->poles - 1];

    for (size_t i = 1; i + 1 < curve->poles; i++)
        if (vec_segment_distance(from, to, curve->pole[i]) > most)
            return true;
    return false;
}

/* The same curve with no fewer spans than that. */
static void divide_link(struct bspline *curve)
{
    while (curve->poles < (size_t)curve->degree + LINK_SPANS) {
        size_t longest = (size_t)curve->degree;
        for (size_t i = longest; i < curve->poles; i++)
            if (bspline_span_length(curve, i) > bspline_span_length(curve, longest))
                longest = i;
        bspline_insert(curve, (curve->knot[longest] + curve->knot[longest + 1]) / 2);
    }
}

static void fit_run(const void *settings, const struct fit_request *request, struct run *points,
                    struct fitted_run *run)
{
    const struct settings *s = settings;
    struct spline_run_options options = s->run;
    struct result *result = run->result;
    options.fit.angle *= request->axis_share;
    options.fit.work = request->work;
    run->stays = run->rough;
    if (run->stays)
        return;
    run->gouge = spline_run_fit_guarded(points, &options, request->gouge, &result->pieces);
    run->swept = request->gouge->guard && !any_still(&result->pieces);
    for (size_t k = 0; run->link && k < result->pieces.n; k++) {
        struct spline_run_piece *piece = &result->pieces.item[k];
        if (!piece->still && rises(&piece->fit.curve, RISES * request->gouge->radius))
            divide_link(&piece->fit.curve);
    }
    add_pieces(request->in, &result->pieces, run);
}

static void result_free(void *result)
{
    spline_run_free(&((struct result *)result)->pieces);
}

/* Says the first place where the tolerance is not kept. */
static void say_unmet(const struct path *in, const struct fitted_runs *runs, struct unmets *unmet)
{
    for (size_t i = 0; i < runs->n; i++) {
        const struct fitted_run *run = &runs->item[i];
        const struct result *result = run->result;
        const struct spline_run *pieces = &result->pieces;
        for (size_t k = 0; k < pieces->n; k++) {
            const struct spline_run_piece *piece = &pieces->item[k];
            const struct splinefit *f = &piece->fit;
            if (piece->still || f->within)
                continue;
            unmet_say(unmet,
                      "%s:%u: pass %zu: %.6f mm at the tip, %.6f mm at the ball, %.4f degrees: "
                      "the tolerance is not kept",
                      in->name, in->item.item[run->from].line, run->pass,
                      f->proof.point + piece->smooth, f->proof.other + piece->smooth,
                      DEGREES(f->proof.axis));
            return;
        }
    }
}

static void report(const void *settings, const struct path *in, const struct fitted_runs *runs,
                   struct unmets *unmet)
{
    const struct settings *s = settings;
    FILE *table = s->common.report ? stderr : NULL;
    struct spline_report r = {0};

    if (table)
        spline_report_head(table);
    for (size_t i = 0; i < runs->n; i++) {
        const struct result *result = runs->item[i].result;
        for (size_t k = 0; k < result->pieces.n; k++) {
            struct spline_run_piece piece = result->pieces.item[k];
            if (!piece.still)
                spline_report_add(&r, runs->item[i].pass, s->common.least, &piece, table);
        }
    }
    if (table)
        spline_report_totals(&r, table);
    note("%zu points in %zu runs: %zu splines, %zu control points, %.2f %% fewer; worst tip %.6f, "
         "ball %.6f mm, axis %.4f degrees",
         r.points, runs->n, r.splines, r.poles, spline_report_fewer(r.points, r.poles),
         r.worst.point, r.worst.other, DEGREES(r.worst.axis));
    if (r.shorter > 0)
        say("%zu knot spans are shorter than asked for (--min-length), the shortest %.4f mm: the "
            "tolerance or a corner leaves them no room",
            r.shorter, r.shortest);
    note(
        "the shortest knot span is %.3f mm long; %zu curves are polylines, with jumps of direction "
        "and axis, in all others both are twice differentiable",
        r.shortest, r.polylines);
    if (r.cut > 0)
        note("%zu curves reached the bound of work: they might do with fewer control points",
             r.cut);
    say_unmet(in, runs, unmet);
}

static double spent(const void *result)
{
    const struct spline_run *pieces = &((const struct result *)result)->pieces;
    double most = 0;
    for (size_t k = 0; k < pieces->n; k++)
        if (!pieces->item[k].still)
            most = fmax(most, spline_report_spent(&pieces->item[k]));
    return most;
}

static struct settings s = {.degree = 3};

/* What does not go with a curve through all points. */
static void check_interpolate(void)
{
    if (s.ends_given && !s.interpolate)
        die_usage("found --ends without --interpolate, expected both");
    if (s.interpolate && (s.common.paper || s.degree_given || s.params_given || s.knots_given))
        die_usage("found %s with --interpolate, expected one of them", s.common.paper   ? "--paper"
                                                                       : s.degree_given ? "--degree"
                                                                       : s.params_given
                                                                           ? "--params"
                                                                           : "--knots");
}

int main(int argc, char **argv)
{
    static const struct cli_option option[] = {
        {'e', "tolerance", "MM", "largest distance of tip and ball from the path (0.01)",
         CLI_NUMBER, &s.common.tolerance, 1e-5, 10, 0, &s.common.tolerance_given},
        {'g', "guard", "FILE",
         "keep the tool clear of this scan along the curves too\n"
         "(default: the one that the path names)",
         CLI_LIST, &s.common.gouge.scan.files, 0, 0, 0, NULL},
        FITTER_OPTIONS(&s.common),
        {0, "axis-tolerance", "DEG",
         "largest deviation of the tool axis (1; without\n"
         "a scan what moves the flute's end by twice -e)",
         CLI_NUMBER, &s.common.angle, 0.001, 45, 0, &s.common.angle_given},
        {0, "degree", "P", "degree of the curves, 2 to 5 (3); a straight line has 1", CLI_COUNT,
         &s.degree, 2, 5, 0, &s.degree_given},
        {0, "points", "same|tip|centre|contact", NULL, CLI_ALIAS, "track", 0, 0, 0, NULL},
        {0, "track", "same|tip|centre|contact",
         "curve to fit: that of the tip, of the ball's centre, or of the contact\n"
         "points, for study (default: the one that the path tracks)",
         CLI_CHOICE, &s.points, 0, 0, 0, NULL},
        {0, "params", "all|uniform|centripetal|chord", "parameters of the points (all)", CLI_CHOICE,
         &s.params, 0, 0, 0, &s.params_given},
        {0, "knots", "all|uniform|average|free",
         "knots of the curves (all: free, the others where these find nothing)", CLI_CHOICE,
         &s.knots, 0, 0, 0, &s.knots_given},
        {0, "interpolate", NULL,
         "cubic splines through all points, with continuous second derivatives\n"
         "(Lai); -e is what they may be off the path between the points",
         CLI_FLAG, &s.interpolate, 0, 0, 0, NULL},
        {0, "ends", "natural|clamped|bessel",
         "ends of the curves of --interpolate: no curvature, the tangent of the\n"
         "path, or the slope of the parabola through three points (natural)",
         CLI_CHOICE, &s.ends, 0, 0, 0, &s.ends_given},
        {0, "paper", NULL,
         "as published: the given points, 5 control points and 5 more each time,\n"
         "with the error at the points only",
         CLI_FLAG, &s.common.paper, 0, 0, 0, NULL},
        {0, "table", NULL, "a table of all curves on standard error", CLI_FLAG, &s.common.report, 0,
         0, 0, NULL},
        {0, "report", NULL, NULL, CLI_ALIAS, "table", 0, 0, 0, NULL},
        {0}};
    struct fitter fitter = {.name = "bsplfit",
                            .options = &s.common,
                            .settings = &s,
                            .prepare = prepare,
                            .fit = fit_run,
                            .report = report,
                            .spent = spent,
                            .result_size = sizeof(struct result),
                            .result_free = result_free};
    struct cli cli = {.tool = "bsplfit",
                      .usual = "tolerance guard axis-tolerance degree table quiet verbose",
                      .usage = "[options] [FILE]",
                      .about = "Replaces the points of a path by B-splines within a tolerance.",
                      .option = option,
                      .in_place = true};
    struct error error;

    s.common = fitter_defaults(0.01);
    cli_parse(&cli, argc, argv);
    if (cli.files > 1)
        die_usage("found %d files, expected one path", cli.files);
    check_interpolate();
    if (s.common.gouge.scan.none && s.common.gouge.scan.files.n > 0)
        die_usage("found -g and --no-guard, expected one of them");
    if (s.common.part_text && path_part_read(s.common.part_text, &s.common.part, &error) < 0)
        die_given(&error);
    fitter.whole = s.points > 0;
    int status = fitter_run(&fitter, &cli, &error);
    if (status < 0)
        die_error(&error);
    return status;
}
