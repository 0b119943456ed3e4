/* fitter - see fitter.h. */
#include "stage/fitter.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/out.h"
#include "io/path/path_part.h"
#include "stage/path_check.h"
#include "fit_ahead.h"

struct fitter_options fitter_defaults(double tolerance)
{
    return (struct fitter_options){
        .tolerance = tolerance, .angle = 1, .gouge = {.noise = -1, .effort = 1}};
}

double fitter_least(const struct fitter_options *options, const struct path *in)
{
    const double blocks = 3 * 0.002 / 60, usual = 800, longest = 1; /* min, mm/min, mm */
    double feed = 0;

    if (options->least_given)
        return options->least;
    for (size_t i = 0; i < in->item.n && in->head.runs.points == 0; i++)
        if (in->item.item[i].kind == PATH_FEED)
            feed = fmax(feed, in->item.item[i].feed);
    if (in->head.runs.points > 0)
        feed = in->head.runs.feed;
    return fmin(blocks * (feed > 0 ? feed : usual), longest);
}

int fitter_check_tolerance(const struct fitter_options *options, const struct path *in,
                           struct error *error)
{
    double radius = path_ball(in);

    if (radius > 0 && options->tolerance >= radius)
        return error_set(error,
                         "%s: found a ball of R %g, expected more than the tolerance %g (-e)",
                         in->name, radius, options->tolerance);
    return 0;
}

/* Items up to `to`, and after each pass that ends before there what was spent in it. */
static void add_as_they_are(const struct fitter *fitter, struct path *out, const struct path *in,
                            struct range range, double *spent)
{
    for (size_t i = range.from; i < range.to; i++) {
        if (in->item.item[i].kind == PATH_PASS && *spent >= 0) {
            path_spend_pass(out, fitter->name, *spent, out->item.n);
            *spent = -1;
        }
        path_add_items(out, in, i, i + 1);
    }
}

/* The range with the fitted items in the place of the runs; all else goes over as it is.  *clear:
 * the items whose motions were found clear. */
static struct path assemble(const struct fitter *fitter, const struct path *in,
                            const struct fitted_runs *runs, struct range range,
                            struct ranges *clear)
{
    struct path out = {.name = in->name};
    size_t done = range.from;
    double spent = -1; /* in this pass so far; below 0: no run in it */

    path_head_copy(&out.head, &in->head);
    out.head.chord = NAN;
    out.head.runs = (struct path_runs){0};
    out.head.passes = path_passes_of(in);
    if (fitter->options->gouge.noise >= 0) {
        out.head.noise_given = true;
        out.head.noise = fitter->options->gouge.noise;
    }
    for (size_t i = 0; i < runs->n; i++) {
        const struct fitted_run *run = &runs->item[i];
        add_as_they_are(fitter, &out, in, (struct range){done, run->from + 1}, &spent);
        size_t first = out.item.n;
        path_add_items(&out, &run->fitted, 0, run->fitted.item.n);
        if (run->swept && run->gouge.deepest.depth == 0)
            *array_push(clear) = (struct range){first, out.item.n};
        spent = fmax(spent, fitter->spent(run->result) + run->gouge.lift);
        done = run->to;
    }
    add_as_they_are(fitter, &out, in, (struct range){done, range.to}, &spent);
    if (spent >= 0)
        path_spend_pass(&out, fitter->name, spent, out.item.n);
    return out;
}

static void free_runs(const struct fitter *fitter, struct fitted_runs *runs)
{
    for (size_t i = 0; i < runs->n; i++)
        fitted_run_free(fitter, &runs->item[i]);
    array_free(runs);
}

static int read_path(const struct fitter *fitter, const char *file, struct fit_ahead *ahead,
                     struct path *in, struct error *error)
{
    struct path_listener listener = fit_ahead_listener(ahead);

    if (path_read_listened(file, &listener, in, error) < 0)
        return -1;
    for (size_t i = 0; i < in->unknown.n; i++)
        say("%s:%u: unknown word %s, copied", in->name, in->unknown.item[i].line,
            in->unknown.item[i].word);
    if (!fit_ahead_began(ahead) && fitter->prepare(fitter->settings, in, error) < 0)
        return -1;
    if (in->head.track != TRACK_CONTACT && !(path_ball(in) > 0))
        say("%s: no ball nose CUTTER: the tolerance is kept at the tracked point alone", in->name);
    return 0;
}

/* What the stages before could not keep is in the last part. */
static void write_path(const char *file, struct path *path, struct path_part part,
                       const struct unmets *unmet)
{
    struct out *o = out_open(file);
    if (path_part_first(part))
        path_write_head(o, &path->head);
    path_write_items(o, path);
    if (path_part_last(part)) {
        unmets_add_all(&path->head.unmet, unmet);
        path_write_end(o, &path->head);
    } else {
        path_write_unmet(o, unmet);
    }
    out_close(o);
}

/* What the stages before could not keep, for whoever sees this tool alone: the first of it. */
static void say_before(const struct unmets *unmet)
{
    if (unmet->n > 0)
        warn("unmet before, %s: %s%s", unmet->item[0].stage, unmet->item[0].text,
             unmet->n > 1 ? "; and more" : "");
}

/* Whoever sees this tool's status alone is told of the stages before, too; in parts, by the one
 * that has their statements (write_path). */
static int status_of(const struct path *path, struct path_part part, const struct unmets *unmet)
{
    return unmets_status(path_part_last(part) ? &path->head.unmet : unmet);
}

/* The part that is asked for, as items of the path. */
static struct range range_of(struct path_part part, const struct path *in)
{
    struct range range;

    path_part_items(part, in, &range.from, &range.to);
    if (range.from == range.to)
        say("%s: part %ld of %ld is empty: there are too few passes", in->name, part.k, part.n);
    return range;
}

/* Holds what will be written against the guard, as far as the fits have not. */
static void check_path(struct path_check *check, const struct path *in, struct range range,
                       const struct path *out, const struct ranges *clear)
{
    bool *is_clear = mem_alloc(out->item.n + 1, sizeof *is_clear);

    for (size_t i = 0; i < out->item.n; i++)
        is_clear[i] = false;
    for (size_t k = 0; k < clear->n; k++)
        for (size_t i = clear->item[k].from; i < clear->item[k].to; i++)
            is_clear[i] = true;
    path_check_follow(check, in, 0, range.from);
    check->clear = is_clear;
    path_check_items(check, out, 0, out->item.n);
    check->clear = NULL;
    free(is_clear);
}

/* What is written may be as deep as the path was made: what no fit was found for is written as it
 * came. */
static struct path_check check_of(const struct gouge_refit_options *gouge, const struct path *in,
                                  int threads)
{
    struct path_check check = {.tool = *gouge, .threads = threads};

    check.tool.tolerance = fmax(gouge->tolerance, gouge_made_within(in));
    return check;
}

/* Reads the path, and fits all runs of the part that is asked for: *range. */
static int read_and_fit(const struct fitter *fitter, const struct cli *cli, struct path *in,
                        struct range *range, struct gouge_refit_options *gouge,
                        struct fitted_runs *runs, struct error *error)
{
    struct fit_ahead *ahead = fit_ahead_new(fitter, cli->threads);
    int result = read_path(fitter, cli->file[0], ahead, in, error);

    if (result == 0) {
        *range = range_of(fitter->options->part, in);
        result = fit_ahead_rest(ahead, in, *range, gouge, runs, error);
    }
    fit_ahead_free(ahead);
    return result;
}

int fitter_run(const struct fitter *fitter, const struct cli *cli, struct error *error)
{
    const struct fitter_options *options = fitter->options;
    struct gouge_refit_options gouge = {0};
    struct fitted_runs runs = {0};
    struct range range = {0};
    struct path in = {0};

    if (read_and_fit(fitter, cli, &in, &range, &gouge, &runs, error) < 0) {
        path_free(&in);
        return -1;
    }
    double lift = 0;
    for (size_t i = 0; i < runs.n; i++)
        lift = fmax(lift, runs.item[i].gouge.lift);

    struct ranges clear = {0};
    struct path out = assemble(fitter, &in, &runs, range, &clear);
    struct unmets unmet = {0};
    fitter->report(fitter->settings, &in, &runs, &unmet);
    struct path_check check = check_of(&gouge, &in, cli->threads);
    check_path(&check, &in, range, &out, &clear);
    array_free(&clear);
    if (lift > 0)
        note("points lifted by at most %.4f mm where motions went too deep between them", lift);
    path_check_conclude(&check, &unmet);
    if (path_part_last(options->part))
        say_before(&out.head.unmet);
    write_path(cli->output, &out, options->part, &unmet);
    int status = status_of(&out, options->part, &unmet);
    unmets_free(&unmet);
    gouge_refit_free(&gouge);
    free_runs(fitter, &runs);
    path_free(&in);
    path_free(&out);
    return status;
}
