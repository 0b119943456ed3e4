/*
 * onsurface - contact points of a mesh put on the NURBS surfaces that it was made from.
 */
#ifndef CLOUDMILL_ONSURFACE_H
#define CLOUDMILL_ONSURFACE_H

#include "curve/motion.h"
#include "nurbs/patch.h"

struct onsurface;

/* Prepares the surfaces; they must outlive it.  A place counts as on a surface up to `slack` mm
 * beyond what trims it. */
struct onsurface *onsurface_new(const struct patches *patches, double slack);

void onsurface_free(struct onsurface *on);

/*
 * Moves a contact point within the plane of this unit normal, square to its own nc_motion in it,
 * onto the nearest surface, inside its trimming, and gives it that surface's normal, to its own
 * side. Returns the number of the surface, or -1 when there is none within `reach` mm: the point is
 * then left as it is.
 */
int onsurface_put(const struct onsurface *on, struct vec3 plane, double reach,
                  struct contact *contact);

#endif
