/*
 * components - the pieces that a labelled cloud in space falls into.
 */
#ifndef CLOUDMILL_COMPONENTS_H
#define CLOUDMILL_COMPONENTS_H

#include <stdbool.h>

#include "base/array.h"
#include "math/vec.h"

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

#endif
