/*
 * arc_axis - how the tool axis is best set at the end of an arc.
 */
#ifndef CLOUDMILL_ARC_AXIS_H
#define CLOUDMILL_ARC_AXIS_H

#include "arcfit/arcfit.h"

/*
 * The axis at the piece's end, unit and rounded to `digits` decimals, that brings the other point
 * nearest to its reference, by least squares over some points; at the end itself it stays within
 * `part` of the two tolerances.  piece->axis_to where there is nothing to gain.
 *
 * For on a piece the axis turns on a great circle while the programmed point goes along its arc, so
 * where the other point goes is not free, but the axis at the end is: turned about the direction of
 * travel by a few hundredths of a degree it takes most of the other point's deviation away, and
 * pieces become longer.
 */
struct vec3 arc_axis_end(const struct reference *reference, const struct arc_piece *piece,
                         const struct deviation *within, double part, int digits);

#endif
