/*
 * rowmesh - a mesh whose fineness follows from an error: rows as far apart, and along each row
 * points as far apart, as the cloud allows that every point of it is within the error of a facet.
 *
 * Paper 1 names this as further work.  All rows are parallel and go across the whole cloud, so that
 * they are rows to the tool path, but their distances differ: a strip between two rows that is off
 * the cloud is halved.
 */
#ifndef CLOUDMILL_ROWMESH_H
#define CLOUDMILL_ROWMESH_H

#include "buckets.h"
#include "footprint.h"
#include "holes.h"
#include "mesh.h"

struct rowmesh {
    double worst, rms; /* distance of the points from the facets above or below them, mm */
    struct vec3 at;    /* the worst point */
    size_t beside;     /* points that no facet is above or below */
    size_t rows;
    int columns;       /* places that a row can have a vertex at */
    size_t bridges;    /* facets over a hole, left out */
};

/*
 * `spacing` is the mean spacing of the points, `widest` the largest distance of two rows, mm.  Rows
 * are never nearer than the points.  The mesh gets vertices, which are points of the cloud, rows,
 * columns and facets; result.worst > error where the points are too far apart for it, or stand
 * upright.
 */
struct rowmesh rowmesh_make(const struct buckets *buckets, const struct footprint *footprint,
                            const struct holes *holes, double error, double spacing, double widest,
                            struct mesh *mesh);

#endif
