/* fit_ahead - see fit_ahead.h. */
#include "fit_ahead.h"

#include <stdlib.h>

#include "base/aside.h"
#include "math/elementary.h"

/* So many points get the usual work each, more share it. */
static const double USUAL_POINTS = 12000;

/* That the end of an unguarded flute may be off. */
static const double TOLERANCES = 2;

/* Passes that are complete: a copy of their items, so that the path can grow meanwhile. */
struct chunk {
    struct fit_ahead *ahead;
    struct path path;        /* its head lies in fit_ahead.head */
    size_t from;             /* item of the whole path that is its first */
    struct fitted_runs runs; /* by its own items */
    bool first;
};

struct fit_ahead {
    const struct fitter *fitter;
    int threads;
    struct aside *aside; /* NULL: nothing was begun */
    bool off;            /* nothing is to be begun */
    bool given;          /* some runs were given away */
    struct run_finder finder;
    struct fitted_runs found; /* and not given away, by the items of the path */

    /* What the other thread makes of it; ours once it has ended. */
    struct path head; /* without items */
    size_t said;      /* what was unmet in it before */
    double work;
    double axis_share; /* of the axis tolerance that may be used */
    struct gouge_refit_options gouge;
    struct guard_scan *scan;
    struct fitted_runs fitted; /* by the items of the whole path */
    int result;                /* of reading the scan */
    struct error error;
};

/* Links are fitted where a scan guards them. */
static double link_tolerance(const struct fit_ahead *a)
{
    const struct fitter_options *o = a->fitter->options;

    return o->paper || o->links_stay ? 0 : o->tolerance;
}

/* Leaves those that the range begins, without the links if there is no guard, numbered anew. */
static void keep_runs(struct fitted_runs *runs, struct range range, bool guarded)
{
    size_t n = 0;

    for (size_t i = 0; i < runs->n; i++) {
        const struct fitted_run *run = &runs->item[i];
        if (run->from < range.from || run->from >= range.to || (run->link && !guarded))
            continue;
        runs->item[n] = *run;
        runs->item[n].number = n;
        n++;
    }
    runs->n = n;
}

struct fit_ahead *fit_ahead_new(const struct fitter *fitter, int threads)
{
    struct fit_ahead *a = mem_alloc(1, sizeof *a);

    *a = (struct fit_ahead){.fitter = fitter, .threads = threads};
    a->off = fitter->whole || fitter->options->part_text;
    return a;
}

bool fit_ahead_began(const struct fit_ahead *a)
{
    return a->aside != NULL;
}

/*
 * The axis may be off by a degree where a guard looks at what flute and holder do.  Without one
 * nothing does, and the tool may stand beside a wall: then its flute's end is off by no more than
 * the tolerances of the fit and of the path.
 */
static void find_axis_share(struct fit_ahead *a, const struct path *path)
{
    const struct fitter_options *o = a->fitter->options;
    double flute = path->head.body.flute;

    a->axis_share = 1;
    if (!a->gouge.guard && !o->angle_given && !o->paper && path->head.body_given && flute > 0)
        a->axis_share = fmin(1, TOLERANCES * o->tolerance / (flute * RADIANS(o->angle)));
}

static void read_scan(void *context)
{
    struct fit_ahead *a = context;
    const struct fitter_options *o = a->fitter->options;

    a->result = gouge_options_begin(&o->gouge, &a->head, o->paper, o->tolerance, a->threads,
                                    &a->gouge, &a->scan, &a->error);
    find_axis_share(a, &a->head);
}

/* The runs from the first on, by items that begin at `now` where they began at `was`. */
static void move_runs(struct fitted_runs *runs, size_t first, size_t was, size_t now)
{
    for (size_t i = first; i < runs->n; i++) {
        runs->item[i].from = runs->item[i].from - was + now;
        runs->item[i].to = runs->item[i].to - was + now;
    }
}

static struct fit_request request_of(const struct fit_ahead *a, const struct path *in)
{
    return (struct fit_request){
        .gouge = &a->gouge, .in = in, .axis_share = a->axis_share, .work = a->work};
}

static void free_chunk(struct chunk *c)
{
    c->path.head = (struct path_head){0};
    path_free(&c->path);
    array_free(&c->runs);
    free(c);
}

static void fit_chunk(void *context)
{
    struct chunk *c = context;
    struct fit_ahead *a = c->ahead;
    size_t n = a->fitted.n;

    c->path.head = a->head.head;
    keep_runs(&c->runs, (struct range){0, c->path.item.n}, a->gouge.guard);
    if (a->result == 0) {
        struct fit_request request = request_of(a, &c->path);
        if (c->first)
            note("fitting begins while the path is read, with %zu run%s", c->runs.n,
                 c->runs.n == 1 ? "" : "s");
        fit_runs(a->fitter, &request, &c->runs, a->threads, &a->fitted);
        move_runs(&a->fitted, n, 0, c->from);
    }
    free_chunk(c);
}

/* What each run may be of the usual work. */
static double share_of_work(const struct fit_ahead *a, double points)
{
    double usual = a->fitter->options->gouge.effort * USUAL_POINTS;

    if (points > usual)
        note("%.0f points, more than %.0f: a shorter search for each; --effort %g searches as long "
             "as for few",
             points, usual, ceil(points / USUAL_POINTS));
    return points > usual ? usual / points : 1;
}

/* What the head promises is enough to begin. */
static void begin(struct fit_ahead *a, const struct path *path)
{
    a->off = a->off || path->head.runs.points == 0 || path->head.track == TRACK_CONTACT;
    if (a->off)
        return;
    a->head.name = path->name;
    path_head_copy(&a->head.head, &path->head);
    a->said = a->head.head.unmet.n;
    a->off = a->fitter->prepare(a->fitter->settings, &a->head, &a->error) != 0;
    if (a->off)
        return;
    a->aside = aside_begin(a->threads);
    a->work = share_of_work(a, (double)path->head.runs.points);
    a->finder.tolerance = link_tolerance(a);
    aside_add(a->aside, read_scan, a);
}

/* Gives away the runs that were found. */
static void give(struct fit_ahead *a, const struct path *path)
{
    struct chunk *c = mem_alloc(1, sizeof *c);
    size_t from = path->item.n, to = 0;

    for (size_t i = 0; i < a->found.n; i++) {
        from = a->found.item[i].from < from ? a->found.item[i].from : from;
        to = a->found.item[i].to > to ? a->found.item[i].to : to;
    }
    *c = (struct chunk){.ahead = a, .from = from, .runs = a->found, .first = !a->given};
    c->path.name = path->name;
    path_add_items(&c->path, path, from, to);
    move_runs(&c->runs, 0, from, 0);
    a->found = (struct fitted_runs){0};
    a->given = true;
    aside_add(a->aside, fit_chunk, c);
}

static void hear_pass(void *context, const struct path *path)
{
    struct fit_ahead *a = context;

    if (!a->off && !a->aside)
        begin(a, path);
    if (!a->aside || path->contact.n == 0)
        return; /* which points are runs is not known yet */
    run_finder_look(&a->finder, path, &a->found);
    if (a->found.n > 0 && !aside_is_full(a->aside))
        give(a, path);
}

struct path_listener fit_ahead_listener(struct fit_ahead *a)
{
    return (struct path_listener){hear_pass, a};
}

/* How much work each run may be depends on the whole path. */
static double work_of(const struct fit_ahead *a, const struct path *in)
{
    const struct fitted_runs *runs = &a->found;
    double points = (double)in->head.runs.points;

    for (size_t i = 0; i < runs->n && in->head.runs.points == 0; i++)
        points += runs->item[i].link ? 0 : (double)(runs->item[i].to - runs->item[i].from);
    return share_of_work(a, points);
}

/* Reads the scan, or takes over what was made of it. */
static int take_scan(struct fit_ahead *a, struct path *in, struct error *error)
{
    const struct fitter_options *o = a->fitter->options;

    if (!a->aside) {
        int result = gouge_options_begin(&o->gouge, in, o->paper, o->tolerance, a->threads,
                                         &a->gouge, &a->scan, error);
        find_axis_share(a, in);
        return result;
    }
    aside_end(a->aside);
    if (a->result != 0) {
        *error = a->error;
        return -1;
    }
    scan_sources_free(&in->head.scan);
    in->head.scan = scan_sources_copy(&a->head.head.scan);
    for (size_t i = a->said; i < a->head.head.unmet.n; i++)
        unmets_add(&in->head.unmet, a->head.head.unmet.item[i].stage,
                   a->head.head.unmet.item[i].text);
    return 0;
}

int fit_ahead_rest(struct fit_ahead *a, struct path *in, struct range range,
                   struct gouge_refit_options *gouge, struct fitted_runs *runs, struct error *error)
{
    bool began = a->aside != NULL;
    int result = take_scan(a, in, error);

    a->aside = NULL;
    if (result == 0) {
        result = gouge_options_check(a->scan, in, a->threads, error);
        a->scan = NULL;
    }
    if (result != 0)
        return -1;
    if (!began)
        a->finder.tolerance = a->gouge.guard ? link_tolerance(a) : 0;
    run_finder_look(&a->finder, in, &a->found);
    if (!began)
        a->work = work_of(a, in);
    keep_runs(&a->found, range, a->gouge.guard);
    struct fit_request request = request_of(a, in);
    fit_runs(a->fitter, &request, &a->found, a->threads, &a->fitted);
    *gouge = a->gouge;
    *runs = a->fitted;
    a->gouge = (struct gouge_refit_options){0};
    a->fitted = (struct fitted_runs){0};
    return 0;
}

void fit_ahead_free(struct fit_ahead *a)
{
    if (a->aside) {
        struct chunk *left = aside_drop(a->aside);
        if (left && (void *)left != (void *)a) /* no reading of the scan */
            free_chunk(left);
        aside_end(a->aside);
    }
    gouge_options_drop(a->scan);
    gouge_refit_free(&a->gouge);
    for (size_t i = 0; i < a->fitted.n; i++)
        fitted_run_free(a->fitter, &a->fitted.item[i]);
    array_free(&a->fitted);
    array_free(&a->found);
    path_free(&a->head);
    free(a);
}
