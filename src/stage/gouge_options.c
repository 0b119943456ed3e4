/* gouge_options - see gouge_options.h. */
#include "stage/gouge_options.h"

#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
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

double gouge_made_within(const struct path *path)
{
    for (size_t i = 0; i < path->head.ledger.n; i++) {
        const char *stage = path->head.ledger.item[i].stage;
        if (strcmp(stage, "meshnorm") == 0 || strcmp(stage, "planecut") == 0)
            return path->head.ledger.item[i].spent;
    }
    return 0;
}

/* The tolerance that the scan is looked at with: the one that the path was made with, unless it is
 * very far from the fitter's, so that what stands for the scan between its points is the same: by
 * another look rims are elsewhere, by more than either tolerance.  A path that does not say it is
 * taken to be made with what its last stage spent, which may have lifts in it. */
static double scan_tolerance(const struct path *path, double tolerance)
{
    const double closest = 0.01, wide = 4, widest = 100; /* of the fitter's */
    size_t n = path->head.ledger.n;
    double made = gouge_made_within(path), most = widest;

    if (!(made > 0)) {
        made = n > 0 ? path->head.ledger.item[n - 1].spent : tolerance;
        most = wide;
    }
    return fmin(fmax(made, closest * tolerance), most * tolerance);
}

/* The scan that guards; with --paper only that of -g. */
static int find_scan(const struct gouge_options *options, struct path *path, bool paper,
                     struct guard_scan *scan, struct error *error)
{
    const struct scan_sources none = {.placed = path->head.scan.placed,
                                      .place = path->head.scan.place};

    if (guard_scan_read(&options->scan, paper ? &none : &path->head.scan, path_ball(path),
                        "the path", "what is fitted is not checked", scan, &path->head.unmet,
                        error) != 0)
        return -1;
    if (!paper && !options->scan.none && options->scan.files.n == 0 && path->head.scan.n == 0)
        say("the path names no scan: what is fitted is held against none (-g FILE names one)");
    scan_sources_free(&path->head.scan);
    path->head.scan = scan_sources_copy(&scan->source);
    return 0;
}

/* The noise that the scan is said to have, here or by the path; negative: it is measured. */
static double noise_of(const struct gouge_options *options, const struct path_head *head)
{
    if (options->noise >= 0 || !head->noise_given)
        return options->noise;
    note("noise of the scan: %g mm, as the path says", head->noise);
    return head->noise;
}

int gouge_options_begin(const struct gouge_options *options, struct path *path, bool paper,
                        double tolerance, int threads, struct gouge_refit_options *refit,
                        struct guard_scan **scan, struct error *error)
{
    struct guard_read_options rule = {.radius = path_ball(path),
                                      .tolerance = scan_tolerance(path, tolerance),
                                      .noise = noise_of(options, &path->head),
                                      .effort = options->effort,
                                      .threads = threads};
    bool ball = rule.radius > 0 && path->head.track != TRACK_CONTACT;
    struct guard_scan found = {.point = {0}};

    *scan = NULL;
    *refit = (struct gouge_refit_options){.radius = rule.radius,
                                          .tolerance = tolerance,
                                          .centre = path->head.track == TRACK_CENTRE,
                                          .holder = path_holder(path)};
    if (!ball && options->scan.files.n > 0)
        return error_at(error, path->name, 0,
                        "found no path of a ball cutter, expected one to guard by a scan");
    if (ball && find_scan(options, path, paper, &found, error) != 0)
        return -1;
    if (found.point.n > 0) {
        refit->guard = guard_read_scan(&found, &rule, error);
        array_free(&rule.certain);
        array_free(&rule.doubtful);
        array_free(&rule.curtain);
    }
    *scan = mem_alloc(1, sizeof **scan);
    **scan = found;
    if (found.point.n == 0 || refit->guard)
        return 0;
    gouge_options_drop(*scan);
    *scan = NULL;
    return -1;
}

int gouge_options_check(struct guard_scan *scan, const struct path *path, int threads,
                        struct error *error)
{
    int result = 0;

    if (scan->point.n > 0) {
        struct vec3s place = balls_of(path);
        result = guard_scan_near(scan, &place, "points of the path", 3 * path_ball(path), threads,
                                 error);
        array_free(&place);
    }
    gouge_options_drop(scan);
    return result;
}

void gouge_options_drop(struct guard_scan *scan)
{
    if (scan)
        guard_scan_free(scan);
    free(scan);
}

int gouge_options_read(const struct gouge_options *options, struct path *path, bool paper,
                       double tolerance, int threads, struct gouge_refit_options *refit,
                       struct error *error)
{
    struct guard_scan *scan;

    if (gouge_options_begin(options, path, paper, tolerance, threads, refit, &scan, error) != 0)
        return -1;
    if (gouge_options_check(scan, path, threads, error) == 0)
        return 0;
    gouge_refit_free(refit);
    return -1;
}
