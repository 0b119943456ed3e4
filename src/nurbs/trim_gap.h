/*
 * trim_gap - where the curves of a trimming loop do not meet.
 */
#ifndef CLOUDMILL_TRIM_GAP_H
#define CLOUDMILL_TRIM_GAP_H

#include "trim_steps.h"

/*
 * The largest gap between curves of a loop that follow each other, the last and the first too, if
 * it is more than rounding and a little inexact: over a ten thousandth of the loop's length.  What
 * is between them is a straight line of the polygon then.  mm, on the surface; 0: there is none;
 * *at: its middle.  `followed` is the loop as trim_follow has it.
 */
double trim_gap(const struct patch *patch, const struct patch_loop *loop, const struct pullback *on,
                const struct uvs *followed, struct vec3 *at);

#endif
