/*
 * borders - the edges of a quilt that no second triangle shares.
 */
#ifndef CLOUDMILL_BORDERS_H
#define CLOUDMILL_BORDERS_H

#include "math/kdtree.h"
#include "nurbs/quilt.h"

struct borders {
    struct sizes edge;   /* of quilt->edge */
    struct sizes vertex; /* at their ends, rising */
    struct kdtree *tree; /* of these */
};

/* The edges between two places of which there is one alone. */
void borders_find(const struct quilt *quilt, struct borders *borders);

void borders_free(struct borders *borders);

#endif
