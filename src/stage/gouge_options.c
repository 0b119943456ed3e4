/* gouge_options - see gouge_options.h. */
#include "stage/gouge_options.h"

#include <stdlib.h>

#include "io/path/path_run.h"
#include "guard_read.h"

/* Where the ball is at the points of all runs. */
static struct vec3s balls_of(const struct path *path)
{
    struct vec3s ball = {0};

    for (size_t from = 0, to; path_next_run(path, &from, &to); from = to) {
        struct run run = path_run_read(path, from, to);
        for (size_t i = 0; i < run.n; i++)
            *array_push(&ball) = run.item[i].ball;
        array_free(&run);
    }
    return ball;
}

/* The tolerance that the scan is looked at with: the one that the path was made with, unless it is
 * far from the fitter's, so that what stands for the scan between its points is the same. */
static double scan_tolerance(const struct path *path, double tolerance)
{
    const double closest = 0.1, widest = 4; /* of the fitter's */
    size_t n = path->head.ledger.n;
    double made = n > 0 ? path->head.ledger.item[n - 1].spent : tolerance;

    return fmin(fmax(made, closest * tolerance), widest * tolerance);
}

int gouge_options_read(const struct gouge_options *options, const struct path *path,
                       double tolerance, int threads, struct gouge_refit_options *refit,
                       struct error *error)
{
    struct guard_read_options scan = {.radius = path_ball(path),
                                      .tolerance = scan_tolerance(path, tolerance),
                                      .noise = options->noise,
                                      .effort = options->effort,
                                      .threads = threads};

    *refit = (struct gouge_refit_options){
        .radius = scan.radius, .tolerance = tolerance, .centre = path->head.track == TRACK_CENTRE};
    if (options->files.n == 0)
        return 0;
    if (!(scan.radius > 0) || path->head.track == TRACK_CONTACT)
        return error_at(error, path->name, 0,
                        "found no path of a ball cutter, expected one to guard by a scan");
    struct vec3s ball = balls_of(path);
    refit->guard = guard_read_points(&options->files, &ball, 3 * scan.radius, &scan, error);
    array_free(&ball);
    array_free(&scan.certain);
    array_free(&scan.doubtful);
    return refit->guard ? 0 : -1;
}

/* The last pass that begins before the item. */
static size_t pass_of(const struct path *path, size_t item)
{
    for (size_t i = item; i-- > 0;)
        if (path->item.item[i].kind == PATH_PASS)
            return path->item.item[i].index;
    return 0;
}

void gouge_summary_add(struct gouge_summary *summary, size_t pass,
                       const struct gouge_refit_result *result)
{
    summary->lift = fmax(summary->lift, result->lift);
    summary->left += result->deepest.depth > 0;
    if (result->deepest.depth > summary->deepest.depth) {
        summary->deepest = result->deepest;
        summary->pass = pass;
    }
}

/* Adds the motions that lead to the items [from, to). */
static void add_motions_to(struct gouge_summary *summary, const struct gouge_refit_options *refit,
                           const struct path *path, size_t from, size_t to)
{
    struct gouge_refit_result result = {.lift = 0};
    struct gouges gouges = {0};

    for (size_t i = from > 0 ? from : 1; i < to; i++) {
        const struct path_item *item = &path->item.item[i], *before = item - 1;
        if (item->kind != PATH_POINT || item->rapid)
            continue;
        while (before > path->item.item && !path_moves(before))
            before--;
        if (!path_moves(before))
            continue;
        struct motion line = motion_line(before->to, item->to);
        gouge_refit_motion(refit, &line, &gouges);
    }
    result.deepest = gouge_refit_beyond(refit, &gouges);
    gouge_summary_add(summary, pass_of(path, from), &result);
    array_free(&gouges);
}

void gouge_summary_add_carried(struct gouge_summary *summary,
                               const struct gouge_refit_options *refit, const struct path *path)
{
    size_t at = 0, from = 0, to;

    if (!refit->guard)
        return;
    for (; path_next_run(path, &from, &to); from = at = to)
        add_motions_to(summary, refit, path, at, from + 1);
    add_motions_to(summary, refit, path, at, path->item.n);
}

int gouge_summary_conclude(const struct gouge_summary *summary,
                           const struct gouge_refit_options *refit)
{
    struct vec3 at = summary->deepest.ball;

    if (summary->lift > 0)
        note("points lifted by at most %.4f mm where motions went too deep between them",
             summary->lift);
    if (summary->left == 0)
        return EXIT_DONE;
    say("in %zu runs the ball goes deeper than %g mm into the scan, in pass %zu %.4f mm with its "
        "centre at %.3f %.3f %.3f",
        summary->left, refit->tolerance, summary->pass, summary->deepest.depth, at.x, at.y, at.z);
    return EXIT_UNMET;
}
