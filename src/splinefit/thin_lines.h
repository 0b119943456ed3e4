/*
 * thin_lines - a polyline without lines that are over before a control has read the next one.
 */
#ifndef CLOUDMILL_THIN_LINES_H
#define CLOUDMILL_THIN_LINES_H

#include "curve/reference.h"

/*
 * The points of a reference (point, other, axis and length alone), but for those that are nearer
 * than `least` mm to the one before that is kept, or to the last of all, where each is no further
 * than `within` beside the line past it.  *off is how far they are at most.  Never fewer than both
 * ends.  The caller frees it.
 */
struct reference thin_lines(const struct reference *reference, const struct deviation *within,
                            double least, struct deviation *off);

#endif
