/*
 * arcrun_part - one smooth part of a run as few arcs and lines, proven on the digits that are
 * printed.
 *
 * It is fitted within less and less of the tolerance until the printed digits keep all of it, from
 * both ends, with a longer search where its points are smooth and dense; or, where it was fitted
 * before and few of its points have moved, in the windows about these alone.
 */
#ifndef CLOUDMILL_ARCRUN_PART_H
#define CLOUDMILL_ARCRUN_PART_H

#include "arcprint.h"
#include "stage/arcrun.h"

/* The work on one part; pieces and printed are for the caller to free. */
struct arcrun_work {
    const struct arcrun_options *options;
    const struct run *dense;
    size_t first; /* point of the dense run at which the reference begins */
    struct reference reference;
    struct pieces pieces;
    struct printeds printed;
    struct deviation worst;
};

/* So little of the usual work is to be done that a run is fitted in a hurry. */
bool arcrun_part_hurried(const struct arcrun_options *options);

/* Pieces of the reference within the tolerance, mm, printed.  `before`: the part as it was, or
 * NULL, of which `now` are the points. */
void arcrun_part_fit(struct arcrun_work *f, double tolerance, const struct arcrun_part *before,
                     const struct run *now);

/* A biarc for each interval between the given points of the run, however far it is off, printed. */
void arcrun_part_each(struct arcrun_work *f, const struct run *run, struct arcrun_report *report);

#endif
