/*
 * axis_smooth - the tool axes along a run turned less than the rule of the axis turns them.
 *
 * The ball's centres stay where they are; the tips follow the axes.
 */
#ifndef CLOUDMILL_AXIS_SMOOTH_H
#define CLOUDMILL_AXIS_SMOOTH_H

#include "curve/run.h"

/*
 * Radii of the ball: over so much before and after a point, and that twice, the rule's axes are
 * averaged where axes have play.  A row over a part goes past details (lips, folds, scales) that
 * are some radii wide and turn the normal to and fro; the ball cuts them alike with an axis that
 * does not nod to each, and neighbouring rows get axes alike.  Near an end of a run the mean is to
 * one side alone and leans inward where the surface bends: by no more than is allowed, off the mean
 * that goes no further than to the nearer end, though at least ..._LEAST.
 */
#define AXIS_SMOOTH_RULE 5
#define AXIS_SMOOTH_RULE_LEAST 1.4

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
 * The directions `rule` of n points, each the mean over the ball's path before and after it, so far
 * as AXIS_SMOOTH_RULE says for a ball of `radius` mm, and that twice: what turns back within it is
 * of details and not of the surface.  Between points a direction goes straight, so that the mean
 * has no step where a point comes into reach.  Points that touch nothing have no say, and keep
 * theirs.  `inward`: by so much, radians, they may lean near the ends.
 */
void axis_smooth_rules(const struct run_point *point, size_t n, double radius, double inward,
                       struct vec3 *rule);

/* The fastest turn between neighbouring points, radians for each millimetre that tip or centre
 * moves, the shorter of the two; HUGE_VAL where the axis turns in one place. */
double axis_smooth_fastest(const struct run *run);

#endif
