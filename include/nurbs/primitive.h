/*
 * primitive - the surfaces of solids as NURBS, as large as what trims them: planes, cylinders and
 * cones have no ends of their own.
 *
 * The normal dS/du x dS/dv is that of ISO 10303-42: along z for a plane, outwards for the others; u
 * is the angle about z, v runs along z, or from the south pole to the north, or round the tube.
 */
#ifndef CLOUDMILL_PRIMITIVE_H
#define CLOUDMILL_PRIMITIVE_H

#include "math/transform.h"
#include "nurbs/patch.h"

enum primitive_kind {
    PRIMITIVE_PLANE,
    PRIMITIVE_CYLINDER,
    PRIMITIVE_CONE,
    PRIMITIVE_SPHERE,
    PRIMITIVE_TORUS
};

struct primitive {
    enum primitive_kind kind;
    struct transform place; /* axes are perpendicular unit vectors */
    double radius;          /* of a cone where z is 0, of a torus from its middle to its tube's */
    double other;           /* the tube's radius; of a cone the half angle, radians */
};

/* Points of the loops' curves in space, from which their extent is taken. */
void primitive_points(const struct patch_loops *loops, struct vec3s *points);

/* The surface as far as the points reach and a little further; -1 when it has no end and there are
 * no points, or when its numbers make no surface. */
int primitive_surface(const struct primitive *p, const struct vec3s *points, struct nurbs *surface);

#endif
