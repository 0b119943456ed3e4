/*
 * vec - points and vectors in space, by value.  This is the main header of math, which knows
 * nothing of machining.  Lengths are in mm, angles in radians.  What else there is:
 *
 *   in space         box.h, transform.h (affine maps), faces.h (triangles), uv.h (two parameters)
 *   what is nearest  kdtree.h (points in space, and a ball that leaves them), point_grid.h (a cloud
 *                    in cells seen from above), box_tree.h (items of any kind), height_pyramid.h
 *                    (heights seen from above)
 *   local surfaces   surface_fit.h, which tells the family: planes, quadrics, cubics, along ridges
 *   equations        band.h (banded, symmetric, positive definite), pnorm.h (sums of high powers of
 *                    distances, and steps that make them less)
 *   polygons         earclip.h
 */
#ifndef CLOUDMILL_VEC_H
#define CLOUDMILL_VEC_H

#include <stddef.h>

#include "base/num.h"
#include "math/elementary.h"

#define PI 3.14159265358979323846
#define DEGREES(radians) ((radians) * (180.0 / PI))
#define RADIANS(degrees) ((degrees) * (PI / 180.0))

struct vec3 {
    double x, y, z;
};

struct vec3s {
    size_t n, cap;
    struct vec3 *item;
};

/* Appends n points. */
void vec3s_add(struct vec3s *to, const struct vec3 *point, size_t n);

static inline struct vec3 vec(double x, double y, double z)
{
    return (struct vec3){x, y, z};
}

/* Each coordinate rounded to so many decimals, as it is printed. */
static inline struct vec3 vec_round(struct vec3 a, int digits)
{
    return vec(num_round(a.x, digits), num_round(a.y, digits), num_round(a.z, digits));
}

static inline struct vec3 vec_add(struct vec3 a, struct vec3 b)
{
    return vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct vec3 vec_sub(struct vec3 a, struct vec3 b)
{
    return vec(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct vec3 vec_scale(double s, struct vec3 a)
{
    return vec(s * a.x, s * a.y, s * a.z);
}

/* a + s b */
static inline struct vec3 vec_along(struct vec3 a, double s, struct vec3 b)
{
    return vec(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

/* a + s (b - a) */
static inline struct vec3 vec_mix(struct vec3 a, struct vec3 b, double s)
{
    return vec_along(a, s, vec_sub(b, a));
}

static inline double vec_dot(struct vec3 a, struct vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vec3 vec_cross(struct vec3 a, struct vec3 b)
{
    return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double vec_length(struct vec3 a)
{
    return sqrt(vec_dot(a, a));
}

static inline double vec_distance(struct vec3 a, struct vec3 b)
{
    return vec_length(vec_sub(a, b));
}

/* The unit vector along a; zero stays zero. */
static inline struct vec3 vec_unit(struct vec3 a)
{
    double l = vec_length(a);
    return l > 0 ? vec_scale(1 / l, a) : a;
}

/* The part of a perpendicular to the unit vector n. */
static inline struct vec3 vec_reject(struct vec3 a, struct vec3 n)
{
    return vec_along(a, -vec_dot(a, n), n);
}

/* x, y or z of a vector: of axis 0, 1 or 2. */
static inline double vec_coordinate(struct vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

/* Angle between two vectors of any length, radians 0 to pi, exact near 0 and pi too. */
static inline double vec_angle(struct vec3 a, struct vec3 b)
{
    return atan2(vec_length(vec_cross(a, b)), vec_dot(a, b));
}

/* Where the point of the segment from a to b is that is nearest to p: 0 at a, 1 at b; 0 where both
 * ends are one point. */
static inline double vec_segment_foot(struct vec3 a, struct vec3 b, struct vec3 p)
{
    struct vec3 d = vec_sub(b, a);
    double d2 = vec_dot(d, d), s = d2 > 0 ? vec_dot(d, vec_sub(p, a)) / d2 : 0;
    return s < 0 ? 0 : s > 1 ? 1 : s;
}

/* That point. */
static inline struct vec3 vec_segment_nearest(struct vec3 a, struct vec3 b, struct vec3 p)
{
    return vec_mix(a, b, vec_segment_foot(a, b, p));
}

/* Its distance from p. */
static inline double vec_segment_distance(struct vec3 a, struct vec3 b, struct vec3 p)
{
    return vec_distance(p, vec_segment_nearest(a, b, p));
}

/* Distance of p from the line through a and b, which are not one point. */
static inline double vec_line_distance(struct vec3 a, struct vec3 b, struct vec3 p)
{
    return vec_length(vec_reject(vec_sub(p, a), vec_unit(vec_sub(b, a))));
}

/* The orientation of three points seen from above: twice the area of their triangle, positive where
 * they go round counter-clockwise, so that c is to the left of the line from a to b. */
static inline double vec_orient_xy(struct vec3 a, struct vec3 b, struct vec3 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* a turned about the unit vector `axis` through an angle, said by its cosine and sine, right-handed
 * (Rodrigues). */
static inline struct vec3 vec_turn_by(struct vec3 a, struct vec3 axis, double cosine, double sine)
{
    struct vec3 turned = vec_along(vec_scale(cosine, a), sine, vec_cross(axis, a));
    return vec_along(turned, (1 - cosine) * vec_dot(axis, a), axis);
}

/* The same through an angle in radians. */
struct vec3 vec_turn(struct vec3 a, struct vec3 axis, double angle);

/* A great circle from the unit vector a to b, to be asked at several places. */
struct great_circle {
    struct vec3 a, b;
    double angle, sine; /* between them, radians; its sine */
};

struct great_circle great_circle_of(struct vec3 a, struct vec3 b);

/* The unit vector at s, from a (0) to b (1) in proportion to the angle. */
struct vec3 great_circle_at(const struct great_circle *circle, double s);

/* The same, asked once. */
struct vec3 vec_slerp(struct vec3 a, struct vec3 b, double s);

/* Any unit vector perpendicular to the unit vector a. */
struct vec3 vec_perpendicular(struct vec3 a);

/* The order of two struct vec3 by x, then y, then z, as qsort and bsearch want it. */
int vec_compare(const void *a, const void *b);

#endif
