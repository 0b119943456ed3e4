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

/* How far it is from place to place there, mm: a quarter of the spacing. */
double border_surface_step(const struct border_surface *border_surface);

/* Is a place within one and a half spacings of the border of the mesh? */
bool border_surface_beside(const struct border_surface *border_surface, struct vec3 p);

/* Is a contact not beyond the border of the scan, which is looked for beside that of the mesh?
 * Points less than a fifth of a spacing off tell none, nor do fewer than 40, nor points more than a
 * spacing off: the mesh is of more. */
bool border_surface_within(const struct border_surface *border_surface, const struct contact *c);

/* An upright plane: what has x . normal = height; `along` is horizontal and in it. */
struct border_surface_plane {
    struct vec3 normal, along;
    double height;
};

/*
 * The point in the plane within a step of c on the surface of the third degree through the 40
 * nearest points of the scan, and its normal there.  False where these do not surround it, seen
 * along the normal, or leave a gap about it half as wide as they reach; where the surface runs
 * along the plane; and where that through the 24 nearest differs: a ball on a normal that is off by
 * e sinks in by e^2 / (2 (1 / R - k)), k the hollow curvature.
 */
bool border_surface_put(const struct border_surface *border_surface,
                        const struct border_surface_plane *plane, struct contact *c);

#endif
