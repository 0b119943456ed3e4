/*
 * holes - where a cloud has no points, seen from above.
 *
 * A facet bridges a hole when a disc wider than the gap, its centre in the facet, holds no point.
 * Measured on a raster of a sixth of the gap, so that the answer for a disc within a sixth of the
 * gap may be either.
 */
#ifndef CLOUDMILL_HOLES_H
#define CLOUDMILL_HOLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "error.h"
#include "vec.h"

struct holes {
    double gap;         /* diameter of the widest disc that is no hole, mm */
    double cell;        /* width of the raster, mm */
    double x, y;        /* the lowest leftmost place of the points; around it is a border */
    size_t rows, words; /* a row of cells is so many words of 64 bits */
    uint64_t *near;     /* by row: is a point within half the gap of the cell's middle? */
};

/* -1 when the gap is so small that the raster would be absurd. */
int holes_find(const struct vec3 *point, size_t n, double gap, struct holes *holes,
               struct error *error);
void holes_free(struct holes *holes);

/* Does the facet with these corners (points of the cloud) bridge a hole? */
bool holes_bridged(const struct holes *holes, struct vec3 a, struct vec3 b, struct vec3 c);

#endif
