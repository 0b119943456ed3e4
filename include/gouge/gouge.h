/*
 * gouge - keeping the ball clear of the part: of the whole scan, or of the mesh as a smooth
 * surface.
 *
 * The part is a set of guard points, dense against the ball's radius.  A ball with its centre at c
 * is clear when no guard point is nearer to c than the radius; the depth of a gouge is the radius
 * less the distance of the nearest guard point.
 *
 * Between guard points that are a gap g apart the ball sinks by up to g^2 / (6 R) (a triangle of
 * points; g^2 / (8 R) between two) into what they stand for, less what a hollow curves away.
 */
#ifndef CLOUDMILL_GOUGE_H
#define CLOUDMILL_GOUGE_H

#include <stdbool.h>

#include "gouge/holder.h"
#include "math/kdtree.h"
#include "mesh/mesh.h"
#include "math/vec.h"

struct gouge_check;

/* From the points of a scan, as dense as they are. */
struct gouge_check *gouge_from_points(const struct vec3 *point, size_t n);

/* The same, and the points are freed as soon as they are in it, by several threads (as
 * in parallel.h). */
struct gouge_check *gouge_take(struct vec3s points, int threads);

/*
 * From a mesh with vertex normals: each facet as the curved triangle that its vertices and normals
 * span (PN triangle, Vlachos et al. 2001, but with handles that make edges of a sphere circular
 * to the sixth order), sampled no coarser than `spacing` mm.  The flat facet would not do: in a
 * hollow it stands above the surface by its sagitta.  Only a facet that stands more than 30
 * degrees off one of its vertices' normals, as at a step or an edge, is sampled flat.
 */
struct gouge_check *gouge_from_mesh(const struct mesh *mesh, double spacing);

void gouge_free(struct gouge_check *guard);

/* The highest z among the guard points, mm. */
double gouge_top(const struct gouge_check *guard);

/* How far from c the box around the guard points reaches in a direction (a unit vector), mm. */
double gouge_extent(const struct gouge_check *guard, struct vec3 c, struct vec3 direction);

/* Distance from p to the nearest guard point, mm; `within` when none is nearer than that. */
double gouge_distance(const struct gouge_check *guard, struct vec3 p, double within);

/* How deep a ball of this radius, its centre at c, is in the part, mm; negative: clear by so
 * much. */
double gouge_depth(const struct gouge_check *guard, struct vec3 c, double radius);

/* The same for a ball whose centre moves straight from a to b: the deepest on the way, 0 where the
 * whole way is clear. */
double gouge_depth_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double radius);

/* Does the ball go no deeper than `depth` on that way?  Quicker than to ask how deep. */
bool gouge_clear_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double radius,
                       double depth);

/*
 * The smallest lift h in [0, limit] that brings the ball with its centre at c + h * up (a unit
 * vector) clear of the part (up to 1e-6 mm), or -1 when no lift within the limit does.  `touch` as
 * of kdtree_leave.
 */
double gouge_lift(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                  double limit, struct kdtree_touch *touch);

/*
 * The smallest lift h >= 0 from which on the ball stays clear all the way along `up`, out of reach
 * of every guard point: where a tool that comes from there ends.  A scan is a shell, and gouge_lift
 * may find room behind it; this does not.
 */
double gouge_rise(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius);

/* Does a ball that is clear at c stay so on its way straight up? */
bool gouge_free_above(const struct gouge_check *guard, struct vec3 c, double radius);

/* True when the ball can come to c from outside, against `up`, and goes no deeper than `depth` into
 * the part on the way. */
bool gouge_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                double depth);

/* How far shank and holder above a ball at c are from the nearest guard point, mm: negative by how
 * deep it is in them; `below` where none is as near. */
double gouge_holder(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                    struct vec3 axis, double below);

/* Are they no nearer than `least`?  Quicker than to ask how near. */
bool gouge_holder_clear(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                        struct vec3 axis, double least);

#endif
