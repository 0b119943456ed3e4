/*
 * gouge_options - the scan that the motions fitted to a path are kept clear of: the options -g and
 * --noise of the fitters.
 */
#ifndef CLOUDMILL_GOUGE_OPTIONS_H
#define CLOUDMILL_GOUGE_OPTIONS_H

#include "base/cli.h"
#include "io/path/path.h"
#include "gouge/gouge_refit.h"

struct gouge_options {
    struct cli_list files; /* none: nothing is kept clear of */
    double noise;          /* of the scan, mm; negative: as found (guard_read.h) */
    double effort;         /* effort.h */
    struct gouge_refit_options rule;

    /* What came of it, over all runs. */
    double lift; /* of points, at most, mm */
    size_t left; /* runs that still go too deep */
    struct gouge deepest;
    size_t pass; /* in which */
};

/* Reads the scan, in the coordinates of the path, for a ball that may go `tolerance` mm deep, as
 * densely as the path's maker did (by the last entry of its ledger, within a tenth and four times
 * that tolerance).  -1 also when the path has no ball cutter, or is clearly elsewhere. */
int gouge_options_read(struct gouge_options *guard, const struct path *path, double tolerance,
                       int threads, struct error *error);

/* Adds what became of the run that begins with this item of the path. */
void gouge_options_add(struct gouge_options *guard, const struct path *path, size_t item,
                       const struct gouge_refit_result *result);

/* Adds the straight motions at feed that belong to no run and are carried through as they are. */
void gouge_options_carried(struct gouge_options *guard, const struct path *path);

/* Says what does not hold; the tool's exit status, EXIT_DONE or EXIT_UNMET. */
int gouge_options_conclude(const struct gouge_options *guard);

void gouge_options_free(struct gouge_options *guard);

#endif
