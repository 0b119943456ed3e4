/*
 * path_judged - what who judges a program by the points takes for left of what a path leaves
 * (coverage_judge.h).
 *
 * Scallop and the tolerances of all stages may be left, so that what is left depends on the stages
 * to come: by a larger limit fewer points are asked for.  A path is judged as STAGES (of noisy
 * points one less) with as much tolerance each may leave it, and as it is, where it becomes a
 * program at once; as it is by twice the share, for most paths get a fitter.
 * What is left only if no edge goes on that no point tells of is no more known to be within reach
 * than not: as many such points may be as others.  Lengths in mm.
 */
#ifndef CLOUDMILL_PATH_JUDGED_H
#define CLOUDMILL_PATH_JUDGED_H

#include "stage/path_coverage.h"

enum { STAGES = 2 };

struct path_judged {
    double limit;                /* so much may be left */
    size_t left;                 /* points that are, though within reach */
    size_t n;                    /* of those out of reach or kept off who judges takes for it ... */
    size_t unseen;               /* ... of those, only since no point tells of an edge ... */
    struct coverage_point worst; /* ... what is on one of them */
    bool more;                   /* all together: more than path_options.left_share */
    bool much; /* and without those unseen, or all together more than twice that */
};

struct path_verdicts {
    struct path_judged worse; /* by the limit that takes more for left */
    struct path_judged as_is; /* .much: by more than the share, and no more than twice that: what a
                                 fitter's tolerance makes up for; its `worst` is not filled */
};

/* Of n points that are judged left by the path as many may be judged so by its program. */
size_t path_judged_most(size_t n);

/* `place`: all that is in the way, as of coverage_judge_left; of a scan where its points are. */
struct path_verdicts path_judged(const struct path_coverage *c, const struct vec3s *place);

#endif
