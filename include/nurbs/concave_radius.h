/*
 * concave_radius - where a NURBS patch is most tightly hollow, and so the largest ball that fits
 * it.
 */
#ifndef CLOUDMILL_CONCAVE_RADIUS_H
#define CLOUDMILL_CONCAVE_RADIUS_H

#include "nurbs/patch.h"
#include "nurbs/trim_grid.h"

struct concave_radius {
    double curvature; /* the largest principal curvature, hollow positive, 1/mm */
    struct uv at;
    struct vec3 point;
};

/*
 * The largest principal curvature inside the loops, seen from the side dS/du x dS/dv or, where
 * `flipped`, from the other: the best of samples in every span of the knots, each then followed
 * uphill within its span to 1e-12 of it.  A curvature of 0 or less says that no place is hollow.
 */
struct concave_radius concave_radius_find(const struct patch *patch, const struct uv_polygon *loops,
                                          bool flipped, int threads);

/* The same for all patches, [i] of patches->item[i] and flipped[i], each inside its own trimming.
 * The caller frees the array. */
struct concave_radius *concave_radius_find_all(const struct patches *patches, const bool *flipped,
                                               int threads);

#endif
