/*
 * edge_curve - the edge of a facet as the surface runs there: a cubic that has the vertices'
 * normals.
 *
 * The straight edge of a facet is a chord of the surface, off by up to its sagitta (k c^2 / 8 for a
 * curvature k and a chord c); the cubic is off by what is of the fourth order in c.  The edge
 * belongs to both facets beside it, and so does the curve.  After the PN triangles of Vlachos et
 * al. 2001, but with handles that make edges of a sphere circular to the sixth order.
 */
#ifndef CLOUDMILL_EDGE_CURVE_H
#define CLOUDMILL_EDGE_CURVE_H

#include "math/vec.h"

struct edge_curve {
    struct vec3 p[4]; /* control points of a Bezier curve, mm */
};

/*
 * The control point next to p on the edge to q, in the tangent plane of p.  With alpha between
 * chord c and tangent the handle is 2 c / (3 (1 + cos alpha)), which is (4/3) tan(alpha/2) of the
 * radius: the best cubic for a circle (PN triangles have c cos alpha / 3, which is too flat).
 */
struct vec3 edge_handle(struct vec3 p, struct vec3 normal, struct vec3 q);

/* From p to q, with unit normals.  Straight where the chord is more than 30 degrees out of the
 * tangent plane at one of them: it spans a step, not a smooth surface. */
struct edge_curve edge_curve(struct vec3 p, struct vec3 p_normal, struct vec3 q,
                             struct vec3 q_normal);

/* The straight one. */
struct edge_curve edge_chord(struct vec3 p, struct vec3 q);

/* How far the curve is off the chord, mm, at most: an eighth of how far the ends are off each
 * other's tangent planes. */
double edge_bulge(struct vec3 p, struct vec3 p_normal, struct vec3 q, struct vec3 q_normal);

/* The point at s from 0 to 1, and the derivative. */
struct vec3 edge_curve_at(const struct edge_curve *curve, double s);
struct vec3 edge_curve_slope(const struct edge_curve *curve, double s);

/* Where a curve that begins (s = 0) not above the plane x . normal = height and ends above it
 * crosses it; it need not rise all the way. */
double edge_curve_crossing(const struct edge_curve *curve, struct vec3 normal, double height);

#endif
