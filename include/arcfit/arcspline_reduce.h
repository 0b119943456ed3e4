/*
 * arcspline_reduce - fewer arcs for a trace, by moving all joints of a chain together.
 *
 * A search from left to right (arc_beam.h) has to take each arc as it comes.  Here all joints, and
 * the tangent at the start, move at once, by Levenberg and Marquardt's method, so that the p-norm
 * of the distances becomes small, p from 2 to 64; one arc fewer is tried from joints spaced anew,
 * until none holds (design/3-geometry.md, "best found").  Where the tool axis turns, its direction
 * at the joints moves too, so that both ends of the lever follow.
 */
#ifndef CLOUDMILL_ARCSPLINE_REDUCE_H
#define CLOUDMILL_ARCSPLINE_REDUCE_H

#include "arcfit/arcfit.h"

/*
 * Replaces parts of the chain `pieces`, which keep `within` of the trace, by fewer pieces that keep
 * it, proven by arc_piece_deviation with joints rounded to `digits` decimals.  Kinks stay where
 * they are. `thorough`: from many spacings of the joints also where the axis turns.  That takes
 * several times as long for a tenth fewer arcs of smooth data, and for hardly fewer of a scan.
 */
void arcspline_reduce(const struct trace *trace, const struct arc_deviation *within, int digits,
                      bool thorough, struct pieces *pieces);

#endif
