/*
 * unseen_step - a step of a scan that is lower than a wall (unseen_wall.h) and no less hidden.
 *
 * About a point some others lie on one plane with it, the rest as far above that plane as each
 * other, none between, on one side: a terrace.  Where its riser is, and how steep, no point tells.
 * Of a bend that was scanned there are points of all heights.  Lengths in mm.
 */
#ifndef CLOUDMILL_UNSEEN_STEP_H
#define CLOUDMILL_UNSEEN_STEP_H

#include <stdbool.h>

#include "math/vec.h"

/* The nearest points that are looked at; where they are spread evenly, they reach so many spacings
 * as seen from above. */
enum { UNSEEN_STEP_POINTS = 32 };
#define UNSEEN_STEP_REACH 3.2

/*
 * How high above p, a point of the scan, the upper side of such a step is; 0: there is none.
 * `near`: the points about p as seen from above, itself among them, UNSEEN_STEP_POINTS at least
 * (fewer: there is none).
 */
double unseen_step_over(struct vec3 p, const struct vec3s *near);

/* Seen from above the points `high` are on one side of p, and none of those that are `low` is
 * before it there: on the way to the wall, or beyond it, under a roof. */
bool unseen_step_is_foot(struct vec3 p, const struct vec3 *low, size_t lows,
                         const struct vec3 *high, size_t highs, double reach);

#endif
