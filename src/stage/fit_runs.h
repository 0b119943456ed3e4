/*
 * fit_runs - the runs of a path, and the links between them, found and fitted: what a fitter
 * (stage/fitter.h) does with a path, or with as much of it as has been read.
 */
#ifndef CLOUDMILL_FIT_RUNS_H
#define CLOUDMILL_FIT_RUNS_H

#include "stage/fitter.h"

/* A part of the path: items [from, to). */
struct range {
    size_t from, to;
};

struct ranges {
    size_t n, cap;
    struct range *item;
};

/* How far the runs of a path are found. */
struct run_finder {
    double tolerance; /* of the fits, mm: links that lead round smoothly are found too; 0: none */
    size_t at, done;  /* items whose passes are known; up to the end of the last run */
    size_t pass;      /* that began last before there */
    size_t found;     /* runs, without the links */
};

/* Appends the runs of the path's items so far, with the links between them, as if the path ended
 * here: where a pass begins after them, or at its end.  Each is numbered by its place. */
void run_finder_look(struct run_finder *finder, const struct path *in, struct fitted_runs *runs);

/* Fits the runs, each numbered by its place, in parts where it takes that, and appends the parts in
 * the order of the path. */
void fit_runs(const struct fitter *fitter, const struct fit_request *request,
              const struct fitted_runs *runs, int threads, struct fitted_runs *all);

void fitted_run_free(const struct fitter *fitter, struct fitted_run *run);

#endif
