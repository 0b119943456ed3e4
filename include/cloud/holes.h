/*
 * holes - where a cloud has no points, seen from above.
 *
 * A hole is where a disc wider than the gap holds no point.  A facet bridges it when it reaches
 * farther into such a disc than the rim.  Measured on a raster of a twelfth of the gap, so that the
 * answer within a twelfth or two may be either.
 */
#ifndef CLOUDMILL_HOLES_H
#define CLOUDMILL_HOLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "cloud/plan_extent.h"
#include "math/vec.h"

struct holes {
    double rim;         /* how far facets may reach into a hole, at most half the gap, mm */
    double cell;        /* width of the raster, mm */
    double x, y;        /* the lowest leftmost place of the points; around it is a border */
    size_t rows, words; /* a row of cells is so many words of 64 bits */
    int reach;          /* from the middle of a hole to where facets may be, cells */
    uint64_t *near;     /* by row: may a facet be over the cell's middle? */
    uint64_t *taken;    /* until holes_end: the cells with points */
};

/* `gap`: diameter of the widest disc that is no hole.  -1 when it is so small that the raster would
 * be absurd. */
int holes_find(const struct vec3 *point, size_t n, double gap, double rim, struct holes *holes,
               struct error *error);
void holes_free(struct holes *holes);

/* The same of points that come in blocks, of which this is the extent in direction 0. */
int holes_begin(const struct plan_extent *extent, double gap, double rim, struct holes *holes,
                struct error *error);
void holes_add(struct holes *holes, const struct vec3 *point, size_t n);
void holes_end(struct holes *holes);

/* Does the facet with these corners (points of the cloud) bridge a hole? */
bool holes_bridged(const struct holes *holes, struct vec3 a, struct vec3 b, struct vec3 c);

#endif
