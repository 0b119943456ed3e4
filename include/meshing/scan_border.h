/*
 * scan_border - where a scan ends, seen from above: its outer border and those of its holes.
 *
 * The facets of the Delaunay triangulation of all points whose circle, which has no point inside,
 * is no wider than the gap are the scan's surface (the alpha shape of H. Edelsbrunner, D.
 * Kirkpatrick, R. Seidel 1983); so a hole is what holes.h calls one, and what is long and thin at
 * a border is none of it.
 */
#ifndef CLOUDMILL_SCAN_BORDER_H
#define CLOUDMILL_SCAN_BORDER_H

#include <stdbool.h>

#include "base/array.h"
#include "math/vec.h"

/* Points by their number, one after the other, with the surface on the left: an outer border runs
 * counter-clockwise, that of a hole clockwise. */
struct scan_border {
    size_t n, cap;
    struct ints *item;
};

/* Of n points, 3 at least. */
struct scan_border scan_border_find(const struct vec3 *point, size_t n, double gap);

/* Leaves out points of a loop that are within `tolerance` of the straight lines between the others,
 * in space (Douglas, Peucker 1973): keep[i] says whether its point i stays; at least 3 do. */
void scan_border_thin(const struct ints *loop, const struct vec3 *point, double tolerance,
                      bool *keep);

void scan_border_free(struct scan_border *border);

#endif
