/*
 * border_surface - the surface of a scan near the border of a mesh that was made from it, up to
 * where the scan itself ends.
 */
#ifndef CLOUDMILL_BORDER_SURFACE_H
#define CLOUDMILL_BORDER_SURFACE_H

#include "mesh/mesh.h"
#include "curve/motion.h"

struct border_surface;

struct border_surface_options {
    const struct vec3s *scan, *doubtful; /* its points (guard_points.h) */
    double spacing;                      /* of the mesh's vertices, mm */
    double radius;                       /* of the ball, mm */
    double sure; /* mm: a place is left out where the ball may be off by more */
};

struct border_surface *border_surface_new(const struct border_surface_options *rule,
                                          const struct mesh *mesh);
void border_surface_free(struct border_surface *border_surface);

/* How far apart places there are put, mm (STEP of the spacing). */
double border_surface_step(const struct border_surface *border_surface);

/* True if a place is near the border of the mesh (within BESIDE spacings). */
bool border_surface_beside(const struct border_surface *border_surface, struct vec3 p);

/* False: border_surface_move leads to no such place from p, wherever it leads. */
bool border_surface_may_be_beside(const struct border_surface *border_surface, struct vec3 p);

/* False if a contact of the mesh lies beyond the border of the scan, which is searched near that
 * of the mesh only.  Points nearer than LITTLE spacings, fewer than NEAR points, and points more
 * than a spacing off show no border: the mesh is of more than this scan. */
bool border_surface_within(const struct border_surface *border_surface, const struct contact *c);

/* An upright plane: what has x . normal = height; `along` is horizontal and in it. */
struct border_surface_plane {
    struct vec3 normal, along;
    double height;
};

/*
 * Moves c, by a step at most, to the point in the plane on the surface of the third degree through
 * the NEAR nearest points of the scan, with its normal there.  False where these do not surround
 * it, seen along the normal, or leave a gap about it half as wide as they reach; where the surface
 * runs along the plane; and where the surface through the FEWER nearest differs: a ball on a normal
 * that is off by e sinks in by e^2 / (2 (1 / R - k)), k the hollow curvature.
 */
bool border_surface_move(const struct border_surface *border_surface,
                         const struct border_surface_plane *plane, struct contact *c);

#endif
