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

/* Of a torus whose tube is wider than its middle: all of it, or what turns one of the two arcs of
 * the tube's circle that end on the axis. */
enum primitive_part { PRIMITIVE_WHOLE, PRIMITIVE_OUTER, PRIMITIVE_INNER };

struct primitive {
    enum primitive_kind kind;
    struct transform place; /* axes are perpendicular unit vectors */
    double radius;          /* of a cone where z is 0, of a torus from its middle to its tube's */
    double other;           /* the tube's radius; of a cone the half angle, radians */
    enum primitive_part part;
};

/* Points of the loops' curves in space, from which their extent is taken. */
void primitive_points(const struct patch_loops *loops, struct vec3s *points);

/* The surface as far as the points reach and a little further; -1 when it has no end and there are
 * no points, or when its numbers make no surface. */
int primitive_surface(const struct primitive *p, const struct vec3s *points, struct nurbs *surface);

/* The point at parameters as ISO 10303-42 counts them: x and y of a plane; an angle about z, and a
 * length along z or an angle. */
struct vec3 primitive_point(const struct primitive *p, double u, double v);

/* Those of a point on it; angles from -pi to pi. */
void primitive_parameters(const struct primitive *p, struct vec3 point, double *u, double *v);

/* Of a torus that cuts itself the part on which the loops' curves in space lie: PRIMITIVE_WHOLE for
 * any other, or where they do not tell. */
enum primitive_part primitive_part_of(const struct primitive *p, const struct patch_loops *loops);

/* Moves the surface along its normals; -1 when nothing is left of it. */
int primitive_offset(struct primitive *p, double distance);

#endif
