/*
 * rotary_spline - rotary angles along a B-spline as B-splines on the same knots.
 *
 * The angles that follow the tool axis along a curve are no B-splines themselves; this fits them
 * by least squares with both ends fixed (Piegl and Tiller, The NURBS Book, 9.4.1, the normal
 * equations banded).
 */
#ifndef CLOUDMILL_ROTARY_SPLINE_H
#define CLOUDMILL_ROTARY_SPLINE_H

#include "curve/motion.h"
#include "machine/ik_choose.h"

/*
 * Poles of the angles, radians: pole[i] has room for as many as the curve of the motion has;
 * `from` are the angles where it starts, and the first poles.  -1 when the axis leaves the travel
 * on the way; *over as ik_choose says it.
 */
int rotary_spline_fit(const struct kinematic_chain *chain, const struct motion *motion,
                      const double from[], double *pole[ROTARY_MAX], int *over);

#endif
