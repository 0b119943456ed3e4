/*
 * segment_steps - how a cloud is divided by orientation, step by step: normals on one side of it,
 * connected pieces of one label, and the surface of a piece continued beyond its sharp edges.
 */
#ifndef CLOUDMILL_SEGMENT_STEPS_H
#define CLOUDMILL_SEGMENT_STEPS_H

#include <stdbool.h>

#include "base/array.h"
#include "cloud/segment.h"
#include "math/vec.h"

/* ---- cloud_normals: normals of a cloud in space that is no height field, all on one side of it.
 */

/* Neighbours of each point, its own index left out: [i * CLOUD_NEAR + k], nearest first. */
enum { CLOUD_NEAR = SEGMENTS_LEAST };

/*
 * The n indices of the CLOUD_NEAR points nearest to each point.  n must be above CLOUD_NEAR.  Free
 * with free().
 */
size_t *cloud_neighbours(const struct vec3 *point, size_t n, int threads);

/* Mean spacing of the points on the surface that they are of, mm: by the median of the circles that
 * the neighbours take. */
double cloud_spacing(const struct vec3 *point, size_t n, const size_t *neighbour);

/*
 * Fills normal[n]: unit, of the plane through each point and its neighbours.  Where a surface is
 * no steeper than 60 degrees and nothing is over it, it faces up: along `up`, unit.  From there
 * signs follow from neighbour to neighbour over the least change of direction (minimum spanning
 * tree: Hoppe et al. 1992), by what a circle through both points would make of them, for at a
 * right angle the directions alone say nothing.  Most of a connected piece without such places
 * faces up.  Where the plane of a neighbour, or of one up to three steps away, serves a point at
 * least twice as well as its own it takes that normal, so that beside a sharp edge normals are
 * those of their side.
 */
void cloud_normals(const struct vec3 *point, size_t n, const size_t *neighbour, struct vec3 up,
                   int threads, struct vec3 *normal);

/* ---- components: the pieces that a labelled cloud in space falls into. */

enum { COMPONENT_NONE = -1 };

struct components {
    size_t n;
    const size_t *neighbour;      /* as of cloud_neighbours */
    const struct vec3 *normal;    /* unit */
    const struct vec3 *direction; /* unit, that each label stands for */
    int *label;                   /* of each point */
};

/* No sharp edge is between two points: their normals are within 50 degrees. */
bool components_smooth(const struct components *c, size_t i, size_t j);

/* Noise leaves single points with another label than all about them: each takes the one that most
 * of its neighbours have, of those whose direction is within 70 degrees of its normal. */
void components_settle(struct components *c);

/*
 * Points of one label that hang together, through neighbours and across no sharp edge, are a
 * piece.  Fills of[n] with the number of each point's, and appends the label of each.  Pieces of
 * less than a hundredth of the cloud, or less than 30 points, go to those about them, best without
 * an edge between; where there are none about they are pieces of their own, below 30 points
 * COMPONENT_NONE.
 */
void components_find(const struct components *c, int *of, struct ints *label);

/* ---- extend_edges: the surface of a part of a cloud continued beyond its sharp edges, for rows to
 * run out over them. */

struct extend_edges {
    const struct vec3 *point, *normal;
    const size_t *neighbour; /* as of cloud_neighbours */
    size_t n;
    const bool *in; /* which points are of the part */
};

/*
 * Appends points, about `spacing` mm apart and no further than `length` mm off the part, beside its
 * points at convex edges: where neighbours outside of it stand off by more than 40 degrees.  They
 * lie square to the edge on a quadric, or plane (side_fit.h), through points nearby with like
 * normals. There is none where other points keep a ball of radius `length` from touching there.
 */
void extend_edges_find(const struct extend_edges *cloud, double spacing, double length,
                       struct vec3s *beyond);

#endif
