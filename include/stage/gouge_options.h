/*
 * gouge_options - the scan that the motions fitted to a path are kept clear of: the options -g,
 * --noise and --effort of the fitters.
 */
#ifndef CLOUDMILL_GOUGE_OPTIONS_H
#define CLOUDMILL_GOUGE_OPTIONS_H

#include "base/cli.h"
#include "gouge/gouge_refit.h"
#include "io/path/path.h"

/* Which scan: the files of -g, or the one that the stream names, or with --no-guard none. */
struct guard_choice {
    struct cli_list files;
    bool none;
};

struct gouge_options {
    struct guard_choice scan;
    double noise;  /* of the scan, mm; negative: as found (guard_read.h) */
    double effort; /* base/effort.h */
};

/*
 * Reads the scan, in the coordinates of the path, for a ball that may go `tolerance` mm deep, as
 * densely as the path's maker did (gouge_made_within, from a hundredth to a hundred times that
 * tolerance; else by the last entry of its ledger, up to four times).  *refit owns it:
 * gouge_refit_free; without a scan it has no guard.  The path's head then names the scan that
 * guards.  With `paper` only -g does.  -1 also when the path has no ball cutter, or is clearly
 * elsewhere.
 */
int gouge_options_read(const struct gouge_options *options, struct path *path, bool paper,
                       double tolerance, int threads, struct gouge_refit_options *refit,
                       struct error *error);

/* How deep the tool that made the path from a mesh let it be, mm; 0: the path does not say.  The
 * entry of a fitter has its lifts in it, and says nothing of depth. */
double gouge_made_within(const struct path *path);

/* What is left of a scan, to be held against the path. */
struct guard_scan;

/*
 * The same in two steps, the first for a path of which no more than the head is known: *scan, then
 * to be given to gouge_options_check once with the whole path, which frees it: -1: the path is
 * elsewhere.  After an error *scan is NULL.
 */
int gouge_options_begin(const struct gouge_options *options, struct path *path, bool paper,
                        double tolerance, int threads, struct gouge_refit_options *refit,
                        struct guard_scan **scan, struct error *error);
int gouge_options_check(struct guard_scan *scan, const struct path *path, int threads,
                        struct error *error);

/* Without a look. */
void gouge_options_drop(struct guard_scan *scan);

#endif
