/*
 * decimate - a chain of points on a picture with no more points than the picture can show.
 */
#ifndef CLOUDMILL_DECIMATE_H
#define CLOUDMILL_DECIMATE_H

#include "math/vec.h"

/*
 * Appends to `out` those of the n points (x and y count) from which straight lines pass all the
 * others within twice the tolerance (as a rule, once); the first and the last stay.  Steps shorter
 * than the tolerance go; where the chain turns back, the turning point stays.  One walk along the
 * chain, with the sector of directions that still serve (Williams 1978, Zhao and Saalfeld 1997).
 */
void decimate_chain(const struct vec3 *point, size_t n, double tolerance, struct vec3s *out);

#endif
