/*
 * delaunay_border - the border of a scan in a triangulation of all its points (scan_border.h).
 */
#ifndef CLOUDMILL_DELAUNAY_BORDER_H
#define CLOUDMILL_DELAUNAY_BORDER_H

#include "delaunay.h"
#include "meshing/scan_border.h"

/* Is a triangle (NONE: no) part of the scan's surface? */
bool delaunay_is_surface(const struct delaunay *d, int triangle, double gap);

struct scan_border delaunay_border(const struct delaunay *d, double gap);

/* The point of a loop between two others, from < to <= n, that is farthest from the line between
 * them, in space, and how far; from + 1 < to. */
size_t scan_border_farthest(const struct ints *loop, const struct vec3 *point, size_t from,
                            size_t to, double *distance);

#endif
