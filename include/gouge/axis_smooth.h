/*
 * axis_smooth - the tool axes along a run turned less than the rule for the axis has them.
 *
 * The ball's centres stay where they are; the tips follow the axes.
 */
#ifndef CLOUDMILL_AXIS_SMOOTH_H
#define CLOUDMILL_AXIS_SMOOTH_H

#include "curve/run.h"

/*
 * The axes that turn least, each no further than `play` radians from where it is: the sum of the
 * squares of the turns by their lengths is made small by relaxation, coarse points first, and each
 * axis is brought back into its cone.
 */
void axis_smooth_play(struct run *run, double play);

/*
 * No more than `rate` radians of turn for a millimetre, of the tip and of the ball's centre,
 * between any two neighbouring points: axes are averaged over a length of the path that is doubled
 * until this holds.  Points in one place get one axis.  Returns how far an axis was turned at most,
 * radians.
 */
double axis_smooth_rate(struct run *run, double rate);

/* The fastest turn between neighbouring points, radians a millimetre of the shorter of both ways;
 * HUGE_VAL where the axis turns in one place. */
double axis_smooth_fastest(const struct run *run);

#endif
