/*
 * boundary - the edges of a patch_mesh that no second triangle shares.
 */
#ifndef CLOUDMILL_BOUNDARY_H
#define CLOUDMILL_BOUNDARY_H

#include "math/kdtree.h"
#include "nurbs/patch_mesh.h"

struct boundary {
    struct sizes edge;   /* of patch_mesh->edge */
    struct sizes vertex; /* at their ends, rising */
    struct kdtree *tree; /* of these */
};

/* The edges between two places of which there is one alone. */
void boundary_find(const struct patch_mesh *patch_mesh, struct boundary *borders);

void boundary_free(struct boundary *borders);

#endif
