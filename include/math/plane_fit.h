/*
 * plane_fit - the plane through points in space, by the least sum of squared distances.
 */
#ifndef CLOUDMILL_PLANE_FIT_H
#define CLOUDMILL_PLANE_FIT_H

#include <stddef.h>

#include "math/vec.h"

struct plane_fit {
    struct vec3 centre, normal; /* the points' mean; unit, its sign is arbitrary */
    double rms;                 /* of the distances from the plane, mm */
    double width, length;       /* rms along the plane, across and along the points' spread, mm */
};

/* The eigenvectors of the points' covariance by Jacobi's rotations.  -1 if the points determine no
 * plane: fewer than 3, or all on a line. */
int plane_fit(const struct vec3 *point, size_t n, struct plane_fit *plane);

#endif
