/*
 * arc_axis - the tool axis at the end of a piece, set so that both ends of the lever follow.
 *
 * On a piece the axis turns on a great circle while the tracked point goes along its arc; where the
 * other end of the lever then goes is not free.  But the axis at the end of the piece is: turned
 * about the direction of travel by a few hundredths of a degree it takes most of the other end's
 * stray away, and pieces become longer.
 */
#ifndef CLOUDMILL_ARC_AXIS_H
#define CLOUDMILL_ARC_AXIS_H

#include "arcfit/arc_piece.h"

/*
 * The axis at the piece's end, unit and rounded to `digits` decimals, that brings the other end of
 * the lever nearest to its trace, by least squares over some points; at the end itself it stays
 * within `part` of the two tolerances.  piece->axis_to where there is nothing to gain.
 */
struct vec3 arc_axis_end(const struct trace *trace, const struct arc_piece *piece,
                         const struct arc_deviation *within, double part, int digits);

#endif
