/*
 * region - a part of space: a box along X, Y and Z, and polygons seen along z, in mm.
 */
#ifndef CLOUDMILL_REGION_H
#define CLOUDMILL_REGION_H

#include "base/array.h"
#include "math/box.h"

/* Corners of closed polygons seen along z; `from` is where each begins among them. */
struct region_polygons {
    struct vec3s corner;
    struct ints from;
};

/* True if p is inside an odd number of them. */
bool region_polygons_hold(const struct region_polygons *polygons, struct vec3 p);

/* Where one ends among the corners. */
size_t region_polygons_end(const struct region_polygons *polygons, size_t k);

struct region_polygons region_polygons_copy(const struct region_polygons *polygons);
void region_polygons_free(struct region_polygons *polygons);

/* What is in box and polygons, with all places seen along z that are `border` from it, in eight
 * directions. */
struct region {
    bool boxed; /* there is a box */
    struct box box;
    struct region_polygons polygons; /* none: all of the box */
    double border;
};

/* Is there anything that a point has to be in? */
bool region_given(const struct region *region);

bool region_holds(const struct region *region, struct vec3 p);

#endif
