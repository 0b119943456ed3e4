/*
 * facet_split - facets of a mesh split at points that lie above or below them, seen along z.
 */
#ifndef CLOUDMILL_FACET_SPLIT_H
#define CLOUDMILL_FACET_SPLIT_H

#include <stdbool.h>

#include "mesh/mesh.h"

enum { FACET_SPLIT_NONE = -1 };

/* A mesh with rows, and the points over its facets. */
struct facet_split {
    struct mesh *mesh;
    int old; /* so many vertices were there */
    const struct vec3 *point;
    const double *within; /* how far each may be off, mm */
    struct ints beyond;   /* [3 * facet + i]: the facet beyond the edge from corner i on, or NONE */
    struct ints first;    /* of each facet: the first of the points over it, or NONE */
    int *next;            /* of each point: the next one over the same facet, or NONE */
    struct ints todo;     /* facets that have changed are appended */
};

/* Is p above or below a facet, or its border, that is one from above? */
bool facet_split_over(const struct facet_split *w, int facet, struct vec3 p);

/* Point i is over the facet. */
void facet_split_put(struct facet_split *w, int facet, int i);

/* How far the worst of the points over a facet is out of it and of those beside it, mm, and which
 * it is; 0: none is out. */
double facet_split_worst(const struct facet_split *w, int facet, int *at);

/* Is p off the corners of the facet, seen from above, and not steeper than 85 degrees to any? */
bool facet_split_apart(const struct facet_split *w, int facet, struct vec3 p);

/*
 * Point i becomes a vertex in no row (-1) and splits the facet in three.  Edges about it are turned
 * where that makes rounder triangles, seen from above, and brings no point out (Lawson 1977); edges
 * along rows, creases and walls stay.
 */
void facet_split_at(struct facet_split *w, int facet, int i);

#endif
