/*
 * lift_place - a point of a run with its centre put somewhere: its axis and tip follow by the rules
 * of a lift (gouge_lift.h).
 */
#ifndef CLOUDMILL_LIFT_PLACE_H
#define CLOUDMILL_LIFT_PLACE_H

#include "gouge/gouge_lift.h"

/* The centre there, the axis as the rule says for there, and the tip below by the ball's radius. */
void lift_place(struct run_point *p, struct vec3 centre, const struct gouge_lift_options *rule,
                double radius);

/* The same of a point that touches.  Where the surface faces down, an axis that would come from
 * below is level instead: the ball touches the same, and its shank is beside the part. */
void lift_place_along(struct run_point *p, struct vec3 centre,
                      const struct gouge_lift_options *rule, double radius);

/* True if the ball goes no deeper than it safely may on the straight line between two points where
 * it is clear. */
bool lift_line_clear(const struct run_point *a, const struct run_point *b,
                     const struct gouge_lift_options *rule);

#endif
