/*
 * neighbourhood_along - neighbourhoods that are longer one way than the other: along a rib or a
 * groove, where a surface bends across and not along.
 */
#ifndef CLOUDMILL_NEIGHBOURHOOD_ALONG_H
#define CLOUDMILL_NEIGHBOURHOOD_ALONG_H

#include <stddef.h>

#include "math/vec.h"

/*
 * Of n points those k (at most; k > 0) that are nearest to `at` when lengths along `way` (unit)
 * count only 1 / `aspect`, as found[], the farthest in space of them last.  Equal ones by their
 * order in point[].  Returns how many.
 */
size_t neighbourhood_along_take(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 way,
                                double aspect, size_t k, struct vec3 *found);

#endif
