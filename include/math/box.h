/*
 * box - boxes along X, Y and Z around points, in mm.
 */
#ifndef CLOUDMILL_BOX_H
#define CLOUDMILL_BOX_H

#include "math/vec.h"

/* A box of points; empty (low above high) before the first. */
struct box {
    struct vec3 low, high;
};

struct box box_empty(void);

/* The box around n points. */
struct box box_around(const struct vec3 *point, size_t n);

void box_add(struct box *box, struct vec3 p);
void box_join(struct box *box, const struct box *other);

/* From corner to corner, mm; 0 if it is empty. */
double box_diagonal(const struct box *box);

/* Squared distance of p; 0 inside, infinite where the box is empty. */
double box_distance2(const struct box *box, struct vec3 p);

#endif
