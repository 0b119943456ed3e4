/*
 * arcspline_refit - part of a chain of arcs replaced by another number of arcs, all their joints
 * moved together (arcspline_optimize.h).
 */
#ifndef CLOUDMILL_ARCSPLINE_REFIT_H
#define CLOUDMILL_ARCSPLINE_REFIT_H

#include "arcfit/arcfit.h"

struct arcspline_refit {
    const struct trace *trace;
    const struct arc_deviation *within;
    int digits;                  /* decimals of the joints */
    const struct arc_piece *old; /* what there is: where the part begins and ends, */
    size_t n;                    /* how it is shared out */
    bool start_held, end_held;   /* the direction there stays */
    bool thorough;               /* many spacings of the joints also where the axis turns */
};

/*
 * So many arcs in the place of the old pieces, proven by arc_piece_deviation with rounded joints;
 * what was in `out` goes.  False when none was found that keep within.
 *
 * The joints begin spaced as evenly as the old pieces were.  For one arc fewer with both directions
 * free there are more tries: spaced anew by what each arc is off, and as the old ones without one
 * of them; where the axis turns only when `thorough`.  When that, and a direction is held, the
 * first of these ways too.
 */
bool arcspline_refit_fit(const struct arcspline_refit *part, size_t arcs, struct pieces *out);

#endif
