/*
 * tilt - the tool axis set anew along a run, leaning to one side of the path (paper 1, 3.5).
 */
#ifndef CLOUDMILL_TILT_H
#define CLOUDMILL_TILT_H

#include <stdbool.h>

#include "curve/run.h"

/*
 * Sets the axis at every point of the run to a = cos(angle) n + sin(angle) b, the angle in radians,
 * and the tip below the centre, which stays:
 *   - the Darboux frame: n is the surface's normal, T the tangent of the centres' path across n,
 *     b = +-(n x T)
 *   - with `frenet` paper 1's eqs 9 to 12: t, n, b are the Frenet frame of the biarcs through the
 *     centres, n turned to the surface's normal (it flips at inflections), on a straight piece the
 *     frame before it, or the Darboux frame where there was none
 * `side` says to which side b leans: the run takes the sign that agrees with it and leaves its own
 * mean b there for the next run, so that the tool leans to the same side on zig and on zag; zero:
 * the sign of n x T.  A run without length, or a point without a normal, keeps its axis.
 */
void tilt_run(struct run *run, double angle, bool frenet, struct vec3 *side);

#endif
