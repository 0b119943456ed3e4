/*
 * fit_ahead - a path's runs fitted while the rest of it is still being read.
 *
 * What a fit must know of the whole path is in its head (RUNS: how many points share the work, and
 * the largest feed; the scan and the tool).  Where the head says it, the scan is made into a guard
 * from the first pass' beginning on, and the passes that are complete are fitted, by another thread
 * (base/aside.h); what was not fitted when the path's end is read is fitted then.  The fits are the
 * same either way.  A path without RUNS, a part of a path (--part), and a fitter that changes the
 * whole path first are read to the end before.
 */
#ifndef CLOUDMILL_FIT_AHEAD_H
#define CLOUDMILL_FIT_AHEAD_H

#include "fit_runs.h"

struct fit_ahead;

/* The fitter must outlive it. */
struct fit_ahead *fit_ahead_new(const struct fitter *fitter, int threads);

/* For path_read_listened. */
struct path_listener fit_ahead_listener(struct fit_ahead *ahead);

/* It has called the fitter's `prepare`. */
bool fit_ahead_began(const struct fit_ahead *ahead);

/*
 * Once the path is read: reads the scan if it is not yet (gouge_options.h), and fits the runs of
 * the range that are left.  *gouge and *runs are all that came of it, in the order of the path;
 * -1, and there is neither, as gouge_options_read.
 */
int fit_ahead_rest(struct fit_ahead *ahead, struct path *in, struct range range,
                   struct gouge_refit_options *gouge, struct fitted_runs *runs,
                   struct error *error);

/* Also while it works, after an error: waits for what is in hand. */
void fit_ahead_free(struct fit_ahead *ahead);

#endif
