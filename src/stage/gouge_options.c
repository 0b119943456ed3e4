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
