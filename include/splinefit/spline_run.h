/*
 * spline_run - a cutting run as B-splines: split at its corners, made dense, fitted (splinefit.h),
 * and kept clear of the part (gouge_refit.h).
 */
#ifndef CLOUDMILL_SPLINE_RUN_H
#define CLOUDMILL_SPLINE_RUN_H

#include "curve/motion.h"
#include "curve/run.h"
#include "gouge/gouge_refit.h"
#include "splinefit/splinefit.h"

struct spline_run_options {
    bool centre;           /* the ball's centre is programmed, not the tip */
    bool paper;            /* as published: the run as one piece, as it is (splinefit_paper) */
    bool through;          /* through all points (splinefit_through), with ... */
    enum spline_ends ends; /* ... these ends of each piece */
    struct splinefit_options fit;
};

struct spline_run_piece {
    size_t from, to; /* its first and last point in the run */
    bool still;      /* all its points are in one place: there is no curve */
    struct splinefit fit;
    struct gouges gouges;  /* where it goes too deep, as long as ... */
    bool swept;            /* ... it is the curve that was held against the guard */
    double smooth;         /* part of the tolerance that went into making the data dense, mm */
    struct poses fallback; /* straight pieces within SPLINE_FALLBACK of the curve, without its
                              start */
};

struct spline_run {
    size_t n, cap;
    struct spline_run_piece *item;
    struct run fitted; /* the points that they were fitted to; owned */
};

/*
 * Fills *pieces with those of a run of at least 2 points.
 *
 * Unless `paper` is set, the run is split where the path turns by more than 60 degrees, in one
 * point and over SPLINE_CORNER (so that noise makes no corners).  Where straight lines between the
 * points would leave the smooth path (run_densify) by more than SPLINE_SPARSE, the curve follows
 * the smooth path, sampled to SPLINE_DENSE, and keeps the rest; but not where the axis is fixed and
 * every tenth point turns by more than 30 degrees, which is noise.  A piece that has no curve
 * within the tolerance (splinefit.h, SPLINEFIT_POLYLINE) is divided, so that but a few lines stay.
 */
void spline_run_fit(const struct run *run, const struct spline_run_options *options,
                    struct spline_run *pieces);

/*
 * The same after some of the run's points were moved a little: pieces end where they did, unless
 * one has no curve now; one whose points all stay is kept as it is, and the curves of the others
 * are moved (splinefit_again).
 */
void spline_run_refit(const struct run *run, const struct spline_run_options *options,
                      struct spline_run *pieces);

/*
 * Fits the run and has its points lifted where the curves go too deep (gouge_refit_fit).  Where
 * that does not help, as at an end, which stays, or where the path climbs a wall, the curve gives
 * way to the straight line between the two points next to the place, which are what was checked
 * before, as long as no piece gets too short for a control by it.  With `paper` what goes too deep
 * is only reported.  Frees what *pieces held; the run's points are those that were lifted then.
 */
struct gouge_refit_result spline_run_fit_guarded(struct run *run,
                                                 const struct spline_run_options *options,
                                                 const struct gouge_refit_options *gouge,
                                                 struct spline_run *pieces);

void spline_run_free(struct spline_run *pieces);

#endif
