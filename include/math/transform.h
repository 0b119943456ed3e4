/*
 * transform - affine maps of space: units, placing by a 4 x 4 matrix, a new origin.
 */
#ifndef CLOUDMILL_TRANSFORM_H
#define CLOUDMILL_TRANSFORM_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

/* q = M (x, y, z, 1): the fourth column is the shift, the last row is 0 0 0 1. */
struct transform {
    double m[4][4];
};

struct transform transform_identity(void);
struct transform transform_scale(double s);
struct transform transform_shift(struct vec3 d);

/* First b, then a. */
struct transform transform_product(struct transform a, struct transform b);

struct vec3 transform_point(const struct transform *t, struct vec3 p);
void transform_points(const struct transform *t, struct vec3 *point, size_t n);

bool transform_is_identity(const struct transform *t);

/* Of the upper left 3 x 3: the factor on volumes, negative for a mirror image. */
double transform_determinant(const struct transform *t);

#endif
