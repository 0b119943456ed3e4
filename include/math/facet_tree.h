/*
 * facet_tree - which of many facets is nearest to a point?
 *
 * A facet may have two corners at one place, and is then a straight piece, or all three: a point.
 * So clouds, chains and meshes are searched alike.  Boxes around facets, halved at the middle of
 * their longer side.
 */
#ifndef CLOUDMILL_FACET_TREE_H
#define CLOUDMILL_FACET_TREE_H

#include <stddef.h>

#include "math/vec.h"

struct facet {
    struct vec3 corner[3];
};

struct facets {
    size_t n, cap;
    struct facet *item;
};

struct facet_tree;

/* Changes the order of the facets, and keeps a pointer to them. */
struct facet_tree *facet_tree_new(struct facets *facets);
void facet_tree_free(struct facet_tree *tree);

/* Distance of p to the nearest facet, mm; HUGE_VAL when there is none. */
double facet_tree_distance(const struct facet_tree *tree, struct vec3 p);

/* The point of the facet that is nearest to p. */
struct vec3 facet_nearest(const struct facet *facet, struct vec3 p);

#endif
