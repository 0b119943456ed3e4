/*
 * lift_smooth - lifted centres raised a little more, to where they run most smoothly (after
 * gouge_lift.h, before axes are planned).
 *
 * A centre runs on the envelope of the balls that touch, which has a corner at each point of a scan
 * that takes over from another and in each hollow where the ball rests on two sides; a fitter needs
 * a piece for each.  Where more may stay on the part than the rows leave (`room`), the centre may
 * cut these corners.  Points are put at even distances first, so that a curve has points to bend
 * at, and those that straight lines need are kept in the end.
 */
#ifndef CLOUDMILL_LIFT_SMOOTH_H
#define CLOUDMILL_LIFT_SMOOTH_H

#include "gouge/gouge_lift.h"

/* Where the ball touches on neighbouring points, points at even distances on the smooth curve
 * through them, clear of the guard and about sqrt(tolerance x radius) apart, so that what is in
 * neither of two neighbours is no deeper than the tolerance between; their first and last stay, and
 * all other points. */
void lift_smooth_spread(struct lifted_strip *strip, const struct gouge_lift_options *rule);

/* Raises the points of such a strip, each by no more than room[] (one of each point, mm), square to
 * the way, where the ball is clear and what straight lines may go deep is kept.  Then leaves out
 * points that straight lines do not need. */
void lift_smooth_raise(struct lifted_strip *strip, const struct gouge_lift_options *rule,
                       const double *room);

#endif
