/*
 * trim_loops - the curves that trim a patch as polygons in its parameters.
 */
#ifndef CLOUDMILL_TRIM_LOOPS_H
#define CLOUDMILL_TRIM_LOOPS_H

#include "nurbs/patch.h"
#include "nurbs/uv_polygon.h"

/*
 * The loops of a patch as polygons whose sides, on the surface, stay within `tolerance` mm of the
 * curve; curves that run backwards are turned round.  Curves in space are put on the surface, by
 * the foot points of their own points (pullback.h).
 */
void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops);

#endif
