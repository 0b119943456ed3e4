/*
 * spline_guard - a cutting run as B-splines that keep the ball clear of the part.
 */
#ifndef CLOUDMILL_SPLINE_GUARD_H
#define CLOUDMILL_SPLINE_GUARD_H

#include "gouge/gouge_refit.h"
#include "splinefit/spline_run.h"

struct spline_guard {
    struct gouge_refit_options rule; /* without a guard, nothing is kept clear of */
    bool paper;                      /* as published (spline_run.h) */
    struct splinefit_options fit;
};

/*
 * Fits the run (spline_run_fit; the ball's centre is tracked with rule.centre) and has its points
 * lifted where the curves go too deep (gouge_refit_fit).  Where that does not help, as at an end,
 * which stays, or where the path climbs a wall, the curve gives way to the straight line between
 * the two points next to the place, which are what was checked before.  With `paper` what goes too
 * deep is only told.  Frees what *pieces held.  The run's points are those that were lifted then.
 */
struct gouge_refit_result spline_guard_fit(const struct spline_guard *guard, struct run *run,
                                           struct spline_run *pieces);

#endif
