/*
 * extend - a cloud continued beyond its outer border, as the surface runs there.
 */
#ifndef CLOUDMILL_EXTEND_H
#define CLOUDMILL_EXTEND_H

#include "base/array.h"
#include "base/error.h"
#include "math/vec.h"

/*
 * Appends points, one for each square of the mean spacing, outside the cloud seen from above and no
 * further than `length` mm from it, nor than twice that in space: on the quadric through the points
 * of the cloud nearest to the place (of as wide a neighbourhood as it is to be continued, wider
 * where there is `noise`, one standard deviation in mm), or where they carry none on their plane.
 * Holes, which an empty disc of `gap` mm fits into and which are not connected with the outside,
 * stay as they are.  -1 when it is to be longer than the cloud is wide, or the strip would hold
 * more than twenty million points.
 */
int extend_cloud(struct vec3s *points, double spacing, double gap, double length, double noise,
                 int threads, struct error *error);

#endif
