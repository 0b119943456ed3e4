/*
 * adaptive_rows - a mesh whose fineness follows from an error: rows as far apart, and along each
 * row points as far apart, as the cloud allows that every point of it is within the error of a
 * facet.
 *
 * Paper 1 names this as further work.  All rows are parallel and go across the whole cloud, so that
 * they are rows to the tool path, but their distances differ: a strip between two rows that is off
 * the cloud is halved.
 */
#ifndef CLOUDMILL_ADAPTIVE_ROWS_H
#define CLOUDMILL_ADAPTIVE_ROWS_H

#include "math/point_grid.h"
#include "meshing/feature_zone.h"
#include "cloud/plan_extent.h"
#include "cloud/holes.h"
#include "mesh/mesh.h"

struct adaptive_rows {
    double worst, rms; /* distance of the points from the facets above or below them, mm */
    struct vec3 at;    /* the worst point */
    size_t beside;     /* points that no facet is above or below */
    size_t rows;
    int columns;    /* places that a row can have a vertex at */
    size_t bridges; /* facets over a hole, left out */
};

struct adaptive_rows_options {
    double error, spacing,
        widest; /* mean spacing of the points, largest distance of two rows, mm */
    const struct feature_zone *zone; /* NULL: no creases and walls are known */
    double out;  /* so many of the points of a strip, as part of them, may be off it by more */
    int threads; /* as of parallel_for; of which the result does not depend */
};

/*
 * Rows are never nearer than the points, but where there is a zone.  The mesh gets vertices, rows,
 * columns and facets; result.worst > error where the points are too far apart for it, or stand
 * upright, or where options->out of them may be off (greedy_insert.h brings these in).  Points near
 * to the creases and walls of the zone are not judged, for these are put into the mesh later: it
 * has there edges no longer than the zone's, and no vertices too near to them.
 */
struct adaptive_rows adaptive_rows_make(const struct point_grid *point_grid,
                                        const struct plan_extent *plan_extent,
                                        const struct holes *holes,
                                        const struct adaptive_rows_options *options,
                                        struct mesh *mesh);

#endif
