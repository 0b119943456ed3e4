/*
 * facetree - which of many facets is nearest to a point?
 *
 * A facet may have two corners at one place, and is then a straight piece, or all three: a point.
 * So clouds, chains and meshes are searched alike.  Boxes around facets, halved at the middle of
 * their longer side.
 */
#ifndef CLOUDMILL_FACETREE_H
#define CLOUDMILL_FACETREE_H

#include <stddef.h>

#include "math/vec.h"

struct facet {
    struct vec3 corner[3];
};

struct facets {
    size_t n, cap;
    struct facet *item;
};

struct facetree;

/* Changes the order of the facets, and keeps a pointer to them. */
struct facetree *facetree_new(struct facets *facets);
void facetree_free(struct facetree *tree);

/* Distance of p to the nearest facet, mm; HUGE_VAL when there is none. */
double facetree_distance(const struct facetree *tree, struct vec3 p);

/* The point of the facet that is nearest to p. */
struct vec3 facet_nearest(const struct facet *facet, struct vec3 p);

#endif
