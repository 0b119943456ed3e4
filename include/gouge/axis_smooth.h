/*
 * axis_smooth - the tool axes along a run turned less than the rule of the axis turns them.
 *
 * The ball's centres stay where they are; the tips follow the axes.
 */
#ifndef CLOUDMILL_AXIS_SMOOTH_H
#define CLOUDMILL_AXIS_SMOOTH_H

#include "curve/run.h"

/*
 * Makes the axes turn as little as they can, each no further than `play` radians from where it is:
 * the sum of (turn^2 / length) is minimized by relaxation, coarse points first (multigrid), and
 * each axis is brought back into its cone.
 */
void axis_smooth_play(struct run *run, double play);

/*
 * Makes the axis turn by no more than `rate` radians for each millimetre of the tip and of the
 * ball's centre, between any two neighbouring points: axes are averaged over a length of the path
 * that is doubled until this holds.  Points in one place get one axis.  Returns how far an axis was
 * turned at most, radians.
 */
double axis_smooth_rate(struct run *run, double rate);

/*
 * The directions `rule` of n points, each the mean over `half` mm of the ball's path before and
 * after it, less beyond the ends, and that twice: what turns back within it is of single contact
 * points and not of the surface.  Between points a direction goes straight, so that the mean has no
 * step where a point comes into reach.  Points that touch nothing have no say, and keep theirs.
 */
void axis_smooth_rules(const struct run_point *point, size_t n, double half, struct vec3 *rule);

/* The fastest turn between neighbouring points, radians for each millimetre that tip or centre
 * moves, the shorter of the two; HUGE_VAL where the axis turns in one place. */
double axis_smooth_fastest(const struct run *run);

#endif
