/*
 * concave_radius - the smallest concave radius of a patch, and so the largest ball that fits it.
 */
#ifndef CLOUDMILL_CONCAVE_RADIUS_H
#define CLOUDMILL_CONCAVE_RADIUS_H

#include "nurbs/patch.h"

struct concave_radius {
    double curvature; /* the largest principal curvature, concave positive, 1/mm */
    struct uv at;
    struct vec3 point;
};

/*
 * The largest principal curvature inside the trimming, seen from the side dS/du x dS/dv or, where
 * `flipped`, from the other.  The samples in every span of the knots that no neighbour exceeds are
 * starts of a pattern search that climbs within its span, to 1e-12 of the span; along the
 * trimming's border, which may be where it is most concave, another one climbs.  A curvature of 0
 * or less means that no place is concave.
 */
struct concave_radius concave_radius_find(const struct patch *patch, bool flipped, int threads);

/* The same for all patches: [i] is of patches->item[i] and flipped[i].  The caller frees the array.
 */
struct concave_radius *concave_radius_find_all(const struct patches *patches, const bool *flipped,
                                               int threads);

#endif
