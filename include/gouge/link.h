/*
 * link - from the end of one run to the start of the next with the tool down.
 */
#ifndef CLOUDMILL_LINK_H
#define CLOUDMILL_LINK_H

#include <stdbool.h>

#include "gouge/gouge_strip.h"

/*
 * Appends the points between to `way`, on a low arch from centre to centre (a tenth of its length
 * high, for there may be material just outside the border of the guard), lifted further where that
 * is not clear; they touch nothing, and the ends themselves are not appended.  Without a guard it
 * is a straight line.  False when a lift above `limit` would be needed, or the lines between are
 * not clear within the tolerance.
 */
bool link_low(const struct run_point *from, const struct run_point *to,
              const struct gouge_lift_options *rule, double limit, struct run *way);

#endif
