/*
 * orient - all patches turned to the same side, the outside out.
 */
#ifndef CLOUDMILL_ORIENT_H
#define CLOUDMILL_ORIENT_H

#include "nurbs/patch.h"
#include "nurbs/patch_mesh.h"

/* Of the area of a body: area vectors that sum up to less say nothing. */
#define ORIENT_CLOSED 0.02

struct orient_count {
    size_t bodies;    /* groups of sheets connected by common edges */
    size_t conflicts; /* pairs of neighbours that cannot be turned alike */
    size_t unclear;   /* bodies that stand so upright that `up` does not tell their outside */
    size_t voids;     /* closed bodies of no shell of the file, within another: turned inwards */
    size_t open;      /* border edges that no other sheet shares */
};

/*
 * Sets patch_mesh->flipped.  Neighbours along an edge are turned to the same side, by a maximum
 * spanning tree over the lengths of the common edges (Kruskal).  Then each body as a whole is
 * turned so that the sum of its area vectors looks along `up`; a closed body, whose area vectors
 * cancel out within ORIENT_CLOSED of its area, so that its volume is positive, or negative where
 * `patches` (NULL: not known) say that it bounds a void.  Where they know of no shells, a closed
 * body that lies within an odd number of others bounds a void, too.
 */
struct orient_count orient_outward(struct patch_mesh *patch_mesh, const struct patches *patches,
                                   struct vec3 up);

#endif
