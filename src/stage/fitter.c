/* fitter - see fitter.h. */
#include "stage/fitter.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/out.h"
#include "base/parallel.h"
#include "io/path/path_part.h"
#include "io/path/path_run.h"
#include "stage/path_check.h"

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
    for (size_t i = 0; i < in->item.n; i++)
        if (in->item.item[i].kind == PATH_FEED)
            feed = fmax(feed, in->item.item[i].feed);
    return fmin(blocks * (feed > 0 ? feed : usual), longest);
}

static const double BESIDE_POLE = RADIANS(2);

/* So many points get the usual work each, more share it. */
static const double USUAL_POINTS = 12000;

enum { TIMES = 5 }; /* a run is fitted, with other parts each time */

enum { LINK_POINTS = 4 }; /* a link of fewer is as short as it may be */

static const double LINK_OFF = 10;   /* tolerances: its lines are no further off a smooth curve, */
static const double LINK_ROUND = 30; /* or, turning gently, no further than that: it is checked */
static const double GENTLE = 0.866;  /* cosine of the most that such a link turns at a point */

static const double LESS_AXIS = 0.3;      /* of the axis tolerance, each time */
static const double SHORTEST = 0.05;      /* mm: of the tracked point, to be fitted at all */
static const double STANDING_TURN = 0.01; /* radians: a turn of the axis, ... */
static const double STANDING = 0.3;       /* mm for a radian of it: the tracked point stands */

/* What the threads share. */
struct workload {
    const struct fitter *fitter;
    struct fit_request request;
    const struct fitted_runs *runs; /* as they were found */
    struct fitted_runs *fitted;     /* by run: its parts, fitted */
};

/* A part of the path: items [from, to). */
struct range {
    size_t from, to;
};

struct ranges {
    size_t n, cap;
    struct range *item;
};

static bool is_in_link(const struct path_item *item)
{
    return item->kind == PATH_POINT && !item->rapid && !item->touches;
}

/* The lines nowhere turn by more than 30 degrees. */
static bool turns_gently(const struct run *run)
{
    const struct run_point *p = run->item;

    for (size_t i = 1; i + 1 < run->n; i++)
        if (vec_dot(vec_unit(vec_sub(p[i].ball, p[i - 1].ball)),
                    vec_unit(vec_sub(p[i + 1].ball, p[i].ball))) < GENTLE)
            return false;
    return true;
}

/* The straight lines between the points stand for a smooth curve. */
static bool is_smooth(const struct path *in, size_t from, size_t to, double tolerance)
{
    struct run points = path_run_read(in, from, to), dense = {.radius = points.radius};
    double off = (turns_gently(&points) ? LINK_ROUND : LINK_OFF) * tolerance;
    bool smooth = run_densify(&points, off, &dense) <= off;

    array_free(&points);
    array_free(&dense);
    return smooth;
}

/* Appends the links among the items of the range that lead round smoothly, each with the point it
 * begins at. */
static void find_links(const struct path *in, struct range range, size_t pass, double tolerance,
                       struct fitted_runs *runs)
{
    const struct path_item *item = in->item.item;

    for (size_t i = range.from, end; i < range.to; i = end + 1) {
        for (end = i; end < range.to && is_in_link(&item[end]);)
            end++;
        size_t begin = i > 0 && item[i - 1].kind == PATH_POINT ? i - 1 : i;
        if (end < begin + LINK_POINTS || !is_smooth(in, begin, end, tolerance))
            continue;
        struct fitted_run run = {
            .from = begin, .to = end, .pass = pass, .number = runs->n, .link = true};
        *array_push(runs) = run;
    }
}

/* The runs, and between them the links unless `tolerance` is 0. */
static struct fitted_runs find_runs(const struct path *in, double tolerance)
{
    struct fitted_runs runs = {0};
    size_t at = 0, pass = 0, done = 0;

    for (size_t from = 0, to; path_next_run(in, &from, &to); from = done = to) {
        if (tolerance > 0 && runs.n > 0)
            find_links(in, (struct range){done, from}, pass, tolerance, &runs);
        for (; at < from; at++)
            if (in->item.item[at].kind == PATH_PASS)
                pass = in->item.item[at].index;
        struct fitted_run run = {.from = from, .to = to, .pass = pass, .number = runs.n};
        *array_push(&runs) = run;
    }
    return runs;
}

static void free_run(const struct fitter *fitter, struct fitted_run *run)
{
    path_free(&run->fitted);
    array_free(&run->gouge.left);
    if (fitter->result_free && run->result)
        fitter->result_free(run->result);
    free(run->result);
}

static double length_of(const struct path *in, size_t from, size_t to)
{
    double length = 0;

    for (size_t i = from + 1; i < to; i++)
        length += vec_distance(in->item.item[i - 1].to.p, in->item.item[i].to.p);
    return length;
}

/* Marks the motions next to the places that are too deep, `wide` more on both sides; n motions. */
static void mark_motions(const struct run *points, const struct gouges *gouges, size_t wide,
                         bool *stays)
{
    size_t n = points->n - 1;

    for (size_t k = 0; k < gouges->n; k++) {
        size_t at = run_motion_at(points, 0, n, gouges->item[k].ball);
        for (size_t i = at > wide ? at - wide : 0; i < n && i <= at + wide; i++)
            stays[i] = true;
    }
}

static void fit_part(const struct workload *w, struct fitted_run run, int time);

/* A part of the run that is not fitted yet. */
static struct fitted_run part_of(const struct fitted_run *run, size_t from, size_t to)
{
    return (struct fitted_run){
        .from = from, .to = to, .pass = run->pass, .number = run->number, .link = run->link};
}

/* The run without the motions that stay as they came, part by part; n motions. */
static void fit_others(const struct workload *w, const struct fitted_run *run, bool *stays,
                       size_t n, int time)
{
    size_t from = 0;

    stays[n] = true;
    for (size_t i = 0; i <= n; i++) {
        if (!stays[i])
            continue;
        if (i > from)
            fit_part(w, part_of(run, run->from + from, run->from + i + 1), time);
        from = i + 1;
    }
}

static bool *no_motions(size_t n)
{
    bool *stays = mem_alloc(n + 1, sizeof *stays);

    for (size_t i = 0; i <= n; i++)
        stays[i] = false;
    return stays;
}

/* The run without the motions next to where it is too deep, part by part. */
static void fit_around(const struct workload *w, const struct fitted_run *run, int time)
{
    struct run points = path_run_read(w->request.in, run->from, run->to);
    bool *stays = no_motions(points.n - 1);

    mark_motions(&points, &run->gouge.left, (size_t)time * (size_t)time, stays);
    fit_others(w, run, stays, points.n - 1, time);
    free(stays);
    array_free(&points);
}

/* Marks the motions on which the axis turns while the tracked point stands: a curve that wavers
 * within the tolerance there would tell a control to creep.  False if there are none. */
static bool mark_standing(const struct path *in, const struct fitted_run *run, bool *stays)
{
    bool any = false;

    for (size_t i = run->from; i + 1 < run->to; i++) {
        struct pose a = in->item.item[i].to, b = in->item.item[i + 1].to;
        double turn = vec_angle(a.a, b.a);
        bool stands = turn > STANDING_TURN && vec_distance(a.p, b.p) < STANDING * turn;
        stays[i - run->from] = stands;
        any = any || stands;
    }
    return any;
}

/* Only the shaft or the holder is too deep: not by the ball's way, but by the axis. */
static bool is_by_axis(const struct gouges *gouges)
{
    for (size_t i = 0; i < gouges->n; i++)
        if (gouges->item[i].part == TOOL_BALL)
            return false;
    return true;
}

/* Marks the motions of a link on which the axis turns so near the pole of Z that the least change
 * of it would turn a rotary axis far: what was planned for it there stays.  False if there are
 * none. */
static bool mark_pole(const struct path *in, const struct fitted_run *run, bool *stays)
{
    bool any = false;

    for (size_t i = run->from; i + 1 < run->to; i++) {
        struct vec3 a = in->item.item[i].to.a, b = in->item.item[i + 1].to.a;
        bool near = vec_distance(a, b) > 0 && fmin(hypot(a.x, a.y), hypot(b.x, b.y)) < BESIDE_POLE;
        stays[i - run->from] = stays[i - run->from] || near;
        any = any || near;
    }
    return any;
}

/* Fits a run, or a part of one, and what it takes for it to be clear, into the parts of its run. */
static void fit_part(const struct workload *w, struct fitted_run run, int time)
{
    struct fit_request request = w->request;

    if (time > 0 && (run.to - run.from < 3 || length_of(request.in, run.from, run.to) < SHORTEST ||
                     time == TIMES))
        return; /* as it came */
    for (;;) {
        struct run points = path_run_read(request.in, run.from, run.to);
        run.result = mem_alloc(1, w->fitter->result_size);
        w->fitter->fit(w->fitter->settings, &request, &points, &run);
        array_free(&points);
        bool again = run.gouge.deepest.depth > 0 && !w->fitter->options->paper && time < TIMES;
        if (!again) {
            *array_push(&w->fitted[run.number]) = run;
            return;
        }
        bool by_axis = is_by_axis(&run.gouge.left) && request.axis_share > LESS_AXIS / 2;
        request.axis_share *= LESS_AXIS;
        if (!by_axis)
            fit_around(w, &run, time + 1);
        free_run(w->fitter, &run);
        if (!by_axis)
            return;
        run = part_of(&run, run.from, run.to);
    }
}

static void fit_runs(void *context, size_t from, size_t to)
{
    const struct workload *w = context;

    for (size_t i = from; i < to; i++) {
        const struct fitted_run *run = &w->runs->item[i];
        size_t n = run->to - run->from - 1;
        bool *stays = no_motions(n);
        bool any = !w->fitter->options->paper && mark_standing(w->request.in, run, stays);
        if (run->link && mark_pole(w->request.in, run, stays))
            any = true;
        if (any)
            fit_others(w, run, stays, n, 1);
        else
            fit_part(w, *run, 0);
        free(stays);
    }
}

/* Leaves the runs that are in the range, numbered anew. */
static void keep_runs(struct fitted_runs *runs, struct range range)
{
    size_t n = 0;

    for (size_t i = 0; i < runs->n; i++) {
        if (runs->item[i].from < range.from || runs->item[i].from >= range.to)
            continue;
        runs->item[n] = runs->item[i];
        runs->item[n].number = n;
        n++;
    }
    runs->n = n;
}

/* All runs of the range fitted, in parts where it takes that.  How much work each may be depends on
 * the whole path. */
static struct fitted_runs fit_all(const struct fitter *fitter, const struct path *in,
                                  struct range range, const struct gouge_refit_options *gouge,
                                  int threads)
{
    const struct fitter_options *options = fitter->options;
    bool links = gouge->guard && !options->paper && !options->links_stay;
    struct fitted_runs runs = find_runs(in, links ? options->tolerance : 0), all = {0};
    double points = 1;

    for (size_t i = 0; i < runs.n; i++)
        points += runs.item[i].link ? 0 : (double)(runs.item[i].to - runs.item[i].from);
    keep_runs(&runs, range);
    struct fit_request request = {
        .gouge = gouge, .in = in, .axis_share = 1, .work = fmin(1, USUAL_POINTS / points)};
    struct workload workload = {fitter, request, &runs,
                                mem_alloc(runs.n + 1, sizeof(struct fitted_runs))};
    for (size_t i = 0; i < runs.n; i++)
        workload.fitted[i] = (struct fitted_runs){0};
    parallel_shown("fitting", threads, runs.n, fit_runs, &workload);
    for (size_t i = 0; i < runs.n; i++) {
        for (size_t k = 0; k < workload.fitted[i].n; k++)
            *array_push(&all) = workload.fitted[i].item[k];
        array_free(&workload.fitted[i]);
    }
    free(workload.fitted);
    array_free(&runs);
    return all;
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
        free_run(fitter, &runs->item[i]);
    array_free(runs);
}

static int read_path(const struct fitter *fitter, const char *file, struct path *in,
                     struct error *error)
{
    if (path_read(file, in, error) < 0)
        return -1;
    for (size_t i = 0; i < in->unknown.n; i++)
        say("%s:%u: unknown word %s, copied", in->name, in->unknown.item[i].line,
            in->unknown.item[i].word);
    if (fitter->prepare(fitter->settings, in, error) < 0)
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

int fitter_run(const struct fitter *fitter, const struct cli *cli, struct error *error)
{
    const struct fitter_options *options = fitter->options;
    struct gouge_refit_options gouge = {0};
    struct path in = {0};

    if (read_path(fitter, cli->file[0], &in, error) < 0 ||
        gouge_options_read(&options->gouge, &in, options->paper, options->tolerance, cli->threads,
                           &gouge, error) < 0) {
        path_free(&in);
        return -1;
    }
    struct range range = range_of(options->part, &in);
    struct fitted_runs runs = fit_all(fitter, &in, range, &gouge, cli->threads);
    double lift = 0;
    for (size_t i = 0; i < runs.n; i++)
        lift = fmax(lift, runs.item[i].gouge.lift);

    struct ranges clear = {0};
    struct path out = assemble(fitter, &in, &runs, range, &clear);
    struct unmets unmet = {0};
    fitter->report(fitter->settings, &in, &runs, &unmet);
    struct path_check check = {.tool = gouge, .threads = cli->threads};
    check_path(&check, &in, range, &out, &clear);
    array_free(&clear);
    if (lift > 0)
        note("points lifted by at most %.4f mm where motions went too deep between them", lift);
    path_check_conclude(&check, &unmet);
    write_path(cli->output, &out, options->part, &unmet);
    int status = unmets_status(&unmet);
    unmets_free(&unmet);
    gouge_refit_free(&gouge);
    free_runs(fitter, &runs);
    path_free(&in);
    path_free(&out);
    return status;
}
