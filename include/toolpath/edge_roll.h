/*
 * edge_roll - the ball rolled over a sharp edge, from the normal of its one side to that of the
 * other.
 */
#ifndef CLOUDMILL_EDGE_ROLL_H
#define CLOUDMILL_EDGE_ROLL_H

#include "curve/motion.h"

/*
 * Appends to `to` contacts from `last` to `next`, without these, that turn the normal in so small
 * steps that straight lines between the ball's centres sink in by no more than `tolerance`.
 * `forward` is the way to `last` from the contact before it: in a valley, where the normal turns
 * backwards, there are none.
 */
void edge_roll(struct contacts *to, struct vec3 forward, struct contact last, struct contact next,
               double radius, double tolerance);

#endif
