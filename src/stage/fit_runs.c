/* fit_runs - see fit_runs.h. */
#include "fit_runs.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/parallel.h"
#include "io/path/path_run.h"

static const double BESIDE_POLE = RADIANS(2);

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

/* Appends the links among the items of the range, each with the point it begins at. */
static void find_links(const struct path *in, struct range range, size_t pass, double tolerance,
                       struct fitted_runs *runs)
{
    const struct path_item *item = in->item.item;

    for (size_t i = range.from, end; i < range.to; i = end + 1) {
        for (end = i; end < range.to && is_in_link(&item[end]);)
            end++;
        size_t begin = i > 0 && item[i - 1].kind == PATH_POINT ? i - 1 : i;
        if (end < begin + LINK_POINTS)
            continue;
        struct fitted_run run = {.from = begin,
                                 .to = end,
                                 .pass = pass,
                                 .number = runs->n,
                                 .link = true,
                                 .rough = !is_smooth(in, begin, end, tolerance),
                                 .leave = path_run_direction(in, begin, true),
                                 .arrive = path_run_direction(in, end - 1, false),
                                 .out = {path_run_normal(in, begin), path_run_normal(in, end - 1)}};
        *array_push(runs) = run;
    }
}

void run_finder_look(struct run_finder *f, const struct path *in, struct fitted_runs *runs)
{
    for (size_t from = f->done, to; path_next_run(in, &from, &to); from = f->done = to) {
        if (f->tolerance > 0 && f->found > 0)
            find_links(in, (struct range){f->done, from}, f->pass, f->tolerance, runs);
        for (; f->at < from; f->at++)
            if (in->item.item[f->at].kind == PATH_PASS)
                f->pass = in->item.item[f->at].index;
        struct fitted_run run = {.from = from, .to = to, .pass = f->pass, .number = runs->n};
        *array_push(runs) = run;
        f->found++;
    }
}

void fitted_run_free(const struct fitter *fitter, struct fitted_run *run)
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
static struct fitted_run part_of(const struct path *in, const struct fitted_run *run, size_t from,
                                 size_t to)
{
    struct fitted_run part = {.from = from,
                              .to = to,
                              .pass = run->pass,
                              .number = run->number,
                              .link = run->link,
                              .rough = run->rough};

    part.out[0] = run->out[0];
    part.out[1] = run->out[1];
    part.leave = from > run->from ? path_run_direction(in, from, true) : run->leave;
    part.arrive = to < run->to ? path_run_direction(in, to - 1, false) : run->arrive;
    return part;
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
            fit_part(w, part_of(w->request.in, run, run->from + from, run->from + i + 1), time);
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
        points.edges = !request.gouge->guard && !w->fitter->options->paper;
        run.result = mem_alloc(1, w->fitter->result_size);
        w->fitter->fit(w->fitter->settings, &request, &points, &run);
        array_free(&points);
        if (run.stays) {
            fitted_run_free(w->fitter, &run);
            return;
        }
        bool again = run.gouge.deepest.depth > 0 && !w->fitter->options->paper && time < TIMES;
        if (!again) {
            *array_push(&w->fitted[run.number]) = run;
            return;
        }
        bool by_axis = is_by_axis(&run.gouge.left) && request.axis_share > LESS_AXIS / 2;
        request.axis_share *= LESS_AXIS;
        if (!by_axis)
            fit_around(w, &run, time + 1);
        fitted_run_free(w->fitter, &run);
        if (!by_axis)
            return;
        run = part_of(w->request.in, &run, run.from, run.to);
    }
}

static void fit_some(void *context, size_t from, size_t to)
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

void fit_runs(const struct fitter *fitter, const struct fit_request *request,
              const struct fitted_runs *runs, int threads, struct fitted_runs *all)
{
    struct workload workload = {fitter, *request, runs,
                                mem_alloc(runs->n + 1, sizeof(struct fitted_runs))};

    for (size_t i = 0; i < runs->n; i++)
        workload.fitted[i] = (struct fitted_runs){0};
    parallel_shown("fitting", threads, runs->n, fit_some, &workload);
    for (size_t i = 0; i < runs->n; i++) {
        for (size_t k = 0; k < workload.fitted[i].n; k++)
            *array_push(all) = workload.fitted[i].item[k];
        array_free(&workload.fitted[i]);
    }
    free(workload.fitted);
}
