/*
 * guard - keeping the ball clear of the part: of the whole scan, or of the mesh as a smooth
 * surface.
 *
 * The part is a set of guard points, dense against the ball's radius.  A ball with its centre at c
 * is clear when no guard point is nearer to c than the radius; the depth of a gouge is the radius
 * less the distance of the nearest guard point.
 */
#ifndef CLOUDMILL_GUARD_H
#define CLOUDMILL_GUARD_H

#include "mesh.h"
#include "vec.h"

struct guard;

/* From the points of a scan, as dense as they are. */
struct guard *guard_from_points(const struct vec3 *point, size_t n);

/*
 * From a mesh with vertex normals: each facet as the curved triangle that its vertices and normals
 * span (PN triangle, Vlachos et al. 2001), sampled no coarser than `spacing` mm.  The flat facet
 * would not do: in a hollow it stands above the surface by its sagitta.
 */
struct guard *guard_from_mesh(const struct mesh *mesh, double spacing);

void guard_free(struct guard *guard);

/* How deep a ball of this radius, its centre at c, is in the part, mm; negative: clear by so much
 * (not searched for beyond one radius). */
double guard_depth(const struct guard *guard, struct vec3 c, double radius);

/*
 * The smallest lift h in [0, limit] that brings the ball with its centre at c + h * up clear of the
 * part (up to 1e-6 mm), or -1 when no lift within the limit does.
 */
double guard_lift(const struct guard *guard, struct vec3 c, struct vec3 up, double radius,
                  double limit);

#endif
