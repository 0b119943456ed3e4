/*
 * predicates - on which side of a line, and of a circle, a point of the plane lies: never wrong.
 *
 * The determinants are evaluated in double precision first; where their rounding could hide the
 * sign, the next stage has more digits, up to all of them: sums of doubles that do not overlap
 * (T. Dekker 1971; D. Priest 1991; J. Shewchuk 1997).  Coordinates must be finite and so that their
 * fourth powers neither overflow nor fall below the smallest normal double (1e-60 to 1e60, or 0).
 */
#ifndef CLOUDMILL_PREDICATES_H
#define CLOUDMILL_PREDICATES_H

#include "math/uv.h"

/* 1: c is on the left of the line from a to b, -1: on the right, 0: on it. */
int orient2d(struct uv a, struct uv b, struct uv c);

/* For a, b, c counter-clockwise: 1: d is inside their circle, -1: outside, 0: on it. */
int incircle(struct uv a, struct uv b, struct uv c, struct uv d);

#endif
