/*
 * rough_place - is there a surface about a place of a scan at all, as there is none in vegetation?
 *
 * The sums of moments of few cells tell: one of them lies on a surface, if only one side of an edge
 * or wall, or none does.  It is far cheaper than to look for a surface in vain.
 */
#ifndef CLOUDMILL_ROUGH_PLACE_H
#define CLOUDMILL_ROUGH_PLACE_H

#include <stdbool.h>

#include "math/point_grid.h"

/* True if of the cell of a place and the eight about it several have points enough to tell, and all
 * of these are further off a plane of their own, as heights, than `most` mm rms, with and without
 * any one point. */
bool rough_place(const struct point_grid *scan, struct vec3 place, double most);

#endif
