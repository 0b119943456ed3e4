/*
 * spline_run - a cutting run as B-splines: parted at its corners, made dense, fitted.
 */
#ifndef CLOUDMILL_SPLINE_RUN_H
#define CLOUDMILL_SPLINE_RUN_H

#include "curve/motion.h"
#include "curve/run.h"
#include "gouge/gouge_refit.h"
#include "splinefit/splinefit.h"

struct spline_run_piece {
    size_t from, to; /* its first and last point in the run */
    bool still;      /* all its points are in one place: there is no curve */
    struct splinefit fit;
    double smooth; /* part of the tolerance that went into making the data dense, mm */
    struct poses
        fallback; /* straight pieces within the tolerance of the curve, without its start */
};

struct spline_run {
    size_t n, cap;
    struct spline_run_piece *item;
    struct run fitted; /* the points that they were fitted to; owned */
};

/*
 * Fills *pieces with those of a run of at least 2 points.  The ball's centre is tracked with
 * `centre`, else the tip.
 *
 * With `paper` the run is one piece, fitted as it is by splinefit_paper.  By default it is parted
 * where the path turns by more than 60 degrees, in one point and over 10 times the tolerance (so
 * that noise makes no corners).  Where straight lines between the points would leave the smooth
 * path (run_densify) by more than the tolerance, the curve follows the smooth path, sampled to a
 * tenth of the tolerance, and keeps the rest; but not where the axis is fixed and every tenth point
 * turns by more than 30 degrees, which is noise.  splinefit_search fits.
 */
void spline_run_fit(const struct run *run, bool centre, bool paper,
                    const struct splinefit_options *options, struct spline_run *pieces);

/*
 * The same after some of the run's points were moved a little: pieces end where they did; one whose
 * points all stay is kept as it is, and the curves of the others are moved (splinefit_again).
 */
void spline_run_refit(const struct run *run, bool centre, bool paper,
                      const struct splinefit_options *options, struct spline_run *pieces);

/*
 * Parts piece k, of more than two points, so that the interval of the run from point i of it to the
 * next one is a piece by itself, and fits what is new.
 */
void spline_run_part(const struct run *run, bool centre, const struct splinefit_options *options,
                     size_t k, size_t i, struct spline_run *pieces);

void spline_run_free(struct spline_run *pieces);

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
